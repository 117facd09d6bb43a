/** Tables of pages: a labelled scroll region with column and row headers. */

import { make } from "../page";
import { saveTable } from "./saving";

export type Cell = Node | string | (Node | string)[];

/** A row with its first cell as header; columns in `numbers` are right-aligned. */
export function row(cells: Cell[], numbers: number[] = []): HTMLTableRowElement {
  return make(
    "tr",
    {},
    ...cells.map((cell, k) =>
      make(k ? "td" : "th", k ? aligned(numbers.includes(k)) : { scope: "row" }, ...[cell].flat()),
    ),
  );
}

/** A table of rows, or with a body that is filled elsewhere; empty headers stay empty. */
export function table(
  label: string,
  header: Cell[],
  rows: Cell[][] | HTMLTableSectionElement,
  numbers: number[] = [],
  caption = "",
): HTMLElement {
  const heads = header.map((cell, k) =>
    cell === ""
      ? make("td", {})
      : make("th", { scope: "col", ...aligned(numbers.includes(k)) }, ...[cell].flat()),
  );
  const body = Array.isArray(rows)
    ? make("tbody", {}, ...rows.map((cells) => row(cells, numbers)))
    : rows;
  const whole = make(
    "table",
    {},
    ...(caption ? [make("caption", {}, caption)] : []),
    make("thead", {}, make("tr", {}, ...heads)),
    body,
  );
  const region = { class: "table", tabindex: "0", role: "region", "aria-label": label };
  return make("div", { class: "savable" }, make("div", region, whole), saveTable(whole, label));
}

const aligned = (isNumber: boolean): Record<string, string> => (isNumber ? { class: "right" } : {});
