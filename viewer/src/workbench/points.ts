/** Hardpoints of a mechanism: dragged in the picture, in its plane or along an axis, snapping; or typed. */

import type { MechanismView } from "../mechanism";
import { make } from "../page";
import { tr } from "../words";
import { numberBox } from "./numberbox";
import { field } from "./parts";
import { part } from "./quantities";

const MM = 1e-3;

/** Without a view they are only typed. `moved` hears the new places of the numbers that changed (SI, by path), and whether a move has ended. */
export class Points {
  readonly element = make("div", { class: "points form" });
  private readonly choice = make("select", { "aria-label": tr("Hardpoint") });
  private readonly inputs = ["x", "y", "z"].map((axis) =>
    numberBox({ step: "any", "aria-label": `${axis} [mm]` }),
  );
  private readonly snap = make(
    "select",
    {},
    ...["0.1", "0.5", "1", "5", "10"].map((step) =>
      make("option", { value: step, ...(step === "1" ? { selected: true } : {}) }, `${step} mm`),
    ),
  );
  private places = new Map<string, [number, number, number]>();
  private from: [number, number, number] | null = null;

  constructor(
    private readonly view: MechanismView | null,
    private readonly moved: (changes: Record<string, number>, done: boolean) => void,
  ) {
    const way = make(
      "select",
      {},
      ...(
        [
          ["view", tr("in the view plane")],
          ["x", tr("along x")],
          ["y", tr("along y")],
          ["z", tr("along z")],
        ] as const
      ).map(([value, words]) => make("option", { value }, words)),
    );
    way.addEventListener("change", () => {
      if (view) view.way = way.value as typeof view.way;
    });
    if (view) view.grabbed = (name, by, done) => this.drag(name, by, done);
    this.choice.addEventListener("change", () => this.choose(this.choice.value));
    this.inputs.forEach((input) => {
      input.addEventListener("change", () => {
        const values = this.inputs.map((input) => Number(input.value));
        if (this.inputs.some((input) => input.value === "") || !values.every(Number.isFinite))
          return;
        this.put(this.choice.value, values as [number, number, number], true);
      });
    });
    this.element.append(
      field(tr("Hardpoint"), this.choice),
      ...this.inputs.map((input, i) => field(`${"xyz"[i]} [mm]`, input)),
      ...(view ? [field(tr("Drag"), way), field(tr("Grid"), this.snap)] : []),
    );
  }

  /** Takes what the hardpoints of a rig are (SI). */
  set(numbers: { path: string; value: number }[]): void {
    const points = new Map<string, [number, number, number]>();
    for (const { path, value } of numbers) {
      const place = /^hardpoints\.(\w+)\[([012])\]$/.exec(path);
      if (!place) continue;
      const point = points.get(place[1]!) ?? [0, 0, 0];
      point[Number(place[2])] = value / MM;
      points.set(place[1]!, point);
    }
    if ([...points.keys()].join() !== [...this.places.keys()].join())
      this.choice.replaceChildren(
        ...[...points.keys()].map((name) => make("option", { value: name }, part(name))),
      );
    this.places = points;
    this.write();
  }

  choose(name: string): void {
    this.choice.value = name;
    this.view?.choose(name);
    this.write();
  }

  private drag(name: string, by: [number, number, number], done: boolean): void {
    const place = this.places.get(name);
    if (!place) return;
    if (this.from === null || this.choice.value !== name) {
      this.from = [...place];
      this.choose(name);
    }
    const far = Math.hypot(...by),
      step = Number(this.snap.value),
      start = this.from;
    const next = start.map((value, i) =>
      Math.abs(by[i]!) > 0.02 * far ? Math.round((value + by[i]!) / step) * step : value,
    ) as [number, number, number];
    if (done) this.from = null;
    if (far > 0 || done) this.put(name, next, done, start);
  }

  /** Tells what differs from where the point is, or was before it was dragged. */
  private put(name: string, next: [number, number, number], done: boolean, before = next): void {
    const place = this.places.get(name);
    if (!place) return;
    const changes: Record<string, number> = {};
    next.forEach((value, i) => {
      if ([place[i]!, before[i]!].some((was) => Math.abs(value - Number(was.toFixed(4))) > 1e-9))
        changes[`hardpoints.${name}[${i}]`] = Number(value.toPrecision(12)) * MM;
    });
    this.places.set(
      name,
      next.map((value, i) => (`hardpoints.${name}[${i}]` in changes ? value : place[i]!)) as [
        number,
        number,
        number,
      ],
    );
    this.write();
    if (Object.keys(changes).length) this.moved(changes, done);
  }

  private write(): void {
    const place = this.places.get(this.choice.value);
    this.inputs.forEach((input, i) => {
      if (document.activeElement !== input)
        input.value = place ? String(Number(place[i]!.toFixed(4))) : "";
    });
  }
}
