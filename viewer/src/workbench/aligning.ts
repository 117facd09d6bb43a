/** Recordings brought onto one clock: by correlation of a channel, or by an event of it. */

import { make, written } from "../page";
import { tr } from "../words";
import * as api from "./api";
import type { Laid } from "./laid";
import { numberBox } from "./numberbox";
import { field, once, select } from "./parts";
import { unitText } from "./quantities";
import { problem } from "./refusals";

interface Aligned {
  shift: number;
  correlation: number | null;
  next_best: number | null;
  overlap: number;
  rate: number | null;
}

const WAYS: Record<string, string> = {
  correlation: "by correlation",
  rise: "at the first rise through a level",
  fall: "at the first fall through a level",
  maximum: "at the maximum",
  minimum: "at the minimum",
  start: "at the start",
};

export class Aligning {
  private readonly moved = select([]);
  private readonly reference = select([]);
  private readonly channel = select([]);
  private readonly by = select(Object.keys(WAYS), "correlation", (way) => tr(WAYS[way]!));
  private readonly level = numberBox({ step: "any", value: "0" });
  private readonly most = numberBox({ step: "any", min: "0" });
  private readonly said = make("p", { class: "state", role: "status" });
  private readonly levelField = field(tr("Level"), this.level);
  private readonly mostField = field(tr("Largest shift"), this.most, tr("empty: any"));
  readonly element: HTMLElement;

  constructor(private readonly laid: Laid) {
    const button = make("button", { type: "button" }, tr("Align"));
    button.addEventListener("click", () => void once(button, this.align()));
    this.by.addEventListener("change", () => this.fields());
    this.element = make(
      "details",
      { class: "aligning" },
      make("summary", {}, tr("Align two recordings")),
      field(tr("Shift"), this.moved),
      field(tr("onto"), this.reference),
      field(tr("How"), this.by),
      field(tr("Channel"), this.channel),
      this.levelField,
      this.mostField,
      make("div", { class: "bar" }, button),
      this.said,
    );
    this.fields();
  }

  private fields(): void {
    this.levelField.hidden = !["rise", "fall"].includes(this.by.value);
    this.mostField.hidden = this.by.value !== "correlation";
  }

  show(): void {
    const { layout, tracks } = this.laid,
      { recordings } = layout;
    this.mostField.querySelector("span")!.textContent =
      `${tr("Largest shift")} [${unitText(this.laid.unit) || "–"}]`;
    this.element.hidden = recordings.length < 2;
    const options = (
      place: HTMLSelectElement,
      entries: [value: string, words: string][],
      usual: number,
    ) => {
      const before = place.value;
      place.replaceChildren(...entries.map(([value, words]) => make("option", { value }, words)));
      place.value = entries.some(([value]) => value === before)
        ? before
        : (entries[usual]?.[0] ?? "");
    };
    const paths = recordings.map(({ path }, k): [string, string] => [String(k), path]);
    options(this.reference, paths, 0);
    options(this.moved, paths, 1);
    if (this.moved.value === this.reference.value && paths.length > 1)
      this.moved.value = this.reference.value === "0" ? "1" : "0";
    const names = [
      ...new Set([
        ...layout.graphs.flatMap(({ channels }) => channels),
        ...tracks.flatMap(({ channels }) => channels.map(({ name }) => name)),
      ]),
    ];
    options(
      this.channel,
      names.map((name) => [name, name]),
      0,
    );
  }

  private async align(): Promise<void> {
    const { layout } = this.laid,
      moved = Number(this.moved.value);
    this.said.classList.remove("problem");
    try {
      const answer = await api.asked("POST", "/api/data/align", {
        layout,
        reference: Number(this.reference.value),
        moved,
        channel: this.channel.value,
        by: this.by.value,
        ...(this.levelField.hidden ? {} : { level: this.level.valueAsNumber || 0 }),
        ...(this.mostField.hidden || !(this.most.valueAsNumber > 0)
          ? {}
          : { maximum_shift: this.most.valueAsNumber }),
      });
      const aligned = (await answer.json()) as Aligned;
      const { unit } = this.laid,
        shown = unitText(unit),
        rate = unit === "s" ? "Hz" : `1/${shown || "–"}`;
      layout.recordings[moved]!.shifts[layout.axis] = Number(aligned.shift.toFixed(6));
      this.laid.changed();
      this.said.textContent =
        `${tr("Shifted by #.", `${written(aligned.shift, 6)} ${shown}`.trim())} ` +
        (aligned.correlation === null
          ? ""
          : `${tr("Correlation #", written(aligned.correlation, 3))}${
              aligned.next_best === null
                ? ""
                : `, ${tr("next best peak #", written(aligned.next_best, 3))}`
            }, ${tr("compared at #", `${written(aligned.rate, 4)} ${rate}`)}.`);
    } catch (error) {
      this.said.replaceChildren(problem(error));
    }
  }
}
