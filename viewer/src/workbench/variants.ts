/** Many variants at once: filtered lines on parallel axes and a scatter plot matrix with the same selection. */

import { colour, make, sized, whenColoursChange, written } from "../page";
import { heard, tr } from "../words";
import { numberBox } from "./numberbox";
import { svg } from "./picture";
import { type Cell, table } from "./table";

export interface Column {
  name: string;
  unit: string;
  factor: number;
  is_number: boolean;
  values: (number | null)[];
}

/** A name that may break behind a dot only. */
const dotted = (text: string) =>
  text.split(/(?<=\.)(?=[a-z])/).flatMap((part, i) => (i ? [make("wbr"), part] : [part]));
const named = (column: Column) => `${column.name} [${column.unit || "–"}]`;
const ends = (values: (number | null)[]): [number, number] => {
  let low = Infinity,
    high = -Infinity;
  for (const value of values)
    if (value !== null) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  return low < high
    ? [low, high]
    : low === high
      ? [low - (Math.abs(low) || 1) * 0.5, low + (Math.abs(low) || 1) * 0.5]
      : [0, 1];
};

/** Selection of variants: those within all ranges. */
export class Brushes {
  readonly ranges = new Map<number, [number, number]>();
  chosen: boolean[] = [];
  picked = -1;
  private readonly listeners: (() => void)[] = [];

  constructor(readonly columns: Column[]) {
    this.count();
  }

  listen(change: () => void): void {
    this.listeners.push(change);
  }

  set(column: number, range: [number, number] | null): void {
    if (range) this.ranges.set(column, range);
    else this.ranges.delete(column);
    this.count();
  }

  clear(): void {
    this.ranges.clear();
    this.count();
  }

  pick(row: number): void {
    this.picked = row;
    for (const change of this.listeners) change();
  }

  private count(): void {
    const rows = this.columns[0]?.values.length ?? 0;
    this.chosen = Array.from({ length: rows }, (_, row) =>
      [...this.ranges].every(([k, [low, high]]) => {
        const value = this.columns[k]!.values[row];
        return value !== null && value !== undefined && value >= low && value <= high;
      }),
    );
    for (const change of this.listeners) change();
  }
}

const SPACE = 130,
  TOP = 26,
  HIGH = 250,
  FOOT = 22;

/** Lines through parallel axes: drag along an axis to keep what passes there, or type the ends of a range. */
export function parallel(brushes: Brushes): HTMLElement {
  const { columns } = brushes,
    scales = columns.map((column) => ends(column.values));
  const width = SPACE * columns.length,
    height = TOP + HIGH + FOOT;
  const drawing = make("canvas"),
    context = sized(drawing, width, height);
  drawing.setAttribute("role", "img");
  drawing.setAttribute(
    "aria-label",
    heard(`every variant as a line through ${columns.map(named).join(", ")}`),
  );
  const at = (k: number) => SPACE * (k + 0.5);
  const y = (k: number, value: number) => {
    const [low, high] = scales[k]!;
    return TOP + HIGH * (1 - (value - low) / (high - low));
  };
  const draw = () => {
    context.clearRect(0, 0, width, height);
    const line = (row: number) => {
      context.beginPath();
      let open = false;
      columns.forEach((column, k) => {
        const value = column.values[row];
        if (value === null || value === undefined) {
          open = false;
          return;
        }
        if (open) context.lineTo(at(k), y(k, value));
        else context.moveTo(at(k), y(k, value));
        open = true;
      });
      context.stroke();
    };
    const rows = brushes.chosen.length;
    context.lineWidth = 1;
    context.strokeStyle = colour("line");
    if (brushes.ranges.size)
      for (let row = 0; row < rows; row++) if (!brushes.chosen[row]) line(row);
    context.strokeStyle = colour("accent");
    context.globalAlpha = Math.max(0.08, Math.min(0.7, 60 / Math.max(rows, 1)));
    for (let row = 0; row < rows; row++) if (brushes.chosen[row]) line(row);
    context.globalAlpha = 1;
    if (brushes.picked >= 0) {
      context.strokeStyle = colour("other-5");
      context.lineWidth = 2.5;
      line(brushes.picked);
    }
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "center";
    columns.forEach((column, k) => {
      const [low, high] = scales[k]!;
      context.strokeStyle = colour("edge");
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(at(k), TOP);
      context.lineTo(at(k), TOP + HIGH);
      context.stroke();
      const range = brushes.ranges.get(k);
      if (range) {
        context.fillStyle = colour("other-5");
        context.globalAlpha = 0.3;
        context.fillRect(
          at(k) - 7,
          y(k, range[1]),
          14,
          Math.max(2, y(k, range[0]) - y(k, range[1])),
        );
        context.globalAlpha = 1;
      }
      context.fillStyle = colour("ink");
      context.fillText(written(high, 3), at(k), TOP - 8);
      context.fillText(written(low, 3), at(k), TOP + HIGH + 15);
      void column;
    });
  };
  let from: { k: number; value: number } | null = null;
  const place = (event: PointerEvent) => {
    const box = drawing.getBoundingClientRect();
    const k = Math.min(
      columns.length - 1,
      Math.max(0, Math.floor((event.clientX - box.left) / SPACE)),
    );
    const share = Math.min(1, Math.max(0, 1 - (event.clientY - box.top - TOP) / HIGH)),
      [low, high] = scales[from?.k ?? k]!;
    return { k, value: low + share * (high - low) };
  };
  drawing.addEventListener("pointerdown", (event) => {
    from = place(event);
    drawing.setPointerCapture(event.pointerId);
  });
  drawing.addEventListener("pointermove", (event) => {
    if (!from) return;
    const { value } = place(event),
      [low, high] = scales[from.k]!;
    if (Math.abs(value - from.value) > 0.01 * (high - low))
      brushes.set(from.k, [Math.min(value, from.value), Math.max(value, from.value)]);
  });
  drawing.addEventListener("pointerup", (event) => {
    if (
      from &&
      Math.abs(place(event).value - from.value) < 0.01 * (scales[from.k]![1] - scales[from.k]![0])
    )
      brushes.set(from.k, null); // a click takes it away
    from = null;
  });
  brushes.listen(draw);
  whenColoursChange(draw);
  draw();
  const heads = make(
    "div",
    { class: "axes" },
    ...columns.map((column) =>
      make(
        "span",
        { title: named(column) },
        ...dotted(column.name),
        make("small", {}, column.unit || "–"),
      ),
    ),
  );
  heads.style.width = `${width}px`;
  heads.style.gridTemplateColumns = `repeat(${columns.length}, ${SPACE}px)`;
  return make(
    "div",
    { class: "wide", tabindex: "0", role: "region", "aria-label": "parallel coordinates" },
    heads,
    drawing,
  );
}

/** The ranges as numbers, for those who do not drag. */
export function ranges(brushes: Brushes): HTMLElement {
  const cells = brushes.columns.map((column, k) => {
    const [low, high] = ends(column.values);
    const inputs = ["from", "to"].map((word) =>
      numberBox({
        step: "any",
        "aria-label": `${column.name}, ${word} [${column.unit || "–"}]`,
        placeholder: written(word === "from" ? low : high, 4),
      }),
    );
    const take = () => {
      const [a, b] = inputs.map((input) => input.value);
      brushes.set(k, a || b ? [a ? Number(a) : -Infinity, b ? Number(b) : Infinity] : null);
    };
    for (const input of inputs) input.addEventListener("change", take);
    brushes.listen(() => {
      const range = brushes.ranges.get(k);
      inputs.forEach((input, i) => {
        if (document.activeElement !== input)
          input.value =
            range && Number.isFinite(range[i]!) ? String(Number(range[i]!.toPrecision(4))) : "";
      });
    });
    return [column.name, inputs[0]!, inputs[1]!, column.unit || "–"];
  });
  return make(
    "details",
    {},
    make("summary", {}, "Ranges as numbers"),
    table("ranges", ["", "from", "to", "unit"], cells),
  );
}

const WIDE = 170,
  TALL = 130,
  MARGIN = 8;

/** Scatter plot of two columns. */
function dots(brushes: Brushes, x: Column, y: Column): HTMLElement {
  const drawing = make("canvas"),
    context = sized(drawing, WIDE, TALL),
    [x0, x1] = ends(x.values),
    [y0, y1] = ends(y.values);
  const px = (value: number) => MARGIN + ((WIDE - 2 * MARGIN) * (value - x0)) / (x1 - x0),
    py = (value: number) => TALL - MARGIN - ((TALL - 2 * MARGIN) * (value - y0)) / (y1 - y0);
  drawing.setAttribute("role", "img");
  drawing.setAttribute(
    "aria-label",
    heard(
      `${named(y)} over ${named(x)}: ${written(y0, 3)} to ${written(y1, 3)} over ${written(x0, 3)} to ${written(x1, 3)}`,
    ),
  );
  const draw = () => {
    context.clearRect(0, 0, WIDE, TALL);
    context.strokeStyle = colour("edge");
    context.strokeRect(0.5, 0.5, WIDE - 1, TALL - 1);
    const rows = brushes.chosen.length;
    const put = (row: number, size: number) => {
      const a = x.values[row],
        b = y.values[row];
      if (a !== null && a !== undefined && b !== null && b !== undefined)
        context.fillRect(px(a) - size / 2, py(b) - size / 2, size, size);
    };
    context.fillStyle = colour("line");
    for (let row = 0; row < rows; row++) if (!brushes.chosen[row]) put(row, 2);
    context.fillStyle = colour("accent");
    context.globalAlpha = rows > 400 ? 0.5 : 0.9;
    for (let row = 0; row < rows; row++) if (brushes.chosen[row]) put(row, 2.5);
    context.globalAlpha = 1;
    if (brushes.picked >= 0) {
      context.fillStyle = colour("other-5");
      put(brushes.picked, 7);
    }
  };
  drawing.addEventListener("click", (event) => {
    const box = drawing.getBoundingClientRect(),
      at = [event.clientX - box.left, event.clientY - box.top];
    let best = -1,
      least = 15 ** 2;
    x.values.forEach((a, row) => {
      const b = y.values[row];
      if (a === null || b === null || b === undefined || !brushes.chosen[row]) return;
      const far = (px(a) - at[0]!) ** 2 + (py(b) - at[1]!) ** 2;
      if (far < least) {
        least = far;
        best = row;
      }
    });
    if (best >= 0) brushes.pick(best);
  });
  brushes.listen(draw);
  whenColoursChange(draw);
  draw();
  return drawing;
}

/** Scatter plots of all metrics over all parameters. */
export function matrix(brushes: Brushes): HTMLElement {
  const numbers = brushes.columns.filter((column) => column.is_number).slice(0, 8),
    metrics = brushes.columns.filter((column) => !column.is_number).slice(0, 6);
  return make(
    "div",
    { class: "wide table", tabindex: "0", role: "region", "aria-label": "scatter plot matrix" },
    make(
      "table",
      { class: "matrix" },
      make(
        "thead",
        {},
        make(
          "tr",
          {},
          make("td", {}),
          ...numbers.map((parameter) => make("th", { scope: "col" }, ...dotted(named(parameter)))),
        ),
      ),
      make(
        "tbody",
        {},
        ...metrics.map((metric) =>
          make(
            "tr",
            {},
            make("th", { scope: "row" }, ...dotted(named(metric))),
            ...numbers.map((number) => make("td", {}, dots(brushes, number, metric))),
          ),
        ),
      ),
    ),
  );
}

export interface Influence {
  metric: string;
  number: string;
  measures: Record<string, { value: number; interval: [number, number] | null } | number>;
}
const INDEX: [string, string][] = [
  ["total", "share of the variance, with interactions"],
  ["mean_absolute_effect", "mean absolute effect"],
  ["regression", "regression coefficient"],
];

/** Sensitivity of a metric as bars, the most important parameter first. */
export function tornado(influences: Influence[], metric: Column, mean: number): HTMLElement {
  const value = (influence: Influence, key: string) => {
    const measure = influence.measures[key];
    return typeof measure === "number" ? measure : (measure?.value ?? NaN);
  };
  const own = influences.filter((influence) => influence.metric === metric.name);
  const [key, words] = INDEX.find(([key]) =>
    own.some((influence) => Number.isFinite(value(influence, key))),
  ) ?? ["regression", "regression coefficient"];
  own.sort((a, b) => Math.abs(value(b, key)) - Math.abs(value(a, key)));
  const swings = own.map((influence) =>
    [value(influence, "at_low"), value(influence, "at_high")].map(
      (end) => (end - mean) * metric.factor,
    ),
  );
  const reach = Math.max(1e-300, ...swings.flat().filter(Number.isFinite).map(Math.abs));
  const rows = own.map((influence, k) => {
    const picture = svg("svg", { viewBox: "-100 0 200 16", class: "swing", "aria-hidden": "true" });
    picture.append(svg("line", { x1: 0, x2: 0, y1: 0, y2: 16, class: "zero" }));
    swings[k]!.forEach((swing, i) => {
      if (!Number.isFinite(swing)) return;
      const long = (96 * swing) / reach;
      picture.append(
        svg("rect", {
          x: Math.min(0, long),
          width: Math.abs(long),
          y: i ? 8.5 : 1.5,
          height: 6,
          class: i ? "high" : "low",
        }),
      );
    });
    const texts = swings[k]!.map((swing) =>
      Number.isFinite(swing) ? `${swing > 0 ? "+" : ""}${written(swing, 3)}` : "–",
    );
    return [influence.number, texts[0]!, picture, texts[1]!, written(value(influence, key), 3)];
  });
  const end = (word: string): Cell => [
    make("span", { class: `key ${word}` }),
    ` ${tr(word)} [${metric.unit || "–"}]`,
  ];
  return table(
    `what ${metric.name} depends on`,
    ["parameter", end("low"), "", end("high"), words],
    rows,
    [1, 3, 4],
    `${metric.name}: mean ${written(mean * metric.factor, 4)} ${metric.unit}; change where a parameter is low and where it is high`,
  );
}
