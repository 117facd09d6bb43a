/** Many small plots over one axis: curves, bands of what is wanted, and the value at the pose that is shown. */

import { at, type Model, type Numbers, type Store } from "../data";
import { drawingOrder, lineStyle } from "../lines";
import { colour, make, sized, whenColoursChange, written } from "../page";
import { offerChart, type ShownChart, type ShownCurve, seeker, sorted } from "../shown";
import { isGerman, localised, tr } from "../words";
import { offer, whenPinned } from "./curves";
import { quantity } from "./quantities";

/** What is wanted of a quantity, or allowed about a measured curve of one wheel (`side`; empty for the axle). */
export interface Band {
  quantity: string;
  at: number[];
  low: (number | null)[];
  high: (number | null)[];
  measured?: {
    role: string; // of the measured curve
    model: string; // and of the one that is judged
    side: string;
    verdict: "within" | "outside";
    leaves: number | null;
  };
}
interface One {
  name: string;
  unit: string;
  lines: { role: string; label: string; y: Numbers }[];
  bands: Band[];
  canvas: HTMLCanvasElement;
  value: HTMLElement;
  mark: HTMLElement;
  box: HTMLElement;
  verdict: HTMLElement;
}

const LEFT = 46,
  RIGHT = 8,
  TOP = 6,
  BOTTOM = 30,
  HEIGHT = 118;

export class Multiples {
  readonly element = make("div", { class: "multiples" });
  private plots: One[] = [];
  private x: Numbers = [];
  private xLabel = "";
  private kind = "";
  private wanted = "";
  private width = 0;
  private place = 0;
  private colours: Record<string, string> = {};

  /** `moved` hears where the pointer is on the axis. */
  constructor(private readonly moved: (x: number) => void) {
    offerChart(this.element, () => this.chart());
    whenPinned(() => this.order());
    new ResizeObserver(() => this.sized()).observe(this.element);
    whenColoursChange(() => {
      this.colours = {};
      this.sized();
    });
  }

  /** The visible curves as data. */
  private chart(): ShownChart | null {
    const panels = this.ordered()
      .filter((one) => !one.box.hidden)
      .map(({ name, unit, lines, bands }) => ({
        name,
        title: quantity(name),
        unit,
        curves: [
          ...lines.map(({ label, role, y }) => ({
            label: lines.length > 1 ? label : "",
            role,
            y,
          })),
          ...bands.flatMap((band) => this.limits(band)),
        ],
      }));
    if (!panels.length) return null;
    return { x_label: this.xLabel, x: this.x, panels, window: this.ends(), columns: 2 };
  }

  /** The limits of a target that holds over a range, as curves. */
  private limits({ at: places, low, high, measured }: Band): ShownCurve[] {
    const [first, last] = [places[0] ?? 0, places[places.length - 1] ?? 0];
    const limit = (label: string, values: (number | null)[]): ShownCurve[] =>
      places.length < 2 || values.includes(null)
        ? []
        : [
            {
              label,
              role: measured?.role ?? "other-1",
              y: Array.from(this.x, (x) =>
                (x as number) < first || (x as number) > last
                  ? null
                  : at(places, values, x as number),
              ),
            },
          ];
    if (measured) {
      const whose = tr(measured.side || "axle");
      return [
        ...limit(`${whose}, ${tr("tolerance, at least")}`, low),
        ...limit(`${whose}, ${tr("tolerance, at most")}`, high),
      ];
    }
    return [...limit(tr("target, at least"), low), ...limit(tr("target, at most"), high)];
  }

  show(model: Model, store: Store, bands: Band[]): void {
    this.xLabel = `${model.x.words} [${model.x.unit || "–"}]`;
    const scene = model.scenes[0]!,
      panes = scene.panes.filter((pane) => !pane.name.startsWith("Δ"));
    this.x = store.get(scene.x);
    const kind = JSON.stringify([panes.map((pane) => [pane.name, pane.unit])]);
    if (kind !== this.kind) {
      this.kind = kind;
      this.plots = panes.map((pane) => this.made(pane.name, pane.words, pane.unit));
      this.element.replaceChildren();
      this.filter(this.wanted);
    }
    panes.forEach((pane, k) => {
      const plot = this.plots[k]!;
      plot.lines = pane.curves.map(({ role, label, y }) => ({ role, label, y: store.get(y) }));
      const own = bands.filter((band) => band.quantity === pane.name);
      plot.bands = own[0]?.measured ? own : own.slice(0, 1);
      plot.box.classList.toggle("wanted", own.length > 0);
    });
    this.order();
    if (!this.width) this.sized();
    else this.draw();
    this.mark(this.place);
  }

  /** Pinned curves first, then those with targets. */
  private ordered(): One[] {
    const { length } = this.plots;
    return sorted(this.plots, ({ name, bands }) =>
      Math.min(offer.rank(name), bands.length ? 1000 : 1001 + length),
    );
  }

  /** Puts the curves in their order, unless they are. */
  private order(): void {
    const boxes = this.ordered().map((one) => one.box);
    for (const plot of this.plots)
      plot.box
        .querySelector(".pin")!
        .setAttribute("aria-pressed", String(Number.isFinite(offer.rank(plot.name))));
    if (boxes.some((box, k) => this.element.children[k] !== box))
      this.element.replaceChildren(...boxes);
  }

  /** Shows those whose name or words hold all words of a text, or of one of its parts between commas. */
  filter(text: string): void {
    this.wanted = text;
    const isWanted = seeker(text);
    for (const plot of this.plots) plot.box.hidden = !isWanted(plot.box.dataset.words!);
    this.draw();
  }

  /** Moves the mark that stands at one place in all plots, and writes the values there. */
  mark(x: number): void {
    this.place = x;
    const [first, last] = this.ends(),
      share = last > first ? (x - first) / (last - first) : 0;
    const left = LEFT + Math.min(Math.max(share, 0), 1) * (this.width - LEFT - RIGHT);
    for (const plot of this.plots) {
      if (plot.box.hidden) continue;
      plot.mark.style.transform = `translateX(${left}px)`;
      const line = plot.lines[0];
      plot.value.textContent = line ? written(at(this.x, line.y, x), 4) : "–";
    }
  }

  private ends(): [number, number] {
    return this.x.length ? [this.x[0] as number, this.x[this.x.length - 1] as number] : [0, 1];
  }

  private made(name: string, words: string, unit: string): One {
    const canvas = make("canvas", { "aria-hidden": "true" }),
      value = make("output", {}, "–"),
      mark = make("i", { class: "at" }),
      verdict = make("span", { class: "verdict" });
    const holder = make("div", { class: "holder" }, canvas, mark);
    holder.addEventListener("pointermove", (event) => {
      const [first, last] = this.ends(),
        box = holder.getBoundingClientRect();
      this.moved(
        first +
          Math.min(Math.max((event.clientX - box.left - LEFT) / (box.width - LEFT - RIGHT), 0), 1) *
            (last - first),
      );
    });
    const box = make(
      "figure",
      { "data-words": `${name} ${quantity(name)} ${words}`.toLowerCase().replaceAll("_", " ") },
      make(
        "figcaption",
        { title: isGerman ? `${name}, ${quantity(name)}` : words },
        make("b", {}, quantity(name)),
        make("span", { class: "unit" }, `[${unit || "–"}]`),
        make("span", { class: "whole" }, value, verdict),
        make("span", { class: "tools" }, ...offer.buttons(name, quantity(name), this.element)),
      ),
      holder,
    );
    return { name, unit, lines: [], bands: [], canvas, value, mark, box, verdict };
  }

  private sized(): void {
    const first = this.plots.find((plot) => !plot.box.hidden);
    const width = first ? Math.floor(first.box.clientWidth) : 0;
    if (width < 60) return;
    this.width = width;
    for (const { canvas } of this.plots) sized(canvas, width, HEIGHT);
    this.draw();
    this.mark(this.place);
  }

  private ink(name: string): string {
    this.colours[name] ??= colour(name);
    return this.colours[name];
  }

  private draw(): void {
    if (!this.width) return;
    for (const plot of this.plots) if (!plot.box.hidden) this.drawn(plot);
  }

  private drawn(panel: One): void {
    const context = panel.canvas.getContext("2d")!,
      { x, width } = this;
    const [first, last] = this.ends();
    let low = Infinity,
      high = -Infinity;
    const take = (value: number | null) => {
      if (value !== null && Number.isFinite(value)) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    };
    for (const { y } of panel.lines) for (let i = 0; i < y.length; i++) take(y[i] as number | null);
    for (const band of panel.bands)
      for (const limits of [band.low, band.high]) limits.forEach(take);
    if (!(high >= low)) [low, high] = [-1, 1];
    const least = 1e-6 * Math.max(Math.abs(low), Math.abs(high)) || 1e-9; // what is even to rounding is drawn as even
    const room = high - low > least ? 0.08 * (high - low) : 0.1 * Math.abs(high) || 1;
    low -= room;
    high += room;
    const toX = (value: number) =>
      LEFT + ((value - first) / (last - first || 1)) * (width - LEFT - RIGHT);
    const toY = (value: number) => TOP + ((high - value) / (high - low)) * (HEIGHT - TOP - BOTTOM);
    context.clearRect(0, 0, width, HEIGHT);
    context.font = "11px system-ui, sans-serif";
    context.lineWidth = 1;
    context.strokeStyle = this.ink("line");
    context.fillStyle = this.ink("muted");
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const tick of ticks(low, high, 3)) {
      const y = Math.round(toY(tick)) + 0.5;
      context.beginPath();
      context.moveTo(LEFT, y);
      context.lineTo(width - RIGHT, y);
      context.stroke();
      context.fillText(short(tick), LEFT - 5, y);
    }
    context.textBaseline = "alphabetic";
    context.textAlign = "center";
    for (const tick of ticks(first, last, 3))
      context.fillText(
        short(tick),
        Math.min(Math.max(toX(tick), LEFT + 8), width - RIGHT - 8),
        HEIGHT - BOTTOM + 12,
      );
    context.fillText(this.xLabel, (LEFT + width - RIGHT) / 2, HEIGHT - 4, width - LEFT - RIGHT);
    panel.verdict.textContent = "";
    for (const band of panel.bands) this.band(context, panel, band, toX, toY, low, high);
    for (const { role, y } of drawingOrder(panel.lines)) {
      const { width: thick, dash } = lineStyle(role);
      context.strokeStyle = this.ink(role);
      context.lineWidth = thick;
      context.setLineDash(dash);
      context.beginPath();
      let down = false;
      for (let i = 0; i < x.length; i++) {
        const value = y[i];
        if (value === null || value === undefined || !Number.isFinite(value)) {
          down = false;
          continue;
        }
        if (down) context.lineTo(toX(x[i] as number), toY(value));
        else context.moveTo(toX(x[i] as number), toY(value));
        down = true;
      }
      context.stroke();
    }
    context.setLineDash([]);
    this.left(context, panel, toX, toY);
  }

  /** Rings where curves leave the tolerance of a measurement, and the verdict. */
  private left(
    context: CanvasRenderingContext2D,
    panel: One,
    toX: (x: number) => number,
    toY: (y: number) => number,
  ): void {
    const judged = panel.bands.flatMap(({ measured }) => measured ?? []);
    if (!judged.length) return;
    const out = judged.filter(({ verdict }) => verdict === "outside"),
      places = out.flatMap(({ leaves }) => leaves ?? []);
    for (const { model, leaves } of out) {
      const y = panel.lines.find(({ role }) => role === model)?.y;
      if (leaves === null || !y) continue;
      context.strokeStyle = this.ink("bad");
      context.lineWidth = 2;
      context.beginPath();
      context.arc(toX(leaves), toY(at(this.x, y, leaves)), 5, 0, 2 * Math.PI);
      context.stroke();
    }
    const nearest = Math.min(...places.map(Math.abs)),
      place = places.find((one) => Math.abs(one) === nearest),
      unit = /\[(.*)\]$/.exec(this.xLabel)?.[1] ?? "";
    panel.verdict.textContent = out.length
      ? ` ✗ ${place === undefined ? "" : `${short(place)} ${unit}`}`
      : " ✓";
    panel.verdict.className = `verdict ${out.length ? "missed" : "good"}`;
    panel.verdict.title = judged
      .map(
        ({ side, verdict, leaves }) =>
          `${tr(side || "axle")}: ${
            verdict === "within"
              ? tr("within the tolerance")
              : tr("leaves the tolerance at #", `${short(leaves ?? Number.NaN)} ${unit}`)
          }`,
      )
      .join("; ");
  }

  /** What is wanted, within its tolerance, and whether the first curve keeps to it. */
  private band(
    context: CanvasRenderingContext2D,
    panel: One,
    band: Band,
    toX: (x: number) => number,
    toY: (y: number) => number,
    low: number,
    high: number,
  ): void {
    const { measured } = band,
      wide = band.at.length > 1 ? 0 : 4;
    context.fillStyle = this.ink(measured?.role ?? "span");
    context.strokeStyle = this.ink(measured?.role ?? "other-1");
    context.beginPath();
    const path = [
      ...band.at.map((place, i) => [toX(place), toY(band.high[i] ?? high)]),
      ...band.at.map((place, i) => [toX(place), toY(band.low[i] ?? low)]).reverse(),
    ];
    if (wide)
      context.rect(path[0]![0]! - wide, path[0]![1]!, 2 * wide, path[1]![1]! - path[0]![1]!);
    else {
      path.forEach(([a, b], i) => {
        if (i) context.lineTo(a!, b!);
        else context.moveTo(a!, b!);
      });
      context.closePath();
    }
    if (measured) context.globalAlpha = 0.15;
    context.fill();
    context.globalAlpha = 1;
    if (measured) return;
    context.stroke();
    const y = panel.lines[0]?.y,
      [first, last] = this.ends(),
      step = 1e-9 * (last - first);
    if (band.at.some((place) => place < first - step || place > last + step)) {
      panel.verdict.textContent = " ?";
      panel.verdict.className = "verdict";
      panel.verdict.title = tr("the sweep does not reach this target");
      return;
    }
    const isMet =
      !!y &&
      band.at.every((place, i) => {
        const value = at(this.x, y, place);
        return (
          value >= (band.low[i] ?? -Infinity) - 1e-9 && value <= (band.high[i] ?? Infinity) + 1e-9
        );
      });
    panel.verdict.textContent = isMet ? " ✓" : " ✗";
    panel.verdict.className = `verdict ${isMet ? "good" : "missed"}`;
    panel.verdict.title = tr(isMet ? "within the tolerance" : "outside the tolerance");
  }
}

/** Round numbers between two ends, about so many. */
export function ticks(low: number, high: number, count: number): number[] {
  const raw = (high - low) / count,
    power = 10 ** Math.floor(Math.log10(raw)),
    step = [1, 2, 5, 10].map((value) => value * power).find((value) => value >= raw)!;
  const indices: number[] = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; k++) indices.push(k * step);
  return indices.length < 2 && count < 6 ? ticks(low, high, count + 1) : indices; // one alone says nothing of how far
}

export function short(value: number): string {
  const text = Number(value.toPrecision(4));
  return localised(
    Math.abs(text) >= 1e5 || (text !== 0 && Math.abs(text) < 1e-3)
      ? text.toExponential(0)
      : String(text),
  );
}
