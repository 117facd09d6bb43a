/** Files that came in: what the server says of them, what was typed in their rows, and what they still lack. */

import { passing } from "../browser";
import { tr } from "../words";

export interface Missing {
  what: "unit" | "speed" | "pressure" | "sign" | "channel" | "road";
  column: string;
  proposal: string;
}
export interface Preview {
  file: string;
  kind: string;
  doubt: string;
  summary: string;
  columns: { name: string; unit: string }[];
  curve: { x?: number[]; y?: number[]; x_label?: string; y_label?: string };
  missing: Missing[];
  fields: Record<string, string | number | Record<string, string>>;
  state: string;
}
/** What is kept of the list while its tab is open: the files, what was typed in their rows, and how they are read. */
export interface List {
  paths: string[];
  lost: { name: string; why: string }[];
  typed: Record<string, Record<string, string>>;
  columns: Record<string, Record<string, string>>;
  table: string;
  target: Record<string, string>;
  /** Values of the laboratory for the rig of a new campaign, by path. */
  values: Record<string, string>;
}

const KEY = "jounce-files";
/** In place of a campaign's path: a new one is made. */
export const NEW = "+";
export const KINDS: Record<string, string> = {
  trial: "trial",
  decay: "free decay",
  spring: "spring",
  tyre: "tyre",
  "": "not in the campaign",
};
export const CHOICES: Record<string, [value: string, words: string][]> = {
  use: [
    ["", "use: automatic"],
    ["fit", "fit"],
    ["hold-out", "hold-out"],
  ],
  stroke_positive: [
    ["", "stroke: sign not stated"],
    ["compression", "stroke positive in compression"],
    ["extension", "stroke positive in extension"],
  ],
  force_positive: [
    ["", "force: sign not stated"],
    ["compression", "force positive in compression"],
    ["tension", "force positive in tension"],
  ],
};
/** Inputs of each kind, with their labels and examples. */
export const INPUTS: Record<string, [key: string, label: string, example: string][]> = {
  trial: [
    ["number", "number", "1"],
    ["speed", "speed", "2 m/s"],
    ["tyre_pressure", "tyre pressure", "0.31 MPa"],
    ["strut_angle", "strut angle", "26 deg"],
    ["road", "road", ""],
    ["use", "use", ""],
  ],
  tyre: [
    ["pressure", "pressure", "0.31 MPa"],
    ["discard_below", "ignore below", "2 mm"],
  ],
  spring: [["discard_below", "ignore below", "2 mm"]],
  decay: [],
};
export const NEEDED = ["speed", "pressure"];
/** Kinds whose files hold force over displacement. */
export const CURVES = ["spring", "tyre"];

/** A sentence about a number of files. */
export const countedFiles = (count: number, single: string, several: string): string =>
  count === 1 ? tr(single) : tr(several, String(count));

const empty = (): List => ({
  paths: [],
  lost: [],
  typed: {},
  columns: {},
  table: "",
  target: {},
  values: {},
});

function stored(): List {
  try {
    return { ...empty(), ...(JSON.parse(passing?.getItem(KEY) ?? "{}") as List) };
  } catch {
    return empty();
  }
}

export class Arrivals {
  readonly list = stored();
  previews: Preview[] = [];
  /** Names of the roads that a trial can have. */
  roads: string[] = ["A"];
  /** Why files were refused, by file. */
  refused = new Map<string, Node | string>();

  /** `changed` hears that a row was changed, `reread` that files must be read in another way. */
  constructor(
    private readonly changed: () => void,
    private readonly reread: () => void,
  ) {}

  get isNew(): boolean {
    return this.list.target.campaign === NEW;
  }

  get chosen(): Preview[] {
    return this.previews.filter((preview) => this.isIn(preview));
  }

  keep(): void {
    try {
      passing?.setItem(KEY, JSON.stringify(this.list));
    } catch {
      /* full: the list is known as long as the page is open */
    }
  }

  /** Forgets all files, but not the campaign if `target` is true. */
  clear(target = false): void {
    const { target: same } = this.list;
    Object.assign(this.list, empty(), target ? { target: same } : {});
    this.keep();
  }

  /** Forgets files that were entered. */
  drop(files: readonly string[]): void {
    this.list.paths = this.list.paths.filter((path) => !files.includes(path));
    for (const file of files) {
      delete this.list.typed[file];
      delete this.list.columns[file];
    }
    this.previews = this.previews.filter((preview) => this.list.paths.includes(preview.file));
  }

  private typed(path: string): Record<string, string> {
    this.list.typed[path] ??= {};
    return this.list.typed[path];
  }

  /** What a row says: what was typed, else what the file says. */
  value(preview: Preview, key: string): string {
    const own = this.list.typed[preview.file]?.[key];
    if (own !== undefined) return own;
    if (key === "kind") return preview.kind in KINDS ? preview.kind : "";
    const known = preview.fields[key];
    if (known !== undefined) return String(known);
    return key === "road" ? (this.roads[0] ?? "") : "";
  }

  /** Takes what was typed in the row of a file. */
  type(preview: Preview, values: Record<string, string>): void {
    Object.assign(this.typed(preview.file), values);
    this.refused.delete(preview.file);
    this.changed();
  }

  isIn(preview: Preview): boolean {
    return this.list.typed[preview.file]?.off !== "yes" && this.value(preview, "kind") !== "";
  }

  /** Ticks files, or unticks them. */
  tick(previews: readonly Preview[], isIn: boolean): void {
    for (const preview of previews) this.typed(preview.file).off = isIn ? "" : "yes";
    this.changed();
  }

  /** Gives all ticked files that have such a field the same value. */
  setTogether(key: string, value: string): void {
    for (const preview of this.chosen) {
      const kind = this.value(preview, "kind");
      const fits =
        key === "kind"
          ? preview.columns.length > 0
          : key.endsWith("_positive") || (INPUTS[kind] ?? []).some(([own]) => own === key);
      if (fits) this.typed(preview.file)[key] = value.trim();
    }
    this.refused.clear();
    this.changed();
  }

  /** The ticked files with the same columns. */
  alike(one: Preview): Preview[] {
    const names = (preview: Preview) => preview.columns.map(({ name }) => name).join("\n");
    return this.previews.filter(
      (other) => other === one || (this.isIn(other) && names(other) === names(one)),
    );
  }

  /** Reads the columns of a file, and of those like it, under other names and with other values. */
  readAs(
    preview: Preview,
    columns: (one: Preview) => Record<string, string>,
    values: Record<string, string> = {},
  ): void {
    for (const one of this.alike(preview)) {
      this.list.columns[one.file] = columns(one);
      Object.assign(this.typed(one.file), values);
    }
    this.keep();
    this.reread();
  }

  /** What a file still lacks, in words. */
  lacks(preview: Preview): string[] {
    const kind = this.value(preview, "kind");
    const words: Record<Missing["what"], string> = {
      unit: tr("unit of #"),
      speed: tr("speed"),
      pressure: tr("pressure"),
      sign: tr("sign"),
      channel: tr("names of the columns"),
      road: tr("road of #"),
    };
    const known = preview.missing.filter(({ what, column, proposal }) =>
      what === "unit"
        ? !proposal &&
          !Object.values(this.list.columns[preview.file] ?? {}).some((c) => c.startsWith(column))
        : what === "sign"
          ? CURVES.includes(kind) &&
            !this.value(preview, "stroke_positive") &&
            !this.value(preview, "force_positive")
          : what === "road"
            ? this.list.typed[preview.file]?.road === undefined
            : what === "channel",
    );
    const needed = (INPUTS[kind] ?? [])
      .map(([key]) => key)
      .filter((key) => NEEDED.includes(key) && !this.value(preview, key));
    return [
      ...known.map(({ what, column }) => words[what].replace("#", column)),
      ...needed.map((key) => words[key as "speed" | "pressure"]),
    ];
  }

  /** The entry of a file in a campaign. */
  entry(preview: Preview): { use: string; fields: object; file: string; state: string } {
    const { file, state } = preview,
      kind = this.value(preview, "kind");
    const typed = Object.fromEntries(
      (INPUTS[kind] ?? []).map(([key]) => [key, this.value(preview, key)]),
    );
    const { columns, channel, sample_time } = preview.fields;
    const read = {
      columns,
      stroke_positive: this.value(preview, "stroke_positive"),
      ...(kind === "decay" ? {} : { force_positive: this.value(preview, "force_positive") }),
    };
    const time = this.value(preview, "sample_time") || sample_time || "";
    const own =
      kind === "trial"
        ? {
            sample_time: time,
            number: /^\d+$/.test(typed.number ?? "") ? Number(typed.number) : typed.number,
            recording: file,
          }
        : { files: [file], ...(kind === "decay" ? { channel, sample_time: time } : {}) };
    return { use: kind, fields: { ...typed, ...read, ...own }, file, state };
  }
}
