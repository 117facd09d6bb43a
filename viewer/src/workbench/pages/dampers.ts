/** Dampers from a test rig: the map over velocity and clicks, its curve between clicks, and what the records show. */

import type { Numbers } from "../../data";
import { make, whenColoursChange, written } from "../../page";
import { LinkedPlots, type PlotPane } from "../../plots";
import { heard, localised, tr } from "../../words";
import * as api from "../api";
import { dropZone, Question, type Reply, report } from "../jobs";
import { numberBox } from "../numberbox";
import { field, optional, problem, select, snippets, textBox } from "../parts";
import type { Finding } from "../refusals";
import { reported } from "../reported";
import { saveChart } from "../saving";
import { address, type Values, VEHICLES } from "../shell";
import { table } from "../table";

interface Curve {
  force: Numbers;
  low: Numbers;
  high: Numbers;
}
interface Mapped {
  curves: {
    velocity: number[];
    velocity_unit: string;
    force_unit: string;
    settings: (Curve & { label: string })[];
    between: (Curve & { clicks: number })[];
  };
  findings: Finding[];
}

/** Colours and dashes of the measured settings, in their order; further ones begin again. */
const ROLES = ["before", "other-1", "other-2", "other-3", "other-4", "other-5", "other-6"];
const SIGNS: Record<string, string> = {
  compression: "positive in compression",
  extension: "positive in extension",
  tension: "positive in tension",
};
const READINGS: Record<string, string> = {
  peak: "peak velocities (PVP)",
  continuous: "the whole loop (CVP)",
};

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const { entries } = await api.project(),
    records = entries.filter(({ kind }) => kind === "record").map(({ path }) => path),
    folders = [...new Set(records.map(folderOf))];
  const wanted = values.get("folder") ?? "",
    folder = select(
      folders.includes(wanted) || !wanted ? folders : [wanted, ...folders],
      wanted || folders.find((name) => /dyno|damper|d.mpfer/i.test(name)),
      (name) => (name === "." ? tr("the project's own folder") : name),
    ),
    settings = optional(
      "from channels and file names",
      records.filter((path) => TABLES.test(path)),
    ),
    reading = optional("what the records allow", Object.keys(READINGS)),
    stroke = optional("found from the gas force", ["compression", "extension"]),
    force = optional("found from the gas force", ["compression", "tension"]);
  for (const option of [...reading.options].slice(1)) option.text = tr(READINGS[option.value]!);
  for (const choice of [stroke, force])
    for (const option of [...choice.options].slice(1)) option.text = tr(SIGNS[option.value]!);
  const ofSettings = () => {
    settings.value = records.find((path) => path === `${inside(folder.value)}settings.csv`) ?? "";
  };
  folder.addEventListener("change", ofSettings);
  ofSettings();
  const question = new Question<Mapped>(
    tr("Map the damper"),
    () => ({
      kind: "damper-map",
      files: [folder.value],
      settings: settings.value,
      reading: reading.value,
      stroke_positive: stroke.value,
      force_positive: force.value,
    }),
    (reply) => {
      history.replaceState(null, "", address("dampers", { folder: folder.value }));
      return shown(reply);
    },
  );
  const form = make(
      "div",
      { class: "form", hidden: !folder.options.length },
      field(tr("Folder of records"), folder),
      field(tr("Settings of each file"), settings),
      field(tr("Reading"), reading),
      field(tr("Stroke"), stroke),
      field(tr("Force"), force),
      question.button,
    ),
    none = make(
      "p",
      { class: "empty", hidden: !form.hidden },
      tr("No records in this project yet: drop those of a damper rig below."),
    );
  const came = () => (paths: string[]) => {
    records.push(...paths);
    const into = folderOf(paths[0]!);
    if (![...folder.options].some(({ value }) => value === into))
      folder.append(make("option", { value: into }, into));
    for (const path of paths)
      if (![...settings.options].some(({ value }) => value === path))
        settings.append(make("option", { value: path }, path));
    folder.value = into;
    ofSettings();
    form.hidden = false;
    none.hidden = true;
  };
  place.replaceChildren(
    make("h1", {}, tr("Dampers")),
    make(
      "p",
      { class: "muted" },
      tr(
        "Records of a test rig become force over velocity for each setting, with intervals. Bump and compression are positive; the gas force is taken out.",
      ),
    ),
    none,
    form,
    question.place,
    ...uses(
      records,
      entries.filter(({ kind }) => VEHICLES.includes(kind)).map(({ path }) => path),
    ),
    make("h2", {}, tr("New records")),
    dropZone(
      () => "dyno",
      tr("Drop records of a damper rig here, or choose them; they are saved in the folder dyno."),
      came,
    ),
  );
  if (wanted) await question.ask();
}

const TABLES = /\.(csv|tsv|txt|xlsx)$/i;

/** What follows a map: clicks for a target, two dampers compared, their sheet; and histograms from the track. */
function uses(records: string[], rigs: string[]): HTMLElement[] {
  const maps = [...new Set(records.map(folderOf)), ...records.filter((path) => TABLES.test(path))];
  const target = optional("damping ratios at the wheel", rigs),
    ofClicks = select(maps),
    boxes = {
      bump: textBox("", "70 %"),
      rebound: textBox("", "70 %"),
      knee: textBox("", "0.1 m/s"),
      motion_ratio: textBox("", "0.8"),
      sprung_mass: textBox("", "65 kg"),
      wheel_rate: textBox("", "20 N/mm"),
    };
  const ratios = make(
    "span",
    { class: "sizes" },
    field(tr("Damping ratio in bump"), boxes.bump),
    field(tr("Damping ratio in rebound"), boxes.rebound),
    field(tr("Knee, wheel speed"), boxes.knee),
    field(tr("Motion ratio"), boxes.motion_ratio),
    field(tr("Sprung mass on the wheel"), boxes.sprung_mass),
    field(tr("Wheel rate"), boxes.wheel_rate),
  );
  target.addEventListener("change", () => {
    ratios.hidden = target.value !== "";
  });
  const clicks = asking(tr("Choose the clicks"), tr("Clicks for a target"), () => ({
    kind: "damper-clicks",
    damper_map: ofClicks.value,
    target: target.value,
    ...(target.value
      ? {}
      : Object.fromEntries(Object.entries(boxes).map(([name, box]) => [name, box.value.trim()]))),
  }));
  const first = select(maps),
    second = select(
      maps,
      maps.find((path) => path !== maps[0] && !TABLES.test(path)),
    ),
    tolerance = textBox("", "5 %"),
    force = textBox("", "20 N");
  const compared = asking(tr("Compare"), tr("Two dampers compared"), () => ({
    kind: "damper-compare",
    first: first.value,
    second: second.value,
    tolerance: tolerance.value.trim(),
    tolerance_force: force.value.trim(),
  }));
  const one = select(maps),
    other = optional("none", maps),
    remark = textBox();
  const sheet = asking(tr("Make the sheet"), tr("Sheet of the damper"), () => ({
    kind: "damper-sheet",
    maps: [one.value, ...(other.value ? [other.value] : [])],
    remark: remark.value.trim(),
  }));
  const track = select(records),
    model = optional("none", records),
    division = select(Object.keys(DIVISIONS), "laps", (name) => tr(DIVISIONS[name]!)),
    low = textBox("", "25 mm/s"),
    stroke = textBox("", "75 mm");
  const histograms = asking(tr("Draw the histograms"), tr("Histograms from the track"), () => ({
    kind: "damper-histogram",
    records: [track.value],
    beside: model.value,
    by: division.value,
    low_speed: low.value.trim(),
    stroke: stroke.value.trim(),
  }));
  const folded = (title: string, about: string, question: Question<unknown>, ...form: Node[]) =>
    make(
      "details",
      { class: "uses", hidden: !maps.length },
      make("summary", {}, title),
      make("p", { class: "muted" }, about),
      make("div", { class: "form" }, ...form, question.button),
      question.place,
    );
  return [
    folded(
      tr("Clicks for a target"),
      tr(
        "The whole clicks with which the damper comes closest to a target, and what is left over.",
      ),
      clicks,
      field(tr("Damper map"), ofClicks),
      field(tr("Target"), target),
      ratios,
    ),
    folded(
      tr("Two dampers compared"),
      tr("Force by force, against a tolerance; the intervals of both count."),
      compared,
      field(tr("Damper map"), first),
      field(tr("Other damper"), second),
      field(tr("Tolerance, of the force"), tolerance),
      field(tr("Tolerance beside it"), force),
    ),
    folded(
      tr("Sheet of the damper"),
      tr("As makers print it; two dampers of an axle stand beside each other."),
      sheet,
      field(tr("Damper map"), one),
      field(tr("Other damper"), other),
      field(tr("Remark"), remark),
    ),
    folded(
      tr("Histograms from the track"),
      tr("Shares of time over travel and velocity, at low and high speed, for each corner."),
      histograms,
      field(tr("Record from the track"), track),
      field(tr("Model on the same road"), model),
      field(tr("Also show"), division),
      field(tr("Low speed up to"), low),
      field(tr("Stroke of the damper"), stroke),
    ),
  ];
}

const DIVISIONS: Record<string, string> = {
  laps: "laps",
  sectors: "sectors",
  whole: "only the whole record",
};

/** A question whose answer is a report. */
const asking = (label: string, title: string, task: () => object): Question<unknown> =>
  new Question<unknown>(label, task, (reply) => [report(reply.report, title), snippets(reply)]);

const folderOf = (path: string) =>
  path.includes("/") ? path.slice(0, path.lastIndexOf("/")) : ".";
const inside = (folder: string) => (folder === "." ? "" : `${folder}/`);

/** Curves with the slider over clicks, and below them what the report says. */
function shown(reply: Reply<Mapped>): HTMLElement[] {
  const whole = make("div", {}, make("p", { class: "state" }, tr("loading …")));
  reported(reply.report, reply.result.findings).then(
    (report) => whole.replaceChildren(report),
    (error) => whole.replaceChildren(problem(error)),
  );
  return [new Curves(reply.result.curves).element, whole, snippets(reply)];
}

/** Force over velocity: measured settings, and the curve between clicks with its interval. */
class Curves {
  readonly element: HTMLElement;
  private readonly plots = new LinkedPlots(
    (x) => this.plots.mark(x),
    () => {},
    null,
    340,
  );
  private readonly slider: HTMLInputElement;
  private readonly typed: HTMLInputElement;
  private readonly rows = make("tbody", {});

  constructor(private readonly data: Mapped["curves"]) {
    const { between } = data,
      last = Math.max(between.length - 1, 0),
      step = last ? between[1]!.clicks - between[0]!.clicks : 1,
      ends = { min: String(between[0]?.clicks ?? 0), max: String(between[last]?.clicks ?? 0) };
    this.slider = make("input", {
      type: "range",
      min: "0",
      max: String(last),
      step: "1",
      value: String(Math.round(last / 2)),
      "aria-label": tr("Clicks"),
    });
    this.typed = numberBox({
      ...ends,
      step: String(step),
      "aria-label": `${tr("Clicks")}, ${tr("typed")}`,
    });
    this.slider.addEventListener("input", () => this.draw(true));
    this.typed.addEventListener("change", () => {
      const value = this.typed.valueAsNumber;
      if (!Number.isFinite(value)) return;
      const nearest = between.reduce(
        (best, { clicks }, k) =>
          Math.abs(clicks - value) < Math.abs(between[best]!.clicks - value) ? k : best,
        0,
      );
      this.slider.value = String(nearest);
      this.draw(true);
    });
    const player = make(
      "div",
      { class: "player", tabindex: "0", role: "region", "aria-label": tr("Force over velocity") },
      make(
        "div",
        { class: "bar" },
        make("span", { class: "grow" }),
        make(
          "button",
          { type: "button", title: tr("everything"), click: () => this.plots.reset() },
          tr("All"),
        ),
        saveChart(this.plots.element, () => tr("Damper map")),
      ),
      make("div", { class: "plots-only" }, this.plots.element),
    );
    const velocity = `${tr("velocity")} [${data.velocity_unit}]`,
      force = (words: string) => `${tr(words)} [${data.force_unit}]`;
    this.element = make(
      "section",
      {},
      make("h2", {}, tr("Force over velocity")),
      ...(between.length
        ? [
            make(
              "div",
              { class: "slider" },
              make("span", { class: "name" }, tr("Clicks")),
              this.slider,
              this.typed,
            ),
          ]
        : []),
      player,
      ...(between.length
        ? [
            make(
              "details",
              {},
              make("summary", {}, tr("Values of the curve between clicks")),
              table(
                tr("Values of the curve between clicks"),
                [velocity, force("force"), force("from"), force("to")],
                this.rows,
                [0, 1, 2, 3],
              ),
            ),
          ]
        : []),
    );
    whenColoursChange(() => this.plots.repaint());
    this.draw(false);
    new IntersectionObserver((_, observer) => {
      this.plots.reset();
      observer.disconnect();
    }).observe(this.element);
  }

  private draw(isMoved: boolean): void {
    const { data } = this,
      chosen = data.between[Number(this.slider.value)];
    const line = (label: string, role: string, y: Numbers, dash?: number[]) => ({
      label,
      role,
      y,
      step: 0.1,
      shown: true,
      ...(dash ? { dash } : {}),
    });
    const lines = data.settings.map(({ label, force }, k) =>
      line(heard(label), ROLES[k % ROLES.length]!, force),
    );
    const own = chosen ?? (data.settings.length === 1 ? data.settings[0]! : null),
      bands: PlotPane["bands"] = [];
    if (own) {
      if (!chosen) lines.length = 0;
      const first = lines.length;
      lines.push(
        line(chosen ? tr("between clicks") : data.settings[0]!.label, "after", own.force),
        line(tr("from"), "after", own.low, DOTS),
        line(tr("to"), "after", own.high, DOTS),
      );
      bands.push({ low: first + 1, high: first + 2, role: "after" });
    }
    if (chosen) this.typed.value = String(chosen.clicks);
    this.slider.setAttribute("aria-valuetext", localised(String(chosen?.clicks ?? "")));
    this.plots.show(
      {
        x: data.velocity,
        xLabel: `${tr("velocity, bump positive")} [${data.velocity_unit}]`,
        spans: [],
        window: null,
        panes: [
          {
            name: "damper.force",
            title: tr("force without gas"),
            unit: data.force_unit,
            lines,
            bands,
          },
        ],
      },
      isMoved ? this.plots.window : null,
    );
    if (!chosen) return;
    this.rows.replaceChildren(
      ...data.velocity.flatMap((x, k) =>
        chosen.force[k] === null || chosen.force[k] === undefined
          ? []
          : [
              make(
                "tr",
                {},
                make("th", { scope: "row", class: "right" }, written(x, 3)),
                ...[chosen.force[k], chosen.low[k], chosen.high[k]].map((value) =>
                  make("td", { class: "right" }, written(value, 4)),
                ),
              ),
            ],
      ),
    );
  }
}

const DOTS = [1, 4]; // of the ends of an interval
