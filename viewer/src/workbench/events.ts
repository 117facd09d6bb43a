/** Notes at places of recordings, and a note on the whole layout. */

import type { Flag } from "../cursors";
import { make, written } from "../page";
import { tr } from "../words";
import { fill } from "./filled";
import type { Laid } from "./laid";
import type { Event } from "./layout";
import { field, textBox } from "./parts";

export class EventList {
  private readonly text = textBox("", tr("kerb, gear change, sensor lost …"));
  private readonly of = make("select", {});
  private readonly list = make("ul", { class: "events" });
  private readonly note = make("textarea", { rows: "3", "aria-label": tr("Notes on this layout") });
  readonly element: HTMLElement;

  constructor(
    private readonly laid: Laid,
    private readonly goTo: (at: number) => void,
  ) {
    this.text.addEventListener("keydown", (event) => {
      if (event.key === "Enter") this.add();
    });
    this.note.addEventListener("change", () => {
      laid.layout.note = this.note.value;
      laid.changed();
    });
    this.element = make(
      "section",
      {},
      make("h2", {}, tr("Events and notes")),
      make(
        "div",
        { class: "form" },
        field(tr("Event at cursor A"), this.text),
        field(tr("of"), this.of),
        make("button", { type: "button", click: () => this.add() }, tr("Add the event")),
      ),
      this.list,
      make("label", { class: "field" }, make("span", {}, tr("Notes on this layout")), this.note),
    );
  }

  /** The events of the present axis on the common axis; those of a recording move with it. */
  get flags(): Flag[] {
    const { layout } = this.laid;
    return layout.events
      .filter(({ axis }) => axis === layout.axis)
      .flatMap((event) => {
        const at = this.place(event);
        return at === null ? [] : [{ at, text: event.text }];
      });
  }

  private place({ recording, at }: Event): number | null {
    const { layout } = this.laid;
    if (!recording) return at;
    const laid = layout.recordings.find(({ path }) => path === recording);
    return laid ? at + (laid.shifts[layout.axis] ?? 0) : null;
  }

  show(): void {
    const { layout, unit } = this.laid,
      before = this.of.value;
    this.of.replaceChildren(
      make("option", { value: "" }, tr("the common axis")),
      ...layout.recordings.map(({ path }) => make("option", { value: path }, path)),
    );
    this.of.value = layout.recordings.some(({ path }) => path === before)
      ? before
      : (layout.recordings[0]?.path ?? "");
    if (document.activeElement !== this.note) this.note.value = layout.note;
    fill(
      this.list,
      ...layout.events.map((event, k) => {
        const at = event.axis === layout.axis ? this.place(event) : null;
        const remove = make(
          "button",
          { type: "button", class: "small", "aria-label": tr("remove #", event.text) },
          "×",
        );
        remove.addEventListener("click", () => {
          layout.events.splice(k, 1);
          this.laid.changed();
        });
        return make(
          "li",
          {},
          ...(at === null
            ? [make("span", { class: "muted" }, `${event.axis} ${written(event.at, 6)}`)]
            : [
                make(
                  "button",
                  { type: "button", click: () => this.goTo(at) },
                  `${written(at, 6)} ${unit}`,
                ),
              ]),
          make("span", {}, event.text),
          make("small", { class: "muted" }, event.recording),
          remove,
        );
      }),
    );
    this.element.hidden = !layout.recordings.length;
  }

  private add(): void {
    const { layout } = this.laid,
      text = this.text.value.trim();
    if (!text || !layout.cursors) {
      this.text.focus();
      return;
    }
    const laid = layout.recordings.find(({ path }) => path === this.of.value);
    layout.events.push({
      at: Number((layout.cursors[0] - (laid?.shifts[layout.axis] ?? 0)).toPrecision(9)),
      text,
      recording: laid?.path ?? "",
      axis: layout.axis,
    });
    this.text.value = "";
    this.laid.changed();
  }
}
