/** What components show, as data: curves for whoever writes them into a file. */

import type { Numbers } from "./data";

export interface ShownCurve {
  label: string;
  role: string;
  y: Numbers;
}
export interface ShownPanel {
  title: string;
  unit: string;
  curves: ShownCurve[];
}
/** Panels over one axis; `window` is the part of it that is visible. */
export interface ShownChart {
  x_label: string;
  x: Numbers;
  panels: ShownPanel[];
  window: [number, number];
  columns: number;
}

const charts = new WeakMap<Element, () => ShownChart | null>();

/** Lets an element tell which curves it shows. */
export function offerChart(element: Element, chart: () => ShownChart | null): void {
  charts.set(element, chart);
}

/** The curves that an element shows; null if it shows none. */
export const chartOf = (element: Element): ShownChart | null => charts.get(element)?.() ?? null;
