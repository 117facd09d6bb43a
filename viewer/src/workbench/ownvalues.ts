/** Values of a laboratory for the rig of a new campaign: its masses first, any other number on request. */

import { make } from "../page";
import { tr, withComma } from "../words";
import * as api from "./api";
import type { Arrivals } from "./arrivals";
import { field, problem, textBox } from "./parts";
import { table } from "./table";

/** What every laboratory weighs or measures at its bench. */
const FIRST = /(^|[._])(mass|angle)$/;
const MOST_FIRST = 6;

export class OwnValues {
  readonly element = make("div", {});
  private readonly fields = make("span", { class: "sizes" });
  private readonly shown = make("div", { "aria-live": "polite" });
  private rig = "";
  private numbers: api.RigNumber[] = [];
  private asked: Promise<api.Rig> | null = null;

  /** `folder` is that of the new campaign. */
  constructor(
    private readonly arrivals: Arrivals,
    private readonly folder: () => string,
  ) {}

  /** Values to be entered, by path, as soon as the rig is known. */
  async entered(): Promise<Record<string, string>> {
    await this.asked;
    return this.changes;
  }

  private get changes(): Record<string, string> {
    const { values } = this.arrivals.list,
      known = new Set(this.numbers.map(({ path }) => path));
    return Object.fromEntries(
      Object.entries(values).filter(([path, value]) => known.has(path) && value),
    );
  }

  /** Offers the numbers of a rig; what was typed for those of the same name stays. */
  async offer(rig: string): Promise<void> {
    this.rig = rig;
    const asked = api.rig(rig);
    this.asked = asked;
    let numbers: api.RigNumber[];
    try {
      ({ numbers } = await asked);
    } catch (error) {
      if (asked === this.asked) this.element.replaceChildren(problem(error));
      return;
    }
    if (asked !== this.asked) return; // another one was chosen meanwhile
    this.numbers = numbers.filter((number) => !number.is_constant);
    const typed = this.changes,
      first = this.numbers.filter(({ path }) => FIRST.test(path)).slice(0, MOST_FIRST),
      others = this.numbers.filter((number) => !first.includes(number));
    const another = make(
      "select",
      { "aria-label": tr("another value of the rig") },
      make("option", { value: "" }, tr("another value of the rig …")),
      ...others.map(({ path }) => make("option", { value: path, disabled: path in typed }, path)),
    );
    another.addEventListener("change", () => {
      const number = others.find(({ path }) => path === another.value);
      if (!number) return;
      another.selectedOptions[0]!.disabled = true;
      another.value = "";
      const box = this.box(number);
      this.fields.append(box);
      box.querySelector("input")!.focus();
    });
    this.fields.replaceChildren(
      ...[...first, ...others.filter(({ path }) => path in typed)].map((number) =>
        this.box(number),
      ),
    );
    this.element.replaceChildren(
      ...(this.numbers.length
        ? [
            make("h3", {}, tr("Values of your laboratory")),
            make(
              "p",
              { class: "muted" },
              tr("Empty fields keep the value of the rig, which they show in grey."),
            ),
            make("div", { class: "form" }, this.fields, another),
            this.shown,
          ]
        : []),
    );
    await this.show();
  }

  private box({ path, value, unit, factor }: api.RigNumber): HTMLElement {
    const { values } = this.arrivals.list,
      usual = `${Number((value * factor).toPrecision(6))} ${unit}`.trim(),
      box = textBox(values[path] ?? "", withComma(usual));
    box.addEventListener("change", () => {
      values[path] = box.value.trim();
      if (!values[path]) delete values[path];
      this.arrivals.keep();
      void this.show();
    });
    return field(path, box);
  }

  /** Shows what the campaign will have instead of the rig's values, or why it cannot. */
  async show(): Promise<void> {
    const { changes, rig } = this,
      asked = JSON.stringify(changes);
    if (!Object.keys(changes).length) {
      this.shown.replaceChildren();
      return;
    }
    const shown = await api
      .asked("POST", "/api/campaign/values", { rig, changes })
      .then((answer) => answer.json() as Promise<{ path: string; before: string; after: string }[]>)
      .then(
        (rows) => [
          table(
            tr("Values of your laboratory"),
            ["value", "in the rig", "in the campaign"],
            rows.map(({ path, before, after }) => [path, withComma(before), withComma(after)]),
            [1, 2],
            tr("The rig is written with these values as #.", `${this.folder()}/rig.toml`),
          ),
        ],
        (error: unknown) => [problem(error)],
      );
    if (rig === this.rig && asked === JSON.stringify(this.changes))
      this.shown.replaceChildren(...shown);
  }
}
