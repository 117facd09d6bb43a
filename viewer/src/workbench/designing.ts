/** Hardpoints from targets: writes a study, searches as a job, and shows the designs found. */

import { make, written } from "../page";
import { isGerman, tr } from "../words";
import * as api from "./api";
import { numberBox } from "./numberbox";
import { field, once, problem, type Sliders, textBox } from "./parts";
import { part, quantity as quantityOf, shownUnit } from "./quantities";
import { Refused } from "./refusals";
import { table } from "./table";

export interface Target {
  quantity: string;
  value?: string;
  at_least?: string;
  at_most?: string;
  tolerance: string;
  at?: string;
  over?: string;
  along?: string;
}
/** A target with the values that the best design reaches, in SI. */
interface Reached {
  quantity: string;
  unit: string;
  before: number[];
  after: number[];
  met: boolean;
}
interface Found {
  id: string;
  state: string;
  said: string;
  said_german: string | null;
  share: number | null;
  left: number | null;
  lasted: number | null;
  report: string;
  error: string | null;
  german: string | null;
  result: unknown;
}

const job = (id: string) => api.get<Found>(`/api/jobs/${encodeURIComponent(id)}`);

/** What each target had and has, from its least to its greatest value. */
function targetTable(targets: Reached[]): HTMLElement {
  const range = (values: number[], factor: number) => {
    const ends = [Math.min(...values), Math.max(...values)].map((end) => written(end * factor, 4));
    return [...new Set(ends)].join(" … ");
  };
  return table(
    tr("Targets"),
    ["target", "before", "after", "unit", "state"],
    targets.map(({ quantity, unit, before, after, met }) => {
      const [shown, factor]: [string, number] = unit.startsWith("rad")
        ? [unit.replace("rad", "°"), 180 / Math.PI]
        : shownUnit(unit);
      return [
        quantityOf(quantity),
        range(before, factor),
        range(after, factor),
        shown,
        tr(met ? "met" : "missed"),
      ];
    }),
    [1, 2],
  );
}

/** A search for hardpoints that meet the targets, as a job: progress, results, and applying a design. */
export function designing(
  name: string,
  rig: api.Rig,
  targets: Target[],
  sliders: Sliders,
  take: (changes: Record<string, number>) => void,
): HTMLElement {
  const names = [
    ...new Set(
      rig.numbers
        .map(({ path }) => /^(hardpoints\.\w+)\[/.exec(path)?.[1])
        .filter((text): text is string => !!text && !text.endsWith("wheel_centre")),
    ),
  ];
  const boxes = names.map((name) =>
    make("input", { type: "checkbox", value: name, checked: /tie_rod|link_5/.test(name) }),
  );
  const within = textBox("15 mm"),
    starts = numberBox({ min: "1", max: "100", value: "4" }),
    out = make("div", { "aria-live": "polite" });
  const begin = make("button", { type: "submit", class: "main" }, tr("Search"));
  const form = make(
    "form",
    {},
    make(
      "fieldset",
      { class: "free" },
      make("legend", {}, tr("Hardpoints that may move")),
      ...boxes.map((box, i) =>
        make("label", {}, box, ` ${part(names[i]!.replace("hardpoints.", ""))}`),
      ),
    ),
    make(
      "div",
      { class: "form" },
      field(tr("Largest move per coordinate"), within),
      field(tr("Searches"), starts),
      begin,
    ),
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const free = boxes.filter((box) => box.checked).map((box) => box.value);
    if (!targets.length || !free.length) {
      out.replaceChildren(
        make(
          "p",
          { class: "muted" },
          tr("Add a target above and choose a hardpoint that may move."),
        ),
      );
      return;
    }
    void once(
      begin,
      search(free, { ...sliders.changes }, within.value, Number(starts.value) || 4, [...targets]),
    ).catch((error) => out.replaceChildren(problem(error)));
  });

  /** Searches with the state at the time of the request, whatever is edited meanwhile. */
  async function search(
    free: string[],
    changes: Record<string, number>,
    within: string,
    starts: number,
    targets: Target[],
  ): Promise<void> {
    const stem = name.replace(/\.toml$/, "").replaceAll("/", "-"),
      mark = new Date().toISOString().replace(/\D/g, "").slice(2, 14),
      study = `designs/${stem}-${mark}.toml`;
    const quoted = (text: string) => JSON.stringify(text),
      file = await api.file(name),
      now = await api.form(name, file.text, [], changes);
    if (now.problems.length)
      throw new Error(
        now.problems
          .map((problem) => `${problem.path ? `${problem.path}: ` : ""}${problem.text}`)
          .join(" "),
      ); // its text is that of the file then
    const start = `designs/${stem}-${mark}-start.toml`;
    await api.save(start, now.text, ""); // the rig as it stands on the page
    const text = [
      `schema = "jounce.design/1"`,
      `rig = ${quoted(`${stem}-${mark}-start.toml`)}`,
      `starts = ${starts}`,
      "",
      ...free.flatMap((text) => [
        "[[free]]",
        `point = ${quoted(text)}`,
        `within = ${quoted(within)}`,
        "",
      ]),
      ...targets.flatMap((target) => [
        "[[target]]",
        ...Object.entries(target).map(([key, value]) => `${key} = ${quoted(String(value))}`),
        "",
      ]),
    ].join("\n");
    await api.save(study, text, "");
    const begun = (await (
      await api.asked("POST", "/api/jobs", {
        kind: "design",
        study,
        out: `designs/${stem}-${mark}`,
      })
    ).json()) as Found;
    const bar = make("progress", { max: "1", "aria-label": tr("progress") }),
      said = make("span", {}),
      cancel = make("button", { type: "button" }, tr("Cancel"));
    cancel.addEventListener("click", () => {
      once(cancel, api.asked("POST", `/api/jobs/${encodeURIComponent(begun.id)}/cancel`, {})).catch(
        (error) => out.append(problem(error)),
      );
    });
    out.replaceChildren(make("p", { class: "bar" }, bar, said, cancel));
    for (;;) {
      const result = await job(begun.id);
      if (!out.isConnected) return;
      if (result.share === null) bar.removeAttribute("value");
      else bar.value = result.share;
      said.textContent = [
        (isGerman && result.said_german) || tr(result.said),
        `${written(result.lasted ?? 0, 2)} s`,
        result.left ? tr("# s left", written(result.left, 2)) : "",
      ]
        .filter(Boolean)
        .join(", ");
      if (result.state === "done") {
        results(result);
        return;
      }
      if (!["running", "cancelling"].includes(result.state)) {
        out.replaceChildren(
          problem(
            result.error
              ? new Refused(result.error, result.german)
              : new Error(tr("The search was stopped.")),
          ),
        );
        return;
      }
      await new Promise((later) => setTimeout(later, 400));
    }
  }

  function results(outcome: Found): void {
    const result = outcome.result as {
      met: boolean;
      moved: Record<string, { before: number; after: number }>;
      targets: Reached[];
      starts: {
        start: number;
        met: boolean;
        cost: number | null;
        travelled: number | null;
        ended: string;
        numbers: Record<string, number>;
      }[];
    };
    const button = make("button", { type: "button", class: "main" }, tr("Apply the best design"));
    button.addEventListener("click", () =>
      take(
        Object.fromEntries(Object.entries(result.moved).map(([path, one]) => [path, one.after])),
      ),
    );
    const other = (start: number, moved: Record<string, number>) => {
      // any search that ended in a rig, not the best alone
      if (!Object.keys(moved).length) return "";
      const taking = make(
        "button",
        { type: "button", "aria-label": tr("Apply the design of search #", String(start)) },
        tr("Apply"),
      );
      taking.addEventListener("click", () => take(moved));
      return taking;
    };
    const numbers = new Map(rig.numbers.map((parameter) => [parameter.path, parameter]));
    out.replaceChildren(
      make(
        "p",
        { class: result.met ? "good" : "problem" },
        result.met
          ? tr("Every target is met.")
          : `${tr("Targets missed: #.", String(result.targets.filter((target) => !target.met).length))} ${tr(
              "Allow a larger move, let more hardpoints move, or widen the tolerance.",
            )}`,
      ),
      targetTable(result.targets),
      table(
        "searches",
        [
          "search",
          "targets",
          "cost (error/tolerance)²",
          "share of allowed movement used",
          "outcome",
          "",
        ],
        result.starts.map((start) => [
          String(start.start),
          start.met ? tr("met") : tr("missed"),
          written(start.cost, 3),
          written(start.travelled, 2),
          tr(start.ended),
          other(start.start, start.numbers),
        ]),
        [2, 3],
      ),
      table(
        "moved hardpoints",
        ["parameter", "before", "after", "unit"],
        Object.entries(result.moved).map(([path, one]) => {
          const { factor = 1, unit = "" } = numbers.get(path) ?? {};
          return [path, written(one.before * factor, 5), written(one.after * factor, 5), unit];
        }),
        [1, 2],
      ),
      make(
        "p",
        { class: "bar" },
        button,
        make("a", { href: outcome.report, target: "_blank" }, tr("Report")),
      ),
    );
  }
  return make("div", {}, form, out);
}
