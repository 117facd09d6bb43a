/** Menus that export or copy what a page shows: figures, tables and the whole page. Nothing is written into the project. */

import { make } from "../page";
import { chartOf, drawingsOf, type ShownChart, type ShownDrawing } from "../shown";
import { tr } from "../words";
import * as api from "./api";
import { once } from "./parts";
import { problem } from "./refusals";

type Block =
  | ({ kind: "chart"; caption: string } & ShownChart)
  | { kind: "table"; caption: string; header: string[]; rows: string[][]; numbers: number[] }
  | ({ kind: "drawing"; caption: string } & Omit<ShownDrawing, "title">)
  | { kind: "text" | "heading"; text: string };
type Form = "png" | "svg" | "pdf" | "html" | "csv" | "xlsx";

const SCALES = [1, 2, 4];

/** Text of an element as it is read, on one line. */
const textOf = (element: Element | null): string =>
  (element?.textContent ?? "").replace(/\s+/g, " ").trim();

/** Title of the open page. */
export const title = (): string => textOf(document.querySelector("#main h1")) || "jounce";

async function file(form: Form, name: string, blocks: Block[], scale = 2): Promise<Blob> {
  const plain = blocks.map((block) =>
    block.kind === "chart"
      ? {
          ...block,
          x: Array.from(block.x),
          panels: block.panels.map(({ title, unit, curves }) => ({
            title,
            unit,
            curves: curves.map((curve) => ({ ...curve, y: Array.from(curve.y) })),
          })),
        }
      : block,
  );
  const answer = await api.asked(
    "POST",
    "/api/export",
    {
      title: name,
      subtitle: textOf(document.getElementById("project")),
      form,
      scale,
      blocks: plain,
    },
    "*/*",
  );
  return answer.blob();
}

function download(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  make("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

const named = (name: string, form: string): string =>
  `${
    name
      .normalize("NFKD")
      .replace(/[^\w]+/g, "-")
      .replace(/^-+|-+$/g, "")
      .slice(0, 80) || "jounce"
  }.${form}`;

/** A menu; its entries close it and report what went wrong beside it. */
function menu(label: string, entries: [string, () => Promise<unknown>][]): HTMLElement {
  const said = make("span", { "aria-live": "polite", class: "said" });
  const list = make("div", { class: "entries", role: "group", "aria-label": label });
  const whole = make(
    "details",
    { class: "save" },
    make("summary", { title: label, "aria-label": label }, tr("Export")),
    list,
  );
  for (const [words, work] of entries)
    list.append(
      make(
        "button",
        {
          type: "button",
          click: () => {
            whole.open = false;
            said.textContent = tr("exporting …");
            work().then(
              () => {
                said.textContent = "";
              },
              (error) => said.replaceChildren(problem(error)),
            );
          },
        },
        words,
      ),
    );
  whole.addEventListener("keydown", (event) => {
    if (!event.ctrlKey && !event.metaKey && event.key !== "?") event.stopPropagation(); // keys of the curves around it
    if (event.key !== "Escape" || !whole.open) return;
    whole.open = false;
    whole.querySelector("summary")!.focus();
  });
  whole.addEventListener("focusout", (event) => {
    if (event.relatedTarget && !whole.contains(event.relatedTarget as Node)) whole.open = false;
  });
  return make("div", { class: "saving" }, whole, said);
}

/** A button that saves one document, which the server makes when it is asked for. */
export function saveDocument(name: string, content: () => Promise<Blob>): HTMLElement {
  const said = make("span", { "aria-live": "polite", class: "said" }),
    button = make("button", { type: "button" }, "Export as PDF");
  button.addEventListener("click", () => {
    said.textContent = tr("exporting …");
    once(button, content()).then(
      (document) => {
        said.textContent = "";
        download(document, named(name, "pdf"));
      },
      (error) => said.replaceChildren(problem(error)),
    );
  });
  return make("div", { class: "saving" }, button, said);
}

/** Saves or copies the curves of an element. */
export function saveChart(element: Element, caption: () => string): HTMLElement {
  const blocks = (): Block[] => {
    const chart = chartOf(element);
    if (!chart) throw new Error(tr("No curve is shown."));
    return [{ kind: "chart", caption: caption(), ...chart }];
  };
  const save = (form: Form, scale?: number) => async () =>
    download(await file(form, caption(), blocks(), scale), named(caption(), form));
  return menu(tr("Export these curves"), [
    ...SCALES.map((scale): [string, () => Promise<unknown>] => [
      `PNG × ${scale}`,
      save("png", scale),
    ]),
    ["SVG", save("svg")],
    ["PDF", save("pdf")],
    ["CSV", save("csv")],
    ["XLSX", save("xlsx")],
    [tr("Copy the picture"), () => copyPicture(() => file("png", caption(), blocks()))],
    [
      tr("Copy the numbers"),
      async () => {
        const text = await (await file("csv", caption(), blocks())).text();
        await clipboard().writeText(tabbed(text.replace(/^\ufeff/, "")));
      },
    ],
  ]);
}

/** Drawings of a mechanism as blocks: as it is seen, or in all views that its page has. */
function drawingBlocks(mechanism: Element, isAll: boolean): Block[] {
  const name = tr("Mechanism of #", title());
  return drawingsOf(mechanism, isAll).map(({ title: view, ...drawing }) => ({
    kind: "drawing",
    caption: isAll ? `${name}: ${view}` : name,
    ...drawing,
  }));
}

/** Adds a menu to a drawing of a mechanism that saves it as it is seen, names of points included. */
export function saveDrawing(mechanism: HTMLElement): void {
  const name = () => `${title()} mechanism`;
  const blocks = (): Block[] => {
    const drawn = drawingBlocks(mechanism, false);
    if (!drawn.length) throw new Error(tr("The drawing has no size yet."));
    return drawn;
  };
  const save = (form: Form, scale?: number) => async () =>
    download(await file(form, name(), blocks(), scale), named(name(), form));
  mechanism
    .querySelector(".bar")!
    .append(
      menu(tr("Export this drawing"), [
        ...SCALES.map((scale): [string, () => Promise<unknown>] => [
          `PNG × ${scale}`,
          save("png", scale),
        ]),
        ["SVG", save("svg")],
        ["PDF", save("pdf")],
        [tr("Copy the picture"), () => copyPicture(() => file("png", name(), blocks()))],
      ]),
    );
}

/** The clipboard, which browsers give only to pages of this machine or of https. */
function clipboard(): Clipboard {
  if (!navigator.clipboard || !("ClipboardItem" in globalThis))
    throw new Error(
      tr("This browser does not let this page use the clipboard: export a file instead."),
    );
  return navigator.clipboard;
}

/** Puts a picture on the clipboard; browsers take it as a promise, so that the click still counts. */
async function copyPicture(picture: () => Promise<Blob>): Promise<void> {
  await clipboard().write([new ClipboardItem({ "image/png": picture() })]);
}

/** Cells separated by tabs, as spreadsheets take them from the clipboard. */
const tabbed = (text: string): string =>
  text.replace(/("(?:[^"]|"")*"|[^,\n]*)(,|\n|$)/g, (_, cell: string, end: string) => {
    const plain = cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell;
    return plain.replace(/[\t\n]+/g, " ") + (end === "," ? "\t" : end);
  });

/** Saves or copies a table. */
export function saveTable(element: HTMLTableElement, label: string): HTMLElement {
  const caption = () => textOf(element.caption) || tr(label);
  const save = (form: Form) => async () =>
    download(await file(form, caption(), [tableOf(element, label)]), named(caption(), form));
  return menu(tr("Export this table"), [
    ["CSV", save("csv")],
    ["XLSX", save("xlsx")],
    ["PDF", save("pdf")],
    [
      tr("Copy"),
      async () => {
        const { header, rows } = tableOf(element, label);
        const lines = [header, ...rows].map((cells) => cells.join("\t"));
        await clipboard().writeText(`${lines.join("\n")}\n`);
      },
    ],
  ]);
}

type TableBlock = Extract<Block, { kind: "table" }>;

/** The visible rows of a table, as text: fields by what is entered in them. */
function tableOf(element: HTMLTableElement, label: string): TableBlock {
  const cell = (element: Element): string => {
    const field = element.querySelector<HTMLInputElement | HTMLSelectElement>("input, select");
    if (!field) return textOf(element);
    if (field instanceof HTMLSelectElement) return textOf(field.selectedOptions[0] ?? null);
    return field.type === "checkbox" ? (field.checked ? "✓" : "") : field.value;
  };
  const rows = [...element.tBodies]
    .flatMap((body) => [...body.rows])
    .filter((row) => !row.hidden)
    .map((row) => [...row.cells].map(cell));
  const heads = [...(element.tHead?.rows[0]?.cells ?? [])];
  const width = Math.max(heads.length, ...rows.map((cells) => cells.length), 1);
  const padded = (cells: string[]) => [...cells, ...Array(width - cells.length).fill("")];
  return {
    kind: "table",
    caption: textOf(element.caption) || tr(label),
    header: padded(heads.map(textOf)),
    rows: rows.map(padded),
    numbers: heads.flatMap((head, k) => (head.classList.contains("right") ? [k] : [])),
  };
}

/** What the page shows, from top to bottom: headings, sentences, curves and tables. */
function pageBlocks(): Block[] {
  const blocks: Block[] = [];
  const walk = (element: Element): void => {
    if (!(element instanceof HTMLElement) || !isVisible(element) || element.matches(SKIPPED))
      return;
    const chart = chartOf(element);
    const drawings = drawingBlocks(element, true);
    if (chart) blocks.push({ kind: "chart", caption: "", ...chart });
    else if (drawings.length) blocks.push(...drawings);
    else if (element instanceof HTMLTableElement)
      blocks.push(tableOf(element, element.parentElement?.getAttribute("aria-label") ?? ""));
    else if (/^H[2-4]$/.test(element.tagName))
      blocks.push({ kind: "heading", text: textOf(element) });
    else if (element.tagName === "P" || element.tagName === "LI") {
      if (textOf(element) && !element.querySelector(CONTROLS))
        blocks.push({ kind: "text", text: textOf(element) });
    } else for (const child of element.children) walk(child);
  };
  walk(document.getElementById("main")!);
  if (blocks.length && blocks[0]!.kind !== "heading")
    blocks.unshift({ kind: "heading", text: tr("Overview") });
  return blocks.filter(
    (block, k) => block.kind !== "heading" || (blocks[k + 1]?.kind ?? "heading") !== "heading",
  );
}

/** Controls, and what only makes sense on a screen. */
const SKIPPED =
  "form, nav, dialog, .form, .controls, .saving, .code, .ways, .bar, .hint, .state, .legend";
const CONTROLS = "a, button, input, select, textarea";
const isVisible = (element: HTMLElement): boolean =>
  !element.hidden && (element.id === "main" || element.offsetParent !== null);

/** Saves the whole page. */
export function savePage(): HTMLElement {
  const save = (form: Form) => async () => {
    const blocks = pageBlocks();
    if (!blocks.some((block) => block.kind !== "heading"))
      throw new Error(tr("There is nothing on this page to export yet."));
    download(await file(form, title(), blocks), named(title(), form));
  };
  return menu(tr("Export this page"), [
    [tr("PDF document"), save("pdf")],
    [tr("HTML report"), save("html")],
    [tr("XLSX workbook: curves and tables"), save("xlsx")],
  ]);
}
