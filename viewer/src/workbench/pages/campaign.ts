/** A bench campaign: measurements dropped in and read, parts characterised, the model updated, every trial compared. */

import { make, withInterval, written } from "../../page";
import { heard, inField, tr, withComma } from "../../words";
import * as api from "../api";
import { Drafts, enter, entered, typedIn } from "../drafts";
import { bring } from "../incoming";
import {
  accompany,
  ask,
  begin,
  dropZone,
  failures,
  JobCard,
  jobList,
  Question,
  report,
  type Step,
  whole,
} from "../jobs";
import { field, once, problem, select, snippets, textBox } from "../parts";
import { pasteTrials } from "../pasting";
import { line, svg } from "../picture";
import { ESTIMATES } from "../quantities";
import { type Fields, Reading } from "../reading";
import { advised, asSaid, type Finding } from "../refusals";
import { reported } from "../reported";
import { address, goTo, type Values } from "../shell";
import { table } from "../table";

interface Bench {
  name: string;
  found: string[];
  files: string[];
  columns?: Record<string, string>;
  variable?: string;
  stroke_positive?: string;
  force_positive?: string;
  law?: string;
  discard_below?: string;
  intercept?: string;
  branch?: string;
  channel?: string;
  from?: string;
  to?: string;
  sample_time?: string;
}
/** The last edit: the campaign's text before it, the digest after it, and its message. */
interface Written {
  path: string;
  before: string;
  digest: string;
  said?: string;
}
let written_: Written | null = null;
interface Overview {
  title: string;
  synthetic: string;
  rig: string;
  roads: string[];
  mass: string;
  bench: Bench[];
  trials: Record<string, unknown>[];
  updates: Record<string, unknown>[];
}

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const job = values.get("job"),
    file = values.get("file");
  if (job) {
    await showRun(place, job);
    return;
  }
  if (file) {
    await showFile(place, file, values.get("read") ?? "");
    return;
  }
  const { entries } = await api.project();
  const files = entries.filter((entry) => entry.kind === "campaign");
  const folder = textBox("campaign"),
    status = make("div", { "aria-live": "polite" });
  const start = make("button", { type: "submit", class: "main" }, "Copy into this project");
  const form = make("form", { class: "form" }, field("Folder", folder), start);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const out = folder.value;
    once(start, ask({ kind: "new-campaign", out })).then(
      () => goTo(place, "campaign", { file: `${out}/campaign.toml` }),
      (error) => status.replaceChildren(problem(error)),
    );
  });
  place.replaceChildren(
    make("h1", {}, "Campaigns"),
    make(
      "p",
      { class: "muted" },
      "From measurements of springs, tyres, decays and trials to a validated model: characterised, updated, and compared with every trial.",
    ),
    files.length
      ? make(
          "ul",
          { class: "files" },
          ...files.map((file) =>
            make(
              "li",
              {},
              make("a", { href: address("campaign", { file: file.path }) }, file.path),
            ),
          ),
        )
      : make(
          "p",
          { class: "empty" },
          "No campaign in this project yet. Start from the example below and add your own measurements.",
        ),
    make("h2", {}, "Runs"),
    jobList(
      ["campaign"],
      (job) => {
        location.hash = address("campaign", { job: job.id });
      },
      "No campaign has been run yet.",
    ),
    make("h2", {}, "Example campaign"),
    make("p", { class: "muted" }, "Ready to run, with synthetic recordings."),
    form,
    status,
  );
}

async function showFile(place: HTMLElement, path: string, read: string): Promise<void> {
  const reading = api.get<Overview>(`/api/campaign?${api.query({ path })}`);
  reading.catch(() => {}); // heard below
  const [saved, project] = await Promise.all([api.file(path), api.folder()]),
    own = textOf(path, saved, place);
  const latest = written_?.path === path ? written_ : null,
    undo = make("button", { type: "button" }, "Undo"),
    done = make("div", { "aria-live": "polite" });
  if (latest)
    done.append(
      make(
        "p",
        { class: "bar" },
        make("span", { class: "good" }, latest.said ?? "Added to the campaign."),
        undo,
      ),
    );
  undo.addEventListener("click", () => {
    once(undo, api.save(path, latest!.before, latest!.digest)).then(
      () => {
        written_ = null;
        goTo(place, "campaign", { file: path, undone: String(Date.now()) });
      },
      (error) => done.append(problem(error)),
    );
  });
  let overview: Overview;
  try {
    overview = await reading;
  } catch (error) {
    // it can be mended here
    if (!place.isConnected) return;
    let others = {}; // what a draft holds for the page that this file will have again
    const drafts = new Drafts<Edited>(
      project,
      address("campaign", { file: path }),
      own.state(),
      () => ({ ...others, ...own.state() }),
      (was) => {
        others = was;
        own.restore(was);
      },
      () => saved.digest,
      () => false,
      own.isTyped,
    );
    own.used = () => drafts.done(own.state());
    drafts.hear(place);
    own.element.open = true;
    place.replaceChildren(
      make("h1", {}, path),
      make("p", {}, make("a", { href: address("campaign") }, "All campaigns")),
      drafts.element,
      done,
      problem(error),
      own.element,
    );
    return;
  }
  if (!place.isConnected) return;
  const folder = path.includes("/") ? path.slice(0, path.lastIndexOf("/")) : "";
  const inside = (name: string) => (folder ? `${folder}/${name}` : name);
  const out = textBox(inside("results")),
    force = make("input", { type: "checkbox" });
  const status = make("div", { "aria-live": "polite" }),
    go = make("button", { type: "button", class: "main" }, "Run the campaign");
  /** Warns that the saved file would be run or checked, not the edited text. */
  const isUnsaved = () => {
    if (own.isTyped()) {
      own.element.open = true;
      status.replaceChildren(
        problem(new Error(tr("The campaign file has unsaved edits: save or discard them."))),
      );
    }
    return own.isTyped();
  };
  go.addEventListener("click", () => {
    const was = state().form;
    if (isUnsaved()) return;
    once(
      go,
      begin({ kind: "campaign", campaign: path, out: out.value, force: force.checked }),
    ).then(
      (job) => {
        drafts.done({ form: was });
        goTo(place, "campaign", { job: job.id });
      },
      (error) => status.replaceChildren(problem(error)),
    );
  });
  const check = make("button", { type: "button" }, "Check");
  check.addEventListener("click", () => {
    if (isUnsaved()) return;
    once(check, api.check(path)).then(
      ({ problems, notes }) =>
        status.replaceChildren(
          ...(problems.length
            ? problems.map(problem)
            : [make("p", { class: "good" }, "No problems found.")]),
          ...notes.flatMap((note) =>
            typeof note === "string"
              ? make("p", { class: "muted" }, asSaid(note))
              : advised([note], "p"),
          ),
        ),
      (error) => status.replaceChildren(problem(error)),
    );
  });
  const reader = make("div", {}),
    come = make("p", { class: "bar", hidden: true }, "measured: ");
  const open = (
    file: string,
    form: "recording" | "force-deflection",
    given: Partial<Bench> = {},
  ) => {
    opened = entry(path, file, form, given, overview, go, (was) => drafts.done({ entry: was }));
    reader.replaceChildren(opened.element);
    drafts.changed();
    reader.scrollIntoView({ block: "start" });
  };
  let opened: Opened | null = null;
  const link = (
    file: string,
    form: "recording" | "force-deflection",
    given: Partial<Bench> = {},
  ) => {
    const button = make(
      "button",
      { type: "button", "aria-label": tr("view #", file) },
      file.split("/").pop()!,
    );
    button.addEventListener("click", () => open(file, form, given));
    return button;
  };
  const where = textBox(inside("measured"));
  const parts = overview.bench
      .map((bench) => part(bench, overview, link))
      .map((row) => ({ ...row, first: entered(row.controls) })),
    form = { out, force, where },
    first = entered(form);
  const state = () => ({
    entry: opened?.state() ?? null,
    form: typedIn(form, first),
    ...own.state(),
    fits: Object.fromEntries(parts.map((part) => [part.name, typedIn(part.controls, part.first)])),
  });
  const drafts = new Drafts<ReturnType<typeof state>>(
    project,
    address("campaign", { file: path }),
    state(),
    state,
    (was) => {
      enter(form, was.form ?? {});
      for (const part of parts) enter(part.controls, was.fits?.[part.name] ?? {});
      own.restore(was);
      if (!was.entry) return;
      open(was.entry.file, was.entry.form, was.entry.fields);
      opened!.restore(was.entry);
    },
    () => saved.digest,
    () => false,
    own.isTyped,
  ); // what else is entered goes with any text
  own.used = () => drafts.done(own.state());
  drafts.hear(place);
  const hasAngles = overview.trials.some((trial) => trial.strut_angle);
  place.replaceChildren(
    make("h1", {}, overview.title),
    make(
      "p",
      { class: "muted" },
      make("a", { href: address("campaign") }, "All campaigns"),
      ` · ${path} · ${tr("rig")} `,
      ...(/^[^@]+\.toml$/.test(overview.rig) && !overview.rig.includes("..")
        ? [make("a", { href: address("rig", { name: inside(overview.rig) }) }, overview.rig)]
        : [overview.rig]),
    ),
    drafts.element,
    done,
    ...(overview.synthetic ? [make("p", { class: "mark fair" }, overview.synthetic)] : []),
    make(
      "div",
      { class: "form" },
      field("Results folder", out),
      make("label", { class: "field" }, make("span", {}, "Replace existing results"), force),
      check,
      go,
    ),
    status,
    make("h2", {}, "Parts"),
    ...(parts.length
      ? parts.map((part) => part.element)
      : [
          make(
            "p",
            { class: "empty" },
            "No measured parts: the rig is used as its file describes it.",
          ),
        ]),
    make("h2", {}, "Trials"),
    table(
      "trials",
      [
        "trial",
        "use",
        "road",
        "speed",
        "tyre pressure",
        ...(hasAngles ? ["strut angle"] : []),
        "recording",
      ],
      overview.trials.map((trial) => [
        String(trial.number),
        tr(String(trial.use ?? "hold-out")),
        String(trial.road ?? tr("measured support")),
        inField(String(trial.speed ?? "–")),
        inField(String(trial.tyre_pressure ?? "–")),
        ...(hasAngles ? [inField(String(trial.strut_angle ?? "–"))] : []),
        trial.file
          ? link(String(trial.file), "recording", trial as Partial<Bench>)
          : make("span", { class: "mark bad" }, `${String(trial.recording)} is missing`),
      ]),
    ),
    pasteTrials(path, (answer) => {
      written_ = answer;
      goTo(place, "campaign", { file: path, pasted: String(Date.now()) });
    }),
    make("h2", {}, "Updates"),
    overview.updates.length
      ? table(
          "updates",
          ["name", "free", "trials", "method"],
          overview.updates.map((update) => [
            String(update.name),
            Object.entries(update.free as Record<string, unknown>)
              .map(
                ([name, bounds]) =>
                  `${name}: ${[bounds]
                    .flat()
                    .map((bound) => inField(String(bound)))
                    .join(" … ")}`,
              )
              .join(", "),
            [update.trials ?? "fit"]
              .flat()
              .map((trial) => tr(String(trial)))
              .join(", "),
            String(update.method ?? "least-squares"),
          ]),
        )
      : make(
          "p",
          { class: "empty" },
          "Nothing is updated: the campaign compares the characterised model with the trials.",
        ),
    own.element,
    make("h2", {}, "Measurements"),
    make("div", { class: "form" }, field("Target folder", where)),
    dropZone(
      () => where.value,
      "Drop measured files here, or choose them (up to 250 MB each).",
      () => {
        const before = reader.firstChild;
        return (paths) => {
          come.append(...paths.map((path) => link(path, "recording")));
          come.hidden = false;
          if (reader.firstChild === before) open(paths[0]!, "recording"); // else another file was opened meanwhile, and is being entered
        };
      },
      (files) =>
        bring(
          files.map((file) => ({ path: file.name, file })),
          path,
        ),
    ),
    come,
    reader,
  );
  if (read) open(read, "recording");
}

/** The text of a file where it is another than the saved one, which may be changed by all that is entered elsewhere. */
interface Edited {
  text: string | null;
}

/** The text of a campaign, for all that has no form: to take trials out, turn a sensor, free other parameters. Whatever it says can be written, and taken back. */
function textOf(
  path: string,
  file: api.Text,
  place: HTMLElement,
): {
  element: HTMLDetailsElement;
  state: () => Edited;
  restore: (was: Edited) => void;
  isTyped: () => boolean;
  used: () => void;
} {
  const area = make("textarea", {
      spellcheck: "false",
      "aria-label": tr("text of #", path),
      rows: "24",
    }),
    save = make("button", { type: "button", disabled: true }, "Save"),
    away = make("button", { type: "button", disabled: true }, "Discard"),
    status = make("div", { "aria-live": "polite" });
  area.value = file.text;
  let before = area.value;
  const isTyped = () => area.value !== before,
    offer = () => {
      save.disabled = away.disabled = !isTyped();
    };
  area.addEventListener("input", offer);
  const element = make(
    "details",
    {},
    make("summary", {}, "Campaign file"),
    make(
      "p",
      { class: "muted" },
      "Exclude trials, turn a sensor around (orientation = -1) or free other parameters: what you save takes effect at once and can be undone.",
    ),
    area,
    make("div", { class: "bar" }, save, away),
    status,
  );
  const own = {
    element,
    isTyped,
    state: (): Edited => ({ text: isTyped() ? area.value : null }),
    used: () => {},
    restore: ({ text }: Edited) => {
      if (typeof text === "string") {
        area.value = text;
        element.open = true;
        offer();
      }
    },
  };
  away.addEventListener("click", () => {
    area.value = before;
    offer();
    status.replaceChildren();
  });
  save.addEventListener("click", () => {
    const now = area.value;
    once(save, api.save(path, now, file.digest)).then(
      ({ digest }) => {
        written_ = { path, before: file.text, digest, said: "Saved." };
        if (area.value === now) {
          before = now;
          own.used();
        }
        goTo(place, "campaign", { file: path, saved: String(Date.now()) });
      },
      (error) => status.replaceChildren(problem(error)),
    );
  });
  return own;
}

/** A value and its interval, as cells. */
function estimated(
  value: number,
  interval: [number, number] | null | undefined,
  factor: number,
  digits = 4,
): [string, string] {
  return interval
    ? withInterval(value * factor, [interval[0] * factor, interval[1] * factor], digits)
    : [written(value * factor, digits), "–"];
}

type Link = (
  file: string,
  form: "recording" | "force-deflection",
  given?: Partial<Bench>,
) => HTMLElement;

/** One measured part: its files and its fit. */
function part(
  bench: Bench,
  whole_: Overview,
  link: Link,
): {
  name: string;
  element: HTMLElement;
  controls: Record<string, HTMLInputElement | HTMLSelectElement>;
} {
  const decays = bench.name === "decay",
    form = decays ? "recording" : "force-deflection";
  const discard = textBox(bench.discard_below ?? ""),
    law = select(["linear", "polynomial", "power", "monotone-spline"], bench.law);
  const intercept = select(["drop", "shift", "keep"], bench.intercept);
  const mass = textBox(whole_.mass),
    from = textBox(bench.from ?? ""),
    to = textBox(bench.to ?? "");
  const common = {
    files: bench.found,
    columns: bench.columns ?? {},
    variable: bench.variable ?? "",
    stroke_positive: bench.stroke_positive ?? "",
  };
  const question = new Question(
    decays ? "Separate damping and friction" : "Fit the stiffness",
    () =>
      decays
        ? {
            kind: "decay",
            ...common,
            channel: bench.channel ?? "sprung.z",
            mass: mass.value,
            begin: from.value,
            end: to.value,
            sample_time: bench.sample_time ?? "",
          }
        : {
            kind: "stiffness",
            ...common,
            force_positive: bench.force_positive ?? "",
            law: law.value,
            discard_below: discard.value,
            intercept: intercept.value,
            branch: bench.branch ?? "loading",
          },
    (reply) => [
      estimates(reply.result as Record<string, unknown>, decays ? "decay" : "stiffness"),
      report(reply.report, decays ? "Free decay with dry friction" : "Fit, with the ignored zone"),
      snippets(reply),
    ],
  );
  const element = make(
    "section",
    { class: "job" },
    make("h3", {}, withComma(heard(tr(bench.name)))),
    bench.found.length
      ? make(
          "p",
          { class: "bar" },
          "measured: ",
          ...bench.found.map((file) => link(file, form, bench)),
        )
      : make("p", { class: "problem" }, `no file found for ${bench.files.join(", ")}`),
    make(
      "div",
      { class: "form" },
      ...(decays
        ? [field("Oscillating mass", mass), field("From", from), field("To", to)]
        : [
            field("Law", law),
            field("Ignore deflections below", discard),
            field("Force at zero", intercept),
          ]),
      question.button,
    ),
    question.place,
  );
  return {
    name: bench.name,
    element,
    controls: decays ? { mass, from, to } : { law, discard, intercept },
  };
}

/** Estimates with 95 % intervals, and findings. */
function estimates(record: Record<string, unknown>, kind: keyof typeof ESTIMATES): HTMLElement {
  const rows = Object.entries(record).flatMap(([name, value]) => {
    const estimate = value as { value?: number; interval?: [number, number] } | null;
    const [words, unit, factor] = ESTIMATES[kind][name] ?? [];
    return words &&
      unit &&
      factor &&
      estimate &&
      typeof estimate === "object" &&
      typeof estimate.value === "number"
      ? [[tr(words), ...estimated(estimate.value, estimate.interval, factor), unit]]
      : [];
  });
  const findings = (record.findings ?? []) as { severity: string; message: string }[];
  return make(
    "div",
    {},
    table("estimates", ["quantity", "value", "95 % interval", "unit"], rows, [1, 2]),
    ...advised(findings, "p"),
  );
}

/** What was entered of a measured file. */
interface Typed {
  file: string;
  form: "recording" | "force-deflection";
  fields: Fields;
  controls: Record<string, string>;
}
interface Opened {
  element: HTMLElement;
  state: () => Typed | null;
  restore: (was: Typed) => void;
}

/** A measured file: how it is read, and how it goes into the campaign, which is not run meanwhile. */
function entry(
  path: string,
  file: string,
  form: "recording" | "force-deflection",
  given: Partial<Bench>,
  whole_: Overview,
  run: HTMLButtonElement,
  used: (was: Typed) => void,
): Opened {
  const place = make("div", {}),
    status = make("div", { "aria-live": "polite" });
  const like = whole_.trials
    .filter(
      (trial) => trial.file && Object.keys((trial.columns as object | undefined) ?? {}).length,
    )
    .reverse()
    .map((trial) => ({ file: String(trial.file), fields: trial as Partial<Fields> }));
  let reading = new Reading(file, form, given as object, form === "recording" ? like : []);
  const kinds: Record<string, string> = {
    trial: "trial",
    decay: "free decay",
    spring: "spring",
    tyre: "tyre at a pressure",
  };
  const use = select(
    Object.keys(kinds),
    form === "force-deflection" ? "spring" : "trial",
    (kind) => kinds[kind]!,
  );
  const speed = textBox("2 m/s"),
    pressure = textBox("", "0.31 MPa"),
    road = make(
      "select",
      {},
      ...whole_.roads.map((road) => make("option", { value: road }, road)),
      make("option", { value: "" }, "none: the support is measured"),
    );
  const support = textBox("", "file with road.z"),
    datum = make(
      "select",
      {},
      make("option", { value: "undeformed" }, "undeformed springs and tyre"),
      make("option", { value: "rest" }, "the wheel at rest on the support"),
    );
  const goes = make(
    "select",
    {},
    make("option", { value: "hold-out" }, "hold-out: validation only"),
    make("option", { value: "fit" }, "used for the fit"),
  );
  const replace = make("input", { type: "checkbox" }),
    discard = textBox("", "2 mm"),
    fields = make("span", { class: "sizes" });
  const offer = () => {
    const wanted =
      use.value === "spring" || use.value === "tyre" ? "force-deflection" : "recording";
    if (wanted !== reading.form) {
      reading = new Reading(file, wanted, reading.fields);
      place.replaceChildren(reading.element);
      void reading.ask();
    }
    fields.replaceChildren(
      ...(use.value === "trial"
        ? [
            field("Road", road),
            ...(road.value
              ? [field("Speed", speed)]
              : [field("Support motion file", support), field("Height measured from", datum)]),
            field("Tyre pressure", pressure),
            field("Use", goes),
          ]
        : use.value === "decay"
          ? [field("Replace the example files", replace)]
          : [
              field("Replace the example files", replace),
              ...(use.value === "tyre" ? [field("Pressure", pressure)] : []),
              field("Ignore deflections below", discard),
            ]),
    );
  };
  use.addEventListener("change", offer);
  road.addEventListener("change", offer);
  const go = make("button", { type: "button", class: "main" }, "Add to the campaign");
  go.addEventListener("click", () => {
    const { columns, variable, sample_time, stroke_positive, force_positive } = reading.fields;
    const how = {
      columns,
      variable,
      stroke_positive,
      ...(use.value === "decay" ? {} : { force_positive }),
      ...(reading.form === "recording" ? { sample_time } : {}),
    };
    const what =
      use.value === "trial"
        ? {
            recording: file,
            ...(road.value
              ? { road: road.value, speed: speed.value }
              : { excitation: { file: support.value, datum: datum.value } }),
            tyre_pressure: pressure.value,
            use: goes.value,
            ...how,
          }
        : {
            files: [file],
            replace: replace.checked,
            ...(use.value === "tyre" ? { pressure: pressure.value } : {}),
            ...(use.value === "decay" ? {} : { discard_below: discard.value }),
            ...how,
          };
    const was = typed();
    once(
      run,
      once(
        go,
        api.asked("POST", "/api/campaign", { campaign: path, use: use.value, fields: what }),
      ),
    ).then(
      async (answer) => {
        written_ = (await answer.json()) as Written;
        used(was);
        goTo(status, "campaign", { file: path, entered: String(Date.now()) });
      },
      (error) => status.replaceChildren(problem(error)),
    );
  });
  place.append(reading.element);
  offer();
  void reading.ask();
  const controls = { use, road, speed, pressure, support, datum, goes, replace, discard };
  const typed = (): Typed => ({
    file,
    form: reading.form,
    fields: reading.fields,
    controls: entered(controls),
  });
  const element = make(
    "section",
    { class: "job" },
    make("h3", {}, file),
    place,
    make("div", { class: "form" }, field("Type of measurement", use), fields, go),
    status,
  );
  let first = JSON.stringify(typed());
  return {
    element,
    state: () => {
      const now = typed();
      return JSON.stringify(now) === first ? null : now;
    },
    restore: (was) => {
      first = "";
      enter(controls, was.controls);
    },
  };
}

interface Results {
  findings: Finding[];
}

async function showRun(place: HTMLElement, id: string): Promise<void> {
  const first = await whole<Results>(id),
    units = await unitsOf(String(first.asked.campaign)),
    results = make("div", {}),
    live = make("div", {});
  const card = new JobCard(first);
  place.replaceChildren(
    make("h1", {}, first.title),
    make(
      "p",
      { class: "muted" },
      make("a", { href: address("campaign") }, "All campaigns"),
      " · ",
      make(
        "a",
        { href: address("campaign", { file: String(first.asked.campaign) }) },
        String(first.asked.campaign),
      ),
    ),
    card.element,
    live,
    results,
  );
  await accompany(
    place,
    first,
    (job) => {
      card.show(job);
      const runs = card.job.state === "running" && card.job.steps?.length;
      live.replaceChildren(...(runs ? [search(card.job.steps, units)] : []));
    },
    (end) => {
      if (!end.result) return;
      const shown = make("div", {}, make("p", { class: "state" }, "loading …"));
      results.replaceChildren(updated(end.out), shown);
      if (!end.has_page) {
        shown.replaceChildren(make("p", { class: "problem" }, "The report was not written."));
        shown.append(...failures(end.result));
        return;
      }
      reported(end.report, end.result.findings).then(
        (page) => shown.replaceChildren(page, inNewTab(end.report)),
        (error) => shown.replaceChildren(problem(error)),
      );
    },
  );
}

/** The report as its own document, to print or to pass on. */
const inNewTab = (address: string): HTMLElement =>
  make(
    "p",
    {},
    make("a", { href: address, target: "_blank", rel: "noopener" }, "The report as a document"),
  );

/** A running search: its objective over the steps, and each parameter between its bounds. */
function search(steps: Step[], units: Units): HTMLElement {
  const last = steps[steps.length - 1]!,
    logs = steps.map((step) => Math.log10(Math.max(step.objective, 1e-300)));
  const low = Math.min(...logs),
    high = Math.max(...logs, low + 1e-9),
    [width, height, edge] = [460, 150, 8];
  const place = (value: number, k: number): [number, number] => [
    edge + ((width - 2 * edge) * k) / Math.max(1, logs.length - 1),
    edge + ((height - 2 * edge) * (high - value)) / (high - low),
  ];
  const picture = svg("svg", {
    viewBox: `0 0 ${width} ${height}`,
    class: "xy",
    role: "img",
    "aria-label": `objective from ${written(steps[0]!.objective, 4)} to ${written(last.objective, 4)} in ${steps.length} evaluations`,
  });
  picture.append(svg("path", { class: "search", d: line(logs.map(place)) }));
  const figure = make("figure", {});
  figure.append(
    picture,
    make(
      "figcaption",
      { class: "muted" },
      `objective (logarithmic scale): ${written(steps[0]!.objective, 4)} initially, ${written(last.objective, 4)} after ${last.evaluation} evaluations`,
    ),
  );
  const rows = Object.entries(last.parameters).map(([path, one]) => {
    const share = (one.value - one.lower) / (one.upper - one.lower || 1);
    const { unit, factor } = units(path);
    return [
      path,
      unit,
      written(one.lower * factor),
      make("meter", {
        min: "0",
        max: "1",
        value: String(Math.min(1, Math.max(0, share))),
        "aria-label": `${path} between its bounds`,
      }),
      written(one.upper * factor),
      written(one.initial * factor),
      written(one.value * factor, 5),
      share < 0.001 || share > 0.999 ? make("span", { class: "mark fair" }, "at its bound") : "",
    ];
  });
  return make(
    "section",
    { class: "job" },
    make("h3", {}, "Search in progress"),
    figure,
    table(
      "parameters",
      ["parameter", "unit", "lower bound", "", "upper bound", "initial", "now", ""],
      rows,
      [2, 4, 5, 6],
    ),
  );
}

/** Links to the rigs that a campaign wrote. */
function updated(folder: string): HTMLElement {
  const section = make("section", { hidden: true }),
    list = make("ul", {});
  section.append(make("h2", {}, "Updated rigs"), list);
  void api.project().then(
    ({ entries }) => {
      const rigs = entries.filter(
        (entry) => entry.kind === "rig" && entry.path.startsWith(`${folder}/`),
      );
      list.append(
        ...rigs.map(({ path }) =>
          make(
            "li",
            {},
            make("a", { href: address("rig", { name: path }) }, path),
            " · ",
            make(
              "a",
              { href: address("trial", { rig: path }), "aria-label": `${tr("drive")}: ${path}` },
              tr("drive"),
            ),
          ),
        ),
      );
      section.hidden = !rigs.length;
    },
    () => {},
  ); // the results stand all the same
  return section;
}

type Units = (path: string) => { unit: string; factor: number };
/** Display units of the parameters of a campaign's rig; SI if the rig is not available. */
async function unitsOf(path: string): Promise<Units> {
  const known = new Map<string, { unit: string; factor: number }>();
  try {
    const { rig } = await api.get<Overview>(`/api/campaign?${api.query({ path })}`),
      folder = path.includes("/") ? `${path.slice(0, path.lastIndexOf("/"))}/` : "";
    for (const parameter of (await api.rig(rig.endsWith(".toml") ? folder + rig : rig)).numbers)
      known.set(parameter.path, { unit: parameter.unit || "–", factor: parameter.factor });
  } catch {
    /* the campaign was moved since */
  }
  return (number) => known.get(number) ?? { unit: "SI", factor: 1 };
}
