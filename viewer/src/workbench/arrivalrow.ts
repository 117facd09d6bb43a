/** The row of a file that came in: kind, curve, content, what is typed, and what it lacks. */

import { make, written } from "../page";
import { tr, withComma } from "../words";
import { type Arrivals, CHOICES, CURVES, INPUTS, KINDS, NEEDED, type Preview } from "./arrivals";
import { select, textBox } from "./parts";
import { line, svg } from "./picture";
import { asSaid } from "./refusals";
import { address } from "./shell";

/** The kind of a record of a shock-absorber tester, which is inspected. */
const TESTED = "tester record";
const LENGTHS = ["mm", "cm", "m", "inch"],
  FORCES = ["N", "kN", "kgf", "lbf"];

/** Fills the row of a file; `opens` is the address of its page and `kind` what the project says it is. */
export function arrivalRow(
  arrivals: Arrivals,
  preview: Preview,
  { opens, kind: known }: { opens: string; kind: string },
  read: () => void,
): HTMLTableRowElement {
  const name = preview.file.split("/").pop()!,
    kind = arrivals.value(preview, "kind"),
    isIn = arrivals.isIn(preview);
  const box = make("input", {
    type: "checkbox",
    "aria-label": tr("enter #", name),
    "data-at": `${preview.file} on`,
    checked: isIn,
    disabled: kind === "",
  });
  box.addEventListener("change", () => arrivals.tick([preview], box.checked));
  const isData = preview.columns.length > 0,
    described = known === "record" ? "" : known; // a rig, a road: it needs no campaign
  const type = isData
    ? choice(arrivals, preview, "kind", Object.entries(KINDS), name)
    : make(
        "span",
        {},
        tr(preview.kind === "unknown" ? described || "not recognised" : preview.kind),
      );
  const columns = make(
    "button",
    { type: "button", class: "link", "aria-label": `${tr("Columns")}: ${name}`, click: read },
    tr("Columns"),
  );
  return make(
    "tr",
    { class: isIn ? "" : "off" },
    make("td", {}, box),
    make(
      "th",
      { scope: "row", title: preview.file },
      opens ? make("a", { href: opens }, name) : name,
    ),
    make(
      "td",
      {},
      type,
      ...(preview.doubt
        ? [make("small", { class: "fair" }, " ", asSaid(`or ${preview.doubt}`))]
        : []),
      ...(preview.kind === TESTED ? [make("small", {}, " ", tr(preview.kind))] : []),
    ),
    make("td", {}, sparkline(preview)),
    make(
      "td",
      {},
      summary(preview.summary),
      ...(isData && kind ? [" ", columns] : []),
      ...others(preview, name),
      ...units(arrivals, preview, name),
    ),
    make("td", { class: "inputs" }, ...inputs(arrivals, preview, kind, name)),
    make("td", {}, ...state(arrivals, preview)),
  );
}

/** Links to the pages that show a record without a campaign. */
function others({ file, kind }: Preview, name: string): (Node | string)[] {
  const link = (page: string, key: string, words: string) =>
    make(
      "a",
      { href: address(page, { [key]: file }), "aria-label": `${tr(words)}: ${name}` },
      tr(words),
    );
  return [
    ...(kind === TESTED ? [" ", link("inspection", "record", "inspect")] : []),
    ...([TESTED, "trial", "decay"].includes(kind) ? [" ", link("data", "path", "analyse")] : []),
  ];
}

/** What a file contains, with numbers as the page writes them. */
function summary(text: string): Node | string {
  const said = asSaid(text);
  return typeof said === "string" ? withComma(said) : said;
}

/** Whether a file is complete, and what it lacks or why it was refused. */
function state(arrivals: Arrivals, preview: Preview): HTMLElement[] {
  const refused = arrivals.refused.get(preview.file);
  if (refused) return [make("span", { class: "wrong", role: "alert" }, refused)];
  if (!arrivals.isIn(preview)) return [];
  const lacking = arrivals.lacks(preview);
  return [
    lacking.length
      ? make("span", { class: "mark fair" }, `${tr("missing")}: ${lacking.join(", ")}`)
      : make("span", { class: "mark good" }, "complete"),
  ];
}

/** A small curve of a file. */
function sparkline({ file, curve }: Preview): HTMLElement | SVGElement {
  const { x = [], y = [] } = curve;
  if (x.length < 2) return make("span", { class: "muted" }, "–");
  const [width, height] = [120, 34];
  const ends = (all: number[]) => [Math.min(...all), Math.max(...all)] as [number, number];
  const [x0, x1] = ends(x),
    [y0, y1] = ends(y);
  const path = line(
    x.map((at, k) => [
      2 + ((width - 4) * (at - x0)) / (x1 - x0 || 1),
      height - 2 - ((height - 4) * (y[k]! - y0)) / (y1 - y0 || 1),
    ]),
  );
  const picture = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    class: "spark",
    role: "img",
    "aria-label": `${curve.y_label ?? ""}: ${written(y0, 3)} … ${written(y1, 3)} (${file.split("/").pop()})`,
  });
  picture.append(svg("path", { d: path }));
  return picture;
}

/** Units that the file does not have: the usual ones are shown, and can be changed. */
function units(arrivals: Arrivals, preview: Preview, name: string): HTMLElement[] {
  const columns = preview.fields.columns as Record<string, string> | undefined;
  if (!CURVES.includes(arrivals.value(preview, "kind")) || !columns) return [];
  return preview.missing
    .filter(({ what, proposal }) => what === "unit" && proposal)
    .flatMap(({ column, proposal }) => {
      const key = Object.keys(columns).find((own) => columns[own]!.startsWith(column));
      if (!key) return [];
      const own = arrivals.list.columns[preview.file]?.[key],
        now = (own && /\[([^\]]*)\]$/.exec(own)?.[1]) || proposal;
      const unit = select(key === "force" ? FORCES : LENGTHS, now);
      unit.setAttribute("aria-label", tr("unit of #", `${column}, ${name}`));
      unit.dataset.at = `${preview.file} unit ${key}`;
      unit.addEventListener("change", () =>
        arrivals.readAs(preview, (like) => ({
          ...(like.fields.columns as Record<string, string>),
          ...arrivals.list.columns[like.file],
          [key]: `${column} [${unit.value}]`,
        })),
      );
      return [make("label", { class: "unit" }, tr("# has no unit: read as", column), " ", unit)];
    });
}

function choice(
  arrivals: Arrivals,
  preview: Preview,
  key: string,
  choices: [value: string, words: string][],
  name: string,
): HTMLSelectElement {
  const control = make(
    "select",
    { "aria-label": `${tr(key)}: ${name}`, "data-at": `${preview.file} ${key}` },
    ...choices.map(([value, words]) =>
      make("option", { value, selected: value === arrivals.value(preview, key) }, tr(words)),
    ),
  );
  control.addEventListener("change", () => arrivals.type(preview, { [key]: control.value }));
  return control;
}

function inputs(arrivals: Arrivals, preview: Preview, kind: string, name: string): HTMLElement[] {
  const shown = (INPUTS[kind] ?? []).map(([key, label, example]) => {
    if (key === "use") return choice(arrivals, preview, key, CHOICES.use!, name);
    if (key === "road")
      return choice(
        arrivals,
        preview,
        key,
        arrivals.roads.map((road) => [road, `${tr("road")} ${road}`]),
        name,
      );
    const input = textBox(arrivals.value(preview, key), `${tr(label)}, ${example}`);
    input.size = key === "number" ? 2 : Math.min(input.placeholder.length, 18);
    input.setAttribute("aria-label", `${tr(label)}: ${name}`);
    input.dataset.at = `${preview.file} ${key}`;
    if (arrivals.isIn(preview) && NEEDED.includes(key) && !input.value)
      input.setAttribute("aria-invalid", "true");
    input.addEventListener("change", () => arrivals.type(preview, { [key]: input.value.trim() }));
    return input;
  });
  if (CURVES.includes(kind) && preview.missing.some(({ what }) => what === "sign"))
    for (const key of ["stroke_positive", "force_positive"])
      shown.push(choice(arrivals, preview, key, CHOICES[key]!, name));
  return shown;
}
