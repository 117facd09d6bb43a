/** One channel over another, with a mark where the run is looked at. */

import { at, type Model, type Numbers, type Pane, type Store } from "../data";
import { colour, make, sized, whenColoursChange, writtenTo } from "../page";
import { tr } from "../words";
import { short, ticks } from "./multiples";
import { field } from "./parts";

const HEIGHT = 320,
  LEFT = 62,
  BOTTOM = 40,
  TOP = 10,
  RIGHT = 14;
const USUAL = ["strut.deflection", "strut.velocity"];

/** One run by both channels. */
interface Both {
  role: string;
  label: string;
  x: Numbers;
  y: Numbers;
}

export class Phase {
  private readonly canvas = make("canvas", { role: "img", "aria-label": tr("Phase plot") });
  private readonly across = make("select", {});
  private readonly upward = make("select", {});
  private readonly values = make("output", {});
  readonly element = make(
    "section",
    { class: "phase", "aria-label": tr("Phase plot") },
    make("h2", {}, tr("Phase plot")),
    make(
      "div",
      { class: "form" },
      field(tr("Horizontal axis"), this.across),
      field(tr("Vertical axis"), this.upward),
      this.values,
    ),
    this.canvas,
  );
  private readonly curves = make("canvas"); // without the marks, which move alone
  private model: Model | null = null;
  private store: Store | null = null;
  private time = 0;
  private known = "";
  private width = 0;
  private isSeen = false;
  private isOld = true;
  private frame = 0;
  private waiting = 0;
  private wanted = "";

  /** `lacking` hears that a channel was chosen whose numbers are not there. */
  constructor(private readonly lacking: () => void) {
    for (const select of [this.across, this.upward])
      select.addEventListener("change", () => this.begin());
    new ResizeObserver(([entry]) => {
      this.width = Math.floor(entry!.contentRect.width);
      this.redraw();
    }).observe(this.element);
    new IntersectionObserver(
      (entries) => {
        this.isSeen = entries.some((entry) => entry.isIntersecting);
        this.draw();
      },
      { rootMargin: "100px" },
    ).observe(this.element);
    whenColoursChange(() => this.redraw());
  }

  /** Names of the channels that are drawn. */
  get channels(): string[] {
    return [this.across, this.upward].map((select, i) => select.value || USUAL[i]!);
  }

  show(model: Model, store: Store): void {
    this.model = model;
    this.store = store;
    const names = model.scenes[0]!.panes.filter((pane) => !pane.name.startsWith("Δ")).map(
      (pane) => pane.name,
    );
    if (names.join() !== this.known) {
      this.known = names.join();
      const before = [this.across.value, this.upward.value];
      [this.across, this.upward].forEach((select, i) => {
        select.replaceChildren(...names.map((name) => make("option", { value: name }, name)));
        select.value =
          [before[i]!, USUAL[i]!, names[Math.min(i, names.length - 1)]!].find((text) =>
            names.includes(text),
          ) ?? "";
      });
    }
    this.begin();
  }

  /** Draws what is chosen, or asks for its numbers, once: the usual channels are not those of every rig. */
  private begin(): void {
    const names = this.channels.join();
    if (this.chosen()?.every((pane) => pane.curves.length)) this.redraw();
    else if (names !== this.wanted) {
      this.wanted = names;
      this.lacking();
    }
  }

  mark(time: number): void {
    this.time = time;
    this.draw();
  }

  /** Both channels that are chosen. */
  private chosen(): [Pane, Pane] | null {
    const [first, second] = [this.across, this.upward].map((select) =>
      this.model?.scenes[0]?.panes.find((pane) => pane.name === select.value),
    );
    return first && second ? [first, second] : null;
  }

  private redraw(): void {
    this.isOld = true;
    this.draw();
  }

  /** Draws with the next frame; where it is not seen, when everything has come to rest. */
  private draw(): void {
    clearTimeout(this.waiting);
    if (this.isSeen) {
      if (!this.frame)
        this.frame = requestAnimationFrame(() => {
          this.frame = 0;
          this.drawn();
        });
    } else this.waiting = setTimeout(() => this.drawn(), 400);
  }

  private drawn(): void {
    const { width, store } = this,
      scene = this.model?.scenes[0],
      chosen = this.chosen();
    if (!scene || !store || !chosen || width < 100) return;
    const [first, second] = chosen;
    const wide = Math.min(width, 720);
    const lines: Both[] = first.curves.flatMap((curve) => {
      const other = second.curves.find((candidate) => candidate.role === curve.role);
      return other
        ? [{ role: curve.role, label: curve.label, x: store.get(curve.y), y: store.get(other.y) }]
        : [];
    });
    const [left, right] = ends(lines.map((line) => line.x)),
      [low, high] = ends(lines.map((line) => line.y)),
      time = store.get(scene.x);
    const toX = (value: number) => LEFT + ((value - left) / (right - left)) * (wide - LEFT - RIGHT),
      toY = (value: number) => TOP + ((high - value) / (high - low)) * (HEIGHT - TOP - BOTTOM);
    if (this.isOld) this.drawCurves(wide, toX, toY, chosen, lines, [left, right], [low, high]);
    this.isOld = false;
    const context = this.canvas.getContext("2d")!;
    context.clearRect(0, 0, wide, HEIGHT);
    context.drawImage(this.curves, 0, 0, wide, HEIGHT);
    for (const { role, x, y } of [...lines].reverse()) {
      const a = at(time, x, this.time),
        b = at(time, y, this.time);
      if (Number.isFinite(a) && Number.isFinite(b)) {
        context.fillStyle = colour(role);
        context.beginPath();
        context.arc(toX(a), toY(b), 5, 0, 2 * Math.PI);
        context.fill();
      }
    }
    const a = lines[0] ? at(time, lines[0].x, this.time) : NaN,
      b = lines[0] ? at(time, lines[0].y, this.time) : NaN;
    const steps = chosen.map((pane) => (pane.curves[0] ? store.step(pane.curves[0].y) : 0));
    this.values.textContent = `${writtenTo(a, steps[0]!)} ${first.unit}, ${writtenTo(b, steps[1]!)} ${second.unit}`;
    this.canvas.setAttribute("aria-label", `${second.name} ${tr("over")} ${first.name}`);
  }

  private drawCurves(
    wide: number,
    toX: (value: number) => number,
    toY: (value: number) => number,
    [first, second]: [Pane, Pane],
    lines: Both[],
    [left, right]: [number, number],
    [low, high]: [number, number],
  ): void {
    sized(this.canvas, wide, HEIGHT);
    const context = sized(this.curves, wide, HEIGHT);
    context.font = "12px system-ui, sans-serif";
    context.fillStyle = colour("muted");
    context.strokeStyle = colour("line");
    context.lineWidth = 1;
    context.textAlign = "center";
    for (const x of ticks(left, right, 6)) {
      context.beginPath();
      context.moveTo(toX(x), TOP);
      context.lineTo(toX(x), HEIGHT - BOTTOM);
      context.stroke();
      context.fillText(short(x), toX(x), HEIGHT - BOTTOM + 15);
    }
    context.textAlign = "right";
    for (const y of ticks(low, high, 5)) {
      context.beginPath();
      context.moveTo(LEFT, toY(y));
      context.lineTo(wide - RIGHT, toY(y));
      context.stroke();
      context.fillText(short(y), LEFT - 5, toY(y) + 4);
    }
    context.fillStyle = colour("ink");
    context.textAlign = "center";
    context.fillText(`${first.name} [${first.unit || "–"}]`, 0.5 * (LEFT + wide), HEIGHT - 8);
    context.save();
    context.translate(12, 0.5 * (TOP + HEIGHT - BOTTOM));
    context.rotate(-Math.PI / 2);
    context.fillText(`${second.name} [${second.unit || "–"}]`, 0, 0);
    context.restore();
    for (const { role, x, y } of [...lines].reverse()) {
      context.strokeStyle = colour(role);
      context.lineWidth = 1.4;
      context.beginPath();
      let down = false;
      for (let i = 0; i < x.length; i++) {
        const a = x[i],
          b = y[i];
        if (a === null || b === null || a === undefined || b === undefined) {
          down = false;
          continue;
        }
        if (down) context.lineTo(toX(a), toY(b));
        else context.moveTo(toX(a), toY(b));
        down = true;
      }
      context.stroke();
    }
  }
}

function ends(lines: Numbers[]): [number, number] {
  let low = Infinity,
    high = -Infinity;
  for (const line of lines)
    for (let i = 0; i < line.length; i++) {
      const value = line[i];
      if (value !== null && value !== undefined && Number.isFinite(value)) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
  if (!(high > low))
    return [(Number.isFinite(low) ? low : 0) - 1, (Number.isFinite(low) ? low : 0) + 1];
  const room = 0.05 * (high - low);
  return [low - room, high + room];
}
