/** Comparing more than two: a choice of what is shown beside the open rig, and a table of what differs. */

import { make } from "../page";
import { tr, withComma } from "../words";
import { table } from "./table";

/** What differs, as cells: path, unit and the value of each. */
export interface Differences {
  names: string[];
  rows: string[][];
  /** What the rows are, if not the differences. */
  title?: string;
}
type Option = [value: string, words: string];

/** A menu of check boxes in groups; at most `most` can be checked. */
export class Against {
  readonly element: HTMLElement;
  private readonly boxes: HTMLInputElement[] = [];
  private readonly summary = make("summary", {});
  private readonly note = make("p", { class: "muted" });
  private readonly choices = make("div", { class: "choices", role: "group" });

  constructor(
    label: string,
    groups: [words: string, options: Option[]][],
    private readonly changed: () => void,
    private readonly most = 5,
  ) {
    const menu = make("details", { class: "against" }, this.summary);
    this.choices.setAttribute("aria-label", label);
    for (const [words, options] of groups)
      if (options.length)
        this.choices.append(
          make("fieldset", {}, make("legend", {}, words), ...options.map((one) => this.box(one))),
        );
    this.choices.append(this.note);
    menu.append(this.choices);
    menu.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !menu.open) return;
      event.stopPropagation();
      menu.open = false;
      this.summary.focus();
    });
    menu.addEventListener("focusout", (event) => {
      if (event.relatedTarget && !menu.contains(event.relatedTarget as Node)) menu.open = false;
    });
    this.element = make("div", { class: "field" }, make("span", {}, label), menu);
    this.tell();
  }

  private box([value, said]: Option): HTMLElement {
    const box = make("input", { type: "checkbox", value });
    box.addEventListener("change", () => {
      this.tell();
      this.changed();
    });
    this.boxes.push(box);
    return make("label", {}, box, make("span", {}, said));
  }

  /** Offers another choice, first of all, and takes it if there is room. */
  add(option: Option): void {
    this.choices.prepend(this.box(option));
    this.values = [option[0], ...this.values].slice(0, this.most);
    this.changed();
  }

  get values(): string[] {
    return this.boxes.filter((box) => box.checked).map((box) => box.value);
  }

  set values(wanted: readonly string[]) {
    for (const box of this.boxes) box.checked = wanted.includes(box.value);
    this.tell();
  }

  /** Says what is chosen, and closes what cannot be chosen beside it. */
  private tell(): void {
    const chosen = this.boxes.filter((box) => box.checked),
      isFull = chosen.length >= this.most;
    const [first] = chosen;
    this.summary.textContent =
      chosen.length > 1
        ? tr("# chosen", String(chosen.length))
        : first
          ? first.nextElementSibling!.textContent
          : tr("nothing");
    for (const box of this.boxes) box.disabled = isFull && !box.checked;
    this.note.textContent = isFull
      ? tr("No more than # at once: the curves stay readable.", String(this.most))
      : "";
    this.note.hidden = !isFull;
  }
}

/** A folded table of what differs; it is made anew only if its content has changed. */
export class Differing {
  readonly element = make("details", { class: "differing", hidden: true });
  private readonly summary = make("summary", {});
  private readonly place = make("div", {});
  private was = "";

  constructor(isOpen = false) {
    this.element.open = isOpen;
    this.element.append(this.summary, this.place);
  }

  show(differences: Differences | null): void {
    this.element.hidden = !differences;
    const now = JSON.stringify(differences);
    if (!differences || now === this.was) return;
    this.was = now;
    const { names, rows } = differences,
      title = tr(differences.title ?? "What differs");
    this.summary.textContent = `${title} (${rows.length})`;
    this.place.replaceChildren(
      rows.length
        ? table(
            title,
            ["parameter", "unit", ...names],
            rows.map(([path = "", unit = "", ...values]) => [
              tr(path),
              unit || "–",
              ...values.map((value) => (/^[−\d]/.test(value) ? withComma(value) : value)),
            ]),
            names.map((_, k) => k + 2),
          )
        : make("p", { class: "muted" }, tr("All values are equal.")),
    );
  }
}
