/** A record of any length: the server sends the visible part with its peaks at every zoom. */

import { Store } from "../../data";
import { make, toggle, whenColoursChange } from "../../page";
import { LinkedPlots } from "../../plots";
import { sorted } from "../../shown";
import { localised, tr } from "../../words";
import * as api from "../api";
import { offer, whenPinned } from "../curves";
import { LiveSnippets, Newest } from "../parts";
import { whileReading } from "../readings";
import { asSaid } from "../refusals";
import { saveChart } from "../saving";
import { address, choose, setLive, type Values } from "../shell";

interface About {
  count: number;
  first: number;
  last: number;
  step: number;
  even: boolean;
  unit: string;
  channels: { name: string; unit: string }[];
  left_out?: string[];
}
const AT_FIRST = 3;

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const path = values.get("path");
  if (!path) {
    await choose(place, "record", tr("Records"), "path", false, ["record"]);
    return;
  }
  const began = performance.now(),
    waiting = make("div");
  place.replaceChildren(make("h1", {}, path), waiting);
  const about = await whileReading(waiting, api.get<About>(`/api/record?${api.query({ path })}`));
  if (!place.isConnected) return;
  const shown = new Set([
      ...about.channels
        .map((channel) => channel.name)
        .filter((text) => Number.isFinite(offer.rank(text))),
      ...about.channels.slice(0, AT_FIRST).map((channel) => channel.name),
    ]),
    newest = new Newest(),
    same = new LiveSnippets(),
    times: number[] = [];
  setLive({ times });
  const state = make("p", { class: "state", role: "status" });
  let drawing = false,
    part: [number, number] = [about.first, about.last];
  const plots: LinkedPlots = new LinkedPlots(
    (x) => plots.mark(x),
    (range) => {
      if (!drawing) {
        part = range;
        void ask();
      }
    },
    offer,
  );
  whenPinned(() => void ask());
  const ask = () =>
    newest.ask(async () => {
      if (!shown.size || !place.isConnected) return;
      const since = performance.now(),
        [low, high] = part,
        width = high - low;
      try {
        const store = Store.of(
          await api.binary("/api/record", {
            path,
            channels: [...shown],
            low: Math.max(about.first, low - width),
            high: Math.min(about.last, high + width),
            columns: Math.max(600, 3 * Math.round(plots.element.clientWidth)),
          }),
        );
        if (!place.isConnected) return;
        const scene = store.content.viewers[0]!.scenes[0]!;
        same.show(store.content as unknown as api.Answer);
        drawing = true;
        plots.show(
          {
            x: store.get(scene.x),
            xLabel: `${tr("time")} [${about.unit}]`,
            spans: [],
            window: null,
            whole: [about.first, about.last],
            panes: sorted(scene.panes, (pane) => offer.rank(pane.name)).map((pane) => ({
              name: pane.name,
              title: pane.name,
              unit: pane.unit,
              lines: pane.curves.map((curve) => ({
                label: "",
                role: curve.role,
                y: store.get(curve.y),
                step: 0,
                shown: true,
              })),
            })),
          },
          part,
        );
        drawing = false;
        times.push(performance.now() - since);
        state.textContent = "";
        state.classList.remove("problem");
      } catch (error) {
        drawing = false;
        state.textContent = error instanceof Error ? error.message : String(error);
        state.classList.add("problem");
      }
    });
  const buttons = make(
    "div",
    { class: "group", role: "group", "aria-label": tr("channels") },
    ...about.channels.map(({ name, unit }) =>
      toggle(
        name,
        shown.has(name),
        (on) => {
          if (on) shown.add(name);
          else shown.delete(name);
          void ask();
        },
        unit,
      ),
    ),
  );
  const zooms = make(
    "div",
    { class: "group" },
    ...(
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
    ),
  );
  const player = make(
    "div",
    { class: "player", tabindex: "0", role: "region", "aria-label": tr("curves") },
    make(
      "div",
      { class: "bar" },
      buttons,
      make("span", { class: "grow" }),
      zooms,
      saveChart(plots.element, () => path),
    ),
    make("div", { class: "plots-only" }, plots.element),
  );
  player.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => plots.pan(-0.2),
      ArrowRight: () => plots.pan(0.2),
      "+": () => plots.zoomBy(0.5),
      "-": () => plots.zoomBy(2),
      "0": () => plots.reset(),
    };
    const action = actions[event.key];
    if (action) {
      event.preventDefault();
      action();
    }
  });
  whenColoursChange(() => plots.repaint());
  place.replaceChildren(
    make("h1", {}, path),
    make(
      "p",
      { class: "muted" },
      `${tr("# samples", String(about.count))}, ${about.even ? `${tr("every")} ${localised(String(Number(about.step.toPrecision(6))))} ${about.unit}` : tr("unevenly spaced")}, ${localised(String(Number(about.first.toPrecision(9))))} – ${localised(String(Number(about.last.toPrecision(9))))} ${about.unit}; ${tr("units as in the file")}`,
    ),
    make(
      "p",
      { class: "bar" },
      make(
        "a",
        { href: address("data", { path }) },
        tr("Analyse and compare with other recordings"),
      ),
      make("a", { href: address("trial", { record: path }) }, tr("Compare with a simulation")),
    ),
    ...(about.left_out ?? []).map((text) =>
      make("p", { class: "problem" }, `${tr("not shown")}: `, asSaid(text)),
    ),
    about.channels.length
      ? player
      : make("p", { class: "empty" }, tr("It has no channel besides time.")),
    state,
    make(
      "p",
      { class: "hint muted" },
      tr(
        "Drag to zoom, Shift + wheel or ← → pans, Ctrl + wheel zooms, double click for everything.",
      ),
    ),
    same.element,
  );
  await ask();
  times.unshift(performance.now() - began);
}
