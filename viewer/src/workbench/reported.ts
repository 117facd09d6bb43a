/** A report within a page: its own sections, tables and figures, taken from its file. Rows of trials open their curves. */

import { type Model, Store } from "../data";
import { make } from "../page";
import { heard, isGerman, tr, withComma } from "../words";
import * as api from "./api";
import { savable } from "./curves";
import { problem } from "./parts";
import { inWords } from "./quantities";
import type { Finding } from "./refusals";
import { saveTable } from "./saving";

const OPEN = 3; // sections that are shown at once: the answer and its evidence; the others unfold

/** Elements and attributes that are taken over. A report may come from elsewhere: no script, style or address is. */
const TEXT = new Set(
  (
    "section h2 h3 h4 h5 p ul ol li table caption thead tbody tr th td div span small strong em figure figcaption " +
    "dl dt dd details summary a wbr"
  ).split(" "),
);
const DRAWN = new Set(
  "svg g path line rect circle polyline polygon text tspan title clipPath defs".split(" "),
);
const KEPT =
  /^(class|scope|colspan|rowspan|tabindex|role|open|aria-[a-z]+|data-(viewer|show|scene)|viewBox|d|x|y|x1|x2|y1|y2|cx|cy|r|dx|dy|width|height|points|transform|text-anchor|dominant-baseline|clip-path)$/;
const SIZES = /^(flex-basis|max-width): \d+px$/;

/** Letters and digits of a sentence, by which it is found again however it is printed. */
const bare = (text: string): string => text.normalize("NFKC").replace(/[^\p{L}\p{N}]+/gu, "");

/** German of a text; nothing if it has none. */
function spoken(words: string): string | undefined {
  const known = tr(words),
    said = known === words ? heard(words) : known;
  return said === words ? undefined : said;
}

/** Numbers of a German text, and lists of them, as they are written there. */
const written = (text: string) =>
  withComma(text)
    .replace(/(\d) and (\d)/g, "$1 und $2")
    .replace(/(\d) of (\d)/g, "$1 von $2");

class Copy {
  constructor(
    private readonly germans: Map<string, string>,
    private readonly isDrawn: (scene: string) => boolean,
  ) {}

  of(node: Node): Node | null {
    if (node instanceof Text) return this.text(node);
    if (!(node instanceof Element)) return null;
    const isSvg = node.namespaceURI === "http://www.w3.org/2000/svg";
    if (!(isSvg ? DRAWN : TEXT).has(node.localName)) return null;
    if (node.localName === "figure" && this.isDrawn(node.id.replace(/^picture-/, ""))) return null;
    const made = isSvg
      ? document.createElementNS(node.namespaceURI!, node.localName)
      : document.createElement(node.localName);
    for (const { name, value } of node.attributes) {
      if (name === "aria-labelledby" && !isSvg) continue; // ids of the report's page are not taken over
      if (KEPT.test(name)) made.setAttribute(name, name === "aria-label" ? heard(value) : value);
      else if (isSvg && name === "id")
        made.id = value; // of clip paths and titles
      else if (name === "data-style" && made instanceof SVGElement)
        for (const part of value.split(/; */).filter((part) => SIZES.test(part)))
          made.style.setProperty(...(part.split(": ") as [string, string]));
    }
    for (const child of node.childNodes) {
      const own = this.of(child);
      if (own) made.append(own);
    }
    return made;
  }

  private text({ data, parentElement, previousSibling, nextSibling }: Text): Node {
    const isPart = [previousSibling, nextSibling].some((node) => node?.nodeName === "WBR"); // of a name
    const [, before = "", words = "", after = ""] =
      /^([\s:]*)(.*?)(\s*)$/s.exec(data.replaceAll("\u00a0", " ")) ?? [];
    if (!isGerman || !words || isPart) return document.createTextNode(data);
    const isSvg = parentElement instanceof SVGElement,
      parts = this.sentences(words);
    if (isSvg || parts.every(({ isLeft }) => !isLeft)) {
      const said = parts.map(({ said }) => said).join(" ");
      return document.createTextNode(`${before}${said}${after}`);
    }
    const shown = new DocumentFragment();
    shown.append(before);
    parts.forEach(({ said, isLeft }, k) => {
      shown.append(k ? " " : "", isLeft ? make("span", { lang: "en" }, said) : said);
    });
    shown.append(after);
    return shown;
  }

  /** A text in German as a whole, else sentence by sentence; what has no German is left as it is. */
  private sentences(words: string): { said: string; isLeft: boolean }[] {
    const known = this.germans.get(bare(words)) ?? (tr(words) === words ? undefined : tr(words));
    if (known) return [{ said: written(known), isLeft: false }];
    const parts = words.split(/(?<=[.!?])(?<!\bEq\.) (?=[A-Z–±\d])/).map((sentence) => {
      const said = spoken(sentence),
        isLeft = !said && /\p{L}{3,} \p{L}{2,}/u.test(sentence);
      return { said: isLeft ? sentence : written(said ?? sentence), isLeft };
    });
    const left = parts.filter(({ isLeft }) => isLeft),
      whole = left.length && parts.length > 1 ? spoken(words) : undefined;
    return whole && !left.some(({ said }) => whole.includes(said)) // as if it were one sentence
      ? [{ said: written(whole), isLeft: false }]
      : parts;
  }
}

/** Shows the report at an address; its findings have their German sentences from the answer of the job. */
export async function reported(address: string, findings: Finding[]): Promise<HTMLElement> {
  const text = await (await api.asked("GET", address)).text(),
    plain = text // styles of a parsed page would be applied, which the policy of this one forbids
      .replace(/<style>.*?<\/style>/gs, "")
      .replace(/ (style|on[a-z]+)="/g, ' data-$1="'),
    source = new DOMParser().parseFromString(plain, "text/html"),
    data = source.getElementById("jounce-data")?.textContent,
    rows = [...source.querySelectorAll<HTMLElement>("details[data-scene]")];
  const scenes = new Set(rows.map((row) => row.dataset.scene!)),
    germans = new Map(
      findings.flatMap(({ message, german }) => (german ? [[bare(message), german] as const] : [])),
    );
  const copy = new Copy(germans, (name) => scenes.has(name)),
    sections = [...source.querySelectorAll("main > section")],
    place = make("div", { class: "reported" }),
    contents = make("ol", {});
  let opened: Promise<Store> | null = null;
  const store = () => {
    opened ??= Store.open(data!).then(inWords);
    return opened;
  };
  const banner = source.querySelector(".banner");
  if (banner) place.append(copy.of(banner) ?? "");
  if (sections.length > 1) place.append(make("nav", { "aria-label": "Contents" }, contents));
  sections.forEach((section, k) => {
    const own = copy.of(section) as HTMLElement,
      heading = own.querySelector("h2")!,
      name = heading.firstChild?.textContent ?? "";
    let goal = own;
    if (k >= OPEN) {
      goal = make("details", { class: "folded" }, make("summary", {}, heading), own);
    }
    heading.tabIndex = -1;
    contents.append(make("li", {}, jump(name, goal, heading)));
    place.append(goal);
  });
  for (const table of place.querySelectorAll("table"))
    table.closest(".table")!.append(saveTable(table, table.caption?.textContent ?? ""));
  for (const row of place.querySelectorAll<HTMLDetailsElement>("details[data-scene]"))
    row.addEventListener("toggle", () => void unfold(row, store), { once: true });
  for (const link of place.querySelectorAll<HTMLAnchorElement>("a[data-show]")) {
    const row = place.querySelector<HTMLElement>(`details[data-scene="${link.dataset.show}"]`);
    if (row)
      link.replaceWith(jump(link.textContent!, row, row.querySelector<HTMLElement>("summary")!));
  }
  for (const holder of place.querySelectorAll<HTMLElement>("[data-viewer]")) {
    if (rows.length || !data) {
      holder.closest("figure")!.remove(); // its scenes are those of the rows
      continue;
    }
    const made = await store(),
      model = made.content.viewers[Number(holder.dataset.viewer)];
    if (model) holder.replaceChildren(savable(model, made).element);
  }
  return place;
}

/** A link to a part of the report, which is unfolded. */
function jump(words: string, goal: HTMLElement, focus: HTMLElement): HTMLElement {
  const link = make("button", { type: "button", class: "link" }, words);
  link.addEventListener("click", () => {
    for (let element: HTMLElement | null = goal; element; element = element.parentElement)
      if (element instanceof HTMLDetailsElement) element.open = true;
    goal.scrollIntoView({ block: "start" });
    focus.focus({ preventScroll: true });
  });
  return link;
}

/** Draws the curves of a row when it is opened for the first time. */
async function unfold(row: HTMLDetailsElement, store: () => Promise<Store>): Promise<void> {
  const holder = make("div", {}, make("p", { class: "state" }, "loading …"));
  row.append(holder);
  try {
    const made = await store(),
      model = modelOf(made.content, row.dataset.scene!);
    if (!model) throw new Error(tr("The report does not contain these curves."));
    const title = row.querySelector("summary")!.firstChild?.textContent ?? "";
    holder.replaceChildren(savable({ ...model, title }, made).element);
  } catch (error) {
    holder.replaceChildren(problem(error));
  }
}

/** The viewer that has a scene, with this scene alone. */
function modelOf({ viewers }: Store["content"], name: string): Model | undefined {
  const model = viewers.find((viewer) => viewer.scenes.some((scene) => scene.name === name));
  return model && { ...model, scenes: model.scenes.filter((scene) => scene.name === name) };
}
