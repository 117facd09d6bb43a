/** Tables copied from a spreadsheet: hardpoints, curves and trials, shown beside the present ones before they are taken. */

import { make, whenLeft, written } from "../page";
import { inField, localised, tr } from "../words";
import * as api from "./api";
import { field, once, problem, select } from "./parts";
import { line, svg } from "./picture";
import { key, part } from "./quantities";
import { advised, type Finding } from "./refusals";
import { table } from "./table";

interface Pasted {
  points: { name: string; theirs: string; before: number[]; after: number[]; distance: number }[];
  unit: string;
  axes: string;
  is_unit_stated: boolean;
  is_mirrored: boolean;
  unknown: Record<string, string>;
  absent: string[];
  findings: Finding[];
  changes: Record<string, number>;
}
interface Subject {
  rig: string;
  text?: string;
  changes: Record<string, number>;
}

const MM = 1e3,
  FAR = 0.1; // m: a point that moves further may be another one
const AXES: [value: string, words: string][] = [
  ["", "as they fit best"],
  ["x,y,z", "x forward, y left, z up"],
  ["-x,-y,z", "x back, y right, z up"],
  ["x,-y,z", "x forward, y right, z up"],
  ["-x,y,z", "x back, y left, z up"],
  ["x,-y,-z", "x forward, y right, z down"],
  ["y,-x,z", "x right, y forward, z up"],
];

/** A fold with a text area for the table, its options and a preview; `take` hears the changed coordinates (SI, by path). */
export function pastePoints(
  subject: () => Subject,
  take: (changes: Record<string, number>) => void,
): HTMLDetailsElement {
  const area = make("textarea", {
      rows: "6",
      spellcheck: "false",
      placeholder: "point\tx [mm]\ty [mm]\tz [mm]",
    }),
    unit = select(["", "mm", "m", "cm", "inch"], "", (text) => text || tr("as in the table")),
    axes = make(
      "select",
      {},
      ...AXES.map(([value, words]) => make("option", { value }, tr(words))),
    ),
    side = select(["left", "right"], "left", tr),
    axle = select(["", "front", "rear"], "", (text) => tr(text || "the only one")),
    preview = make("div", { "aria-live": "polite" }),
    read = make("button", { type: "button" }, tr("Compare with the rig"));
  const names: Record<string, string> = {};
  let turn = 0;
  const ask = async () => {
    const own = ++turn;
    if (!area.value.trim()) {
      preview.replaceChildren();
      return;
    }
    try {
      const answer = await api.asked("POST", "/api/points", {
        ...subject(),
        table: area.value,
        unit: unit.value,
        axes: axes.value,
        side: side.value,
        axle: axle.value,
        names,
      });
      const pasted = (await answer.json()) as Pasted;
      if (own === turn) preview.replaceChildren(...shown(pasted));
    } catch (error) {
      if (own === turn) preview.replaceChildren(problem(error), ...forgotten());
    }
  };
  /** Names that were assigned, which a later table may not have. */
  const forgotten = (): HTMLElement[] => {
    if (!Object.keys(names).length) return [];
    const forget = make("button", { type: "button" }, tr("Forget the assigned names"));
    forget.addEventListener("click", () => {
      for (const name of Object.keys(names)) delete names[name];
      void ask();
    });
    return [forget];
  };
  const text = (value: number) => localised(String(Number((MM * value).toFixed(4))));
  /** Coordinates below each other; those that are not as in `other` stand out. */
  const place = (at: number[], other = at) =>
    at.flatMap((value, k) => [
      ...(k ? [" "] : []),
      make(text(value) === text(other[k]!) ? "span" : "b", { class: "coordinate" }, text(value)),
    ]);
  const shown = (pasted: Pasted): HTMLElement[] => {
    const count = new Set(Object.keys(pasted.changes).map((path) => path.split("[")[0])).size;
    const go = make(
      "button",
      { type: "button", class: "main", disabled: !count },
      tr("Take # changed points", String(count)),
    );
    go.addEventListener("click", () => {
      take(pasted.changes);
      preview.replaceChildren(
        make("p", { class: "good" }, tr("# points taken. Undo reverses this.", String(count))),
      );
    });
    const known = AXES.find(([value]) => value === pasted.axes)?.[1];
    return [
      make(
        "p",
        {},
        tr(
          pasted.is_unit_stated ? "Unit: #." : "Unit: #, since the points then fit best.",
          pasted.unit,
        ),
        " ",
        tr("Axes: #.", known ? tr(known) : pasted.axes),
        ...(pasted.is_mirrored ? [" ", tr("The right corner was mirrored.")] : []),
      ),
      table(
        "hardpoints",
        ["hardpoint", "in the table", "before [mm]", "after [mm]", "moves by [mm]"],
        pasted.points.map((point) => [
          part(point.name),
          point.theirs,
          place(point.before),
          place(point.after, point.before),
          point.distance > FAR
            ? make("span", { class: "mark fair" }, written(MM * point.distance, 4))
            : written(MM * point.distance, 4),
        ]),
        [2, 3, 4],
      ),
      ...Object.entries(pasted.unknown).map(([theirs, where]) => {
        const choice = make(
          "select",
          {},
          make("option", { value: "" }, tr("leave it out")),
          ...[...pasted.absent].map((name) => make("option", { value: name }, part(name))),
        );
        choice.addEventListener("change", () => {
          if (choice.value) names[theirs] = choice.value;
          else delete names[theirs];
          void ask();
        });
        return field(
          `${where.replace(/^table, line /, `${tr("line")} `)}: ${tr("# is no hardpoint of this rig", theirs)}`,
          choice,
        );
      }),
      ...(pasted.absent.length
        ? [
            make(
              "p",
              { class: "muted" },
              tr("Not in the table, so unchanged: #", pasted.absent.map(part).join(", ")),
            ),
          ]
        : []),
      ...advised(
        pasted.findings.filter((finding) => finding.severity !== "note"),
        "p",
      ),
      make("p", { class: "bar" }, go, ...forgotten()),
    ];
  };
  for (const select of [unit, axes, side, axle])
    select.addEventListener("change", () => void ask());
  read.addEventListener("click", () => void once(read, ask()));
  area.addEventListener("paste", () => setTimeout(() => void ask()));
  const fold = make(
    "details",
    { class: "pasting" },
    make("summary", {}, tr("Paste hardpoints from a table")),
    field(tr("Rows of a name and three coordinates, copied from a spreadsheet"), area),
    make(
      "div",
      { class: "form" },
      field(tr("Unit"), unit),
      field(tr("Axes of the table"), axes),
      field(tr("Corner"), side),
      field(tr("Axle"), axle),
      read,
    ),
    preview,
  );
  /** A table pasted while nothing is typed into is meant for the hardpoints. */
  const pasted = (event: ClipboardEvent) => {
    const given = event.clipboardData?.getData("text/plain") ?? "",
      target = event.target as Element | null;
    if (!fold.isConnected || target?.closest("input, textarea, select") || !/[\t;].*\n/.test(given))
      return;
    event.preventDefault();
    fold.open = true;
    area.value = given;
    fold.scrollIntoView({ block: "nearest" });
    void ask();
  };
  document.addEventListener("paste", pasted);
  whenLeft(() => document.removeEventListener("paste", pasted));
  return fold;
}

/** A fold with a text area for a table, further fields, and a preview that `ask` makes of the text. */
function fold(
  title: string,
  label: string,
  example: string,
  fields: HTMLSelectElement[],
  labels: string[],
  ask: (text: string) => Promise<HTMLElement[]>,
): HTMLDetailsElement {
  const area = make("textarea", { rows: "5", spellcheck: "false", placeholder: example }),
    preview = make("div", { "aria-live": "polite" }),
    read = make("button", { type: "button" }, tr("Compare"));
  let turn = 0;
  const show = async () => {
    const own = ++turn;
    let shown: HTMLElement[];
    try {
      shown = area.value.trim() ? await ask(area.value) : [];
    } catch (error) {
      shown = [problem(error)];
    }
    if (own === turn) preview.replaceChildren(...shown);
  };
  for (const field of fields) field.addEventListener("change", () => void show());
  read.addEventListener("click", () => void once(read, show()));
  area.addEventListener("paste", () => setTimeout(() => void show()));
  for (const kind of ["input", "change"])
    area.addEventListener(kind, (event) => event.stopPropagation()); // not typed into a form around it
  return make(
    "details",
    { class: "pasting" },
    make("summary", {}, tr(title)),
    field(tr(label), area),
    make(
      "div",
      { class: "form" },
      ...fields.map((select, k) => field(tr(labels[k]!), select)),
      read,
    ),
    preview,
  );
}

const [WIDE, HIGH, LEFT, ABOVE, BELOW, EDGE] = [340, 200, 44, 18, 30, 8]; // of the picture of two curves

/** Two curves in one picture with the ends of its axes: the present one and the pasted one. */
function curves(
  over: "deflection" | "velocity",
  before: [number[], number[]],
  after: [number[], number[]],
): HTMLElement {
  const all = [0, 1].map((k) => [...before[k]!, ...after[k]!]);
  const [x0 = 0, x1 = 1, y0 = 0, y1 = 1] = all.flatMap((values) => [
    Math.min(...values),
    Math.max(...values),
  ]);
  const [right, bottom] = [WIDE - EDGE, HIGH - BELOW];
  const x = (at: number) => LEFT + ((right - LEFT) * (at - x0)) / (x1 - x0 || 1),
    y = (at: number) => bottom - ((bottom - ABOVE) * (at - y0)) / (y1 - y0 || 1);
  const path = ([over, force]: [number[], number[]]) =>
    line(over.map((at, k) => [x(at), y(force[k]!)]));
  const [unit, factor] = over === "deflection" ? ["mm", MM] : ["m/s", 1];
  const text = (x: number, y: number, anchor: string, words: string) => {
    const label = svg("text", { x, y, "text-anchor": anchor });
    label.textContent = words;
    return label;
  };
  const zero = (ends: Record<string, number>) => svg("line", { class: "zero", ...ends });
  const picture = svg("svg", {
    viewBox: `0 0 ${WIDE} ${HIGH}`,
    class: "spark pair",
    role: "img",
    "aria-label": tr("present and pasted curve"),
  });
  picture.append(
    ...(x0 < 0 && x1 > 0 ? [zero({ x1: x(0), x2: x(0), y1: ABOVE, y2: bottom })] : []),
    ...(y0 < 0 && y1 > 0 ? [zero({ x1: LEFT, x2: right, y1: y(0), y2: y(0) })] : []),
    svg("rect", { class: "frame", x: LEFT, y: ABOVE, width: right - LEFT, height: bottom - ABOVE }),
    svg("path", { class: "was", d: path(before) }),
    svg("path", { d: path(after) }),
    text(LEFT, bottom + 12, "start", written(factor * x0, 3)),
    text(right, bottom + 12, "end", written(factor * x1, 3)),
    text((LEFT + right) / 2, bottom + 24, "middle", `${key(over)} [${unit}]`),
    text(LEFT - 4, ABOVE + 8, "end", written(y1, 3)),
    text(LEFT - 4, bottom, "end", written(y0, 3)),
    text(LEFT, ABOVE - 6, "start", `${key("force")} [N]`),
  );
  const figure = make("figure", {});
  figure.append(
    picture,
    make("figcaption", { class: "muted" }, tr("solid: pasted; dashed: present")),
  );
  return figure;
}

interface PastedCurve {
  over: number[];
  force: number[];
  columns: [string, string];
  units: [string, string];
  is_unit_stated: boolean;
  before: [number[], number[]];
}

/** A table of a force over deflection or velocity; `take` hears the curve in SI. */
export function pasteCurve(
  over: "deflection" | "velocity",
  before: [unknown, unknown],
  take: (over: number[], force: number[]) => void,
): HTMLDetailsElement {
  const lengths = over === "deflection" ? ["mm", "m", "cm", "inch"] : ["m/s", "mm/s", "inch/s"];
  const stated = (text: string) => text || tr("as in the table");
  const unit = select(["", ...lengths], "", stated),
    force = select(["", "N", "kN", "kgf", "lbf"], "", stated),
    turned = make(
      "select",
      {},
      ...[
        ["", "neither"],
        ["over", key(over)],
        ["force", "force"],
        ["both", "both"],
      ].map(([value, words]) => make("option", { value: value! }, tr(words!))),
    );
  return fold(
    "Paste a curve from a table",
    "Two columns copied from a spreadsheet, compression positive",
    over === "deflection" ? "deflection [mm]\tforce [N]" : "velocity [mm/s]\tforce [N]",
    [unit, force, turned],
    ["Unit of the first column", "Unit of the force", "Reverse the sign of"],
    async (table) => {
      const answer = await api.asked("POST", "/api/curve", {
        table,
        over,
        over_unit: unit.value,
        force_unit: force.value,
        turned: turned.value,
        before,
      });
      const curve = (await answer.json()) as PastedCurve;
      const go = make(
        "button",
        { type: "button", class: "main" },
        tr("Take # rows", String(curve.over.length)),
      );
      go.addEventListener("click", () => take(curve.over, curve.force));
      return [
        make(
          "p",
          {},
          tr(
            curve.is_unit_stated ? "Units: #." : "Units: #, the usual ones for such numbers.",
            curve.units.join(", "),
          ),
        ),
        curves(over, curve.before, [curve.over, curve.force]),
        make("p", { class: "bar" }, go),
      ];
    },
  );
}

interface PastedTrials {
  changes: { number: number; key: string; before: string; after: string }[];
  absent: number[];
  unlisted: number[];
  digest: string;
}
interface WrittenTrials {
  path: string;
  before: string;
  digest: string;
}

/** A table of trials for the trials of a campaign; `written` hears what undoes it. */
export function pasteTrials(
  path: string,
  written: (answer: WrittenTrials) => void,
): HTMLDetailsElement {
  const send = async (body: object) =>
    (await api.asked("POST", "/api/campaign/trials", { campaign: path, ...body })).json();
  return fold(
    "Paste the table of trials",
    "Number, speed, angle, pressure and profile of each trial, copied from a spreadsheet with its headings",
    "trial\tspeed [m/s]\tpressure [MPa]\tprofile",
    [],
    [],
    async (text) => {
      const trials = (await send({ table: text })) as PastedTrials;
      const go = make(
          "button",
          { type: "button", class: "main", disabled: !trials.changes.length },
          tr("Write # changes into the campaign", String(trials.changes.length)),
        ),
        status = make("div", { "aria-live": "polite" });
      go.addEventListener("click", () => {
        once(go, send({ table: text, was: trials.digest })).then(
          (answer) => written(answer as WrittenTrials),
          (error) => status.replaceChildren(problem(error)),
        );
      });
      const of = (words: string, numbers: number[]) =>
        numbers.length ? [make("p", { class: "muted" }, tr(words, numbers.join(", ")))] : [];
      return [
        ...(trials.changes.length
          ? [
              table(
                "changed trials",
                ["trial", "field", "before", "after"],
                trials.changes.map((change) => [
                  String(change.number),
                  key(change.key),
                  inField(change.before) || "–",
                  inField(change.after),
                ]),
              ),
            ]
          : [make("p", { class: "good" }, tr("The campaign says the same."))]),
        ...of("Not in the campaign, so left out: trial #", trials.absent),
        ...of("Not in the table, so unchanged: trial #", trials.unlisted),
        make("p", { class: "bar" }, go),
        status,
      ];
    },
  );
}
