/** Files that come in: uploaded, recognised, mended, and entered together into a campaign. */

import { make } from "../../page";
import { heard, tr } from "../../words";
import * as api from "../api";
import { arrivalRow } from "../arrivalrow";
import { Arrivals, CURVES, countedFiles, KINDS, type List, type Preview } from "../arrivals";
import { Target } from "../arrivaltarget";
import { settingsOf, together, trialTable } from "../arrivaltools";
import { arrived, choosers, type Given, MOST_FILES, store } from "../incoming";
import { ask } from "../jobs";
import { field, once, problem, select, snippets } from "../parts";
import { type Fields, Reading } from "../reading";
import { address, goTo, OPENS, type Values } from "../shell";

interface Previews {
  files: Preview[];
  roads: Record<string, object>;
}

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const campaign = values.get("campaign") ?? "",
    { files, isCut } = arrived();
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
  const page = new FilesPage(place);
  if (files.length) await upload(files, isCut, folderOf(campaign), page.arrivals.list, status);
  page.arrivals.keep();
  const [project, library] = await Promise.all([api.project(), api.library()]);
  if (!place.isConnected) return;
  page.begin(project.entries, library, campaign);
  rest.replaceChildren(page.element);
  await page.look();
}

const folderOf = (path: string) =>
  `${path.includes("/") ? path.slice(0, path.lastIndexOf("/") + 1) : ""}measured`;

/** Uploads the files one by one; what fails is listed, and stops no other. */
async function upload(
  given: Given[],
  isCut: boolean,
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
  if (isCut)
    list.lost.push({
      name: "",
      why: tr(
        "Only the first # files were taken: bring the others in afterwards.",
        `${MOST_FILES}`,
      ),
    });
  status.replaceChildren();
}

/** The list of files with all that can be mended, and the campaign that they enter. */
class FilesPage {
  readonly element = make("section", {});
  readonly arrivals = new Arrivals(
    () => this.changed(),
    () => void this.look(),
  );
  private target!: Target;
  private done: string[] = [];
  /** A pasted table that cannot be read, and the reason. */
  private refused: { table: string; why: HTMLElement } | null = null;
  private readonly body = make("tbody", {});
  private readonly status = make("div", { "aria-live": "polite" });
  private readonly reader = make("div", {});
  private readonly counted = make("p", { class: "state", role: "status" });

  constructor(private readonly place: HTMLElement) {}

  begin(entries: api.Entry[], library: { name: string }[], campaign: string): void {
    this.target = new Target(this.arrivals, entries, library, campaign, () => void this.look());
    this.target.button.addEventListener("click", () => void this.enter());
  }

  /** Asks what the files are; where they cannot be read together, each is read alone. */
  async look(): Promise<void> {
    const { arrivals, target } = this,
      { paths, columns, table } = arrivals.list;
    if (!paths.length) {
      this.draw();
      return;
    }
    this.status.replaceChildren(
      make(
        "p",
        { class: "state" },
        countedFiles(paths.length, "reading 1 file …", "reading # files …"),
      ),
    );
    if (!this.element.childElementCount) this.element.append(this.status);
    const used = table === this.refused?.table ? "" : table;
    const question = (some: string[]) =>
      ask<Previews>({
        kind: "preview-files",
        files: some,
        columns: Object.fromEntries(some.filter((p) => columns[p]).map((p) => [p, columns[p]!])),
        table: used,
      });
    const known: Preview[] = [];
    const said: HTMLElement[] = [];
    const take = ({ files, roads }: Previews) => {
      known.push(...files);
      Object.assign(target.trains, roads);
    };
    try {
      const reply = await question(paths);
      take(reply.result);
      said.push(snippets(reply));
    } catch (error) {
      if (used) {
        this.refused = { table, why: problem(error) }; // what was pasted stays, to be mended
        await this.look();
        return;
      }
      for (const path of paths)
        await question([path]).then(
          (reply) => take(reply.result),
          (why) => known.push(unread(path, why)),
        );
    }
    if (!this.place.isConnected) return;
    arrivals.previews = known;
    arrivals.roads = await target.roads();
    this.status.replaceChildren();
    this.draw(said);
  }

  private draw(more: HTMLElement[] = []): void {
    const { arrivals } = this,
      { lost, paths } = arrivals.list;
    const lists = [
      ...lost.map(({ name, why }) =>
        problem(new Error(why.includes(name) ? why : `${name}: ${why}`)),
      ),
      ...(this.done.length ? [this.entered()] : []),
    ];
    if (!paths.length) {
      this.element.replaceChildren(
        ...lists,
        make("p", { class: "empty" }, "No new files."),
        this.ofProject(),
      );
      return;
    }
    this.rows();
    const isForCampaign = arrivals.previews.some(({ kind }) => kind in KINDS);
    const clear = make("button", { type: "button" }, "Clear the list");
    clear.addEventListener("click", () => {
      arrivals.clear();
      this.draw();
    });
    this.element.replaceChildren(
      ...lists,
      this.status,
      ...this.tables(),
      ...(isForCampaign ? [together(arrivals)] : []),
      this.table(),
      this.reader,
      ...(isForCampaign ? [this.counted, this.target.form()] : []),
      make(
        "p",
        { class: "bar" },
        clear,
        make("span", { class: "muted" }, "The files stay in the project."),
      ),
      ...more,
    );
  }

  private entered(): HTMLElement {
    const file = this.arrivals.list.target.campaign ?? "";
    return make(
      "p",
      { class: "good" },
      countedFiles(this.done.length, "1 file entered.", "# files entered."),
      " ",
      make("a", { href: address("campaign", { file }) }, tr("Open the campaign")),
    );
  }

  private table(): HTMLElement {
    const all = make("input", { type: "checkbox", "aria-label": "all files", checked: true });
    all.addEventListener("change", () => this.arrivals.tick(this.arrivals.previews, all.checked));
    return make(
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
    );
  }

  /** Settings of a laboratory, if they are among the files, and the table of trials. */
  private tables(): HTMLElement[] {
    const { arrivals } = this,
      settings = arrivals.previews.find((preview) => preview.kind === "settings"),
      hasTrials = arrivals.previews.some((preview) => arrivals.value(preview, "kind") === "trial");
    return [
      ...(settings
        ? [
            settingsOf(
              settings.file,
              () => this.target.folder,
              (file) => goTo(this.place, "campaign", { file }),
              (error) => this.status.replaceChildren(problem(error)),
            ),
          ]
        : []),
      ...(hasTrials ? [trialTable(arrivals, () => this.look())] : []),
      ...(this.refused && this.refused.table === arrivals.list.table ? [this.refused.why] : []),
    ];
  }

  /** Folders of the project with measured files, for those that were copied there. */
  private ofProject(): HTMLElement {
    const folders = new Map<string, string[]>();
    for (const { path, kind } of this.target.entries) {
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
      this.arrivals.list.paths = (folders.get(choice.value) ?? []).slice(0, MOST_FILES);
      this.arrivals.keep();
      void once(go, this.look());
    });
    return make("div", { class: "form" }, field("Folder of the project", choice), go);
  }

  private changed(): void {
    this.arrivals.keep();
    this.rows();
  }

  private rows(): void {
    const { arrivals } = this,
      at = document.activeElement?.getAttribute("data-at");
    this.body.replaceChildren(
      ...arrivals.previews.map((preview) => {
        const kind = this.target.entries.find(({ path }) => path === preview.file)?.kind ?? "",
          [page, key] = OPENS[kind]?.[0] ?? [];
        const opens = page && key ? address(page, { [key]: preview.file }) : "";
        return arrivalRow(arrivals, preview, { opens, kind }, () => this.read(preview));
      }),
    );
    if (at) this.body.querySelector<HTMLElement>(`[data-at="${CSS.escape(at)}"]`)?.focus();
    const { chosen } = arrivals,
      open = chosen.filter((preview) => arrivals.lacks(preview).length);
    this.counted.textContent = [
      countedFiles(chosen.length, "1 file will be entered", "# files will be entered"),
      ...(open.length ? [countedFiles(open.length, "1 lacks something", "# lack something")] : []),
    ].join("; ");
    this.target.count(chosen.length);
  }

  /** Names, units and signs of a file's columns, for all ticked files with the same ones. */
  private read(preview: Preview): void {
    const { arrivals } = this,
      kind = arrivals.value(preview, "kind"),
      form = CURVES.includes(kind) ? "force-deflection" : "recording";
    const given: Partial<Fields> = {
      columns:
        arrivals.list.columns[preview.file] ??
        (preview.fields.columns as Record<string, string>) ??
        {},
      stroke_positive: arrivals.value(preview, "stroke_positive"),
      force_positive: arrivals.value(preview, "force_positive"),
      sample_time: String(preview.fields.sample_time ?? ""),
    };
    const reading = new Reading(preview.file, form, given),
      { length } = arrivals.alike(preview);
    const use = make(
        "button",
        { type: "button", class: "main" },
        length > 1
          ? tr("Use for # files with these columns", String(length))
          : tr("Use for this file"),
      ),
      close = make("button", { type: "button" }, "Close");
    close.addEventListener("click", () => this.reader.replaceChildren());
    use.addEventListener("click", () => {
      const { columns, ...values } = reading.fields,
        { sample_time, stroke_positive, force_positive } = values;
      this.reader.replaceChildren();
      arrivals.readAs(preview, () => ({ ...columns }), {
        sample_time,
        stroke_positive,
        force_positive,
      });
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

  private async enter(): Promise<void> {
    let path: string, entered: string[];
    try {
      ({ path, entered } = await this.target.enter());
    } catch (error) {
      this.status.replaceChildren(problem(error));
      this.status.scrollIntoView({ block: "nearest" });
      return;
    }
    this.done = [...this.done, ...entered];
    if (entered.length && !this.arrivals.chosen.length) {
      this.arrivals.clear(true);
      goTo(this.place, "campaign", { file: path });
      return;
    }
    this.arrivals.keep();
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
