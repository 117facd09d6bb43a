/** Plots over one common axis, one above the other: zoom, pan and cursor are linked. */

import uPlot from "uplot";
import { Cursors, type Flag, Flags, type Span } from "./cursors";
import { at, type Numbers } from "./data";
import { drawingOrder, lineStyle } from "./lines";
import { colour, isFast, make, whenLeft, writtenTo } from "./page";
import { type Offer, offerChart, type ShownChart } from "./shown";
import { localised } from "./words";

export interface Line {
  label: string;
  role: string;
  y: Numbers;
  step: number;
  shown: boolean;
  dash?: number[];
  points?: boolean; // no line
}
export interface PlotPane {
  name: string;
  title: string;
  unit: string;
  lines: Line[];
  /** Filled ranges between two of the lines, by their numbers. */
  bands?: { low: number; high: number; role: string }[];
}
export interface Plotted {
  x: Numbers;
  xLabel: string;
  panes: PlotPane[];
  spans: [number, number][];
  window: [number, number] | null;
  whole?: [number, number]; // of which only a part is held
}

const AXIS = 62;
/** Index of a curve among the series of its plot, of which the first is the axis. */
const seriesOf = (lines: Line[], line: Line) => drawingOrder(lines).indexOf(line) + 1;

let count = 0;

export class LinkedPlots {
  private readonly key = `plots-${count++}`;
  readonly element = make("div", { class: "plots" });
  private plots: uPlot[] = [];
  private heads: HTMLElement[] = [];
  private marks: HTMLElement[] = [];
  private shown: Plotted | null = null;
  private range: [number, number] = [0, 1];
  private busy = false;
  private place = 0;
  private handles: Cursors[] = [];
  private cursors: Span | null = null;
  private flags: Flags[] = [];
  private notes: readonly Flag[] = [];
  /** Called when a cursor is dragged, or put where the plot is clicked. */
  onCursor: ((index: 0 | 1, value: number) => void) | null = null;

  /**
   * `moved` is called with the pointer's position on the common axis, `zoomed` with the visible range.
   * Each head has what `offer` makes; `tall` is the height of a plot that stands alone, px.
   */
  constructor(
    private readonly moved: (x: number) => void,
    private readonly zoomed: (range: [number, number]) => void = () => {},
    private readonly offer: Offer | null = null,
    private readonly tall = 250,
  ) {
    offerChart(this.element, () => this.chart());
    whenLeft(() => this.clear()); // plots whose cursors are linked know each other until then
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.element.addEventListener("dblclick", () => this.reset());
  }

  show(plotted: Plotted, keep: [number, number] | null = null): void {
    if (this.refresh(plotted, keep)) return;
    this.clear();
    this.shown = plotted;
    const { x } = plotted,
      first = x[0] as number,
      last = x[x.length - 1] as number;
    this.range = keep ?? plotted.window ?? [first, last];
    plotted.panes.forEach((pane, k) => this.add(pane, k === plotted.panes.length - 1));
    this.mark(this.place);
    this.zoomed(this.range);
  }

  /** Replaces the data of the plots; returns whether they have the same form. */
  private refresh(plotted: Plotted, keep: [number, number] | null): boolean {
    const kind = (curve: Plotted) =>
      JSON.stringify([
        curve.xLabel,
        curve.panes.map((pane) => [
          pane.title,
          pane.unit,
          pane.lines.map((line) => [line.label, line.role, line.dash]),
        ]),
      ]);
    if (!this.shown || kind(this.shown) !== kind(plotted)) return false;
    this.shown = plotted;
    const { x } = plotted;
    this.range = keep ?? plotted.window ?? [x[0] as number, x[x.length - 1] as number];
    plotted.panes.forEach((pane, k) => {
      const plot = this.plots[k]!;
      for (const line of pane.lines) {
        const place = seriesOf(pane.lines, line);
        if (plot.series[place]!.show !== line.shown) plot.setSeries(place, { show: line.shown });
      }
      plot.setData([x, ...drawingOrder(pane.lines).map((line) => line.y)] as uPlot.AlignedData);
    });
    this.mark(this.place);
    this.zoomed(this.range);
    return true;
  }

  /** The visible curves as data. */
  private chart(): ShownChart | null {
    if (!this.shown) return null;
    const panels = this.shown.panes.map((pane) => ({
      name: pane.name,
      title: pane.title,
      unit: pane.unit,
      curves: pane.lines
        .filter((line) => line.shown)
        .map(({ label, role, y }) => ({ label, role, y })),
    }));
    const { x, xLabel: x_label } = this.shown;
    return { x_label, x, panels, window: this.range, columns: 1 };
  }

  clear(): void {
    this.shown = null;
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    this.heads = [];
    this.marks = [];
    this.handles = [];
    this.flags = [];
    this.element.replaceChildren();
  }

  /** Shows two cursors at values of the axis, or none. */
  setCursors(cursors: Span | null): void {
    this.cursors = cursors;
    for (const handle of this.handles) handle.show(cursors, this.range);
  }

  /** Shows notes at places of the axis. */
  setNotes(notes: readonly Flag[]): void {
    this.notes = notes;
    for (const flags of this.flags) flags.show(notes, this.range);
  }

  /** Position of the pointer on the axis, where it was last. */
  get pointed(): number {
    return this.place;
  }

  get window(): [number, number] {
    return this.range;
  }

  get whole(): [number, number] {
    const x = this.shown?.x;
    if (this.shown?.whole) return this.shown.whole;
    return x?.length ? [x[0] as number, x[x.length - 1] as number] : [0, 1];
  }

  reset(): void {
    this.zoom(...this.whole);
  }

  /** Shows the range from `low` to `high`, limited to the data. */
  zoom(low: number, high: number): void {
    const [first, last] = this.whole,
      least = (last - first) * (this.shown?.whole ? 1e-7 : 1e-4) || 1;
    const span = Math.min(Math.max(high - low, least), last - first);
    const start = Math.min(Math.max(low, first), last - span);
    this.range = [start, start + span];
    this.busy = true;
    for (const plot of this.plots) plot.setScale("x", { min: this.range[0], max: this.range[1] });
    this.busy = false;
    this.mark(this.place);
    this.zoomed(this.range);
  }

  /** Zooms by a factor about a place of the axis. */
  zoomBy(factor: number, about = (this.range[0] + this.range[1]) / 2): void {
    this.zoom(about - (about - this.range[0]) * factor, about + (this.range[1] - about) * factor);
  }

  pan(share: number): void {
    const width = this.range[1] - this.range[0];
    this.zoom(this.range[0] + share * width, this.range[1] + share * width);
  }

  setShown(role: string, shown: boolean): void {
    this.shown?.panes.forEach((pane, k) =>
      pane.lines.forEach((line) => {
        if (line.role === role) {
          line.shown = shown;
          this.plots[k]!.setSeries(seriesOf(pane.lines, line), { show: shown });
        }
      }),
    );
    this.mark(this.place);
  }

  /** Moves the mark that stands at one place in all plots, and writes the values there. */
  mark(x: number): void {
    this.place = x;
    const plotted = this.shown;
    if (!plotted) return;
    plotted.panes.forEach((pane, k) => {
      const plot = this.plots[k]!,
        left = plot.valToPos(x, "x");
      const inside = x >= this.range[0] && x <= this.range[1];
      this.marks[k]!.style.transform = `translateX(${left}px)`;
      this.marks[k]!.hidden = !inside;
      const values = this.heads[k]!.querySelectorAll("output");
      pane.lines.forEach((line, i) => {
        const output = values[i]!;
        output.parentElement!.hidden = !line.shown;
        if (line.shown) output.textContent = writtenTo(at(plotted.x, line.y, x), line.step);
      });
    });
  }

  repaint(): void {
    const { shown, range } = this;
    if (shown) {
      this.clear();
      this.show(shown, range);
    }
  }

  private add(pane: PlotPane, isLast: boolean): void {
    const plotted = this.shown!;
    const head = make(
      "div",
      { class: "pane-head" },
      make(
        "span",
        {},
        make("b", {}, pane.title),
        make("span", { class: "unit" }, ` [${pane.unit || "–"}]`),
      ),
    );
    for (const line of pane.lines)
      head.append(
        make(
          "span",
          { class: "value" },
          ...(line.label
            ? [
                make("i", { class: `swatch ${line.role}${line.dash ? " dashed" : ""}` }),
                `${line.label} `,
              ]
            : []),
          make("output", {}, "–"),
        ),
      );
    if (this.offer)
      head.append(
        make(
          "span",
          { class: "tools" },
          ...this.offer.buttons(pane.name, pane.title, this.element),
        ),
      );
    const holder = make("div", { class: "pane" });
    this.element.append(head, holder);
    const ink = colour("ink"),
      grid = { stroke: colour("line"), width: 1 },
      faint = colour("span");
    const font = "12px system-ui, sans-serif";
    const values = (_: uPlot, ticks: number[]) => alike(ticks);
    const plot = drawnByTheProcessor(
      () =>
        new uPlot(
          {
            width: Math.max(this.element.clientWidth, 200),
            height: this.height(isLast),
            padding: [6, 12, 0, 0],
            legend: { show: false },
            cursor: {
              sync: { key: this.key, setSeries: false },
              drag: { x: true, y: false, setScale: false },
              points: { show: false },
              y: false,
              bind: { dblclick: () => null },
            },
            scales: {
              x: { time: false, auto: false, range: () => this.range },
              y: {
                range: (_u: uPlot, low: number | null, high: number | null) => around(low, high),
              },
            },
            axes: [
              {
                stroke: ink,
                grid,
                ticks: { show: false },
                size: isLast ? 24 : 6,
                font,
                values: isLast ? values : () => [],
                label: isLast ? plotted.xLabel : undefined,
                labelSize: 16,
                labelFont: font,
                labelGap: 0,
                gap: 3,
              },
              { stroke: ink, grid, ticks: { show: false }, size: AXIS, space: 22, font, values }, // at least two marks, whatever the range
            ],
            series: [
              {},
              ...drawingOrder(pane.lines).map((line) => {
                const { width, dash } = lineStyle(line.role);
                return {
                  label: line.label,
                  stroke: colour(line.role),
                  points: line.points
                    ? { show: true, size: 3, fill: colour(line.role), width: 0, filter: null }
                    : { show: false },
                  ...(line.points ? { paths: () => null } : {}),
                  show: line.shown,
                  pxAlign: 0,
                  width,
                  dash: line.dash ?? dash,
                };
              }),
            ],
            bands: (pane.bands ?? []).map(({ low, high, role }) => ({
              series: [
                seriesOf(pane.lines, pane.lines[high]!),
                seriesOf(pane.lines, pane.lines[low]!),
              ],
              fill: `color-mix(in srgb, ${colour(role)} 20%, transparent)`,
            })),
            hooks: {
              drawClear: [
                (u) => {
                  u.ctx.fillStyle = faint;
                  for (const [from, to] of plotted.spans) {
                    const low = Math.max(from, this.range[0]),
                      high = Math.min(to, this.range[1]);
                    if (high > low)
                      u.ctx.fillRect(
                        u.valToPos(low, "x", true),
                        u.bbox.top,
                        u.valToPos(high, "x", true) - u.valToPos(low, "x", true),
                        u.bbox.height,
                      );
                  }
                },
              ],
              draw: [
                (u) => {
                  const k = this.plots.indexOf(u); // once it knows its size
                  this.handles[k]?.show(this.cursors, this.range);
                  this.flags[k]?.show(this.notes, this.range);
                },
              ],
              setSelect: [
                (u) => {
                  if (u.select.width > 4)
                    this.zoom(
                      u.posToVal(u.select.left, "x"),
                      u.posToVal(u.select.left + u.select.width, "x"),
                    );
                  u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
                },
              ],
              setCursor: [
                (u) => {
                  if (
                    this.busy ||
                    u.cursor.left === undefined ||
                    u.cursor.left === null ||
                    u.cursor.left < 0 ||
                    !u.cursor.event
                  )
                    return;
                  this.moved(u.posToVal(u.cursor.left, "x"));
                },
              ],
            },
          } as uPlot.Options,
          [plotted.x, ...drawingOrder(pane.lines).map((line) => line.y)] as uPlot.AlignedData,
          holder,
        ),
    );
    const mark = make("div", { class: "mark-line" });
    plot.over.append(mark);
    plot.over.style.touchAction = "pan-y";
    if (this.onCursor) {
      let pressed = 0;
      plot.over.addEventListener("pointerdown", (event) => {
        pressed = event.clientX;
      });
      plot.over.addEventListener("click", (event) => {
        if (Math.abs(event.clientX - pressed) > 4) return; // it was dragged
        this.clicked(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
      });
      this.flags.push(
        new Flags(plot.over, (value) => plot.valToPos(value, "x"), !this.plots.length),
      );
      this.handles.push(
        new Cursors(
          plot.over,
          (value) => plot.valToPos(value, "x"),
          (pixels) => plot.posToVal(pixels, "x"),
          (index, value) => this.onCursor?.(index, value),
        ),
      );
    }
    this.plots.push(plot);
    this.heads.push(head);
    this.marks.push(mark);
  }

  /** Puts the nearer cursor where the plot was clicked. */
  private clicked(value: number): void {
    if (!this.cursors) return;
    const [a, b] = this.cursors;
    this.onCursor?.(Math.abs(value - a) <= Math.abs(value - b) ? 0 : 1, value);
  }

  private height(isLast: boolean): number {
    const count = this.shown?.panes.length ?? 1;
    const body = count > 3 ? 96 : count === 3 ? 120 : count === 2 ? 165 : this.tall;
    return body + (isLast ? 40 : 6) + 6;
  }

  private resize(): void {
    const width = this.element.clientWidth;
    if (width < 50) return;
    this.plots.forEach((plot, k) =>
      plot.setSize({ width, height: this.height(k === this.plots.length - 1) }),
    );
    this.mark(this.place);
  }

  private wheel(event: WheelEvent): void {
    if (!event.ctrlKey && !event.shiftKey) return; // else the page scrolls
    event.preventDefault();
    const plot = this.plots[0];
    if (!plot) return;
    if (event.shiftKey) this.pan(Math.sign(event.deltaY || event.deltaX) * 0.1);
    else
      this.zoomBy(
        event.deltaY > 0 ? 1.25 : 0.8,
        plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"),
      );
  }
}

/** Makes plots that render on the processor if there is no graphics card: emulating one takes twice as long. */
function drawnByTheProcessor<T>(make: () => T): T {
  if (isFast()) return make();
  const kind = HTMLCanvasElement.prototype,
    usual = kind.getContext; // uPlot asks for its context itself
  kind.getContext = function (this: HTMLCanvasElement, name: string, options?: object) {
    return usual.call(
      this,
      name,
      name === "2d" ? { ...options, willReadFrequently: true } : options,
    );
  } as typeof usual;
  try {
    return make();
  } finally {
    kind.getContext = usual;
  }
}

/** Labels of an axis, all with as many digits behind the point. */
function alike(ticks: number[]): string[] {
  const texts = ticks.map((tick) => String(Number(tick.toPrecision(10))));
  if (texts.some((text) => text.includes("e"))) return texts.map(localised);
  const digits = Math.max(0, ...texts.map((text) => text.split(".")[1]?.length ?? 0));
  return ticks.map((tick) => localised(tick === 0 ? "0" : tick.toFixed(digits)));
}

/** Range of an axis for values from `low` to `high`; constant values get a margin on both sides. */
function around(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null) return [0, 1];
  if (high > low) return uPlot.rangeNum(low, high, 0.1, true) as [number, number];
  const aside = 0.1 * Math.abs(low) || 1;
  return [low - aside, low + aside];
}
