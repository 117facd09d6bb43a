/** Rides over rough roads with and without control: comfort, travel, road holding; and the best designs between them. */

import { Store } from "../../data";
import { make, written } from "../../page";
import { tr } from "../../words";
import type { ParetoFront } from "../answers";
import * as api from "../api";
import { savable } from "../curves";
import { Drafts, enter, entered } from "../drafts";
import {
  accompany,
  begin,
  failures,
  follow,
  JobCard,
  jobList,
  Question,
  report,
  titled,
  whole,
} from "../jobs";
import { numberBox } from "../numberbox";
import { field, once, problem, select, snippets, textBox } from "../parts";
import { line, plane, svg } from "../picture";
import { inWords, MERITS, shownUnit } from "../quantities";
import { advised, asSaid, raised } from "../refusals";
import { address, carry, given, goTo, type Values, VEHICLES } from "../shell";
import { table } from "../table";
import type { Choices } from "./inspection";

interface Run {
  control: string;
  merits: Record<string, number>;
  comfort: Record<string, string>;
  findings: { severity: string; message: string; place: string }[];
}
interface Compared {
  vehicle: string;
  road: string;
  speed: number;
  duration: number;
  runs: Run[];
  failed: Record<string, string>;
}
const MOST_OVERLAID = 6;
const ROLES = ["comfort", "holding", "travel"] as const;
export async function show(place: HTMLElement, values: Values): Promise<void> {
  const id = values.get("job");
  if (id) {
    await showRun(place, id);
    return;
  }
  const [{ entries }, choices, library] = await Promise.all([
    api.project(),
    api.get<Choices>("/api/choices"),
    api.library(),
  ]);
  const rigs = [
    ...entries.filter((entry) => VEHICLES.includes(entry.kind)).map((entry) => entry.path),
    ...library.map((shippedRig) => shippedRig.name),
  ];
  const roads = [
    ..."ABCDEFGH".split("").map((part) => `iso:${part}`),
    ...choices.roads,
    ...entries.filter((entry) => entry.kind === "road").map((entry) => entry.path),
  ];
  const vehicle = select(rigs, values.get("vehicle") ?? "audi-a6-quarter-car"),
    road = select(roads, values.get("road") ?? "iso:C"),
    changes = given<Record<string, number | string>>(values.get("set"));
  const speed = textBox(values.get("speed") ?? "20 m/s"),
    duration = textBox(values.get("duration") ?? "20 s"),
    seed = numberBox({ min: "0", value: "0" });
  const controls = make(
    "fieldset",
    { class: "free" },
    make("legend", {}, "Controllers"),
    ...choices.controls.map((name) =>
      make(
        "label",
        {},
        make(
          "input",
          name === "passive" || name === "skyhook"
            ? { type: "checkbox", value: name, checked: true }
            : { type: "checkbox", value: name },
        ),
        ` ${name}`,
      ),
    ),
  );
  const said = make("div", { "aria-live": "polite" }),
    go = make("button", { type: "submit", class: "main" }, "Drive"),
    form = make("form", {});
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const chosen = [...controls.querySelectorAll<HTMLInputElement>("input:checked")].map(
      (element) => element.value,
    );
    const was = driven();
    once(
      go,
      begin({
        kind: "compare",
        vehicle: vehicle.value,
        road: road.value,
        speed: speed.value,
        duration: duration.value,
        seed: Number(seed.value),
        control: chosen.length ? chosen : ["passive"],
        changes,
      }),
    ).then(
      (job) => {
        drafts?.done({ drive: was });
        goTo(place, "ride", { job: job.id });
      },
      (error) => said.replaceChildren(problem(error)),
    );
  });
  vehicle.addEventListener("change", () => carry(vehicle.value));
  const changed = Object.entries(changes);
  form.append(
    make(
      "div",
      { class: "form" },
      field("Vehicle or rig", vehicle),
      field("Road", road),
      field("Speed", speed),
      field("Duration", duration),
      field("Seed", seed),
    ),
    ...(changed.length
      ? [
          make(
            "p",
            { class: "muted" },
            `changed (SI): ${changed.map(([path, value]) => `${path} = ${written(Number(value), 5)}`).join(", ")} `,
            make("a", { href: address("ride", { vehicle: vehicle.value }) }, "as it is"),
          ),
        ]
      : []),
    controls,
    make("div", { class: "bar" }, go),
    said,
  );
  const boxes = [...controls.querySelectorAll("input")],
    driving = {
      vehicle,
      road,
      speed,
      duration,
      seed,
      ...Object.fromEntries(boxes.map((box) => [`control ${box.value}`, box])),
    };
  const driven = () => entered(driving),
    search = pareto(rigs, roads, (was) => drafts?.done({ search: was })),
    offers = make("div", {});
  let drafts: Drafts<{ drive: Record<string, string>; search: Searched }> | null = null;
  place.replaceChildren(
    make("h1", {}, "Ride and control"),
    make(
      "p",
      { class: "muted" },
      "Drive a vehicle over a rough road, passive or controlled, and compare comfort, travel and road holding.",
    ),
    offers,
    form,
    make("h2", {}, "Best designs"),
    search.element,
    make("h2", {}, "Rides and fronts"),
    jobList(
      ["compare", "pareto"],
      (job) => {
        location.hash = address("ride", { job: job.id });
      },
      "No rides yet.",
    ),
    make("h2", {}, "Overlay rides"),
    overlay(),
  );
  const [folder] = await Promise.all([api.folder(), search.loaded]),
    state = () => ({ drive: driven(), search: search.state() });
  const again = values.get("again");
  if (again)
    try {
      const { kind, asked } = await whole(again);
      if (kind === "pareto") await search.restore(searched(asked));
      else enter(driving, driveOf(asked, boxes));
      (kind === "pareto" ? search.element : form).scrollIntoView();
    } catch (error) {
      said.replaceChildren(problem(error));
    }
  if (!place.isConnected) return;
  drafts = new Drafts(
    folder,
    address("ride", values.has("set") ? Object.fromEntries(values) : {}),
    state(),
    state,
    async (was) => {
      enter(driving, was.drive);
      await search.restore(was.search);
    },
  );
  for (const element of [form, search.element]) drafts.hear(element);
  offers.replaceChildren(drafts.element);
}

/** A ride with one controller. */
interface One {
  vehicle: string;
  road: string;
  speed: string;
  duration: string;
  seed: number;
  changes: Record<string, unknown>;
  control: string;
}

/** The rides of a job, one for each controller. */
function ridesOf(asked: Record<string, unknown>): One[] {
  const {
    control,
    kind: _,
    ...drive
  } = asked as unknown as Omit<One, "control"> & {
    control: string[];
    kind?: string;
  };
  return control.map((name) => ({ ...drive, control: name }));
}

interface Drawn {
  content: object;
  notes: string[];
  failed: Record<string, string>;
}

/** Draws rides over time or as spectra, in figures that can be saved; `isAlone` adds what does the same. */
function drawn(
  rides: () => One[],
  isAlone: boolean,
): { asking: HTMLElement; question: Question<Drawn> } {
  const over = select(["0", "1"], "0", (value) =>
    tr(value === "0" ? "time" : "frequency (spectra)"),
  );
  let draw = (): void => {};
  over.addEventListener("change", () => draw());
  const question = new Question<Drawn>(
    "Draw",
    () => ({ kind: "overlay", rides: rides() }),
    ({ result, ...reply }) => {
      const holder = make("div", {});
      void Store.open(JSON.stringify(result.content))
        .then(inWords)
        .then((store) => {
          if (!holder.isConnected) return; // others were drawn meanwhile
          draw = () => {
            const model = store.content.viewers[Number(over.value)];
            if (model) holder.replaceChildren(savable(model, store).element);
          };
          draw();
        });
      return [
        ...Object.entries(result.failed).map(([name, reason]) =>
          make("p", { class: "problem" }, `not run: ${name}: `, asSaid(reason)),
        ),
        ...result.notes.map((text) => make("p", { class: "muted" }, text)),
        holder,
        ...(isAlone ? [snippets(reply)] : []),
      ];
    },
  );
  const asking = make("div", { class: "form" }, field("Curves over", over), question.button);
  return { asking, question };
}

/** Curves of the rides of a job, drawn at once, up to as many as an overlay takes. */
function curvesOf(asked: Record<string, unknown>): HTMLElement {
  const rides = ridesOf(asked).slice(0, MOST_OVERLAID),
    { asking, question } = drawn(() => rides, false);
  question.button.hidden = true;
  setTimeout(() => void question.ask()); // once it is part of the page
  return make("section", {}, make("h2", {}, "Curves"), asking, question.place);
}

/** Overlays up to six finished rides of any vehicles, over time and as spectra. */
function overlay(): HTMLElement {
  const boxes = make("fieldset", { class: "free" }, make("legend", {}, "Finished rides")),
    chosen = new Map<string, One>(),
    offered = new Set<string>();
  const none = make("p", { class: "empty" }, "No finished ride yet: drive first."),
    { asking, question } = drawn(() => [...chosen.values()], true);
  const section = make("section", {}, none, boxes, asking, question.place);
  boxes.hidden = asking.hidden = true;
  follow(section, (jobs) => {
    for (const job of jobs
      .filter((job) => job.kind === "compare" && job.state === "done")
      .reverse()) {
      for (const request of ridesOf(job.asked)) {
        const key = JSON.stringify(request);
        if (offered.has(key)) continue; // the same was driven before
        offered.add(key);
        const box = make("input", { type: "checkbox" });
        box.addEventListener("change", () => {
          if (box.checked) chosen.set(key, request);
          else chosen.delete(key);
          question.button.disabled = !chosen.size;
        });
        const changed = Object.entries(request.changes)
          .map(
            ([path, value]) =>
              `, ${path} = ${typeof value === "number" ? written(value, 4) : String(value)}`,
          )
          .join("");
        boxes.append(
          make(
            "label",
            {},
            box,
            ` ${titled(job.title)}${request.seed ? `, ${request.seed}` : ""}, ${request.control}${changed}`,
          ),
        );
      }
    }
    none.hidden = offered.size > 0;
    boxes.hidden = asking.hidden = !offered.size;
    question.button.disabled = !chosen.size;
  });
  return section;
}

interface Searched {
  form: Record<string, string>;
  rows: string[][];
}
const DAMPING = "N*s/m",
  MOST_PROPOSED = 4; // two axles, bump and rebound

/** Bounds that are proposed for a parameter, in its unit: a third to three times its value; of a hardpoint 30 mm. */
function usualBounds(own?: api.RigNumber): string {
  if (!own || (!own.value && own.si !== "m")) return "";
  const value = own.value * own.factor,
    [low, high] = /hardpoints\./.test(own.path)
      ? [value - 0.03 * own.factor, value + 0.03 * own.factor]
      : [0.3 * value, 3 * value].sort((a, b) => a - b),
    short = (end: number) => Number(end.toPrecision(3));
  return `${short(low!)}..${short(high!)} ${own.unit}`.trim();
}

/** What a ride was asked for, as its form has it. */
function driveOf(
  asked: Record<string, unknown>,
  boxes: HTMLInputElement[],
): Record<string, string> {
  const control = asked.control as string[],
    texts = ["vehicle", "road", "speed", "duration", "seed"].map((name) => [
      name,
      String(asked[name] ?? ""),
    ]),
    chosen = boxes.map((box) => [`control ${box.value}`, String(control.includes(box.value))]);
  return Object.fromEntries([...texts, ...chosen]);
}

/** What a search was asked for, as its form has it. */
function searched(asked: Record<string, unknown>): Searched {
  const limits = asked.limit as Record<string, string>;
  return {
    form: {
      vehicle: String(asked.vehicle),
      road: String(asked.road),
      speed: String(asked.speed),
      points: String(asked.points ?? ""),
      limit: limits["strut.deflection"] ?? "",
    },
    rows: Object.entries(asked.free as Record<string, string>),
  };
}

function pareto(
  rigs: string[],
  roads: string[],
  begun: (was: Searched) => void,
): {
  element: HTMLElement;
  loaded: Promise<void>;
  state: () => Searched;
  restore: (was: Searched) => Promise<void>;
} {
  const vehicle = select(rigs, "audi-a6-quarter-car"),
    road = select(
      roads.filter((road) => road.startsWith("iso:")),
      "iso:C",
    ),
    speed = textBox("20 m/s"),
    points = numberBox({ min: "2", max: "200", value: "12" });
  const rows = make("div", {}),
    paths = make("datalist", { id: "paths-that-are-free" }),
    said = make("div", { "aria-live": "polite" });
  const limit = textBox("", "20 mm");
  const more = make("button", { type: "button" }, "Add a parameter"),
    go = make("button", { type: "button", class: "main" }, "Search");
  let numbers: api.RigNumber[] = [];
  const add = (
    path = "",
    bounds = usualBounds(numbers.find((parameter) => parameter.path === path)),
  ) => {
    const which = make("input", {
        type: "text",
        value: path,
        list: "paths-that-are-free",
        "aria-label": "design variable",
        size: "30",
      }),
      within = make("input", {
        type: "text",
        value: bounds,
        placeholder: "low..high unit, or ±30 %",
        "aria-label": "bounds",
      });
    which.addEventListener("change", () => {
      within.value = usualBounds(
        numbers.find((parameter) => parameter.path === which.value.trim()),
      );
    });
    const away = make(
      "button",
      { type: "button", "aria-label": tr("remove #", path || tr("this parameter")) },
      "×",
    );
    const row = make("div", { class: "bar pair" }, which, within, away);
    away.addEventListener("click", () => row.remove());
    rows.append(row);
  };
  const load = async () => {
    const name = vehicle.value;
    said.replaceChildren();
    rows.replaceChildren(); // the numbers of another rig are none to be edited
    more.disabled = go.disabled = true;
    try {
      const rig = await api.rig(name);
      if (vehicle.value !== name) return; // another one was chosen meanwhile
      numbers = rig.numbers;
      const chosen = numbers.filter((parameter) => parameter.is_chosen),
        dampers = chosen.filter((number) => number.si === DAMPING).slice(0, MOST_PROPOSED);
      paths.replaceChildren(...chosen.map((number) => make("option", { value: number.path })));
      for (const { path } of dampers.length ? dampers : chosen.slice(0, 1)) add(path);
      more.disabled = go.disabled = false;
    } catch (error) {
      if (vehicle.value === name) said.replaceChildren(problem(error));
    }
  };
  let loaded = load();
  vehicle.addEventListener("change", () => {
    loaded = load();
  });
  more.addEventListener("click", () => add());
  go.addEventListener("click", () => {
    const free = Object.fromEntries(
      [...rows.children]
        .map(
          (row) =>
            [...row.querySelectorAll("input")].map((element) => element.value.trim()) as [
              string,
              string,
            ],
        )
        .filter(([path]) => path),
    );
    const was = state();
    once(
      go,
      begin({
        kind: "pareto",
        vehicle: vehicle.value,
        road: road.value,
        speed: speed.value,
        free,
        points: Number(points.value),
        limit: limit.value ? { "strut.deflection": limit.value } : {},
      }),
    ).then(
      (job) => {
        begun(was);
        goTo(said, "ride", { job: job.id });
      },
      (error) => said.replaceChildren(problem(error)),
    );
  });
  const controls = { vehicle, road, speed, points, limit },
    state = () => ({
      form: entered(controls),
      rows: [...rows.children].map((row) =>
        [...row.querySelectorAll("input")].map((element) => element.value),
      ),
    });
  const restore = async (was: Searched) => {
    enter(controls, was.form);
    await loaded;
    rows.replaceChildren();
    for (const [path, within] of was.rows) add(path, within);
  };
  return {
    loaded,
    state,
    restore,
    element: make(
      "section",
      {},
      make(
        "p",
        { class: "muted" },
        "From the most comfortable design to the one with the best road holding; each opens as a ride.",
      ),
      make(
        "div",
        { class: "form" },
        field("Vehicle or rig", vehicle),
        field("Road", road),
        field("Speed", speed),
        field("Designs", points),
        field("Maximum r.m.s. travel (optional)", limit),
      ),
      rows,
      paths,
      make("div", { class: "bar" }, more, go),
      said,
    ),
  };
}

async function showRun(place: HTMLElement, id: string): Promise<void> {
  const first = await whole<Compared | ParetoFront>(id),
    results = make("div", {}),
    card = new JobCard(first);
  place.replaceChildren(
    make("h1", {}, titled(first.title)),
    make("p", {}, make("a", { href: address("ride") }, "All rides")),
    card.element,
    results,
  );
  await accompany(
    place,
    first,
    (job) => card.show(job),
    (end) => {
      if (!end.result) return;
      results.replaceChildren(
        ...("runs" in end.result ? merits(end.result) : front(end.result, end.asked)),
        ...failures("runs" in end.result ? end.result : null),
        ...("runs" in end.result ? [curvesOf(end.asked)] : []),
        snippets(end),
        ...(end.has_page
          ? [
              report(
                end.report,
                "runs" in end.result ? "Time histories, spectra and all metrics" : "Report",
              ),
            ]
          : []),
      );
    },
  );
}

/** Comparison of controllers; the best value of each merit is marked. */
function merits(comparison: Compared): HTMLElement[] {
  const shown = MERITS.filter(([name]) =>
    comparison.runs.some((run) => Number.isFinite(run.merits[name])),
  );
  const best = Object.fromEntries(
    shown.map(([name]) => [
      name,
      Math.min(...comparison.runs.map((run) => run.merits[name] ?? Infinity)),
    ]),
  );
  const passive = comparison.runs.find((run) => run.control === "passive");
  return [
    table(
      "controllers",
      ["controller", ...shown.map(([, words, unit]) => `${tr(words)} [${unit}]`), "comfort"],
      comparison.runs.map((run) => [
        run.control,
        ...shown.map(([name, , , factor]) => {
          const value = run.merits[name],
            before = passive?.merits[name];
          if (value === undefined) return "–";
          const isBest = value === best[name] && comparison.runs.length > 1 && value > 0,
            number = written(value * factor),
            change = 100 * (value / (before || NaN) - 1);
          return [
            isBest ? make("span", { class: "mark good" }, number) : number,
            run === passive || Number.isNaN(change)
              ? ""
              : ` (${change >= 0 ? "+" : ""}${written(change, 2)} %)`,
          ];
        }),
        Object.values(run.comfort)
          .map((text) =>
            text
              .split(" to ")
              .map((end) => tr(end))
              .join(tr(" to ")),
          )
          .join("; "),
      ]),
      shown.map((_, k) => k + 1),
      "Smaller is better; change from the passive rig in brackets",
    ),
    ...Object.entries(comparison.failed).map(([name, reason]) =>
      make("p", { class: "problem" }, `not run: ${name}: `, asSaid(reason)),
    ),
    ...advised(
      comparison.runs.flatMap((run) =>
        run.findings.map((finding) => ({
          ...finding,
          place: [run.control, finding.place].filter(Boolean).join(", "),
        })),
      ),
      "p",
    ),
  ];
}

/** A metric with the wheels that it combines, in the language of the page. */
const metricSaid = (words: string): string =>
  words.replace(
    /, (unweighted r\.m\.s\.|r\.m\.s\.|worst) of (.+)$/,
    (_, how: string, wheels: string) =>
      `, ${tr(
        `${how} of #`,
        wheels
          .split(/(, | and )/)
          .map((part) => tr(part))
          .join(""),
      )}`,
  );

/** The front as points that open as rides, with the present rig and single optimum dampers. */
function front(pareto: ParetoFront, asked: Record<string, unknown>): HTMLElement[] {
  interface Point {
    name: string;
    comfort: number;
    holding: number;
    travel: number;
    values: Record<string, number>;
    on: boolean;
  }
  const points: Point[] = [
    ...pareto.comfort.map((comfort, k) => ({
      name: `design ${k + 1}`,
      comfort,
      holding: pareto.holding[k]!,
      travel: pareto.travel[k]!,
      values: Object.fromEntries(
        Object.entries(pareto.numbers).map(([path, values]) => [path, values[k]!]),
      ),
      on: true,
    })),
    ...pareto.marks.map((mark) => ({ ...mark, name: `${mark.name} (${mark.kind})`, on: false })),
  ];
  const opened = (point: Point) =>
    address("ride", {
      vehicle: String(asked.vehicle),
      road: String(asked.road),
      speed: String(asked.speed),
      set: JSON.stringify(point.values),
    });
  const ends = (values: number[]) => {
    const low = Math.min(...values),
      high = Math.max(...values),
      room = 0.06 * (high - low || 1);
    return [low - room, high + room] as const;
  };
  const axis = (role: "comfort" | "holding") => {
    const [unit, factor] = shownUnit(pareto.units[role]!);
    return {
      ends: ends(points.map((point) => point[role])),
      label: `${metricSaid(pareto.words[role]!)} [${unit}]`,
      factor,
    };
  };
  const { picture, at } = plane(axis("comfort"), axis("holding"), {
    role: "group",
    "aria-label": "Pareto front",
  });
  const front = points.filter((point) => point.on).sort((a, b) => a.comfort - b.comfort);
  picture.append(
    svg("path", {
      class: "search",
      d: line(front.map((point) => at(point.comfort, point.holding))),
    }),
  );
  for (const point of points) {
    const link = svg("a", { href: opened(point), "aria-label": `open ${point.name} as a ride` });
    const [x, y] = at(point.comfort, point.holding);
    link.append(
      svg("title", {}, `${point.name}: open as a ride`),
      point.on
        ? svg("circle", { cx: x, cy: y, r: 6, class: "on" })
        : svg("rect", { x: x - 5, y: y - 5, width: 10, height: 10, class: "off" }),
    );
    picture.append(link);
  }
  const figure = make("figure", {}),
    numbers = Object.keys(pareto.numbers);
  figure.append(
    picture,
    make(
      "figcaption",
      { class: "muted" },
      `${raised(pareto.driven)}; circles: the front; squares: the present rig and single optimum dampers. Each opens as a ride.`,
    ),
  );
  return [
    ...(pareto.converged
      ? []
      : [make("p", { class: "mark fair" }, "The search did not converge for every design.")]),
    figure,
    table(
      "designs",
      [
        "design",
        ...ROLES.map(
          (role) => `${metricSaid(pareto.words[role]!)} [${shownUnit(pareto.units[role]!)[0]}]`,
        ),
        ...numbers.map((path) => `${path} [${shownUnit(pareto.number_units[path]!)[0]}]`),
        "",
      ],
      points.map((point) => [
        point.name,
        ...ROLES.map((role) => written(point[role] * shownUnit(pareto.units[role]!)[1])),
        ...numbers.map((path) =>
          written((point.values[path] ?? NaN) * shownUnit(pareto.number_units[path]!)[1]),
        ),
        make("a", { href: opened(point), "aria-label": `open ${point.name} as a ride` }, "open"),
      ]),
      [...ROLES, ...numbers].map((_, k) => k + 1),
    ),
    ...advised(pareto.findings, "p"),
  ];
}
