/** The recordings of a layout: which are shown, and by how much each is shifted. */

import { make } from "../page";
import { tr } from "../words";
import { fill } from "./filled";
import { bring, choosers, type Given, store, takeDrops } from "./incoming";
import { extent, type Laid } from "./laid";
import { MOST_RECORDINGS } from "./layout";
import { numberBox } from "./numberbox";
import { unitText } from "./quantities";
import { problem } from "./refusals";

const FOLDER = "measured"; // of the project, where files that come in are stored

export const ROLES = ["after", "other-5", "other-1", "other-2", "other-3", "other-6"];

export class RecordingList {
  private readonly list = make("ul", { class: "recordings" });
  private readonly more = make("select", { "aria-label": tr("Add a recording") });
  private readonly wrong = make("div", { "aria-live": "polite" });
  private readonly hint = make(
    "p",
    { class: "muted" },
    tr(
      "Drop recordings anywhere on this page, choose them, or add one of the project. Saved runs of the page Trial are among them.",
    ),
  );
  readonly element = make(
    "section",
    {},
    make("h2", {}, tr("Recordings")),
    this.hint,
    this.list,
    this.more,
    choosers("", (files) => void this.take(files)),
    this.wrong,
  );

  constructor(
    private readonly laid: Laid,
    private readonly paths: string[],
  ) {
    takeDrops((files) => void this.take(files));
    this.more.addEventListener("change", () => {
      if (!this.more.value) return;
      laid.layout.recordings.push({ path: this.more.value, shown: true, shifts: {} });
      laid.changed();
    });
  }

  /** Stores files in the project and shows them; those that are no measurement, or too many, are listed as new files. */
  private async take(files: Given[]): Promise<void> {
    const { recordings } = this.laid.layout,
      room = MOST_RECORDINGS - recordings.length;
    if (files.length > room || files.some(({ path }) => path.endsWith(".toml"))) {
      bring(files);
      return;
    }
    this.wrong.replaceChildren();
    for (const file of files)
      try {
        const path = await store(file, FOLDER);
        if (!this.paths.includes(path)) this.paths.push(path);
        if (!recordings.some((recording) => recording.path === path))
          this.laid.layout.recordings.push({ path, shown: true, shifts: {} });
      } catch (error) {
        this.wrong.append(problem(error));
      }
    this.laid.changed();
  }

  show(): void {
    this.hint.hidden = this.laid.layout.recordings.length > 0;
    const { layout, tracks, unit } = this.laid,
      { recordings, axis } = layout;
    fill(
      this.list,
      ...recordings.map((recording, k) => {
        const track = tracks.find(({ path }) => path === recording.path);
        const shown = make("input", {
          type: "checkbox",
          checked: recording.shown,
          "aria-label": tr("show #", recording.path),
        });
        shown.addEventListener("change", () => {
          recording.shown = shown.checked;
          this.laid.changed();
        });
        const shift = numberBox({
          step: "any",
          value: String(recording.shifts[axis] ?? 0),
          "aria-label": tr("shift of #", recording.path),
        });
        shift.addEventListener("change", () => {
          const value = shift.valueAsNumber;
          if (!Number.isFinite(value)) shift.value = String(recording.shifts[axis] ?? 0);
          else {
            if (value === 0) delete recording.shifts[axis];
            else recording.shifts[axis] = value;
            this.laid.changed();
          }
        });
        const remove = make(
          "button",
          { type: "button", class: "small", "aria-label": tr("remove #", recording.path) },
          "×",
        );
        remove.addEventListener("click", () => {
          recordings.splice(k, 1);
          this.laid.changed();
        });
        return make(
          "li",
          {},
          make(
            "div",
            { class: "named" },
            make(
              "label",
              {},
              shown,
              recordings.length > 1 ? make("i", { class: `swatch ${ROLES[k]}` }) : "",
              make("b", {}, recording.path),
            ),
            remove,
          ),
          make(
            "small",
            { class: "muted" },
            track?.problem ? tr("not shown") : track ? extent(track, unit) : "",
          ),
          make("label", { class: "shift" }, `${tr("Shift")} `, shift, ` ${unitText(unit) || "–"}`),
        );
      }),
    );
    const others = this.paths.filter(
      (path) => !recordings.some((recording) => recording.path === path),
    );
    const isFull = recordings.length >= MOST_RECORDINGS;
    this.more.replaceChildren(
      make(
        "option",
        { value: "" },
        isFull
          ? tr("no more than # recordings", String(MOST_RECORDINGS))
          : others.length
            ? tr("Add a recording …")
            : tr("No other recording in this project"),
      ),
      ...(isFull ? [] : others.map((path) => make("option", { value: path }, path))),
    );
    this.more.disabled = isFull || !others.length;
  }
}
