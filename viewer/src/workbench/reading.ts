/** A measured file before it is imported: columns, names, units and signs, with a preview. */

import { Store } from "../data";
import { make, written } from "../page";
import { tr } from "../words";
import { savable } from "./curves";
import { Question } from "./jobs";
import { field, snippets } from "./parts";
import { line, plane, svg } from "./picture";
import { inWords } from "./quantities";
import { advised, asSaid } from "./refusals";
import { table } from "./table";

interface Preview {
  columns: {
    name: string;
    unit: string;
    count: number;
    least: number | null;
    greatest: number | null;
  }[];
  more: number;
  problem: string | null;
  findings: { severity: string; place: string; message: string }[];
  content: object | null;
  points: { x: number[]; y: number[]; count: number } | null;
}
export interface Fields {
  columns: Record<string, string>;
  variable: string;
  sample_time: string;
  stroke_positive: string;
  force_positive: string;
}

const USUAL = [
  "time",
  "sprung.z",
  "sprung.az",
  "unsprung.z",
  "unsprung.az",
  "strut.deflection",
  "strut.force",
  "tyre.force",
  "road.z",
];

/** Force over deflection as dots. */
function xy(points: { x: number[]; y: number[]; count: number }): HTMLElement {
  const span = (values: number[]) => {
    let low = Math.min(0, ...values.slice(0, 1)),
      high = low;
    for (const value of values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return high > low ? ([low, high] as const) : ([low - 1, high + 1] as const);
  };
  const [x0, x1] = span(points.x),
    [y0, y1] = span(points.y);
  const { picture, at } = plane(
    { ends: [x0, x1], label: tr("deflection, compression positive [mm]") },
    { ends: [y0, y1], label: tr("force, compression positive [N]") },
    {
      role: "img",
      "aria-label": `force from ${written(y0, 3)} to ${written(y1, 3)} N over deflections from ${written(x0, 3)} to ${written(x1, 3)} mm`,
    },
  );
  const dots = points.x.map((x, k) => `${line([at(x, points.y[k]!)])}h.01`).join("");
  const axes = [line([at(0, y0), at(0, y1)]), line([at(x0, 0), at(x1, 0)])].join("");
  picture.append(svg("path", { class: "zero", d: axes }), svg("path", { class: "dots", d: dots }));
  const holder = make("figure", {});
  holder.append(
    picture,
    make("figcaption", { class: "muted" }, `preview of ${points.count} samples`),
  );
  return holder;
}

/** A form of how a file is read, with its preview; `fields` is what was chosen. */
export class Reading {
  readonly element = make("div", { class: "reading" });
  readonly fields: Fields = {
    columns: {},
    variable: "",
    sample_time: "",
    stroke_positive: "",
    force_positive: "",
  };
  private readonly mapping = make("tbody", {});
  private readonly names = make("datalist", { id: "channels-to-read" });
  private readonly question: Question<Preview>;
  private readonly signs = new Map<"stroke_positive" | "force_positive", HTMLSelectElement>();
  private known: Preview["columns"] = [];

  /** `like`: files whose way of being read is offered, where this one has their columns. */
  constructor(
    readonly file: string,
    public form: "recording" | "force-deflection",
    given: Partial<Fields> = {},
    private readonly like: { file: string; fields: Partial<Fields> }[] = [],
  ) {
    Object.assign(this.fields, given, { columns: { ...given.columns } });
    const sign = (key: "stroke_positive" | "force_positive", words: string[]) => {
      const select = make(
        "select",
        {},
        make("option", { value: "" }, "not stated"),
        ...words.map((word) =>
          make(
            "option",
            word === this.fields[key] ? { value: word, selected: true } : { value: word },
            `positive in ${word}`,
          ),
        ),
      );
      select.addEventListener("change", () => {
        this.fields[key] = select.value;
        void this.ask();
      });
      this.signs.set(key, select);
      return select;
    };
    const text = (key: "variable" | "sample_time", hint: string) => {
      const input = make("input", { type: "text", value: this.fields[key], placeholder: hint });
      input.addEventListener("change", () => {
        this.fields[key] = input.value.trim();
        if (key === "variable") {
          this.known = [];
          this.mapping.replaceChildren();
        } // its columns are others
        void this.ask();
      });
      return input;
    };
    this.question = new Question<Preview>(
      "Preview",
      () => ({ kind: "preview", files: [this.file], form: this.form, ...this.asked() }),
      (reply) => this.shown(reply.result, reply),
    );
    this.names.append(...USUAL.map((unit) => make("option", { value: unit })));
    this.element.append(
      make(
        "div",
        { class: "form" },
        field("Stroke", sign("stroke_positive", ["compression", "extension"])),
        field("Force", sign("force_positive", ["compression", "tension"])),
        ...(form === "recording"
          ? [field("Sample time, if not in the file", text("sample_time", "1 ms"))]
          : []),
        field("Variable or group (.mat, .tdms)", text("variable", "")),
        this.question.button,
      ),
      make(
        "details",
        { open: true },
        make("summary", {}, "Columns"),
        this.names,
        table(
          "columns",
          ["column of the file", "unit", "from", "to", "read as", "unit, if not in the file"],
          this.mapping,
        ),
      ),
      this.question.place,
    );
  }

  asked(): object {
    const { columns, variable, sample_time, stroke_positive, force_positive } = this.fields;
    return {
      columns,
      variable,
      stroke_positive,
      force_positive,
      ...(this.form === "recording" ? { sample_time } : {}),
    };
  }

  ask(): Promise<void> {
    return this.question.ask();
  }

  private shown(
    preview: Preview,
    reply: { python: string; command: string; files: Record<string, string> },
  ): HTMLElement[] {
    if (JSON.stringify(preview.columns) !== JSON.stringify(this.known)) {
      this.known = preview.columns;
      this.offer();
    }
    const shown: HTMLElement[] = this.alike();
    if (preview.problem)
      shown.push(make("p", { class: "problem", role: "alert" }, asSaid(preview.problem)));
    shown.push(
      ...advised(
        preview.findings.map((quantity) => ({ ...quantity, place: "" })),
        "p",
      ),
    );
    if (preview.more) shown.push(make("p", { class: "muted" }, `and ${preview.more} more columns`));
    if (preview.points) shown.push(xy(preview.points));
    if (preview.content) {
      const holder = make("div", {});
      shown.push(holder);
      void Store.open(JSON.stringify(preview.content))
        .then(inWords)
        .then((store) => {
          const model = store.content.viewers[0];
          if (model) holder.replaceChildren(savable(model, store).element);
        });
    }
    return [...shown, snippets(reply)];
  }

  /** A file of the same columns was read before: one button reads this one so, where nothing was said of it yet. */
  private alike(): HTMLElement[] {
    const names = new Set(this.known.map((quantity) => quantity.name));
    const same = this.like.find(
      (quantity) =>
        quantity.file !== this.file &&
        Object.values(quantity.fields.columns ?? {}).every((column) =>
          names.has(column.replace(/ \[[^\]]*\]$/, "")),
        ),
    );
    if (!same || Object.keys(this.fields.columns).length) return [];
    const button = make(
      "button",
      { type: "button" },
      tr("Read with the settings of #", same.file.split("/").pop()!),
    );
    button.addEventListener("click", () => {
      this.fields.columns = { ...same.fields.columns };
      for (const [key, select] of this.signs)
        select.value = this.fields[key] = same.fields[key] ?? "";
      this.offer();
      void this.ask();
    });
    return [make("p", { class: "bar" }, button)];
  }

  private offer(): void {
    const meant = Object.fromEntries(
      Object.entries(this.fields.columns).map(([name, column]) => [
        column.replace(/ \[[^\]]*\]$/, ""),
        { name, unit: /\[([^\]]*)\]$/.exec(column)?.[1] ?? "" },
      ]),
    );
    this.mapping.replaceChildren(
      ...this.known.map((quantity) => {
        const own = meant[quantity.name];
        const name =
          this.form === "recording"
            ? make("input", {
                type: "text",
                list: "channels-to-read",
                value: own?.name ?? "",
                placeholder: "as it is",
                "aria-label": `quantity of ${quantity.name}`,
                size: "16",
              })
            : make(
                "select",
                { "aria-label": `quantity of ${quantity.name}` },
                ...["", "displacement", "force"].map((word) =>
                  make(
                    "option",
                    word === (own?.name ?? "") ? { value: word, selected: true } : { value: word },
                    word || "as it is",
                  ),
                ),
              );
        const unit = make("input", {
          type: "text",
          value: own?.unit ?? "",
          placeholder: quantity.unit || "e.g. mm",
          "aria-label": `unit of ${quantity.name}`,
          size: "8",
        });
        const take = () => {
          for (const [key, column] of Object.entries(this.fields.columns))
            if (column.replace(/ \[[^\]]*\]$/, "") === quantity.name)
              delete this.fields.columns[key];
          if (name.value)
            this.fields.columns[name.value] = unit.value.trim()
              ? `${quantity.name} [${unit.value.trim()}]`
              : quantity.name;
          void this.ask();
        };
        name.addEventListener("change", take);
        unit.addEventListener("change", take);
        return make(
          "tr",
          {},
          make("th", { scope: "row" }, quantity.name),
          make("td", {}, quantity.unit || "–"),
          make("td", { class: "right" }, written(quantity.least)),
          make("td", { class: "right" }, written(quantity.greatest)),
          make("td", {}, name),
          make("td", {}, unit),
        );
      }),
    );
  }
}
