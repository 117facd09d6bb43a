/** Spectrum, histogram or scatter plot of the window between the cursors. */

import { Store } from "../data";
import { make, whenColoursChange, written } from "../page";
import { LinkedPlots } from "../plots";
import { tr } from "../words";
import * as api from "./api";
import type { Laid, Said } from "./laid";
import type { Chart } from "./layout";
import { numberBox } from "./numberbox";
import { field, Newest, select } from "./parts";
import { unitText } from "./quantities";
import { asSaid } from "./refusals";
import { saveChart } from "./saving";

interface Figure {
  recording: number;
  resolution?: number;
  averages?: number;
  samples?: number;
  every?: number;
  slope?: number;
  offset?: number;
  correlation?: number;
}
interface Beside {
  notes: Said[];
  figures: Figure[];
}

const PATIENCE = 400; // ms of waiting for a chart, until the page says that it is computed
const KINDS: Record<Chart["kind"], string> = {
  "": "none",
  spectrum: "spectrum",
  histogram: "histogram",
  scatter: "scatter plot",
};

export class WindowChart {
  private readonly kind = select(Object.keys(KINDS), "", (kind) =>
    tr(KINDS[kind as Chart["kind"]]),
  );
  private readonly channel = select([]);
  private readonly across = select([]);
  private readonly bins = numberBox({ min: "5", max: "200", step: "1" });
  private readonly channelField = field(tr("Channel"), this.channel);
  private readonly acrossField = field(tr("Horizontal axis"), this.across);
  private readonly binsField = field(tr("Bins"), this.bins);
  private readonly plots = new LinkedPlots((x) => this.plots.mark(x));
  private readonly notes = make("div", { "aria-live": "polite" });
  private readonly newest = new Newest();
  private readonly player: HTMLElement;
  readonly element: HTMLElement;

  constructor(private readonly laid: Laid) {
    const change = (control: HTMLElement, take: (chart: Chart) => void) =>
      control.addEventListener("change", () => {
        take(laid.layout.chart);
        laid.changed();
      });
    change(this.kind, (chart) => {
      chart.kind = this.kind.value as Chart["kind"];
    });
    change(this.channel, (chart) => {
      chart.channel = this.channel.value;
    });
    change(this.across, (chart) => {
      chart.across = this.across.value;
    });
    change(this.bins, (chart) => {
      chart.bins = Math.min(200, Math.max(5, Math.round(this.bins.valueAsNumber) || 40));
    });
    this.player = make(
      "div",
      { class: "player", tabindex: "0", role: "region", "aria-label": tr("Chart of the window") },
      make(
        "div",
        { class: "bar" },
        make("span", { class: "grow" }),
        make(
          "button",
          { type: "button", title: tr("everything"), click: () => this.plots.reset() },
          tr("All"),
        ),
        saveChart(this.plots.element, () => tr(KINDS[laid.layout.chart.kind])),
      ),
      make("div", { class: "plots-only" }, this.plots.element),
    );
    this.element = make(
      "section",
      {},
      make("h2", {}, tr("Spectrum, histogram, scatter plot")),
      make(
        "div",
        { class: "form" },
        field(tr("Chart of the window"), this.kind),
        this.channelField,
        this.acrossField,
        this.binsField,
      ),
      this.notes,
      this.player,
    );
    whenColoursChange(() => this.plots.repaint());
  }

  show(): void {
    const { layout, tracks } = this.laid,
      { chart } = layout;
    const names = [
      ...new Set([
        ...layout.graphs.flatMap(({ channels }) => channels),
        ...tracks.flatMap(({ channels }) => channels.map(({ name }) => name)),
      ]),
    ];
    for (const [place, value] of [
      [this.channel, chart.channel || names[0]],
      [this.across, chart.across || names[1] || names[0]],
    ] as const) {
      place.replaceChildren(
        ...[...new Set([...names, ...(value ? [value] : [])])].map((name) =>
          make("option", { value: name, selected: name === value }, name),
        ),
      );
    }
    this.kind.value = chart.kind;
    this.bins.value = String(chart.bins);
    this.channelField.hidden = !chart.kind;
    this.acrossField.hidden = chart.kind !== "scatter";
    this.binsField.hidden = chart.kind !== "histogram";
    this.player.hidden = !chart.kind;
    this.element.hidden = !layout.cursors || !names.length;
  }

  /** Asks for the chart of the window. */
  draw(): Promise<void> {
    return this.newest.ask(async () => {
      const { layout } = this.laid,
        { cursors, chart } = layout;
      if (!chart.kind || !cursors || !layout.recordings.length) {
        this.notes.replaceChildren();
        return;
      }
      const waiting = setTimeout(
        () => this.notes.replaceChildren(make("p", { class: "computing" }, tr("computing …"))),
        PATIENCE,
      );
      try {
        const store = Store.of(
          await api.binary("/api/data/chart", {
            layout: {
              ...layout,
              chart: {
                ...chart,
                channel: this.channel.value,
                across: chart.kind === "scatter" ? this.across.value : "",
              },
            },
            begin: cursors[0],
            end: cursors[1],
          }),
        );
        if (this.element.isConnected) this.take(store, chart.kind);
      } catch (error) {
        this.notes.replaceChildren(
          make("p", { class: "problem" }, error instanceof Error ? error.message : String(error)),
        );
      } finally {
        clearTimeout(waiting);
      }
    });
  }

  private take(store: Store, kind: Chart["kind"]): void {
    const beside = store.content as unknown as Beside,
      viewer = store.content.viewers[0]!,
      [pane] = viewer.scenes[0]!.panes,
      x = store.get(viewer.scenes[0]!.x);
    this.notes.replaceChildren(
      ...beside.notes.map(({ text, german }) =>
        make("p", { class: "problem" }, asSaid(text, german)),
      ),
      make(
        "ul",
        { class: "figures muted" },
        ...beside.figures.map((figure) => make("li", {}, this.words(figure))),
      ),
    );
    if (!pane?.curves.length) {
      this.plots.clear();
      return;
    }
    const words = kind === "spectrum" ? tr("frequency") : viewer.x.words;
    this.plots.show({
      x,
      xLabel: `${words} [${unitText(viewer.x.unit) || "–"}]`,
      spans: [],
      window: kind === "spectrum" ? [0, Math.min(60, x[x.length - 1] as number)] : null,
      panes: [
        {
          name: pane.name,
          title: pane.name,
          unit: unitText(pane.unit),
          lines: pane.curves.map((curve) => ({
            label: curve.label,
            role: curve.role,
            y: store.get(curve.y),
            step: 0,
            shown: true,
            points: kind === "scatter",
          })),
        },
      ],
    });
  }

  private words(figure: Figure): string {
    const path = this.laid.layout.recordings[figure.recording]?.path ?? "";
    if (figure.resolution !== undefined)
      return `${path}: ${tr("resolution # Hz", written(figure.resolution, 3))}, ${tr("mean of # independent spectra", written(figure.averages, 3))}`;
    const every =
      (figure.every ?? 1) > 1 ? `, ${tr("every #th is drawn", String(figure.every))}` : "";
    const line =
      figure.slope === undefined
        ? ""
        : `, ${tr("slope #", written(figure.slope))}, ${tr("offset #", written(figure.offset))}, ${tr("correlation #", written(figure.correlation, 3))}`;
    return `${path}: ${tr("# samples", String(figure.samples))}${every}${line}`;
  }
}
