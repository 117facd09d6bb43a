/** How the curve of each role is drawn, on every page and in its legend. */

import { tr } from "./words";

interface LineStyle {
  width: number;
  dash: number[]; // px
  words: string;
}
const STYLES: Record<string, LineStyle> = {
  measured: { width: 2, dash: [], words: "solid" },
  after: { width: 1.6, dash: [], words: "solid" },
  before: { width: 1.25, dash: [5, 3], words: "dashed" },
  "other-5": { width: 1.25, dash: [5, 3], words: "dashed" },
  "other-1": { width: 1.5, dash: [2, 3], words: "dotted" },
  "other-2": { width: 1.25, dash: [8, 3, 2, 3], words: "dash-dotted" },
  "other-3": { width: 1.25, dash: [12, 4], words: "long dashes" },
  "other-4": { width: 1.25, dash: [8, 3, 2, 3, 2, 3], words: "dash and two dots" },
  "other-6": { width: 1.5, dash: [2, 7], words: "wide dots" },
};

export const lineStyle = (role: string): LineStyle =>
  STYLES[role] ?? { width: 1.25, dash: [], words: "solid" };

/** Name of a curve with its line style in words, for those who do not see its colour. */
export const inStyle = (label: string, role: string): string =>
  `${label} (${tr(lineStyle(role).words)})`;

/** Curves in the order of drawing: the changed one comes last, on top of all others. */
export const drawingOrder = <T extends { role: string }>(curves: readonly T[]): T[] =>
  [...curves].sort(
    (curve, other) => Number(curve.role === "after") - Number(other.role === "after"),
  );
