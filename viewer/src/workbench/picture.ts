/** Small drawings of pages: elements of SVG, and a plane with its axes. */

import { heard } from "../words";
import { short, ticks } from "./multiples";

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

/** Round numbers along an axis: their values (SI), and their texts in its unit. */
function marked({ ends: [low, high], factor = 1 }: Axis): [number, string][] {
  const round = ticks(low * factor, high * factor, 7);
  return round.map((value) => [value / factor, short(value)]);
}

export function plane(x: Axis, y: Axis, attributes: Attributes): Plane {
  const [width, height, left, foot] = [560, 340, 66, 40];
  const [[x0, x1], [y0, y1]] = [x.ends, y.ends];
  const at = (a: number, b: number): [number, number] => [
    left + ((width - left - 12) * (a - x0)) / (x1 - x0),
    height - foot - ((height - foot - 10) * (b - y0)) / (y1 - y0),
  ];
  const middle = { "text-anchor": "middle" };
  const picture = svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "xy", ...attributes });
  picture.append(
    svg("path", { class: "axis", d: `M${left} 6V${height - foot}H${width - 8}` }),
    ...marked(x).flatMap(([value, text]) => {
      const [across, foot_] = at(value, y0);
      return [
        svg("path", { class: "axis", d: `M${across} ${foot_}v4` }),
        svg("text", { x: across, y: foot_ + 16, ...middle }, text),
      ];
    }),
    ...marked(y).flatMap(([value, text]) => {
      const [edge, up] = at(x0, value);
      return [
        svg("path", { class: "axis", d: `M${edge} ${up}h-4` }),
        svg("text", { x: edge - 6, y: up + 4, "text-anchor": "end" }, text),
      ];
    }),
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
