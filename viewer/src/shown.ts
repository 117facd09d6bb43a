/** What components show, as data: curves for whoever writes them into a file. */

import type { Numbers } from "./data";

export interface ShownCurve {
  label: string;
  role: string;
  y: Numbers;
}
export interface ShownPanel {
  name: string; // of the quantity or channel
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

/** What curves offer beside their names, and which of them come first: lower ranks do, those of the others are infinite. */
export interface Offer {
  buttons: (name: string, title: string, element: Element) => Node[];
  rank: (name: string) => number;
}

/** Whether a text has all words of what is sought, or of one of its parts between commas. */
export function seeker(sought: string): (own: string) => boolean {
  const parts = sought
    .toLowerCase()
    .split(/[,;…]/)
    .map((part) => part.split(/\s+/).filter(Boolean))
    .filter((words) => words.length);
  return (own) =>
    !parts.length || parts.some((words) => words.every((word) => own.toLowerCase().includes(word)));
}

/** Things by their ranks; those of equal rank stay in order. */
export const sorted = <T>(things: T[], rank: (nullable: T) => number): T[] =>
  things
    .map((thing, k): [number, number, T] => [Math.min(rank(thing), 1e9), k, thing])
    .sort(([a, i], [b, j]) => a - b || i - j)
    .map(([, , one]) => one);

/** A drawing as paths in pixels, from back to front, with the names in it. */
export interface ShownDrawing {
  title: string;
  width: number;
  height: number;
  shapes: DrawnShape[];
  names: { text: string; x: number; y: number }[];
}
export interface DrawnShape {
  d: string;
  fill?: string;
  stroke?: string;
  width?: number;
  dash?: number[];
  alpha?: number;
}

const drawings = new WeakMap<Element, (all: boolean) => ShownDrawing[]>();

/** Lets an element tell what it draws: as it is seen, or in all its views. */
export function offerDrawings(element: Element, views: (all: boolean) => ShownDrawing[]): void {
  drawings.set(element, views);
}

/** The drawing that an element shows, or all its views; none if it draws nothing. */
export const drawingsOf = (element: Element, all = false): ShownDrawing[] =>
  drawings.get(element)?.(all) ?? [];
