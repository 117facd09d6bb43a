/** Two cursors over linked plots: lines that can be dragged, with the window between them shaded. */

import { make } from "./page";

export type Span = [number, number];
const NAMES = ["A", "B"] as const;

/** The cursors in one plot; `toPixels` and `toValue` are those of its axis. */
export class Cursors {
  private readonly band = make("div", { class: "cursor-band" });
  private readonly lines = NAMES.map((name) =>
    make("div", { class: "cursor-line" }, make("b", {}, name)),
  );

  constructor(
    over: HTMLElement,
    private readonly toPixels: (value: number) => number,
    toValue: (pixels: number) => number,
    moved: (index: 0 | 1, value: number) => void,
  ) {
    over.append(this.band, ...this.lines);
    this.lines.forEach((line, index) => {
      line.addEventListener("pointerdown", (event) => {
        event.stopPropagation(); // no zoom
        event.preventDefault();
        line.setPointerCapture(event.pointerId);
      });
      line.addEventListener("mousedown", (event) => event.stopPropagation());
      line.addEventListener("click", (event) => event.stopPropagation());
      line.addEventListener("pointermove", (event) => {
        if (!line.hasPointerCapture(event.pointerId)) return;
        const box = over.getBoundingClientRect();
        const place = Math.min(Math.max(event.clientX - box.left, 0), box.width);
        moved(index as 0 | 1, toValue(place));
      });
    });
  }

  /** Puts the cursors at their values, where these lie in the visible range. */
  show(cursors: Span | null, [low, high]: Span): void {
    this.band.hidden = !cursors;
    this.lines.forEach((line, k) => {
      const value = cursors?.[k] ?? NaN;
      line.hidden = !(value >= low && value <= high);
      if (!line.hidden) line.style.transform = `translateX(${this.toPixels(value)}px)`;
    });
    if (!cursors) return;
    const [first, last] = cursors[0] < cursors[1] ? cursors : [cursors[1], cursors[0]];
    const left = this.toPixels(Math.max(first, low)),
      right = this.toPixels(Math.min(last, high));
    this.band.style.left = `${left}px`;
    this.band.style.width = `${Math.max(0, right - left)}px`;
  }
}

/** A note at a place of the axis. */
export interface Flag {
  at: number;
  text: string;
}

/** Notes as lines in one plot, with their texts where there is room: in the first plot. */
export class Flags {
  private readonly layer = make("div", { class: "flags" });

  constructor(
    over: HTMLElement,
    private readonly toPixels: (value: number) => number,
    private readonly hasTexts: boolean,
  ) {
    over.append(this.layer);
  }

  show(flags: readonly Flag[], [low, high]: Span): void {
    this.layer.replaceChildren(
      ...flags
        .filter(({ at }) => at >= low && at <= high)
        .map(({ at, text }) => {
          const flag = make(
            "div",
            { class: "flag" },
            ...(this.hasTexts ? [make("span", {}, text)] : []),
          );
          flag.style.transform = `translateX(${this.toPixels(at)}px)`;
          return flag;
        }),
    );
  }
}
