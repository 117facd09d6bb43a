/** Studies: write what varies and how, run the sweep as a job, and show its results. */

import { make, written } from "../../page";
import { heard, tr } from "../../words";
import * as api from "../api";
import { Drafts, enter, entered } from "../drafts";
import { begin, follow, JobCard, jobList, report, type Whole, whole } from "../jobs";
import { numberBox } from "../numberbox";
import { OBSTACLES, USUAL } from "../obstacles";
import { field, once, problem, select, snippets, textBox } from "../parts";
import { advised, asSaid } from "../refusals";
import { address, type Values, VEHICLES } from "../shell";
import { row, table } from "../table";
import {
  Brushes,
  type Column,
  type Influence,
  matrix,
  parallel,
  ranges,
  tornado,
} from "../variants";

interface Sweep {
  count: number;
  finished: number;
  columns: Column[];
  variants: number[];
  summary: {
    ran: number;
    metrics: {
      name: string;
      unit: string;
      mean: number;
      standard_deviation: number;
      least: number;
      greatest: number;
      percentiles: Record<string, { value: number }>;
    }[];
    influences: Influence[];
    failed: Record<string, { variants: number; first: number }>;
    findings: { severity: string; message: string }[];
  } | null;
  run: {
    rig: string;
    road: string | Record<string, unknown>;
    speed: string;
    duration: string;
  } | null;
}

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const job = values.get("job"),
    folder = values.get("folder");
  if (job || folder) {
    await showSweep(place, job, folder);
    return;
  }
  const { entries } = await api.project();
  const rigs = [
    ...entries.filter((entry) => VEHICLES.includes(entry.kind)).map((entry) => entry.path),
    ...(await api.library()).map((shippedRig) => shippedRig.name),
  ];
  const matchingEntries = entries.filter((entry) => entry.kind === "sweep");
  const starters = new Map(matchingEntries.map((entry) => [entry.path, starter(entry.path)]));
  place.replaceChildren(
    make("h1", {}, "Studies"),
    make("p", { class: "muted" }, "Vary parameters and see what drives each metric."),
    make("h2", {}, "Sweeps"),
    jobList(
      ["sweep"],
      (job) => {
        location.hash = address("studies", { job: job.id });
      },
      "No sweeps yet. Write a study below, or start one of this project.",
    ),
    ...(matchingEntries.length
      ? [
          make("h2", {}, "Studies in this project"),
          make(
            "ul",
            {},
            ...[...starters].map(([path, button]) => make("li", {}, path, " ", button)),
          ),
        ]
      : []),
    make("h2", {}, "A new study"),
    await writer(rigs, values.get("rig") ?? ""),
  );
  starters
    .get(values.get("study") ?? "")
    ?.querySelector("button")
    ?.focus();
}

/** A button that starts the sweep of a study of this project. */
function starter(path: string): HTMLElement {
  const out = path.replace(/\.toml$/, "-swept"),
    status = make("span", {});
  const button = make("button", { type: "button", "aria-label": `Start ${path}` }, "Start");
  button.addEventListener("click", () => {
    once(button, begin({ kind: "sweep", study: path, out, resume: true })).then(
      () => status.replaceChildren(),
      (error) => status.replaceChildren(problem(error)),
    );
  });
  return make(
    "span",
    {},
    button,
    " ",
    make("small", { class: "muted" }, tr("into #", out)),
    status,
  );
}

const DESIGNS: Record<string, [string, boolean]> = {
  sobol: ["Sobol: even coverage of all parameters", true],
  "latin-hypercube": ["Latin hypercube", true],
  "monte-carlo": ["Monte Carlo: random", true],
  grid: ["Grid: every combination", false],
  list: ["List: one value of each parameter per variant", false],
  morris: ["Morris: screening by trajectories", true],
  saltelli: ["Saltelli: variance-based indices", true],
};
const SPREADS: Record<string, [string, string[]]> = {
  share: ["± share", ["20 %"]],
  range: ["range", ["from", "to"]],
  normal: ["normal", ["mean", "sd"]],
  triangular: ["triangular", ["low", "mode", "high"]],
  values: ["values", ["value, value, ..."]],
};
async function writer(rigs: string[], chosen: string): Promise<HTMLElement> {
  if (!rigs.length) return make("p", { class: "empty" }, "No rig in this project yet.");
  const rig = select(rigs, chosen);
  const rows = make("tbody", {}),
    paths = make("datalist", { id: "paths-of-the-rig" });
  const design = select(Object.keys(DESIGNS), "sobol", (kind) => DESIGNS[kind]![0]);
  const count = numberBox({ min: "1", value: "256" }),
    seed = numberBox({ min: "0", value: "0" });
  const metrics = make("input", {
    type: "text",
    size: "34",
    value: "rms sprung.az, max strut.deflection",
  });
  const road = select([...Object.keys(OBSTACLES), "iso"], undefined, (text) =>
    text === "iso" ? "random road (ISO 8608)" : tr(text.replace("-", " ")),
  );
  const sizes = make("span", { class: "sizes" });
  const speed = textBox("2 m/s"),
    duration = textBox("1.5 s");
  const name = textBox("study.toml"),
    out = textBox("swept");
  const status = make("div", { "aria-live": "polite" });
  name.addEventListener("change", () => {
    out.value = `${name.value.replace(/\.toml$/, "")}-swept`;
  });
  let numbers: api.RigNumber[] = [],
    isLoaded = false,
    isWriting = false;

  const add = (path = "", spread = "share") => {
    const which = make("input", {
      type: "text",
      value: path,
      list: "paths-of-the-rig",
      "aria-label": "parameter to vary",
      size: "30",
      spellcheck: "false",
    });
    const kind = make(
      "select",
      { "aria-label": "distribution" },
      ...Object.entries(SPREADS).map(([key, [words]]) =>
        make("option", key === spread ? { value: key, selected: true } : { value: key }, tr(words)),
      ),
    );
    const fields = make("span", { class: "sizes" }),
      now = make("td", { class: "muted" });
    const offer = () => {
      const own = numbers.find((parameter) => parameter.path === which.value);
      now.textContent = own
        ? tr("now #", `${written(own.value * own.factor)} ${own.unit}`)
        : which.value
          ? tr("not a parameter of this rig")
          : "";
      const unit = own?.unit ?? "",
        value = own ? own.value * own.factor : 1;
      const usual: Record<string, number> = {
        from: 0.8,
        to: 1.2,
        low: 0.8,
        mode: 1,
        high: 1.2,
        mean: 1,
        sd: 0.05,
      };
      fields.replaceChildren(
        ...SPREADS[kind.value]![1].map((word) => {
          const text =
            kind.value === "share"
              ? "20 %"
              : word in usual
                ? `${Number((usual[word]! * value).toPrecision(4))} ${unit}`.trim()
                : `${Number((0.9 * value).toPrecision(4))} ${unit}, ${Number((1.1 * value).toPrecision(4))} ${unit}`;
          return make("input", {
            type: "text",
            value: text,
            "aria-label": `${which.value || "parameter"}, ${word in usual ? word : kind.value}`,
            "data-word": word,
            size: kind.value === "values" ? "26" : "11",
          });
        }),
      );
    };
    which.addEventListener("change", offer);
    kind.addEventListener("change", offer);
    const away = make(
      "button",
      { type: "button", "aria-label": tr("remove #", path || tr("this parameter")) },
      "×",
    );
    const row = make(
      "tr",
      {},
      make("td", {}, which),
      make("td", {}, kind),
      make("td", {}, fields),
      now,
      make("td", {}, away),
    );
    away.addEventListener("click", () => row.remove());
    offer();
    rows.append(row);
  };
  const classes = select([..."ABCDEFGH"], "C");
  classes.name = "class";
  const offerRoad = () =>
    sizes.replaceChildren(
      ...(road.value === "iso"
        ? [field("Class", classes)]
        : OBSTACLES[road.value]!.map((text) =>
            field(
              text[0]!.toUpperCase() + text.slice(1),
              make("input", { type: "text", value: USUAL[text]!, name: text }),
            ),
          )),
    );
  road.addEventListener("change", offerRoad);
  const save = make("button", { type: "button" }, "Save the study"),
    go = make("button", { type: "submit", class: "main" }, "Save and start"),
    more = make("button", { type: "button" }, "Add a parameter");
  const buttons = () => {
    more.disabled = !isLoaded;
    save.disabled = go.disabled = !isLoaded || isWriting;
  };
  const load = async () => {
    const name = rig.value;
    status.replaceChildren();
    rows.replaceChildren(); // the numbers of another rig are none to be edited
    isLoaded = false;
    buttons();
    try {
      const loaded = await api.rig(name);
      if (rig.value !== name) return; // another one was chosen meanwhile
      numbers = loaded.numbers;
      const varied = numbers.filter((parameter) => !parameter.is_constant);
      paths.replaceChildren(...varied.map((number) => make("option", { value: number.path })));
      const usual = ["strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness"].filter(
        (path) => numbers.some((parameter) => parameter.path === path),
      );
      for (const path of usual.length
        ? usual
        : varied
            .filter((number) => number.is_chosen)
            .slice(0, 4)
            .map((number) => number.path))
        add(path);
      isLoaded = true;
      buttons();
    } catch (error) {
      if (rig.value === name) status.replaceChildren(problem(error));
    }
  };
  let loading = Promise.resolve();
  rig.addEventListener("change", () => {
    loading = load();
  });
  design.addEventListener("change", () => {
    count.disabled = !DESIGNS[design.value]![1];
  });
  const spread = (row: HTMLTableRowElement): unknown => {
    const kind = row.querySelector("select")!.value;
    const given = Object.fromEntries(
      [...row.querySelectorAll<HTMLInputElement>("input[data-word]")].map((element) => [
        element.dataset.word!,
        element.value.trim(),
      ]),
    );
    const texts = Object.values(given);
    if (kind === "share") return texts[0];
    if (kind === "range") return texts;
    if (kind === "values")
      return texts[0]!
        .split(",")
        .map((part) => part.trim())
        .filter(Boolean);
    return given;
  };
  let digest = "",
    written_ = "";
  const make_ = async () => {
    const was = state(),
      path = name.value,
      sizesOf = Object.fromEntries(
        [...sizes.querySelectorAll<HTMLInputElement | HTMLSelectElement>("[name]")].map(
          (element) => [element.name, element.value],
        ),
      );
    const made = (await (
      await api.asked("POST", "/api/study", {
        path,
        was: written_ === path ? digest : "",
        rig: rig.value,
        trial: {
          speed: speed.value,
          duration: duration.value,
          road:
            road.value === "iso"
              ? `iso:${sizesOf.class}`
              : { kind: road.value, start: "0.2 m", ...sizesOf },
        },
        design: {
          kind: design.value,
          ...(DESIGNS[design.value]![1]
            ? { count: Number(count.value), seed: Number(seed.value) }
            : {}),
        },
        vary: Object.fromEntries(
          [...rows.rows].map((row) => [row.querySelector("input")!.value.trim(), spread(row)]),
        ),
        metrics: metrics.value
          .split(",")
          .map((part) => part.trim())
          .filter(Boolean),
      })
    ).json()) as { digest: string; count: number; path: string };
    digest = made.digest;
    written_ = path;
    drafts.done(was);
    return made;
  };
  const form = make("form", {});
  /** Writes one study at a time: a second request would overwrite an unknown state. */
  const write = (then: (made: { count: number; path: string }) => Promise<(Node | string)[]>) => {
    isWriting = true;
    buttons();
    void make_()
      .then(then)
      .catch((error) => [problem(error)])
      .then((said) => {
        isWriting = false;
        buttons();
        status.replaceChildren(...said);
      });
  };
  save.addEventListener("click", () =>
    write(async (made) => [make("p", { class: "good" }, `${made.path}: ${made.count} variants.`)]),
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const into = out.value;
    write(async (made) => {
      const job = await begin({ kind: "sweep", study: made.path, out: into });
      return [make("p", { class: "good" }, `${made.count} variants started.`), snippets(job)];
    });
  });
  more.addEventListener("click", () => add());
  form.append(
    make(
      "div",
      { class: "form" },
      field("Rig", rig),
      field("Road", road),
      sizes,
      field("Speed", speed),
      field("Duration", duration),
    ),
    table("varied parameters", ["parameter", "distribution", "", "", ""], rows),
    paths,
    more,
    make(
      "div",
      { class: "form" },
      field("Design", design),
      field("Count", count),
      field("Seed", seed),
      field("Metrics, separated by commas", metrics),
    ),
    make(
      "div",
      { class: "form" },
      field("Study file", name),
      field("Results folder", out),
      save,
      go,
    ),
    status,
  );
  offerRoad();
  await load();
  const controls = { rig, road, speed, duration, design, count, seed, metrics, name, out };
  const sized = () =>
    Object.fromEntries(
      [...sizes.querySelectorAll<HTMLInputElement | HTMLSelectElement>("[name]")].map((element) => [
        element.name,
        element,
      ]),
    );
  const state = () => ({
    form: entered(controls),
    sizes: entered(sized()),
    rows: [...rows.rows].map((row) => [
      row.querySelector("input")!.value,
      row.querySelector("select")!.value,
      ...[...row.querySelectorAll<HTMLInputElement>("input[data-word]")].map(
        (element) => element.value,
      ),
    ]),
  });
  const drafts = new Drafts(await api.folder(), address("studies"), state(), state, async (was) => {
    enter({ rig }, was.form); // its numbers come first
    await loading;
    enter(controls, { ...was.form, rig: rig.value });
    await loading;
    enter(sized(), was.sizes);
    rows.replaceChildren();
    for (const [path, spread, ...texts] of was.rows) {
      add(path, spread);
      rows
        .lastElementChild!.querySelectorAll<HTMLInputElement>("input[data-word]")
        .forEach((element, k) => {
          element.value = texts[k] ?? element.value;
        });
    }
  });
  drafts.hear(form);
  form.prepend(drafts.element);
  return form;
}

async function showSweep(
  place: HTMLElement,
  id: string | null,
  given: string | null,
): Promise<void> {
  const job = id ? await whole(id) : null;
  if (!place.isConnected) return;
  const folder = given ?? String(job?.asked.out ?? "");
  if (job && (job.state === "running" || job.state === "cancelling")) {
    showRunning(place, job, folder);
    return;
  }
  const sweep = await api.get<Sweep>(`/api/sweep?${api.query({ folder })}`);
  const title = job?.title ?? `Sweep in ${folder}`;
  const back = make("p", {}, make("a", { href: address("studies") }, "All studies"));
  if (!sweep.columns.length) {
    place.replaceChildren(
      make("h1", {}, title),
      back,
      make("p", { class: "empty" }, "No variant has finished yet."),
    );
    return;
  }
  const brushes = new Brushes(sweep.columns),
    rows = sweep.variants.length,
    { summary } = sweep;
  const status = make("p", { class: "state", role: "status" }),
    chosen = make("tbody", {});
  const clear = make("button", { type: "button" }, "All variants");
  clear.addEventListener("click", () => brushes.clear());
  const select = () => {
    const selectedRows = brushes.chosen.flatMap((isChosen, row) => (isChosen ? [row] : []));
    status.textContent =
      heard(`${selectedRows.length} of ${rows} variants`) +
      (rows < sweep.finished ? heard(` shown, of ${sweep.finished}`) : "") +
      (brushes.picked >= 0 ? heard(`; variant ${sweep.variants[brushes.picked]} is marked`) : "");
    const first = [
      ...(brushes.picked >= 0 ? [brushes.picked] : []),
      ...selectedRows.filter((row) => row !== brushes.picked),
    ].slice(0, 20);
    chosen.replaceChildren(
      ...first.map((variant) => {
        const mark = make(
          "button",
          {
            type: "button",
            "aria-label": `mark variant ${sweep.variants[variant]}`,
            "aria-pressed": String(variant === brushes.picked),
          },
          String(sweep.variants[variant]),
        );
        mark.addEventListener("click", () =>
          brushes.pick(variant === brushes.picked ? -1 : variant),
        );
        const link = {
          href: sweep.run ? opened(sweep, variant) : "",
          "aria-label": `open variant ${sweep.variants[variant]} as a trial`,
        };
        return row(
          [
            mark,
            ...sweep.columns.map((column) => written(column.values[variant])),
            sweep.run ? make("a", link, "open as a trial") : "",
          ],
          sweep.columns.map((_, k) => k + 1),
        );
      }),
    );
  };
  brushes.listen(select);
  select();
  const metrics = sweep.columns.filter((column) => !column.is_number);
  place.replaceChildren(
    make("h1", {}, title),
    back,
    make(
      "p",
      { class: "muted" },
      `${sweep.finished} of ${sweep.count} variants finished`,
      summary && summary.ran < sweep.finished ? `; ${sweep.finished - summary.ran} not run` : "",
      ".",
    ),
    ...Object.entries(summary?.failed ?? {}).map(([reason, lost]) =>
      make(
        "p",
        { class: "problem" },
        `${lost.variants} not run (first: variant ${lost.first}): `,
        asSaid(reason),
      ),
    ),
    ...advised(summary?.findings ?? [], "p"),
    ...(summary?.metrics.length ? [make("h2", {}, "Metrics"), statistics(summary, metrics)] : []),
    ...(summary?.influences.length
      ? [
          make("h2", {}, "Sensitivity of the metrics"),
          ...metrics.flatMap((metric) => {
            const own = summary.metrics.find((two) => two.name === metric.name);
            return own ? [tornado(summary.influences, metric, own.mean)] : [];
          }),
        ]
      : []),
    make("h2", {}, "Variants"),
    make(
      "p",
      { class: "muted" },
      "Drag along an axis to filter the variants; click the axis to clear the filter.",
    ),
    parallel(brushes),
    make("div", { class: "bar" }, status, clear),
    ranges(brushes),
    ...(metrics.length ? [matrix(brushes)] : []),
    table(
      "selected variants",
      ["variant", ...sweep.columns.map((column) => `${column.name} [${column.unit || "–"}]`), ""],
      chosen,
      sweep.columns.map((_, k) => k + 1),
      "First selected variants",
    ),
    ...(job ? [snippets(job)] : []),
    ...(job?.has_page ? [report(job.report, "Report")] : []),
  );
}

/** A running sweep: its progress and a link to the results so far; the final results follow. */
function showRunning(place: HTMLElement, job: Whole, folder: string): void {
  const card = new JobCard(job);
  place.replaceChildren(
    make("h1", {}, job.title),
    make("p", {}, make("a", { href: address("studies") }, "All studies")),
    card.element,
    make("p", {}, make("a", { href: address("studies", { folder }) }, "Results so far")),
  );
  let shown = false;
  follow(card.element, (jobs) => {
    const now = jobs.find((candidate) => candidate.id === job.id);
    if (!now || shown) return;
    card.show(now);
    if (now.state === "running" || now.state === "cancelling") return;
    shown = true;
    showSweep(place, job.id, null).catch((error) =>
      place.replaceChildren(make("h1", {}, job.title), card.element, problem(error)),
    );
  });
}

type Summary = NonNullable<Sweep["summary"]>;
function statistics(summary: Summary, metrics: Column[]): HTMLElement {
  const levels = Object.keys(summary.metrics[0]!.percentiles).map((key) => `${key} %`),
    numbers = ["mean", "standard deviation", "minimum", ...levels, "maximum"];
  return table(
    "metrics",
    ["metric", "unit", ...numbers],
    summary.metrics.map((metric) => {
      const { factor = 1, unit = "" } = metrics.find(({ name }) => name === metric.name) ?? {};
      const percentiles = Object.values(metric.percentiles).map((level) => level.value);
      const values = [
        metric.mean,
        metric.standard_deviation,
        metric.least,
        ...percentiles,
        metric.greatest,
      ];
      return [metric.name, unit || "–", ...values.map((value) => written(value * factor))];
    }),
    numbers.map((_, k) => k + 2),
  );
}

/** Address of a variant as a trial, with its parameters and the road of the study. */
function opened(sweep: Sweep, row: number): string {
  const run = sweep.run!,
    changes: Record<string, number> = {};
  let { speed, duration } = run;
  for (const column of sweep.columns) {
    const value = column.values[row];
    if (!column.is_number || value === null || value === undefined) continue;
    if (column.name === "trial.speed") speed = `${value / column.factor} m/s`;
    else if (column.name === "trial.duration") duration = `${value / column.factor} s`;
    else if (!column.name.startsWith("trial.") && !column.name.startsWith("control."))
      changes[column.name] = value / column.factor;
  }
  if (typeof run.road === "string")
    return address("ride", {
      vehicle: run.rig,
      road: run.road,
      speed,
      duration,
      set: JSON.stringify(changes),
    });
  return address("trial", {
    rig: run.rig,
    road: JSON.stringify(run.road),
    speed,
    duration,
    set: JSON.stringify(changes),
  });
}
