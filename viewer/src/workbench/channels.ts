/** The channels of all recordings of a layout, and the graphs they are in. */

import { make } from "../page";
import { tr } from "../words";
import { fill } from "./filled";
import type { Laid } from "./laid";
import { MOST_CHANNELS, MOST_GRAPHS } from "./layout";
import { unitText } from "./quantities";

const MOST = 200; // in the list: more are not read but searched

export class ChannelList {
  private readonly into = make("select", { "aria-label": tr("Graph for the next channel") });
  private readonly filter = make("input", {
    type: "search",
    placeholder: tr("search"),
    "aria-label": tr("Search channels"),
  });
  private readonly list = make("ul", { class: "channels" });
  readonly element = make(
    "section",
    {},
    make("h2", {}, tr("Channels")),
    make("div", { class: "choice" }, this.filter, this.into),
    this.list,
  );

  constructor(private readonly laid: Laid) {
    this.filter.addEventListener("input", () => this.show());
  }

  show(): void {
    const { layout, tracks } = this.laid,
      { graphs } = layout;
    const target = this.into.value;
    this.into.replaceChildren(
      make("option", { value: "" }, tr("into a graph of its own")),
      ...graphs.map(({ channels }, k) =>
        make("option", { value: String(k) }, `${tr("into")} ${k + 1}: ${channels.join(", ")}`),
      ),
    );
    this.into.value = Number(target) < graphs.length ? target : "";
    const units = new Map<string, string>();
    for (const { channels } of tracks)
      for (const { name, unit } of channels) if (!units.has(name)) units.set(name, unit);
    for (const { channels } of graphs)
      for (const name of channels) if (!units.has(name)) units.set(name, this.state(name));
    const words = this.filter.value.toLowerCase().split(/\s+/);
    const fitting = [...units].filter(([name]) =>
      words.every((word) => name.toLowerCase().includes(word)),
    );
    this.element.hidden = !units.size;
    fill(
      this.list,
      ...fitting.slice(0, MOST).map(([name, unit]) => {
        const inside = graphs.flatMap(({ channels }, k) =>
          channels.includes(name) ? [k + 1] : [],
        );
        const button = make(
          "button",
          { type: "button", "aria-pressed": String(inside.length > 0) },
          make("span", {}, name),
          " ",
          make("small", {}, [unitText(unit) || "–", ...inside.map((k) => `#${k}`)].join("  ")),
        );
        button.addEventListener("click", () => this.toggle(name));
        return make("li", {}, button);
      }),
      ...(fitting.length > MOST
        ? [make("li", { class: "muted" }, tr("# more", String(fitting.length - MOST)))]
        : []),
    );
  }

  /** Why a channel of a graph has no curve. */
  private state(name: string): string {
    const { layout, tracks } = this.laid;
    if (!layout.formulas.some((formula) => formula.name === name)) return tr("missing");
    const isRefused = tracks.some(({ formulas }) =>
      formulas.some((formula) => formula.name === name && formula.problem),
    );
    return isRefused ? tr("faulty") : tr("computing …");
  }

  /** Puts a channel into the chosen graph, or takes it out of all. */
  private toggle(name: string): void {
    const { layout } = this.laid,
      { graphs } = layout,
      target = graphs[Number(this.into.value)];
    if (graphs.some(({ channels }) => channels.includes(name)))
      layout.graphs = graphs
        .map(({ channels }) => ({ channels: channels.filter((channel) => channel !== name) }))
        .filter(({ channels }) => channels.length);
    else if (this.into.value && target && target.channels.length < MOST_CHANNELS)
      target.channels.push(name);
    else if (graphs.length < MOST_GRAPHS) graphs.push({ channels: [name] });
    this.laid.changed();
  }
}
