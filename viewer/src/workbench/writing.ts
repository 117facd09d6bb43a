/** Writes changed numbers of a rig into its file, after showing what would change. */

import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { difference, once, problem } from "./parts";

type Changes = Record<string, number>;
type AsWritten = (path: string, value: number) => number;

export class Writing {
  readonly element = make("div", {});
  private readonly button = make(
    "button",
    { type: "button" },
    tr("Save these changes to the file"),
  );
  private readonly review = make("div", {});
  private readonly said = make("span", { "aria-live": "polite" });

  /** `saved` hears what was written, and how numbers are written; changes made meanwhile stay. */
  constructor(
    private readonly rig: api.Rig,
    private readonly changes: () => Changes,
    private readonly saved: (changes: Changes, asWritten: AsWritten) => void,
  ) {
    this.button.addEventListener("click", () => this.show());
    this.element.append(make("p", { class: "bar" }, this.button, this.said), this.review);
  }

  say(text: string): void {
    this.said.textContent = text;
  }

  /** A number as it is written to the file (SI): lengths to a micrometre, others with six digits. */
  private readonly asWritten: AsWritten = (path, value) => {
    const own = this.rig.numbers.find((parameter) => parameter.path === path);
    if (!own) return value;
    const shown = value * own.factor,
      text = own.unit === "mm" ? shown.toFixed(3) : shown.toPrecision(6);
    return Number((Number(text) / own.factor).toPrecision(12));
  };

  private show(): void {
    const { name } = this.rig;
    const changes = Object.fromEntries(
      Object.entries(this.changes()).map(([path, value]) => [path, this.asWritten(path, value)]),
    );
    this.review.replaceChildren();
    this.said.replaceChildren();
    if (!Object.keys(changes).length) {
      this.say(tr("No changes to save."));
      return;
    }
    void once(
      this.button,
      (async () => {
        try {
          const file = await api.file(name),
            form = await api.form(name, file.text, [], changes);
          if (form.problems.length) throw new Error(form.problems[0]!.text);
          const yes = make("button", { type: "button", class: "main" }, tr("Write to the file")),
            no = make("button", { type: "button" }, tr("Back"));
          no.addEventListener("click", () => {
            this.review.replaceChildren();
            this.button.focus();
          });
          yes.addEventListener("click", () => {
            once(
              yes,
              api
                .save(name, form.text, file.digest)
                .then(() => this.saved(changes, this.asWritten)),
            ).catch((error) => this.said.replaceChildren(problem(error)));
          });
          this.review.replaceChildren(difference(form.changed, yes, no));
          yes.focus();
        } catch (error) {
          this.said.replaceChildren(problem(error));
        }
      })(),
    );
  }
}
