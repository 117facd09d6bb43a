/** Writes changed numbers of a rig into its file, after showing what would change. */

import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { difference, field, once, problem, textBox } from "./parts";

type Changes = Record<string, number>;
type AsWritten = (path: string, value: number) => number;

/** A number as it is written to the file (SI): lengths to a micrometre, others with six digits. */
function asWritten(rig: api.Rig, path: string, value: number): number {
  const own = rig.numbers.find((parameter) => parameter.path === path);
  if (!own) return value;
  const shown = value * own.factor,
    text = own.unit === "mm" ? shown.toFixed(3) : shown.toPrecision(6);
  return Number((Number(text) / own.factor).toPrecision(12));
}

const allWritten = (rig: api.Rig, changes: Changes): Changes =>
  Object.fromEntries(
    Object.entries(changes).map(([path, value]) => [path, asWritten(rig, path, value)]),
  );

/** Saves a rig with its changes as another file of the project; `saved` hears its path. */
export function savingAs(
  rig: api.Rig,
  changes: () => Changes,
  saved: (path: string) => void,
): HTMLElement {
  const isOwn = rig.name.endsWith(".toml"),
    stem = rig.name
      .replace(/\.toml$/, "")
      .split("/")
      .pop()!,
    path = textBox(isOwn ? `${stem}-2.toml` : `${stem}.toml`),
    said = make("span", { "aria-live": "polite" }),
    button = make(
      "button",
      { type: "submit" },
      tr(isOwn ? "Save as a new file" : "Copy into this project"),
    );
  const form = make(
    "form",
    { class: "form" },
    field(tr("Name of the new file"), path),
    button,
    said,
  );
  const save = async (to: string): Promise<void> => {
    const now = allWritten(rig, changes());
    let file = isOwn ? await api.file(rig.name) : { ...(await api.start(rig.name, to)) };
    if (Object.keys(now).length) {
      const form = await api.form(isOwn ? rig.name : to, file.text, [], now);
      if (form.problems.length) throw form.problems[0]!;
      file = { ...file, text: form.text };
    } else if (!isOwn) return saved(to);
    await api.save(to, file.text, isOwn ? "" : file.digest);
    saved(to);
  };
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    said.replaceChildren();
    once(button, save(path.value.trim())).catch((error) => said.replaceChildren(problem(error)));
  });
  return form;
}

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

  private show(): void {
    const { name } = this.rig;
    const changes = allWritten(this.rig, this.changes());
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
                .then(() => this.saved(changes, (path, value) => asWritten(this.rig, path, value))),
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
