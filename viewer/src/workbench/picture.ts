/** Small drawings of pages: elements of SVG, and a plane with its axes. */

import { written } from "../page";
import { heard } from "../words";

export type Attributes = Record<string, string | number>;

export function svg(name: string, attributes: Attributes = {}, content = ""): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes))
    element.setAttribute(key, key === "aria-label" ? heard(String(value)) : String(value));
  element.textContent = heard(content);
  return element;
}

/** An axis: its ends (SI), its label, and the factor to its unit. */
export interface Axis {
  ends: readonly [number, number];
  label: string;
  factor?: number;
}
/** A plane of two axes: its picture, and the mapping of values to it. */
export interface Plane {
  picture: SVGElement;
  at: (x: number, y: number) => [number, number];
}

export function plane(x: Axis, y: Axis, attributes: Attributes): Plane {
  const [width, height, left, foot] = [560, 340, 66, 40];
  const [[x0, x1], [y0, y1]] = [x.ends, y.ends];
  const at = (a: number, b: number): [number, number] => [
    left + ((width - left - 12) * (a - x0)) / (x1 - x0),
    height - foot - ((height - foot - 10) * (b - y0)) / (y1 - y0),
  ];
  const tick = (axis: Axis, value: number, place: Attributes) =>
    svg("text", place, written(value * (axis.factor ?? 1), 3));
  const below = height - foot + 16,
    middle = { "text-anchor": "middle" };
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "xy", ...attributes });
  picture.append(
    svg("path", { class: "axis", d: `M${left} 6V${height - foot}H${width - 8}` }),
    tick(x, x0, { x: left, y: below }),
    tick(x, x1, { x: width - 12, y: below, "text-anchor": "end" }),
    tick(y, y0, { x: left - 5, y: height - foot, "text-anchor": "end" }),
    tick(y, y1, { x: left - 5, y: 20, "text-anchor": "end" }),
    svg("text", { x: (left + width) / 2, y: height - 8, ...middle }, x.label),
    svg(
      "text",
      { x: 13, y: height / 2, transform: `rotate(-90 13 ${height / 2})`, ...middle },
      y.label,
    ),
  );
  return { picture, at };
}

/** Path of a line through points of a plane. */
export const line = (places: [number, number][]): string =>
  places.map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`).join("");
