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
  private readonly movedChannel = select([]);
  private readonly by = select(Object.keys(WAYS), "correlation", (way) => tr(WAYS[way]!));
  private readonly level = numberBox({ step: "any", value: "0" });
  private readonly most = numberBox({ step: "any", min: "0" });
  private readonly said = make("p", { class: "state", role: "status" });
  private readonly levelField = field(tr("Level"), this.level);
  private readonly mostField = field(tr("Largest shift"), this.most, tr("empty: any"));
  readonly element: HTMLElement;
  private isChosen = false;

  constructor(private readonly laid: Laid) {
    const button = make("button", { type: "button" }, tr("Align"));
    button.addEventListener("click", () => void once(button, this.align()));
    for (const recording of [this.moved, this.reference])
      recording.addEventListener("change", () => {
        this.isChosen = false;
        this.show();
      });
    const pair = [this.channel, this.movedChannel] as const;
    for (const [own, other] of [pair, [pair[1], pair[0]] as const])
      own.addEventListener("change", () => {
        this.isChosen = true;
        this.follow(own, other);
      });
    this.by.addEventListener("change", () => this.fields());
    this.element = make(
      "details",
      { class: "aligning" },
      make("summary", {}, tr("Align two recordings")),
      field(tr("Shift"), this.moved),
      field(tr("onto"), this.reference),
      field(tr("How"), this.by),
      field(tr("Channel that is shifted"), this.movedChannel),
      field(tr("Channel that stays"), this.channel),
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

  /** Chooses the channel of the same name, if the other recording has it. */
  private follow(own: HTMLSelectElement, other: HTMLSelectElement): void {
    if ([...other.options].some(({ value }) => value === own.value)) other.value = own.value;
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
    const of = (recording: string) =>
      tracks
        .find(({ path }) => path === recordings[Number(recording)]?.path)
        ?.channels.map(({ name }) => name) ?? [];
    const [moved, reference] = [of(this.moved.value), of(this.reference.value)],
      drawn = layout.graphs.map(({ channels }) => channels);
    // of one name if both have it, else two that share a graph
    const pair = drawn
      .flatMap((graph) =>
        reference
          .filter((name) => graph.includes(name))
          .map((name) => [name, ...moved.filter((own) => own === name || graph.includes(own))]),
      )
      .map(([name, ...own]) => [name!, own.find((one) => one === name) ?? own[0]] as const)
      .find(([, own]) => own);
    const named = (names: string[]) => names.map((name): [string, string] => [name, name]);
    const wasEmpty = [this.channel, this.movedChannel].map((box) => !box.value);
    options(this.channel, named(reference), 0);
    options(this.movedChannel, named(moved), 0);
    if (this.isChosen) {
      // the channel of one was chosen before the other recording was read
      if (wasEmpty[1]) this.follow(this.channel, this.movedChannel);
      else if (wasEmpty[0]) this.follow(this.movedChannel, this.channel);
      return;
    }
    if (!pair) return;
    [this.channel.value, this.movedChannel.value] = [pair[0], pair[1]!];
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
        moved_channel: this.movedChannel.value,
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
