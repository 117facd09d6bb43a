/** Records what is painted in space as paths, for files that stay sharp at every size. */

import type { DrawnShape } from "./shown";

const short = (value: number) => String(Math.round(value * 100) / 100);

/** Stands in for `Path2D`, and can be read again. */
export class RecordedPath {
  d = "";
  lineTo(x: number, y: number): void {
    this.d += `${this.d ? "L" : "M"}${short(x)} ${short(y)}`;
  }
}

/** Stands in for the context of a canvas, as far as `Picture` uses it. */
export class Recorder {
  readonly shapes: DrawnShape[] = [];
  private readonly colours = document.createElement("canvas").getContext("2d")!; // reads every way of writing a colour
  private dash: number[] = [];
  private circle = "";
  lineWidth = 1;
  globalAlpha = 1;

  get fillStyle(): string {
    return String(this.colours.fillStyle);
  }
  set fillStyle(colour: string) {
    this.colours.fillStyle = colour;
  }
  get strokeStyle(): string {
    return String(this.colours.strokeStyle);
  }
  set strokeStyle(colour: string) {
    this.colours.strokeStyle = colour;
  }
  setLineDash(dash: number[]): void {
    this.dash = dash;
  }
  clearRect(): void {}
  beginPath(): void {
    this.circle = "";
  }
  /** A whole circle. */
  arc(x: number, y: number, r: number): void {
    const size = `A${short(r)} ${short(r)} 0 1 0`;
    this.circle = `M${short(x - r)} ${short(y)}${size} ${short(x + r)} ${short(y)}${size} ${short(x - r)} ${short(y)}Z`;
  }
  fill(path?: Path2D | RecordedPath): void {
    const d = path instanceof RecordedPath ? `${path.d}Z` : this.circle;
    this.shapes.push({ d, fill: this.fillStyle, ...this.faint() });
  }
  stroke(path: Path2D | RecordedPath): void {
    this.shapes.push({
      d: (path as RecordedPath).d,
      stroke: this.strokeStyle,
      width: Math.round(this.lineWidth * 100) / 100,
      ...(this.dash.length ? { dash: this.dash } : {}),
      ...this.faint(),
    });
  }
  private faint(): { alpha?: number } {
    return this.globalAlpha < 1 ? { alpha: this.globalAlpha } : {};
  }
}
