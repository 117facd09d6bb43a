/** What every curve of the workbench offers: a place at the top, a large picture, and its values as a table. */

import { lasting } from "../browser";
import { at, type Model, type Store } from "../data";
import { make, toggle, whenLeft, written } from "../page";
import { Player } from "../player";
import { LinkedPlots } from "../plots";
import { chartOf, type Offer, type ShownChart } from "../shown";
import { tr } from "../words";
import { announce, dialog } from "./dialog";
import { saveChart, saveDrawing, title } from "./saving";
import { table } from "./table";

const KEY = "jounce-pinned",
  MOST_PINNED = 30,
  MOST_ROWS = 200;

/** Names of the curves that come first, the one that was pinned first on top; kept for later visits. */
let pinned: string[] = (() => {
  try {
    const known: unknown = JSON.parse(lasting?.getItem(KEY) ?? "[]");
    return Array.isArray(known)
      ? known.filter((one): one is string => typeof one === "string")
      : [];
  } catch {
    return [];
  }
})();
const listeners = new Set<() => void>();

export const pinnedCurves = (): string[] => pinned;

/** Calls back when a curve is pinned or released, until the page is left. */
export function whenPinned(does: () => void): void {
  listeners.add(does);
  whenLeft(() => listeners.delete(does));
}

function pin(name: string, label: string, on: boolean): void {
  pinned = [...pinned.filter((text) => text !== name), ...(on ? [name] : [])].slice(-MOST_PINNED);
  try {
    lasting?.setItem(KEY, JSON.stringify(pinned));
  } catch {
    // a full storage: it stays until the page is left
  }
  for (const listener of listeners) listener();
  announce(tr(on ? "# pinned to the top" : "# no longer pinned", label));
}

const rank = (name: string): number => (pinned.includes(name) ? pinned.indexOf(name) : Infinity);

/** Buttons beside the name of a curve: they pin it, and open it large or as a table. */
function buttons(name: string, label: string, element: Element): Node[] {
  const own = (part: string) => `[data-curve="${CSS.escape(name)}"].${part}`;
  const pins = toggle(
    "",
    pinned.includes(name),
    (on) => {
      pin(name, label, on);
      element.querySelector<HTMLElement>(own("pin"))?.focus(); // it may have been made anew
    },
    tr("keep at the top"),
  );
  pins.classList.add("tool", "pin");
  pins.setAttribute("aria-label", tr("Keep # at the top", label));
  const opens = make(
    "button",
    {
      type: "button",
      class: "tool enlarge",
      title: tr("enlarge, or show as a table"),
      click: () => enlarge(element, name),
    },
    "⤢",
  );
  opens.setAttribute("aria-label", tr("Enlarge #, or show it as a table", label));
  for (const button of [pins, opens]) button.dataset.curve = name;
  return [pins, opens];
}

export const offer: Offer = { buttons, rank };

/** Curves and mechanism with menus that save them, and with buttons at each curve. */
export function savable(model: Model, store: Store): Player {
  const player = new Player(model, store, offer);
  whenPinned(() => player.reorder());
  const plots = player.element.querySelector(".plots")!;
  const caption = () => model.title || title();
  player.element.querySelector(".bar")!.append(saveChart(plots, caption));
  const mechanism = player.element.querySelector<HTMLElement>(".mechanism");
  if (mechanism) saveDrawing(mechanism);
  return player;
}

/** One curve of an element, over the window; the others follow by keys or by name. */
function enlarge(element: Element, name: string): void {
  const chart = chartOf(element);
  if (!chart) return;
  const { panels } = chart,
    unit = (one: { title: string; unit: string }) => `${one.title} [${one.unit || "–"}]`;
  const choice = make(
    "select",
    { "aria-label": tr("curve") },
    ...panels.map((panel, k) => make("option", { value: String(k) }, panel.title)),
  );
  const axis = /^(.*) \[(.*)\]$/.exec(chart.x_label) ?? ["", chart.x_label, ""];
  const place = make("output", { class: "place" }),
    plots = new LinkedPlots(
      (x) => mark(x),
      () => {},
      null,
      Math.max(200, Math.min(innerHeight - 260, 620)),
    ),
    picture = make("div", { class: "player bare", tabindex: "0", role: "group" }, plots.element),
    values = make("div", { class: "values", hidden: true });
  let [k, now] = [0, chart.window[0]];
  const mark = (x: number) => {
    const [first, last] = plots.whole;
    now = Math.min(Math.max(x, first), last);
    plots.mark(now);
    const panel = panels[k]!;
    const said = panel.curves.map(({ label, y }) =>
      `${label} ${written(at(chart.x, y, now))} ${panel.unit}`.trim(),
    );
    place.textContent = `${axis[1]} ${written(now)} ${axis[2]}: ${said.join(", ")}`;
  };
  const show = () => {
    const panel = panels[k]!,
      isTable = tabled.getAttribute("aria-pressed") === "true";
    choice.value = String(k);
    picture.hidden = isTable;
    place.hidden = isTable;
    values.hidden = !isTable;
    picture.setAttribute("aria-label", tr("#; ← → step, + − 0 zoom", unit(panel)));
    pins.setAttribute("aria-pressed", String(pinned.includes(panel.name)));
    if (isTable) values.replaceChildren(...tableOf(chart, k, plots.window));
    else {
      plots.show(
        {
          x: chart.x,
          xLabel: chart.x_label,
          spans: [],
          window: chart.window,
          panes: [
            {
              ...panel,
              lines: panel.curves.map(({ label, role, y }) => ({
                label,
                role,
                y,
                step: 0,
                shown: true,
              })),
            },
          ],
        },
        plots.window[1] > plots.window[0] && plots.element.childElementCount ? plots.window : null,
      );
      mark(now);
    }
  };
  const go = (to: number) => {
    k = (to + panels.length) % panels.length;
    show();
    announce(unit(panels[k]!));
  };
  choice.addEventListener("change", () => go(Number(choice.value)));
  const pins = toggle(tr("At the top"), false, (on) => pin(panels[k]!.name, panels[k]!.title, on));
  const tabled = toggle(tr("Table"), false, (on) => {
    show();
    announce(on ? (values.querySelector("p")?.textContent ?? "") : unit(panels[k]!));
  });
  const step = (by: number, label: string, text: string) =>
    make(
      "button",
      { type: "button", title: label, "aria-label": label, click: () => go(k + by) },
      text,
    );
  const close = make("button", { type: "button" }, tr("Close"));
  const whole = dialog(
    "enlarged",
    tr("Enlarged curve"),
    make(
      "div",
      { class: "bar" },
      step(-1, tr("previous curve"), "‹"),
      choice,
      step(1, tr("next curve"), "›"),
      tabled,
      pins,
      close,
    ),
    picture,
    place,
    values,
  );
  close.addEventListener("click", () => whole.close());
  whole.addEventListener("close", () => {
    plots.clear();
    const again = `[data-curve="${CSS.escape(name)}"].enlarge`;
    element.querySelector<HTMLElement>(again)?.focus(); // it may have been made anew
  });
  picture.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const sample = (plots.whole[1] - plots.whole[0]) / Math.max(chart.x.length - 1, 1),
      by = sample * (event.shiftKey ? 20 : 1);
    const does: Record<string, () => void> = {
      ArrowLeft: () => mark(now - by),
      ArrowRight: () => mark(now + by),
      "+": () => plots.zoomBy(0.5, now),
      "=": () => plots.zoomBy(0.5, now),
      "-": () => plots.zoomBy(2, now),
      "0": () => plots.reset(),
      PageUp: () => go(k - 1),
      PageDown: () => go(k + 1),
    };
    if (!does[event.key]) return;
    event.preventDefault();
    does[event.key]!();
  });
  k = Math.max(
    0,
    panels.findIndex((panel) => panel.name === name),
  );
  show();
  picture.focus();
}

/** The values of one panel in a window: at most so many rows, and a sentence that says which they are. */
function tableOf(chart: ShownChart, k: number, [low, high]: [number, number]): HTMLElement[] {
  const panel = chart.panels[k]!,
    { x } = chart,
    inside: number[] = [];
  for (let i = 0; i < x.length; i++)
    if ((x[i] as number) >= low && (x[i] as number) <= high) inside.push(i);
  const every = Math.max(1, Math.ceil(inside.length / MOST_ROWS)),
    shown = inside.filter((_, i) => i % every === 0);
  const [first, last] = [x[inside[0] ?? 0], x[inside[inside.length - 1] ?? 0]] as [number, number];
  const name = `${panel.title} [${panel.unit || "–"}]`;
  const sentence =
    every > 1
      ? [shown.length, inside.length, every].reduce<string>(
          (text, number) => text.replace("#", String(number)),
          tr("# of # values: every #th row. Zoom in for those between, or save the curves.", "#"),
        )
      : tr("All # values.", String(inside.length));
  return [
    make(
      "p",
      { class: "muted" },
      `${name}, ${chart.x_label}: ${written(first)} … ${written(last)}. ${sentence}`,
    ),
    table(
      name,
      [
        chart.x_label,
        ...panel.curves.map(({ label }) => (label ? `${label} [${panel.unit || "–"}]` : name)),
      ],
      shown.map((i) => [
        written(x[i] as number),
        ...panel.curves.map(({ y }) => written(y[i] as number | null, 5)),
      ]),
      [0, ...panel.curves.map((_, i) => i + 1)],
    ),
  ];
}
