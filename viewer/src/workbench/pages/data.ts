/** Many recordings on one axis: curves, two cursors, figures of the window; its state is a layout in the address. */

import { lasting } from "../../browser";
import { Store } from "../../data";
import { make, whenColoursChange, whenLeft } from "../../page";
import { LinkedPlots } from "../../plots";
import { tr } from "../../words";
import { Aligning } from "../aligning";
import * as api from "../api";
import { ChannelList } from "../channels";
import { EventList } from "../events";
import { FormulaList } from "../formulas";
import type { Laid, Said, Track } from "../laid";
import {
  emptyLayout,
  type Layout,
  MOST_RECORDINGS,
  packed,
  unpacked,
  whole as wholeLayout,
} from "../layout";
import { LayoutBar } from "../layouts";
import { LiveSnippets, Newest, Steps, select } from "../parts";
import { unitText } from "../quantities";
import { whileReading } from "../readings";
import { RecordingList } from "../recordings";
import { asSaid } from "../refusals";
import { saveChart } from "../saving";
import { address, setLive, type Values } from "../shell";
import { WindowTable } from "../window";
import { WindowChart } from "../windowchart";

interface Beside {
  whole: [number, number];
  recordings: Track[];
  curves: { recording: number; dash: number }[][];
  problems: Said[];
  lacking: { path: string; channels: string[] }[];
  python: string;
}

const DASHES = [undefined, [8, 4], [2, 3], [10, 3, 2, 3], [5, 2], [1, 2]];
const PAUSE = 300, // ms without a change, until the address follows
  PATIENCE = 400, // ms of waiting for curves, until the page says that they are computed
  LOOKS = 5000; // ms between two looks at the files

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const began = performance.now(),
    { folder, entries } = await api.project();
  const page = new DataPage(place, folder, entries);
  await page.begin(values);
  setLive({ times: page.times });
  page.times.unshift(performance.now() - began);
}

class DataPage implements Laid {
  layout = emptyLayout();
  tracks: Track[] = [];
  unit = "s";
  readonly times: number[] = [];
  private readonly newest = new Newest();
  private readonly measuring = new Newest();
  private readonly state = make("p", { class: "state", role: "status" });
  private readonly computing = make("span", { class: "computing", role: "status" });
  private readonly problems = make("div", { "aria-live": "polite" });
  private readonly notices = make("div", { "aria-live": "polite" });
  private readonly readings = make("div");
  private readonly plots: LinkedPlots;
  private readonly player: HTMLElement;
  private readonly axis = select([]);
  private readonly recordings: RecordingList;
  private readonly channels: ChannelList;
  private readonly window: WindowTable;
  private readonly bar: LayoutBar;
  private readonly aligning: Aligning;
  private readonly formulas: FormulaList;
  private readonly chart: WindowChart;
  private readonly events: EventList;
  private readonly same = new LiveSnippets();
  private readonly steps: Steps<Layout>;
  private readonly known = new Map<string, string>();
  private drawing = false;
  private isRenewed = false;
  private timer = 0;

  constructor(
    private readonly place: HTMLElement,
    private readonly folder: string,
    entries: api.Entry[],
  ) {
    this.plots = new LinkedPlots(
      (x) => this.plots.mark(x),
      (range) => {
        if (this.drawing) return;
        const [low, high] = this.plots.whole;
        this.layout.window = range[0] <= low && range[1] >= high ? null : range;
        this.remember();
        void this.draw();
      },
    );
    this.plots.onCursor = (index, value) => this.setCursor(index, value);
    this.recordings = new RecordingList(
      this,
      entries.filter((entry) => entry.kind === "record").map((entry) => entry.path),
    );
    this.channels = new ChannelList(this);
    this.window = new WindowTable(this, {
      zoom: () => {
        const { cursors } = this.layout;
        if (cursors) this.plots.zoom(Math.min(...cursors), Math.max(...cursors));
      },
      toggle: () => this.toggleCursors(),
    });
    this.bar = new LayoutBar(
      this,
      entries.filter((entry) => entry.kind === "layout").map((entry) => entry.path),
      (layout) => this.open(layout),
    );
    this.aligning = new Aligning(this);
    this.formulas = new FormulaList(
      this,
      () => this.bar.others,
      (path) => this.bar.read(path),
    );
    this.chart = new WindowChart(this);
    this.events = new EventList(this, (at) => {
      this.setCursor(0, at);
      const [low, high] = this.plots.window;
      if (at < low || at > high) this.plots.zoom(at - (high - low) / 2, at + (high - low) / 2);
    });
    this.player = this.region();
    const root = make("div", { class: "data-page" });
    this.steps = new Steps(
      () => this.layout,
      (layout) => this.open(layout),
      root,
    );
    this.axis.addEventListener("change", () => {
      this.layout.axis = this.axis.value;
      this.layout.window = null;
      if (this.layout.cursors) this.isRenewed = true; // on another axis their values mean nothing
      this.layout.cursors = null;
      this.changed();
    });
    root.append(
      make(
        "div",
        { class: "data-side" },
        this.recordings.element,
        this.aligning.element,
        this.channels.element,
      ),
      make(
        "div",
        { class: "data-main" },
        this.notices,
        this.problems,
        this.readings,
        this.player,
        this.state,
        this.window.element,
        this.chart.element,
        this.formulas.element,
        this.events.element,
      ),
    );
    place.replaceChildren(
      make("h1", {}, tr("Data")),
      make("div", { class: "bar" }, this.bar.element, this.steps.element),
      root,
      this.same.element,
    );
    whenColoursChange(() => this.plots.repaint());
    const looks = setInterval(() => void this.look(), LOOKS);
    whenLeft(() => clearInterval(looks));
  }

  /** Begins with the layout of the address, of a file, with one recording (beside the others), or with the last state here. */
  async begin(values: Values): Promise<void> {
    const file = values.get("layout") ?? "",
      state = values.get("state") ?? "",
      path = values.get("path");
    let layout: Layout | null = null;
    if (file) layout = await this.bar.load(file, state !== "");
    if (state) {
      const given = await unpacked(state);
      if (!given) throw new Error(tr("This link is damaged: the layout in it cannot be read."));
      layout = given;
    }
    if (!layout && (!path || values.get("beside"))) layout = this.left();
    layout ??= emptyLayout();
    const isFull = layout.recordings.length >= MOST_RECORDINGS;
    if (path && !isFull && !layout.recordings.some((recording) => recording.path === path))
      layout.recordings.push({ path, shown: true, shifts: {} });
    this.steps.amend(() => {
      this.layout = wholeLayout(layout);
    });
    await this.refresh();
  }

  /** Shows another layout. */
  open(layout: Layout): void {
    this.layout = wholeLayout(structuredClone(layout));
    this.changed();
  }

  changed(): void {
    this.steps.changed();
    void this.refresh();
  }

  private async refresh(): Promise<void> {
    this.remember();
    this.show();
    await this.draw();
    await this.follow();
  }

  /** What depends on the window between the cursors follows. */
  private async follow(): Promise<void> {
    await Promise.all([this.window.measure(this.measuring), this.chart.draw()]);
  }

  /** Fills the lists from the layout. */
  private show(): void {
    const { layout } = this,
      names = new Set(
        this.tracks.flatMap((track) => track.channels.map((channel) => channel.name)),
      );
    if (layout.axis !== "time") names.add(layout.axis);
    this.axis.replaceChildren(
      ...["time", ...names].map((name) =>
        make(
          "option",
          { value: name, selected: name === layout.axis },
          name === "time" ? tr("time") : name,
        ),
      ),
    );
    this.recordings.show();
    this.channels.show();
    this.bar.show();
    this.window.show();
    this.aligning.show();
    this.chart.show();
    this.formulas.show();
    this.events.show();
    this.formulas.element.hidden = !layout.recordings.length;
    this.plots.setCursors(layout.cursors);
    this.plots.setNotes(this.events.flags);
    this.player.hidden = !layout.recordings.length;
    this.window.element.hidden = !layout.recordings.length;
    this.same.element.hidden = !layout.recordings.length;
  }

  /** Keeps the layout in the address and in the browser. */
  private remember(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(async () => {
      if (!this.place.isConnected) return;
      const state = await packed(this.layout);
      try {
        lasting?.setItem(`jounce-data\n${this.folder}`, JSON.stringify(this.layout));
      } catch {
        /* full: the address still has it */
      }
      if (this.place.isConnected)
        history.replaceState(null, "", address("data", { ...this.bar.named, state }));
    }, PAUSE);
  }

  private left(): Layout | null {
    try {
      const found: unknown = JSON.parse(lasting?.getItem(`jounce-data\n${this.folder}`) ?? "null");
      return found && typeof found === "object" ? wholeLayout(found as Partial<Layout>) : null;
    } catch {
      return null;
    }
  }

  private draw(): Promise<void> {
    return this.newest.ask(async () => {
      if (!this.place.isConnected) return;
      const since = performance.now(),
        { window } = this.layout,
        aside = window ? (window[1] - window[0]) / 2 : 0;
      const waiting = setTimeout(() => {
        this.computing.textContent = tr("computing …");
        this.formulas.wait(true);
        this.channels.show();
      }, PATIENCE);
      try {
        const store = Store.of(
          await whileReading(
            this.readings,
            api.binary("/api/data/curves", {
              layout: this.layout,
              ...(window ? { low: window[0] - aside, high: window[1] + aside } : {}),
              columns: Math.min(
                4000,
                Math.max(600, Math.round(2 * this.plots.element.clientWidth)),
              ),
            }),
          ),
        );
        if (!this.place.isConnected) return;
        this.take(store, window);
        this.times.push(performance.now() - since);
        this.state.textContent = "";
        this.state.classList.remove("problem");
      } catch (error) {
        this.state.textContent = error instanceof Error ? error.message : String(error);
        this.state.classList.add("problem");
      } finally {
        clearTimeout(waiting);
        this.computing.textContent = "";
        this.formulas.wait(false);
        this.channels.show();
      }
    });
  }

  private take(store: Store, window: [number, number] | null): void {
    const beside = store.content as unknown as Beside,
      viewer = store.content.viewers[0]!,
      scene = viewer.scenes[0]!;
    const news = JSON.stringify(this.tracks) !== JSON.stringify(beside.recordings);
    this.tracks = beside.recordings;
    this.unit = viewer.x.unit;
    this.same.show({ python: beside.python, command: "", files: {} });
    this.compare();
    if ((news || this.isRenewed) && this.suggest(beside.whole)) return;
    if (news) this.show();
    const problems = [
      ...this.tracks.flatMap((track) => (track.problem ? [track.problem] : [])),
      ...beside.problems,
    ];
    this.problems.replaceChildren(
      ...problems.map(({ text, german }) => make("p", { class: "problem" }, asSaid(text, german))),
      ...beside.lacking.map(({ path, channels }) =>
        make("p", { class: "muted" }, `${tr("Not in #:", path)} ${channels.join(", ")}`),
      ),
    );
    const [low, high] = beside.whole;
    this.drawing = true;
    if (scene.panes.length)
      this.plots.show(
        {
          x: store.get(scene.x),
          xLabel: `${this.layout.axis === "time" ? tr("time") : this.layout.axis} [${unitText(this.unit) || "–"}]`,
          spans: [],
          window: null,
          whole: beside.whole,
          panes: scene.panes.map((pane, k) => ({
            name: pane.name,
            title: pane.name,
            unit: unitText(pane.unit),
            lines: pane.curves.map((curve, i) => {
              const dash = DASHES[beside.curves[k]![i]!.dash];
              return {
                label: curve.label,
                role: curve.role,
                y: store.get(curve.y),
                step: 0,
                shown: true,
                ...(dash ? { dash } : {}),
              };
            }),
          })),
        },
        window ?? [low, high],
      );
    else this.plots.clear();
    this.plots.setCursors(this.layout.cursors);
    this.plots.setNotes(this.events.flags);
    this.drawing = false;
  }

  /** A first choice of channels and cursors where there is none; whether the layout was changed so. */
  private suggest([low, high]: [number, number]): boolean {
    const { layout } = this,
      first = this.tracks.find((track) => track.channels.length);
    const isNew = !layout.graphs.length && !layout.cursors;
    if (!first || !(isNew || this.isRenewed)) return false;
    this.isRenewed = false;
    this.steps.amend(() => {
      if (isNew)
        layout.graphs = first.channels.slice(0, 3).map(({ name }) => ({ channels: [name] }));
      layout.cursors = this.thirds(low, high);
    });
    void this.refresh();
    return true;
  }

  /** Says which files are no longer those that were opened. */
  private compare(): void {
    for (const { path, digest } of this.tracks) {
      const before = this.known.get(path);
      if (digest) this.known.set(path, digest);
      if (before && digest && before !== digest) this.notice(path);
    }
  }

  private notice(path: string): void {
    const whole = make(
      "p",
      { class: "notice" },
      tr("# has changed: curves and figures show the file as it is now.", path),
      " ",
      make("button", { type: "button", click: () => whole.remove() }, tr("OK")),
    );
    this.notices.append(whole);
  }

  /** Looks whether a file was changed. */
  private async look(): Promise<void> {
    if (document.hidden || !this.known.size) return;
    const paths = this.layout.recordings.map(({ path }) => path);
    try {
      const answer = await api.asked("POST", "/api/data/state", { paths });
      const digests = (await answer.json()) as Record<string, string>;
      if (!this.place.isConnected) return;
      if (paths.some((path) => (this.known.get(path) ?? "") !== (digests[path] ?? "")))
        await this.refresh();
    } catch {
      /* the next request says what is wrong */
    }
  }

  /** A value as precise as a range shows it. */
  private rounded(value: number, [low, high] = this.plots.window): number {
    const step = (high - low) / 5000;
    return step > 0 ? Number(value.toFixed(Math.max(0, Math.ceil(-Math.log10(step))))) : value;
  }

  private thirds(low: number, high: number): [number, number] {
    const third = (high - low) / 3;
    return [this.rounded(low + third, [low, high]), this.rounded(high - third, [low, high])];
  }

  private setCursor(index: 0 | 1, value: number): void {
    const { cursors } = this.layout;
    if (!cursors) return;
    cursors[index] = this.rounded(value);
    this.plots.setCursors(cursors);
    this.remember();
    this.steps.changed();
    this.window.show();
    void this.follow();
  }

  private toggleCursors(): void {
    this.layout.cursors = this.layout.cursors ? null : this.thirds(...this.plots.window);
    this.changed();
  }

  private region(): HTMLElement {
    const { plots } = this;
    const zooms = (
      [
        ["+", tr("zoom in"), () => plots.zoomBy(0.5)],
        ["−", tr("zoom out"), () => plots.zoomBy(2)],
        ["‹", tr("to the left"), () => plots.pan(-0.5)],
        ["›", tr("to the right"), () => plots.pan(0.5)],
        [tr("All"), tr("everything"), () => plots.reset()],
      ] as [string, string, () => void][]
    ).map(([text, title, click]) =>
      make(
        "button",
        { type: "button", title, ...(text.length > 1 ? {} : { "aria-label": title }), click },
        text,
      ),
    );
    const player = make(
      "div",
      { class: "player", tabindex: "0", role: "region", "aria-label": tr("curves") },
      make(
        "div",
        { class: "bar" },
        make("label", { class: "group" }, `${tr("Over")} `, this.axis),
        make("span", { class: "grow" }, this.computing),
        make("div", { class: "group" }, ...zooms),
        saveChart(plots.element, () => this.layout.recordings.map(({ path }) => path).join(", ")),
      ),
      make("div", { class: "plots-only" }, plots.element),
      make(
        "p",
        { class: "hint" },
        tr(
          "Drag to zoom, Shift + wheel or ← → pans, Ctrl + wheel zooms, double click for everything. Drag a cursor, click to move the nearer one; the keys A and B put one under the pointer.",
        ),
      ),
    );
    player.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (event.target instanceof HTMLSelectElement) return;
      const actions: Record<string, () => void> = {
        ArrowLeft: () => plots.pan(-0.2),
        ArrowRight: () => plots.pan(0.2),
        "+": () => plots.zoomBy(0.5),
        "-": () => plots.zoomBy(2),
        "0": () => plots.reset(),
        a: () => this.setCursor(0, plots.pointed),
        b: () => this.setCursor(1, plots.pointed),
      };
      const action = actions[event.key];
      if (action) {
        event.preventDefault();
        action();
      }
    });
    return player;
  }
}
