/** Components of the pages. */

import { type Model, Store } from "../data";
import { make, written } from "../page";
import type { Player } from "../player";
import { tr } from "../words";
import type { Answer, OfRig, Rig, RigNumber } from "./api";
import { pinnedCurves, savable } from "./curves";
import { mayLeave } from "./drafts";
import { numberBox } from "./numberbox";
import { inWords } from "./quantities";

export { problem } from "./refusals";

export function field(label: string, control: HTMLElement, note = ""): HTMLLabelElement {
  return make(
    "label",
    { class: "field" },
    make("span", {}, label),
    control,
    ...(note ? [make("small", {}, note)] : []),
  );
}

/** A field for a short text without spell checking. */
export function textBox(value = "", placeholder = ""): HTMLInputElement {
  const box = make("input", { type: "text", value, placeholder, spellcheck: "false" });
  keepUnit(box);
  return box;
}

/** Gives a number that is typed without a unit the unit that the field had, or that of its example, and shows it. */
function keepUnit(box: HTMLInputElement): void {
  const unitOf = (text: string) => /^[-+\d.,]+\s+([^\d\s][^\s:]*)$/.exec(text.trim())?.[1];
  let unit = unitOf(box.value) ?? unitOf(box.placeholder.split(", ").pop()!);
  box.addEventListener("change", () => {
    if (unit && /^[-+]?(\d+([.,]\d*)?|[.,]\d+)$/.test(box.value.trim()))
      box.value = `${box.value.trim()} ${unit}`;
    unit = unitOf(box.value) ?? unit;
  });
}

/** A choice between values, shown as they are or in `words`; the first is selected by default. */
export function select(
  values: readonly string[],
  chosen?: string,
  words: (value: string) => string = (value) => value,
): HTMLSelectElement {
  return make(
    "select",
    {},
    ...values.map((value) => make("option", { value, selected: value === chosen }, words(value))),
  );
}

/** A choice that may stay empty; `none` is the text of the empty option. */
export const optional = (none: string, values: readonly string[]): HTMLSelectElement =>
  select(["", ...values], "", (value) => tr(value || none));

/** Disables a button while its work runs, so that a second press starts nothing. */
export function once<T>(button: HTMLButtonElement, work: Promise<T>): Promise<T> {
  button.disabled = true;
  return work.finally(() => {
    button.disabled = false;
  });
}

/** Lines that a save would change in a file, to be seen before it is written. */
export function difference(
  changed: readonly string[],
  yes: HTMLButtonElement,
  no: HTMLButtonElement,
  ...notes: HTMLElement[]
): HTMLElement {
  const title = tr("Changes to the file"),
    kinds = { "+": "added", "-": "removed", "@": "muted" } as Record<string, string>;
  return make(
    "section",
    { class: "difference", "aria-label": title },
    make("h2", {}, title),
    ...notes,
    make(
      "pre",
      { tabindex: "0", "aria-label": title },
      ...changed.map((line) => make("span", { class: kinds[line[0] ?? ""] ?? "" }, `${line}\n`)),
    ),
    make("div", { class: "bar" }, yes, no),
  );
}

/** A text that can be copied. */
export function copied(title: string, text: string): HTMLElement {
  const button = make("button", { type: "button" }, tr("Copy")),
    place = make("pre", { tabindex: "0", "aria-label": title }, text);
  button.addEventListener("click", () => {
    const copies =
      navigator.clipboard?.writeText(place.textContent) ??
      Promise.reject(new Error("no clipboard")); // only a page of this machine has one, or of https
    void copies.then(
      () => {
        button.textContent = tr("Copied");
      },
      () => {
        getSelection()?.selectAllChildren(place);
        button.textContent = tr("Selected: copy it");
      },
    );
  });
  return make(
    "section",
    { class: "code" },
    make("div", { class: "bar" }, make("h2", {}, title), button),
    place,
  );
}

/** The same in Python and on the command line, with the files of both, to copy. */
export function snippets(same: Answer): HTMLElement {
  return make("div", { class: "ways" }, ...copies(same));
}

function copies({ python, command, files = {} }: Answer): HTMLElement[] {
  return [
    ...(python ? [copied(tr("The same in Python"), python)] : []),
    ...(command ? [copied(tr("The same on the command line"), command)] : []),
    ...Object.entries(files).map(([name, content]) => copied(name, content)),
  ];
}

/** Warns if an answer is based on another version of the rig's file than the page. */
export class Outdated {
  readonly element = make("div", { "aria-live": "polite" });
  constructor(private readonly rig: Rig) {}
  show({ digest }: OfRig): void {
    if (digest === this.rig.digest) {
      this.element.replaceChildren();
      return;
    }
    if (this.element.firstChild) return;
    const again = make("button", { type: "button" }, tr("Reload"));
    again.addEventListener("click", () => {
      if (mayLeave()) dispatchEvent(new HashChangeEvent("hashchange"));
    });
    this.element.append(
      make(
        "p",
        { class: "problem" },
        tr(
          "# has changed: the curves show the file as it is now, the parameters on this page do not.",
          this.rig.name,
        ),
      ),
      make("div", { class: "bar" }, again),
    );
  }
}

/** Snippets of curves that change often: only their texts are replaced. */
export class LiveSnippets {
  readonly element = make("div", { class: "ways" });
  show({ python, command, files }: Answer): void {
    const texts = [python, ...(command ? [command] : []), ...Object.values(files)],
      places = this.element.querySelectorAll("pre");
    if (places.length === texts.length)
      places.forEach((place, i) => {
        if (place.textContent !== texts[i]) place.textContent = texts[i]!;
      });
    else this.element.replaceChildren(...copies({ python, command, files }));
  }
}

/** Runs one request at a time, and then only the newest waiting one. */
export class Newest {
  private busy = false;
  private next: (() => Promise<void>) | null = null;
  async ask(question: () => Promise<void>): Promise<void> {
    this.next = question;
    if (this.busy) return;
    this.busy = true;
    try {
      while (this.next) {
        const now: () => Promise<void> = this.next;
        this.next = null;
        await now();
      }
    } finally {
      this.busy = false;
    }
  }
}

/** Runs all tasks one after the other, so that no edit is lost while an answer is slow. */
export class InTurn {
  private last = Promise.resolve();
  /** Number of unfinished tasks. */
  waiting = 0;
  /** `rested` is called when nothing waits any more. */
  constructor(
    private readonly refused: (error: unknown) => void,
    private readonly rested: () => Promise<void> | void = () => {},
  ) {}
  do(work: () => Promise<void>): Promise<void> {
    this.waiting++;
    this.last = this.last
      .then(work)
      .catch(this.refused)
      .then(() => {
        if (!--this.waiting) return this.rested();
      })
      .catch(this.refused);
    return this.last;
  }
}

/** Undo and redo of the entries; edits without a pause are one step. `put` restores a state. */
export class Steps<T> {
  private readonly past: string[] = [];
  private future: string[] = [];
  private now: string;
  private timer = 0;
  private readonly undo = make("button", { type: "button", disabled: true }, tr("Undo"));
  private readonly redo = make("button", { type: "button", disabled: true }, tr("Redo"));
  readonly element = make("div", { class: "bar" }, this.undo, this.redo);

  /** Ctrl+Z and Ctrl+Y below `root` do the same, but in a text that is being typed. */
  constructor(
    private readonly state: () => T,
    private readonly put: (state: T) => void,
    root: HTMLElement,
  ) {
    this.now = JSON.stringify(state());
    this.undo.addEventListener("click", () => this.back());
    this.redo.addEventListener("click", () => this.forth());
    for (const text of ["input", "change", "click", "pointerup"])
      root.addEventListener(text, () => this.changed());
    root.addEventListener("keydown", (event) => {
      const isTyped =
        event.target instanceof HTMLInputElement &&
        event.target.type !== "range" &&
        event.target.type !== "checkbox";
      if (!(event.ctrlKey || event.metaKey) || isTyped) return;
      if (event.key === "z" && !event.shiftKey) {
        event.preventDefault();
        this.back();
      }
      if (event.key === "y" || (event.key === "Z" && event.shiftKey)) {
        event.preventDefault();
        this.forth();
      }
    });
  }

  /** Takes what `change` does as part of the step before, so that Undo never stops between both. */
  amend(change: () => void): void {
    this.take();
    change();
    this.now = JSON.stringify(this.state());
  }

  /** Notes a possible change; it becomes a step after a pause. */
  changed(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.take(), PAUSE);
  }

  private take(): void {
    clearTimeout(this.timer);
    const state = JSON.stringify(this.state());
    if (state !== this.now) {
      this.past.push(this.now);
      this.future = [];
      this.now = state;
    }
    for (const [one, other, lies] of [
      [this.undo, this.redo, this.past],
      [this.redo, this.undo, this.future],
    ] as const) {
      if (!lies.length && one === document.activeElement) {
        other.disabled = false;
        other.focus();
      } // the keyboard goes on from there
      one.disabled = !lies.length;
    }
  }

  private back(): void {
    this.take();
    this.step(this.past, this.future);
  }
  private forth(): void {
    this.take();
    this.step(this.future, this.past);
  }

  private step(from: string[], to: string[]): void {
    const state = from.pop();
    if (state === undefined) return;
    to.push(this.now);
    this.now = state;
    this.put(JSON.parse(state) as T);
    this.take();
  }
}

const PAUSE = 300; // ms

/** A path that breaks after its dots and underscores. */
const breakable = (path: string) =>
  path.split(/(?<=[._])/).flatMap((part) => [part, make("wbr", {})]);

/** Parameters of a rig as sliders from 50 % to 150 % of their value; only changes are sent. */
export class Sliders {
  readonly element = make("div", { class: "sliders" });
  readonly changes: Record<string, number> = {};
  private readonly rows = make("div", {});
  private readonly known = new Map<string, RigNumber>();

  constructor(
    rig: Rig,
    first: string[],
    private readonly moved: () => void,
    given: Record<string, number> = {},
  ) {
    const known = this.known;
    for (const parameter of rig.numbers) known.set(parameter.path, parameter);
    const choice = make(
      "select",
      { "aria-label": tr("another parameter") },
      make("option", { value: "" }, tr("another parameter …")),
    );
    const changed = rig.numbers.filter((parameter) => !parameter.is_constant);
    for (const [label, isChosen] of [
      [tr("springs, dampers, hardpoints"), true],
      [tr("masses, tyres and sizes"), false],
    ] as const) {
      const own = changed.filter((number) => number.is_chosen === isChosen);
      if (own.length)
        choice.append(
          make("optgroup", { label }, ...own.map(({ path }) => make("option", {}, path))),
        );
    }
    choice.addEventListener("change", () => {
      const number = known.get(choice.value);
      if (number) this.add(number);
      choice.value = "";
    });
    for (const path of first) {
      const number = known.get(path);
      if (number) this.add(number);
    }
    for (const [path, value] of Object.entries(given))
      if (Number.isFinite(value)) this.take(path, value);
    const back = make("button", { type: "button" }, tr("Reset all"));
    back.addEventListener("click", () => {
      this.reset();
      this.moved();
    });
    this.element.append(this.rows, make("div", { class: "bar" }, choice, back));
  }

  /** Puts all numbers back to what the rig says. */
  reset(): void {
    for (const path of Object.keys(this.changes)) delete this.changes[path];
    this.rows.querySelectorAll<HTMLInputElement>("input").forEach((element) => {
      element.value = element.defaultValue;
    });
  }

  /** Takes a number that was changed elsewhere (SI), and shows its slider. */
  take(path: string, value: number): void {
    const number = this.known.get(path);
    if (number) {
      this.add(number);
      this.set(path, value);
    }
  }

  /** Takes a number that was changed elsewhere (SI). */
  set(path: string, value: number): void {
    const number = this.known.get(path);
    if (!number) return;
    const shown = Number((value * number.factor).toPrecision(7)),
      row = this.rows.querySelector(`[data-path="${CSS.escape(path)}"]`);
    if (Math.abs(value - number.value) <= 1e-12 * Math.max(Math.abs(value), 1))
      delete this.changes[path];
    else this.changes[path] = value;
    row?.querySelectorAll("input").forEach((input) => {
      input.value = String(shown);
    });
  }

  private add(parameter: RigNumber): void {
    if (this.rows.querySelector(`[data-path="${CSS.escape(parameter.path)}"]`)) return;
    const shown = parameter.value * parameter.factor,
      reach = 0.5 * Math.abs(shown) || 1;
    const text = String(Number(shown.toPrecision(6)));
    const name = `${parameter.path} [${parameter.unit || "–"}]`;
    const slider = make("input", {
      type: "range",
      min: String(shown - reach),
      max: String(shown + reach),
      step: String(reach / 100),
      value: text,
      "aria-label": name,
    });
    const number = numberBox({
      step: "any",
      value: text,
      "aria-label": `${name}, ${tr("typed")}`,
    });
    const take = (value: string) => {
      const wanted = Number(value);
      if (value === "" || !Number.isFinite(wanted)) return;
      if (value === text) delete this.changes[parameter.path];
      else this.changes[parameter.path] = wanted / parameter.factor;
      this.moved();
    };
    slider.addEventListener("input", () => {
      number.value = String(Number(Number(slider.value).toPrecision(5)));
      take(number.value);
    });
    number.addEventListener("input", () => {
      slider.value = number.value;
      take(number.value);
    });
    this.rows.append(
      make(
        "div",
        { class: "slider", "data-path": parameter.path },
        make("span", { class: "name" }, ...breakable(parameter.path)),
        slider,
        number,
        make("span", { class: "unit" }, parameter.unit),
      ),
    );
  }
}

/** Curves that follow the inputs: one request at a time, the newest next; the last answer stays until the next. */
export class Live {
  readonly element = make("div", { class: "live" });
  private readonly state = make("p", { class: "state", role: "status" });
  private readonly place = make("div", {});
  private readonly same = new LiveSnippets();
  private player: Player | null = null;
  private busy = false;
  private again = false;
  /** Called with the content shown, and with the position on its axis under the cursor. */
  shown: ((model: Model, store: Store) => void) | null = null;
  moved: ((place: number) => void) | null = null;
  /** Milliseconds from a question to its curves. */
  readonly times: number[] = [];

  /** `question` is given the names of the channels whose numbers are wanted. */
  constructor(private readonly question: (channels: string[]) => Promise<ArrayBuffer>) {
    this.element.append(this.state, this.place, this.same.element);
  }

  async ask(): Promise<void> {
    this.again = this.busy;
    if (this.busy) return;
    this.busy = true;
    const began = performance.now();
    const waiting = setTimeout(() => {
      this.state.textContent = this.player
        ? tr("computing …")
        : tr("computing; the first run compiles the model, which takes a few seconds");
    }, 500);
    try {
      const store = inWords(Store.of(await this.question(this.player?.shown ?? pinnedCurves())));
      if (!this.element.isConnected) return;
      const model = store.content.viewers[0]!;
      if (this.player) this.player.replace(model, store);
      else {
        this.player = savable(model, store);
        this.place.replaceChildren(this.player.element);
        this.player.moved = (place) => this.moved?.(place);
        this.player.lacking = () => void this.ask();
      }
      this.shown?.(model, store);
      this.same.show(store.content as unknown as Answer);
      this.times.push(performance.now() - began);
      this.state.textContent = `${tr("computed and drawn in")} ${written(this.times[this.times.length - 1]!, 2)} ms`;
      this.state.classList.remove("problem");
    } catch (error) {
      this.state.textContent = error instanceof Error ? error.message : String(error);
      this.state.classList.add("problem");
    } finally {
      clearTimeout(waiting);
      this.busy = false;
      if (this.again && this.element.isConnected) void this.ask();
    }
  }
}
