/** Files that come in: recognised, mended, and entered together into a campaign. */

import { passing } from "../../browser";
import { make, written } from "../../page";
import { heard, tr } from "../../words";
import * as api from "../api";
import { arrived, choosers, type Given, store } from "../incoming";
import { ask } from "../jobs";
import { field, once, problem, select, snippets, textBox } from "../parts";
import { line, svg } from "../picture";
import { type Fields, Reading } from "../reading";
import { asSaid, Refused } from "../refusals";
import { address, goTo, OPENS, type Values } from "../shell";

interface Missing {
  what: "unit" | "speed" | "pressure" | "sign" | "channel";
  column: string;
  proposal: string;
}
interface Preview {
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
interface Previews {
  files: Preview[];
  roads: Record<string, object>;
}
/** What is kept of the list while its tab is open: the files, what was typed in their rows, and how they are read. */
interface List {
  paths: string[];
  lost: { name: string; why: string }[];
  typed: Record<string, Record<string, string>>;
  columns: Record<string, Record<string, string>>;
  table: string;
  target: Record<string, string>;
}
interface Entered {
  entered: string[];
  refused: { file: string; message: string; german: string | null }[];
}

const KEY = "jounce-files",
  NEW = "+";
const KINDS: Record<string, string> = {
  trial: "trial",
  decay: "free decay",
  spring: "spring",
  tyre: "tyre",
  "": "not in the campaign",
};
const LENGTHS = ["mm", "cm", "m", "inch"],
  FORCES = ["N", "kN", "kgf", "lbf"];
const CHOICES: Record<string, [value: string, words: string][]> = {
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
const INPUTS: Record<string, [key: string, label: string, example: string][]> = {
  trial: [
    ["number", "number", "1"],
    ["speed", "speed", "2 m/s"],
    ["tyre_pressure", "tyre pressure", "0.31 MPa"],
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
const NEEDED = ["speed", "pressure"];

const empty = (): List => ({
  paths: [],
  lost: [],
  typed: {},
  columns: {},
  table: "",
  target: {},
});

function kept(): List {
  try {
    return { ...empty(), ...(JSON.parse(passing?.getItem(KEY) ?? "{}") as List) };
  } catch {
    return empty();
  }
}

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const list = kept(),
    campaign = values.get("campaign") ?? "";
  const keep = () => {
    try {
      passing?.setItem(KEY, JSON.stringify(list));
    } catch {
      /* full: the list is known as long as the page is open */
    }
  };
  const [given, project, library] = [arrived(), await api.project(), await api.library()];
  const status = make("div", { "aria-live": "polite" }),
    rest = make("div", {});
  place.replaceChildren(
    make("h1", {}, "New files"),
    make(
      "p",
      { class: "muted" },
      "Drop files or folders anywhere, or choose them. They are stored in the project and recognised; nothing enters a campaign before you say so.",
    ),
    choosers(campaign),
    status,
    rest,
  );
  if (given.length) await upload(given, folderOf(campaign), list, status);
  keep();
  if (!place.isConnected) return;
  const table = new Table(place, list, keep, campaign, project.entries, library);
  rest.replaceChildren(table.element);
  await table.look();
}

const folderOf = (path: string) =>
  `${path.includes("/") ? path.slice(0, path.lastIndexOf("/") + 1) : ""}measured`;

/** Uploads the files one by one; what fails is listed, and stops no other. */
async function upload(
  given: Given[],
  folder: string,
  list: List,
  status: HTMLElement,
): Promise<void> {
  const bar = make("progress", { max: String(given.length), "aria-label": "upload" }),
    said = make("p", { class: "state" });
  status.replaceChildren(bar, said);
  list.lost = [];
  for (const [k, one] of given.entries()) {
    bar.value = k;
    said.textContent = tr("uploading #", one.path);
    try {
      const path = await store(one, folder);
      if (!list.paths.includes(path)) list.paths.push(path);
    } catch (error) {
      list.lost.push({
        name: one.path,
        why: error instanceof Error ? error.message : String(error),
      });
    }
  }
  status.replaceChildren();
}

/** A small curve of a file. */
function sparkline({ file, curve }: Preview): HTMLElement | SVGElement {
  const { x = [], y = [] } = curve;
  if (x.length < 2) return make("span", { class: "muted" }, "–");
  const [width, height] = [120, 34];
  const ends = (all: number[]) => [Math.min(...all), Math.max(...all)] as [number, number];
  const [x0, x1] = ends(x),
    [y0, y1] = ends(y);
  const path = line(
    x.map((at, k) => [
      2 + ((width - 4) * (at - x0)) / (x1 - x0 || 1),
      height - 2 - ((height - 4) * (y[k]! - y0)) / (y1 - y0 || 1),
    ]),
  );
  const picture = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    class: "spark",
    role: "img",
    "aria-label": `${curve.y_label ?? ""}: ${written(y0, 3)} … ${written(y1, 3)} (${file.split("/").pop()})`,
  });
  picture.append(svg("path", { d: path }));
  return picture;
}

/** The list of files with all that can be mended, and the campaign that they enter. */
class Table {
  readonly element = make("section", {});
  private previews: Preview[] = [];
  private roads: string[] = ["A"];
  private trains: Record<string, object> = {};
  private refused = new Map<string, Node | string>();
  private done: string[] = [];
  private readonly body = make("tbody", {});
  private readonly status = make("div", { "aria-live": "polite" });
  private readonly reader = make("div", {});
  private readonly counted = make("p", { class: "state", role: "status" });
  private readonly enterButton = make(
    "button",
    { type: "button", class: "main" },
    "Enter into the campaign",
  );

  constructor(
    private readonly place: HTMLElement,
    private readonly list: List,
    private readonly keep: () => void,
    campaign: string,
    private readonly entries: api.Entry[],
    private readonly library: { name: string; has_hardpoints: boolean }[],
  ) {
    const campaigns = entries
      .filter((entry) => entry.kind === "campaign")
      .map((entry) => entry.path);
    if (campaign && campaigns.includes(campaign)) list.target.campaign = campaign;
    if (!campaigns.includes(list.target.campaign ?? ""))
      list.target.campaign = campaigns.length === 1 ? campaigns[0]! : NEW;
    this.enterButton.addEventListener("click", () => void this.enter());
  }

  private typed(path: string): Record<string, string> {
    this.list.typed[path] ??= {};
    return this.list.typed[path];
  }

  /** What a row says: what was typed, else what the file says. */
  private value(preview: Preview, key: string): string {
    const own = this.typed(preview.file)[key];
    if (own !== undefined) return own;
    if (key === "kind") return preview.kind in KINDS ? preview.kind : "";
    const known = preview.fields[key];
    if (known !== undefined) return String(known);
    return key === "road" ? (this.roads[0] ?? "") : "";
  }

  private isIn(preview: Preview): boolean {
    return this.typed(preview.file).off !== "yes" && this.value(preview, "kind") !== "";
  }

  /** Asks what the files are; where they cannot be read together, each is read alone. */
  async look(): Promise<void> {
    const { paths, columns, table } = this.list;
    if (!paths.length) {
      this.draw();
      return;
    }
    this.status.replaceChildren(
      make("p", { class: "state" }, tr("reading # files …", String(paths.length))),
    );
    if (!this.element.childElementCount) this.element.append(this.status);
    const question = (some: string[]) =>
      ask<Previews>({
        kind: "preview-files",
        files: some,
        columns: Object.fromEntries(some.filter((p) => columns[p]).map((p) => [p, columns[p]!])),
        table,
      });
    const known: Preview[] = [];
    const said: HTMLElement[] = [];
    const take = ({ files, roads }: Previews) => {
      known.push(...files);
      Object.assign(this.trains, roads);
    };
    try {
      const reply = await question(paths);
      take(reply.result);
      said.push(snippets(reply));
    } catch (error) {
      if (table) {
        this.list.table = "";
        said.push(problem(error));
      }
      for (const path of paths)
        await question([path]).then(
          (reply) => take(reply.result),
          (why) => known.push(unread(path, why)),
        );
    }
    if (!this.place.isConnected) return;
    this.previews = known;
    const here = this.list.target.campaign ?? NEW;
    const own =
      here === NEW
        ? ["A"]
        : await api
            .get<{ roads: string[] }>(`/api/campaign?${api.query({ path: here })}`)
            .then(({ roads }) => roads)
            .catch(() => []);
    this.roads = [...new Set([...own, ...(here === NEW ? Object.keys(this.trains) : [])])];
    this.status.replaceChildren();
    this.draw(said);
  }

  private draw(more: HTMLElement[] = []): void {
    const { lost, paths } = this.list;
    const lists = [
      ...lost.map(({ name, why }) =>
        problem(new Error(why.includes(name) ? why : `${name}: ${why}`)),
      ),
      ...(this.done.length
        ? [
            make(
              "p",
              { class: "good" },
              tr("# files entered.", String(this.done.length)),
              " ",
              make(
                "a",
                { href: address("campaign", { file: this.list.target.campaign ?? "" }) },
                tr("Open the campaign"),
              ),
            ),
          ]
        : []),
    ];
    if (!paths.length) {
      this.element.replaceChildren(
        ...lists,
        make("p", { class: "empty" }, "No new files."),
        this.ofProject(),
      );
      return;
    }
    const all = make("input", { type: "checkbox", "aria-label": "all files", checked: true });
    all.addEventListener("change", () => {
      for (const preview of this.previews) this.typed(preview.file).off = all.checked ? "" : "yes";
      this.changed();
    });
    this.rows();
    const clear = make("button", { type: "button" }, "Clear the list");
    clear.addEventListener("click", () => {
      Object.assign(this.list, empty());
      this.keep();
      this.draw();
    });
    this.element.replaceChildren(
      ...lists,
      this.status,
      ...this.tables(),
      this.together(),
      make(
        "div",
        { class: "table", tabindex: "0", role: "region", "aria-label": "files" },
        make(
          "table",
          { class: "arrivals" },
          make(
            "thead",
            {},
            make(
              "tr",
              {},
              make("td", {}, all),
              ...["file", "type", "curve", "content", "entered as", "state"].map((head) =>
                make("th", { scope: "col" }, head),
              ),
            ),
          ),
          this.body,
        ),
      ),
      this.reader,
      this.counted,
      this.target(),
      make(
        "p",
        { class: "bar" },
        clear,
        make("span", { class: "muted" }, "The files stay in the project."),
      ),
      ...more,
    );
  }

  /** Folders of the project with measured files, for those that were copied there. */
  private ofProject(): HTMLElement {
    const folders = new Map<string, string[]>();
    for (const { path, kind } of this.entries) {
      if (kind !== "record") continue;
      const folder = path.includes("/") ? path.slice(0, path.lastIndexOf("/")) : ".";
      folders.set(folder, [...(folders.get(folder) ?? []), path]);
    }
    if (!folders.size) return make("p", { hidden: true });
    const choice = select([...folders.keys()], undefined, (name) =>
        tr("# files", `${name}: ${folders.get(name)!.length}`),
      ),
      go = make("button", { type: "button" }, "List these files");
    go.addEventListener("click", () => {
      this.list.paths = (folders.get(choice.value) ?? []).slice(0, 500);
      this.keep();
      void once(go, this.look());
    });
    return make("div", { class: "form" }, field("Folder of the project", choice), go);
  }

  private changed(): void {
    this.keep();
    this.rows();
  }

  private rows(): void {
    const at = document.activeElement?.getAttribute("data-at");
    this.body.replaceChildren(...this.previews.map((preview) => this.row(preview)));
    if (at) this.body.querySelector<HTMLElement>(`[data-at="${CSS.escape(at)}"]`)?.focus();
    const chosen = this.previews.filter((preview) => this.isIn(preview)),
      open = chosen.filter((preview) => this.lacks(preview).length);
    this.counted.textContent = [
      tr("# files are entered", String(chosen.length)),
      ...(open.length ? [tr("# lack something", String(open.length))] : []),
    ].join(", ");
    this.enterButton.disabled = !chosen.length;
    const isNew = this.list.target.campaign === NEW;
    this.enterButton.textContent = isNew
      ? tr("Make the campaign with # files", String(chosen.length))
      : tr("Enter # files into the campaign", String(chosen.length));
  }

  /** What a file still lacks, in words. */
  private lacks(preview: Preview): string[] {
    const kind = this.value(preview, "kind");
    const words: Record<Missing["what"], string> = {
      unit: tr("unit of #"),
      speed: tr("speed"),
      pressure: tr("pressure"),
      sign: tr("sign"),
      channel: tr("names of the columns"),
    };
    const known = preview.missing.filter(({ what, column, proposal }) =>
      what === "unit"
        ? !proposal &&
          !Object.values(this.list.columns[preview.file] ?? {}).some((c) => c.startsWith(column))
        : what === "sign"
          ? ["spring", "tyre"].includes(kind) &&
            !this.value(preview, "stroke_positive") &&
            !this.value(preview, "force_positive")
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

  private row(preview: Preview): HTMLTableRowElement {
    const name = preview.file.split("/").pop()!,
      kind = this.value(preview, "kind");
    const box = make("input", {
      type: "checkbox",
      "aria-label": tr("enter #", name),
      "data-at": `${preview.file} on`,
      checked: this.isIn(preview),
      disabled: kind === "",
    });
    box.addEventListener("change", () => {
      this.typed(preview.file).off = box.checked ? "" : "yes";
      this.changed();
    });
    const isData = preview.columns.length > 0,
      opens = OPENS[this.entries.find(({ path }) => path === preview.file)?.kind ?? ""]?.[0];
    const type = isData
      ? this.choice(preview, "kind", Object.entries(KINDS), name)
      : make("span", {}, tr(preview.kind === "unknown" ? "not recognised" : preview.kind));
    const lacking = this.isIn(preview) ? this.lacks(preview) : [];
    const state = this.refused.get(preview.file);
    return make(
      "tr",
      { class: this.isIn(preview) ? "" : "off" },
      make("td", {}, box),
      make(
        "th",
        { scope: "row", title: preview.file },
        opens ? make("a", { href: address(opens[0], { [opens[1]]: preview.file }) }, name) : name,
      ),
      make(
        "td",
        {},
        type,
        ...(preview.doubt
          ? [make("small", { class: "fair" }, " ", asSaid(`or ${preview.doubt}`))]
          : []),
      ),
      make("td", {}, sparkline(preview)),
      make("td", {}, asSaid(preview.summary), ...this.units(preview, name)),
      make("td", { class: "inputs" }, ...this.inputs(preview, kind, name, isData)),
      make(
        "td",
        {},
        ...(state
          ? [make("span", { class: "wrong", role: "alert" }, state)]
          : lacking.length
            ? [make("span", { class: "mark fair" }, `${tr("missing")}: ${lacking.join(", ")}`)]
            : this.isIn(preview)
              ? [make("span", { class: "mark good" }, "complete")]
              : []),
      ),
    );
  }

  /** Units that the file does not have: the usual ones are shown, and can be changed. */
  private units(preview: Preview, name: string): HTMLElement[] {
    const columns = preview.fields.columns as Record<string, string> | undefined;
    if (!["spring", "tyre"].includes(this.value(preview, "kind")) || !columns) return [];
    return preview.missing
      .filter(({ what, proposal }) => what === "unit" && proposal)
      .flatMap(({ column, proposal }) => {
        const key = Object.keys(columns).find((own) => columns[own]!.startsWith(column));
        if (!key) return [];
        const own = this.list.columns[preview.file]?.[key],
          now = (own && /\[([^\]]*)\]$/.exec(own)?.[1]) || proposal;
        const choice = select(key === "force" ? FORCES : LENGTHS, now);
        choice.setAttribute("aria-label", tr("unit of #", `${column}, ${name}`));
        choice.dataset.at = `${preview.file} unit ${key}`;
        choice.addEventListener("change", () => {
          for (const like of this.alike(preview))
            this.list.columns[like.file] = {
              ...(like.fields.columns as Record<string, string>),
              ...this.list.columns[like.file],
              [key]: `${column} [${choice.value}]`,
            };
          this.keep();
          void this.look();
        });
        return [
          make("label", { class: "unit" }, tr("# has no unit: read as", column), " ", choice),
        ];
      });
  }

  /** The ticked files with the same columns. */
  private alike(one: Preview): Preview[] {
    const names = (preview: Preview) => preview.columns.map(({ name }) => name).join("\n");
    return this.previews.filter(
      (other) => other === one || (this.isIn(other) && names(other) === names(one)),
    );
  }

  private choice(
    preview: Preview,
    key: string,
    choices: [value: string, words: string][],
    name: string,
  ): HTMLSelectElement {
    const control = make(
      "select",
      { "aria-label": `${tr(key)}: ${name}`, "data-at": `${preview.file} ${key}` },
      ...choices.map(([value, words]) =>
        make("option", { value, selected: value === this.value(preview, key) }, tr(words)),
      ),
    );
    control.addEventListener("change", () => {
      this.typed(preview.file)[key] = control.value;
      this.refused.delete(preview.file);
      this.changed();
    });
    return control;
  }

  private inputs(preview: Preview, kind: string, name: string, isData: boolean): HTMLElement[] {
    const shown = (INPUTS[kind] ?? []).map(([key, label, example]) => {
      if (key === "use") return this.choice(preview, key, CHOICES.use!, name);
      if (key === "road")
        return this.choice(
          preview,
          key,
          this.roads.map((road) => [road, `${tr("road")} ${road}`]),
          name,
        );
      const input = textBox(this.value(preview, key), `${tr(label)}, ${example}`);
      input.size = key === "number" ? 2 : 8;
      input.setAttribute("aria-label", `${tr(label)}: ${name}`);
      input.dataset.at = `${preview.file} ${key}`;
      if (this.isIn(preview) && NEEDED.includes(key) && !input.value)
        input.setAttribute("aria-invalid", "true");
      input.addEventListener("change", () => {
        this.typed(preview.file)[key] = input.value.trim();
        this.refused.delete(preview.file);
        this.changed();
      });
      return input;
    });
    if (preview.missing.some(({ what }) => what === "sign") && ["spring", "tyre"].includes(kind))
      for (const key of ["stroke_positive", "force_positive"])
        shown.push(this.choice(preview, key, CHOICES[key]!, name));
    if (isData && kind) {
      const columns = make(
        "button",
        { type: "button", "aria-label": `${tr("Columns")}: ${name}` },
        "Columns",
      );
      columns.addEventListener("click", () => this.read(preview, kind));
      return [...shown, columns];
    }
    return shown;
  }

  /** Names, units and signs of a file's columns, for all ticked files with the same ones. */
  private read(preview: Preview, kind: string): void {
    const form = kind === "spring" || kind === "tyre" ? "force-deflection" : "recording";
    const given: Partial<Fields> = {
      columns:
        this.list.columns[preview.file] ?? (preview.fields.columns as Record<string, string>) ?? {},
      stroke_positive: this.value(preview, "stroke_positive"),
      force_positive: this.value(preview, "force_positive"),
      sample_time: String(preview.fields.sample_time ?? ""),
    };
    const reading = new Reading(preview.file, form, given),
      like = this.alike(preview);
    const use = make(
        "button",
        { type: "button", class: "main" },
        like.length > 1
          ? tr("Use for # files with these columns", String(like.length))
          : tr("Use for this file"),
      ),
      close = make("button", { type: "button" }, "Close");
    close.addEventListener("click", () => this.reader.replaceChildren());
    use.addEventListener("click", () => {
      const { columns, sample_time, stroke_positive, force_positive } = reading.fields;
      for (const other of like) {
        this.list.columns[other.file] = { ...columns };
        Object.assign(this.typed(other.file), { sample_time, stroke_positive, force_positive });
      }
      this.reader.replaceChildren();
      this.keep();
      void this.look();
    });
    this.reader.replaceChildren(
      make(
        "section",
        { class: "job" },
        make("h2", {}, preview.file),
        reading.element,
        make("p", { class: "bar" }, use, close),
      ),
    );
    void reading.ask();
    this.reader.scrollIntoView({ block: "nearest" });
  }

  /** One value for all ticked files that have such a field. */
  private together(): HTMLElement {
    const keys: [string, string][] = [
      ["kind", "type"],
      ["speed", "speed"],
      ["tyre_pressure", "tyre pressure"],
      ["road", "road"],
      ["use", "use"],
      ["pressure", "pressure of tyre tests"],
      ["discard_below", "ignore below"],
      ["stroke_positive", "sign of the stroke"],
      ["force_positive", "sign of the force"],
    ];
    const key = make(
        "select",
        {},
        ...keys.map(([value, words]) => make("option", { value }, tr(words))),
      ),
      holder = make("span", {}),
      set = make("button", { type: "button" }, "Set for all ticked files");
    const control = (): HTMLInputElement | HTMLSelectElement => {
      const choices =
        key.value === "kind"
          ? Object.entries(KINDS)
          : key.value === "road"
            ? this.roads.map((road) => [road, road] as [string, string])
            : CHOICES[key.value];
      const example = Object.values(INPUTS)
        .flat()
        .find(([own]) => own === key.value)?.[2];
      const made = choices
        ? make(
            "select",
            {},
            ...choices.map(([value, words]) => make("option", { value }, tr(words))),
          )
        : textBox("", example ?? "");
      made.setAttribute("aria-label", tr("value"));
      return made;
    };
    let value = control();
    holder.append(value);
    key.addEventListener("change", () => {
      value = control();
      holder.replaceChildren(value);
    });
    set.addEventListener("click", () => {
      for (const preview of this.previews) {
        const kind = this.value(preview, "kind");
        const fits =
          key.value === "kind"
            ? preview.columns.length > 0
            : key.value.endsWith("_positive") ||
              (INPUTS[kind] ?? []).some(([own]) => own === key.value);
        if (this.isIn(preview) && fits) this.typed(preview.file)[key.value] = value.value.trim();
      }
      this.refused.clear();
      this.changed();
    });
    return make(
      "div",
      { class: "form" },
      field("All ticked files", key),
      make("label", { class: "field" }, make("span", {}, "Value"), holder),
      set,
    );
  }

  /** A table of trials copied from a spreadsheet, and settings of a laboratory among the files. */
  private tables(): HTMLElement[] {
    const shown: HTMLElement[] = [];
    const settings = this.previews.find((preview) => preview.kind === "settings");
    if (settings) {
      const go = make("button", { type: "button" }, "Make the campaign from the settings file"),
        out = "campaign";
      const source = settings.file.slice(0, settings.file.lastIndexOf("/"));
      go.addEventListener("click", () => {
        once(go, ask({ kind: "new-campaign", out, source, settings: settings.file })).then(
          () => goTo(this.place, "campaign", { file: `${out}/campaign.toml` }),
          (error) => this.status.replaceChildren(problem(error)),
        );
      });
      shown.push(
        make(
          "p",
          { class: "bar" },
          go,
          make(
            "span",
            { class: "muted" },
            tr("# states masses, obstacle, belt and sensors.", settings.file.split("/").pop()!),
          ),
        ),
      );
    }
    if (!this.previews.some((preview) => this.value(preview, "kind") === "trial")) return shown;
    const area = make("textarea", {
        rows: "4",
        spellcheck: "false",
        placeholder: "trial\tspeed [m/s]\tpressure [MPa]\tprofile",
      }),
      fill = make("button", { type: "button" }, "Fill in from the table");
    area.value = this.list.table;
    const take = () => {
      this.list.table = area.value;
      this.keep();
      void once(fill, this.look());
    };
    fill.addEventListener("click", take);
    area.addEventListener("paste", () => setTimeout(take));
    const details = make(
      "details",
      {},
      make("summary", {}, "Paste the table of trials"),
      field(
        "Number, speed, angle, pressure and profile of each trial, copied from a spreadsheet with its headings",
        area,
      ),
      make("p", { class: "bar" }, fill),
    );
    details.open = this.list.table !== "";
    return [...shown, details];
  }

  /** The campaign that the files enter: one of the project, or a new one with its rig and obstacle. */
  private target(): HTMLElement {
    const to = this.list.target,
      campaigns = this.entries
        .filter((entry) => entry.kind === "campaign")
        .map((entry) => entry.path);
    const choice = make(
      "select",
      {},
      ...campaigns.map((path) =>
        make("option", { value: path, selected: path === to.campaign }, path),
      ),
      make("option", { value: NEW, selected: to.campaign === NEW }, tr("a new campaign")),
    );
    const rigs = [
      ...this.entries
        .filter((entry) => entry.kind === "rig" && !entry.path.includes("@"))
        .map((entry) => entry.path),
      ...this.library.map((one) => one.name),
    ];
    const control = (key: string, made: HTMLInputElement | HTMLSelectElement) => {
      if (to[key] !== undefined) made.value = to[key];
      to[key] = made.value;
      made.addEventListener("change", () => {
        to[key] = made.value;
        this.keep();
      });
      return made;
    };
    const quarter = rigs.includes("kart-quarter-car") ? "kart-quarter-car" : rigs[0];
    const parts = make(
      "span",
      { class: "sizes" },
      field("Folder", control("folder", textBox("campaign"))),
      field(
        "Rig",
        control("rig", select(rigs, rigs.find((rig) => rig.endsWith(".toml")) ?? quarter)),
      ),
      field(
        "Obstacle",
        control(
          "obstacle",
          select(["half-sine", "versine", "triangle", "rectangle"], "half-sine", (kind) =>
            tr(kind.replace("-", " ")),
          ),
        ),
      ),
      field("Height", control("height", textBox("10 mm"))),
      field("Length", control("length", textBox("60 mm"))),
    );
    parts.hidden = to.campaign !== NEW;
    choice.addEventListener("change", () => {
      to.campaign = choice.value;
      this.keep();
      void this.look();
    });
    return make("div", { class: "form" }, field("Campaign", choice), parts, this.enterButton);
  }

  private fields(preview: Preview): { use: string; fields: object } {
    const kind = this.value(preview, "kind");
    const typed = Object.fromEntries(
      (INPUTS[kind] ?? []).map(([key]) => [key, this.value(preview, key)]),
    );
    const { columns, channel, strut_angle, sample_time } = preview.fields;
    const read = {
      columns,
      stroke_positive: this.value(preview, "stroke_positive"),
      ...(kind === "decay" ? {} : { force_positive: this.value(preview, "force_positive") }),
    };
    const time = this.value(preview, "sample_time") || sample_time || "";
    if (kind === "trial")
      return {
        use: kind,
        fields: {
          ...typed,
          ...read,
          sample_time: time,
          strut_angle,
          number: /^\d+$/.test(typed.number ?? "") ? Number(typed.number) : typed.number,
          recording: preview.file,
        },
      };
    return {
      use: kind,
      fields: {
        ...typed,
        ...read,
        files: [preview.file],
        ...(kind === "decay" ? { channel, sample_time: time } : {}),
      },
    };
  }

  private async enter(): Promise<void> {
    const to = this.list.target,
      isNew = to.campaign === NEW;
    const chosen = this.previews.filter((preview) => this.isIn(preview));
    const path = isNew
      ? `${(to.folder || "campaign").replace(/\/+$/, "")}/campaign.toml`
      : to.campaign!;
    const body = {
      campaign: path,
      ...(isNew
        ? {
            new: {
              rig: to.rig,
              obstacle: { kind: to.obstacle, height: to.height, length: to.length },
              roads: this.trains,
            },
          }
        : {}),
      files: chosen.map((preview) => ({
        ...this.fields(preview),
        file: preview.file,
        state: preview.state,
      })),
    };
    let reply: Entered;
    try {
      reply = (await (
        await once(this.enterButton, api.asked("POST", "/api/campaign/files", body))
      ).json()) as Entered;
    } catch (error) {
      this.status.replaceChildren(problem(error));
      this.status.scrollIntoView({ block: "nearest" });
      return;
    }
    this.refused = new Map(
      reply.refused.map(({ file, message, german }) => [
        file,
        new Refused(message, german).message,
      ]),
    );
    this.list.paths = this.list.paths.filter((path) => !reply.entered.includes(path));
    for (const text of reply.entered) {
      delete this.list.typed[text];
      delete this.list.columns[text];
    }
    this.previews = this.previews.filter((preview) => this.list.paths.includes(preview.file));
    if (reply.entered.length) {
      to.campaign = path;
      this.done = [...this.done, ...reply.entered];
      if (isNew && !this.entries.some((entry) => entry.path === path))
        this.entries.push({ path, kind: "campaign" } as api.Entry);
    }
    if (!this.previews.some((preview) => this.isIn(preview)) && reply.entered.length) {
      Object.assign(this.list, { ...empty(), target: to });
      this.keep();
      goTo(this.place, "campaign", { file: path });
      return;
    }
    this.keep();
    this.draw();
  }
}

/** A file that could not be read at all. */
const unread = (file: string, why: unknown): Preview => ({
  file,
  kind: "unknown",
  doubt: "",
  summary: heard(why instanceof Error ? why.message : String(why)),
  columns: [],
  curve: {},
  missing: [],
  fields: {},
  state: "",
});
