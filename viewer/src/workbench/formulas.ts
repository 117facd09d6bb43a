/** Computed channels of a layout: formulas with units, and what is wrong with them in each recording. */

import { make } from "../page";
import { tr } from "../words";
import { fill } from "./filled";
import type { Laid } from "./laid";
import type { Layout } from "./layout";
import { asSaid } from "./refusals";

const EXAMPLES: [formula: string, words: string][] = [
  ["derivative(lowpass(damper.displacement, '30 Hz'))", "damper velocity, filtered first"],
  ["integral(speed)", "distance"],
  ["speed * yaw_rate", "lateral acceleration"],
  ["sprung.az / '1 g'", "acceleration as a multiple of g"],
  ["where(speed > '10 km/h', steer, 0)", "steer angle while moving"],
  ["front_left.damper.displacement - front_right.damper.displacement", "roll of an axle"],
];
const FUNCTIONS =
  "abs sqrt exp log log10 sin cos tan asin acos atan atan2 sign min max clip where mean rms std minimum maximum first last derivative integral lowpass highpass bandpass smooth delay detrend";

/** A message without the recording that it begins with. */
const without = (path: string, text: string) =>
  text.startsWith(`${path}: `) ? text.slice(path.length + 2) : text;

export class FormulaList {
  private readonly list = make("ul", { class: "formulas" });
  private readonly other = make("select", { "aria-label": tr("Take the formulas of a layout") });
  readonly element: HTMLElement;
  private readonly said = new Map<string, HTMLElement>();
  private answered = new Set<string>();
  private isWaiting = false;

  constructor(
    private readonly laid: Laid,
    private readonly layouts: () => string[],
    private readonly read: (path: string) => Promise<Layout | null>,
  ) {
    this.other.addEventListener("change", () => void this.take());
    this.element = make(
      "section",
      {},
      make("h2", {}, tr("Computed channels")),
      this.list,
      make(
        "div",
        { class: "bar" },
        make("button", { type: "button", click: () => this.add() }, tr("Add a formula")),
        this.other,
      ),
      make(
        "details",
        {},
        make("summary", {}, tr("How formulas are written")),
        make(
          "p",
          { class: "muted" },
          tr(
            "Names of channels, + − * / **, comparisons and functions; quantities in quotes with their unit, names with spaces in `backquotes`. A formula may use those above it. Without a unit it has its SI unit.",
          ),
        ),
        make("p", { class: "muted" }, make("code", {}, FUNCTIONS)),
        make(
          "ul",
          {},
          ...EXAMPLES.map(([formula, words]) =>
            make("li", {}, make("code", {}, formula), ` ${tr(words)}`),
          ),
        ),
      ),
    );
  }

  /** Says of formulas without an answer that they are computed, until it comes. */
  wait(isWaiting: boolean): void {
    this.isWaiting = isWaiting;
    const { formulas } = this.laid.layout;
    if (!isWaiting) this.answered = new Set(formulas.map((formula) => JSON.stringify(formula)));
    for (const formula of formulas)
      this.said.get(formula.name)?.replaceChildren(...this.states(formula));
  }

  show(): void {
    const { formulas } = this.laid.layout;
    this.said.clear();
    fill(
      this.list,
      ...formulas.map((formula, k) => {
        const box = (
          key: "name" | "formula" | "unit",
          label: string,
          placeholder: string,
        ): HTMLInputElement => {
          const input = make("input", {
            type: "text",
            class: key,
            value: formula[key],
            placeholder,
            spellcheck: "false",
            "aria-label": tr(label, String(k + 1)),
          });
          input.addEventListener("change", () => {
            this.rename(key, formula.name, input.value.trim());
            formula[key] = input.value.trim();
            this.laid.changed();
          });
          return input;
        };
        const remove = make(
          "button",
          { type: "button", class: "small", "aria-label": tr("remove #", formula.name) },
          "×",
        );
        remove.addEventListener("click", () => {
          formulas.splice(k, 1);
          this.rename("name", formula.name, "");
          this.laid.changed();
        });
        const said = make("div", { "aria-live": "polite" }, ...this.states(formula));
        this.said.set(formula.name, said);
        return make(
          "li",
          {},
          make(
            "div",
            { class: "named" },
            box("name", "name of formula #", tr("name")),
            "=",
            box("formula", "formula #", "derivative(damper.displacement)"),
            box("unit", "unit of formula #", this.unit(formula.name) || tr("SI unit")),
            remove,
          ),
          said,
        );
      }),
    );
    const others = this.layouts();
    this.other.hidden = !others.length;
    this.other.replaceChildren(
      make("option", { value: "" }, tr("Take the formulas of a layout …")),
      ...others.map((path) => make("option", { value: path }, path)),
    );
  }

  private unit(name: string): string {
    for (const { formulas } of this.laid.tracks) {
      const state = formulas.find((formula) => formula.name === name);
      if (state?.unit) return state.unit;
    }
    return "";
  }

  /** What is wrong with a formula, or worth knowing; the same in all recordings is said once, without their names. */
  private states(formula: Layout["formulas"][number]): HTMLElement[] {
    if (this.isWaiting && !this.answered.has(JSON.stringify(formula)))
      return [make("p", { class: "computing" }, tr("computing …"))];
    const { tracks } = this.laid,
      said = new Map<string, { kind: string; german: string | null; paths: string[] }>();
    for (const { path, formulas } of tracks)
      for (const state of formulas) {
        if (state.name !== formula.name) continue;
        const texts = state.problem ? [state.problem, ...state.notes] : state.notes;
        for (const one of texts) {
          const text = without(path, one.text),
            kind = one === state.problem ? "problem" : "notice",
            german = one.german && without(path, one.german);
          const { paths } = said.get(text) ?? { paths: [] };
          said.set(text, { kind, german, paths: [...paths, path] });
        }
      }
    return [...said].map(([text, { kind, german, paths }]) =>
      make(
        "p",
        { class: kind },
        ...(paths.length < tracks.length ? [`${paths.join(", ")}: `] : []),
        asSaid(text, german),
      ),
    );
  }

  /** Graphs follow the name of a formula. */
  private rename(key: string, before: string, now: string): void {
    if (key !== "name" || before === now) return;
    const { layout } = this.laid;
    layout.graphs = layout.graphs
      .map(({ channels }) => ({
        channels: channels.flatMap((channel) =>
          channel !== before ? [channel] : now ? [now] : [],
        ),
      }))
      .filter(({ channels }) => channels.length);
  }

  private add(): void {
    const { formulas, graphs } = this.laid.layout,
      names = new Set([
        ...formulas.map(({ name }) => name),
        ...this.laid.tracks.flatMap(({ channels }) => channels.map(({ name }) => name)),
      ]);
    let count = 1;
    while (names.has(`computed_${count}`)) count++;
    const first = this.laid.tracks.flatMap(({ channels }) => channels)[0]?.name ?? "time";
    const name = `computed_${count}`;
    formulas.push({
      name,
      formula: /^[\p{L}_][\p{L}\p{N}_.]*$/u.test(first) ? first : `\`${first}\``,
      unit: "",
    });
    if (graphs.length < 12) graphs.push({ channels: [name] });
    this.laid.changed();
    this.list.querySelector<HTMLInputElement>("li:last-child .formula")?.focus();
  }

  private async take(): Promise<void> {
    const layout = await this.read(this.other.value),
      { formulas } = this.laid.layout;
    for (const formula of layout?.formulas ?? [])
      if (!formulas.some(({ name }) => name === formula.name)) formulas.push(formula);
    this.laid.changed();
  }
}
