/** Shock-absorber inspection: evaluate and grade records, search the store, and show the history of a vehicle. */

import { make, written } from "../../page";
import { isGerman, localised, tr } from "../../words";
import type { Trend } from "../answers";
import * as api from "../api";
import { Drafts, enter, entered } from "../drafts";
import { dropZone, Question, type Reply, report } from "../jobs";
import { field, optional, select, snippets, textBox } from "../parts";
import { WHEEL_QUANTITIES } from "../quantities";
import { Reading } from "../reading";
import { advised, asSaid, inLanguage } from "../refusals";
import { saveDocument } from "../saving";
import { address, type Values, VEHICLES } from "../shell";
import { table } from "../table";

type Used = Record<string, string>;
type Controls = Record<string, HTMLInputElement | HTMLSelectElement>;
export interface Choices {
  testers: string[];
  methods: string[];
  controls: string[];
  roads: string[];
}
/** A record of the project, and why it cannot be inspected. */
interface Tested {
  path: string;
  why: string | null;
  german: string | null;
}
interface Reasoned {
  reasons: string[];
  german?: { reasons?: string[]; grade?: Record<string, string> };
}
interface Wheel extends Reasoned {
  wheel: string;
  axle?: string;
  static_load: number | null;
  verdict: string;
  grade: Record<string, string>;
  uncertainty: Record<string, number>;
  findings: { severity: string; message: string }[];
  [quantity: string]: unknown;
}
interface Graded {
  wheels: Wheel[];
  axle?: Reasoned & { axle: string; verdict: string };
  verdict: string;
  deciding: string[];
  limits: { label: string; source: string };
  vehicle: { verdict: string; reasons: string[] };
  reasons?: string[];
  findings?: { severity: string; message: string }[];
  error?: { message: string };
  store: { location: string; records: number[] } | null;
}
const TONES: Record<string, string> = {
  pass: "good",
  advise: "fair",
  fail: "bad",
  "not graded": "bad",
};
/** Reasons of a verdict in the language of the page. */
const reasonsOf = (about?: Reasoned): (Node | string)[] =>
  (isGerman && about?.german?.reasons) || (about?.reasons ?? []).map((text) => asSaid(text));
const mark = (verdict: string) =>
  make("span", { class: `mark ${TONES[verdict] ?? "plain"}` }, verdict);

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const [{ entries }, choices, library, tested] = await Promise.all([
    api.project(),
    api.get<Choices>("/api/choices"),
    api.library(),
    api.get<Tested[]>("/api/tested"),
  ]);
  const wanted = values.get("record") ?? "",
    records = tested.filter(({ path, why }) => !why || path === wanted).map(({ path }) => path),
    others = tested.filter(({ path }) => !records.includes(path)),
    stores = entries.filter((entry) => entry.kind === "store").map((entry) => entry.path);
  const rigs = [
    ...entries.filter((entry) => VEHICLES.includes(entry.kind)).map((entry) => entry.path),
    ...library.map((shippedRig) => shippedRig.name),
  ];
  const store = select(stores),
    search_ = search(store, choices),
    noStore = make(
      "p",
      { class: "empty" },
      "No store in this project yet. Name one (such as lane.sqlite) when you evaluate a record.",
    );
  const offered = () => {
    search_.hidden = !store.options.length;
    noStore.hidden = !search_.hidden;
  };
  const stored = (name: string) => {
    if (name) offer(store, [name]);
    offered();
  }; // what is typed into the search stays
  const { element, here, controls } = evaluation(
    records,
    rigs,
    choices,
    stores,
    wanted,
    stored,
    (was) => drafts.done({ evaluate: was }),
  );
  const test = simulated(rigs, choices, (was) => drafts.done({ simulate: was }));
  const state = () => ({ evaluate: entered(controls), simulate: entered(test.controls) });
  const drafts = new Drafts(await api.folder(), address("inspection"), state(), state, (was) => {
    enter(controls, was.evaluate);
    enter(test.controls, was.simulate);
  });
  for (const area of [element, test.element]) drafts.hear(area);
  offered();
  place.replaceChildren(
    make("h1", {}, "Inspection"),
    make(
      "p",
      { class: "muted" },
      "Evaluate records of shock-absorber testers, grade them against limits, and save report and record in a store.",
    ),
    drafts.element,
    make("h2", {}, "Evaluate a record"),
    element,
    ...(others.length ? [left(others, here)] : []),
    make("h2", {}, "New records"),
    dropZone(
      () => "records",
      "Drop tester records here, or choose them; they are saved in the folder records.",
      here,
    ),
    make("details", {}, make("summary", {}, "No record available? Simulate a test"), test.element),
    make("h2", {}, "Store"),
    noStore,
    search_,
  );
}

/** Records that are not offered, with the reason; a tester whose file names its columns may still read them. */
function left(others: Tested[], here: () => (paths: string[]) => void): HTMLElement {
  const rows = others.map(({ path, why, german }) => {
    const button = make(
      "button",
      { type: "button", "aria-label": `${tr("offer")}: ${path}` },
      tr("offer"),
    );
    button.addEventListener("click", () => {
      here()([path]);
      button.disabled = true;
    });
    return [path, inLanguage(why ?? "", german), button];
  });
  return make(
    "details",
    {},
    make("summary", {}, tr("Records that are not of a tester (#)", String(others.length))),
    table(
      tr("Records that are not of a tester"),
      ["record", "reason", ""],
      rows,
      [],
      tr("A tester whose file names other columns may read them: offer them then."),
    ),
  );
}

/** Adds missing names to a choice. */
function offer(choice: HTMLSelectElement, names: string[]): void {
  const known = new Set([...choice.options].map((option) => option.value));
  choice.append(
    ...names
      .filter((name) => !known.has(name))
      .map((name) => make("option", { value: name }, name)),
  );
}

/** What evaluates a record, and what is called when records come: the first of them is chosen, unless another one was meanwhile. */
function evaluation(
  records: string[],
  rigs: string[],
  choices: Choices,
  stores: string[],
  chosen: string,
  stored: (store: string) => void,
  used: (was: Used) => void,
): { element: HTMLElement; here: () => (paths: string[]) => void; controls: Controls } {
  const record = select(records, chosen),
    other = optional("none", records),
    tester = select(
      choices.testers,
      choices.testers.find((tester) => tester.includes("egea")),
    ),
    vehicle = optional("not specified", rigs);
  const method = optional("the tester's own", choices.methods),
    store = textBox(stores[0] ?? "", "lane.sqlite"),
    plate = textBox("", "B-AB 123"),
    date = textBox(today()),
    by = textBox(),
    languages: Record<string, string> = { en: "English", de: "Deutsch" },
    language = select(["en", "de"], isGerman ? "de" : "en", (value) => languages[value]!);
  for (const option of language.options) option.lang = option.value;
  const look = make("button", { type: "button" }, "View the record"),
    looked = make("div", {});
  look.addEventListener("click", () => {
    const reading = new Reading(record.value, "recording");
    looked.replaceChildren(reading.element);
    void reading.ask();
  });
  const controls = { record, other, tester, vehicle, method, plate, date, by, language, store };
  let was: Used = {};
  const question = new Question(
    "Evaluate and grade",
    () => {
      was = entered(controls);
      return {
        kind: "evaluate",
        records: [record.value, ...(other.value ? [other.value] : [])],
        tester: tester.value,
        vehicle: vehicle.value,
        methods: method.value ? [method.value] : [],
        store: store.value,
        plate: plate.value,
        date: date.value,
        inspector: by.value,
        language: language.value,
      };
    },
    (reply: Reply<Graded>, asked) => {
      used(was);
      if (reply.result.store) stored(asked.store);
      return [...graded(reply.result), testReport(reply, asked), snippets(reply)];
    },
  );
  const none = make(
    "p",
    { class: "empty", hidden: !!records.length },
    "No record of a tester in this project yet: drop one below, or simulate a test.",
  );
  const whole = make(
    "section",
    { hidden: !records.length },
    make(
      "div",
      { class: "form" },
      field("Record of one axle", record),
      field("Record of the other axle", other),
      field("Tester", tester),
      field("Deciding method", method),
      field("Vehicle", vehicle),
    ),
    make(
      "div",
      { class: "form" },
      field("Number plate", plate),
      field("Date", date),
      field("Inspector", by),
      field("Language of the report", language),
      field("Save in the store", store),
      look,
      question.button,
    ),
    looked,
    question.place,
  );
  const here = () => {
    const before = record.value;
    return (paths: string[]) => {
      for (const select of [record, other]) offer(select, paths);
      if (record.value === before || !before) record.value = paths[0]!;
      whole.hidden = false;
      none.hidden = true;
    };
  };
  return { element: make("div", {}, none, whole), here, controls };
}

/** The test report of one or two axles, which can be saved as PDF; nothing is stored again. */
const testReport = (reply: Reply<Graded>, asked: { language: string }): HTMLElement =>
  report(
    reply.report,
    "Test report",
    asked.language,
    saveDocument("Test report", async () =>
      (await api.asked("POST", "/api/protocol", asked)).blob(),
    ),
  );

/** Opens the protocol of stored records below a list, as they were graded. */
function reopened(store: string, records: number[], place: HTMLElement): void {
  const protocol = new Question<Graded>(
    "Again",
    () => ({ kind: "protocol", store, records, language: isGerman ? "de" : "en" }),
    (reply, asked) => [
      make("h3", {}, `Protocol of record ${records.join(", ")}`),
      ...graded(reply.result),
      testReport(reply, asked as { language: string }),
      snippets(reply),
    ],
  );
  place.replaceChildren(protocol.place);
  void protocol.ask().then(() => place.scrollIntoView({ block: "nearest" }));
}

/** A button that opens the protocol of the records of one visit. */
function opens(store: string, visit: Visit[], place: HTMLElement): HTMLButtonElement {
  const records = [...visit].sort((visit, other) => visit.axle.localeCompare(other.axle)),
    numbers = records.map((record) => record.number),
    button = make(
      "button",
      { type: "button", "aria-label": `protocol of record ${numbers.join(", ")}` },
      tr("protocol"),
    );
  button.addEventListener("click", () => reopened(store, numbers, place));
  return button;
}

/** A stored record of one axle. */
interface Visit {
  number: number;
  date: string;
  axle: string;
}
/** The records of a test: this one, and that of the other axle of the same plate and day if there is just one. */
function visitOf(own: Stored, records: Stored[]): Visit[] {
  const others = records.filter(
    (record) =>
      own.plate &&
      own.axle &&
      own.date &&
      record.axle &&
      record.axle !== own.axle &&
      record.plate === own.plate &&
      record.date === own.date,
  );
  return others.length === 1 ? [own, others[0]!] : [own];
}

/** Verdicts first, then the values of each wheel, and the reasons. */
function graded(grading: Graded): HTMLElement[] {
  const { wheels } = grading,
    shown: HTMLElement[] = [];
  if (grading.error)
    shown.push(make("p", { class: "problem", role: "alert" }, grading.error.message));
  shown.push(
    make(
      "p",
      { class: "bar" },
      "verdict: ",
      mark(grading.verdict),
      make(
        "span",
        { class: "muted" },
        `${grading.deciding.join(", ")} decides; limits: ${grading.limits.label}`,
      ),
      ...(grading.store
        ? [
            make(
              "span",
              { class: "good" },
              `saved in the store as record ${grading.store.records.join(", ")}`,
            ),
          ]
        : []),
    ),
  );
  const quantities = WHEEL_QUANTITIES.filter(([name]) =>
    wheels.some((wheel) => typeof wheel[name] === "number"),
  );
  const name = (wheel: Wheel) =>
    [wheel.axle, wheel.wheel]
      .filter(Boolean)
      .map((word) => tr(word!))
      .join(" ");
  const cell = (wheel: Wheel, key: string, factor: number) => {
    const value = wheel[key],
      doubt = wheel.uncertainty?.[key];
    if (typeof value !== "number") return "–";
    if (!doubt || !value) return written(value * factor);
    const place = (x: number) => Math.floor(Math.log10(Math.abs(x * factor)));
    const decimals = Math.min(Math.max(0, Math.min(-place(doubt), 3 - place(value))), 20); // both end at one place, the doubt is rounded up
    const up = Math.ceil(doubt * factor * 10 ** decimals - 1e-9) / 10 ** decimals;
    return `${localised((value * factor).toFixed(decimals))} ± ${localised(up.toFixed(decimals))}`;
  };
  const methods = [...new Set(wheels.flatMap((wheel) => Object.keys(wheel.grade)))];
  shown.push(
    table(
      "wheels",
      ["wheel", ...wheels.map(name), "unit"],
      [
        [tr("verdict"), ...wheels.map((wheel) => mark(wheel.verdict)), ""],
        ...quantities.map(([key, words, unit, factor]) => [
          words,
          ...wheels.map((wheel) => cell(wheel, key, factor)),
          unit,
        ]),
        ...methods.map((method) => [
          tr("grade #", method.toUpperCase()),
          ...wheels.map(
            (wheel) => (isGerman && wheel.german?.grade?.[method]) || wheel.grade[method] || "–",
          ),
          "",
        ]),
      ],
      wheels.map((_, k) => k + 1),
    ),
  );
  const reasons = [
    ...wheels.flatMap((wheel) =>
      reasonsOf(wheel).map((text) => make("li", {}, `${name(wheel)}: `, text)),
    ),
    ...reasonsOf(grading.axle).map((text) => make("li", {}, text)),
    ...wheels.flatMap((wheel) =>
      advised(
        wheel.findings.map((finding) => ({ ...finding, place: name(wheel) })),
        "li",
      ),
    ),
    ...advised(grading.findings ?? [], "li"),
  ];
  shown.push(
    make(
      "details",
      {},
      make("summary", {}, `Reasons (${reasons.length})`),
      make("ul", {}, ...reasons),
    ),
  );
  return shown;
}

/** Today's date in local time. */
function today(): string {
  const now = new Date(),
    two = (part: number) => String(part).padStart(2, "0");
  return `${now.getFullYear()}-${two(now.getMonth() + 1)}-${two(now.getDate())}`;
}

function simulated(
  rigs: string[],
  choices: Choices,
  used: (was: Used) => void,
): { element: HTMLElement; controls: Controls } {
  const rig = select(
      rigs,
      rigs.find((rig) => rig === "audi-a6-half-car-4dof"),
    ),
    tester = select(
      choices.testers,
      choices.testers.find((tester) => tester.includes("egea")),
    );
  const wear = textBox("", "0.4"),
    wheel = select(["both", "left", "right"], "both", (value) => tr(value)),
    out = textBox("simulated.csv");
  const controls = { rig, tester, wear, wheel, out };
  let was: Used = {};
  const question = new Question(
    "Simulate the test",
    () => {
      was = entered(controls);
      return {
        kind: "test",
        vehicle: rig.value,
        tester: tester.value,
        wear: wear.value,
        wheel: wheel.value,
        out: out.value,
      };
    },
    (reply, asked) => {
      used(was);
      return [
        make(
          "p",
          { class: "good" },
          `${asked.out} was saved. `,
          make("a", { href: address("inspection", { record: asked.out }) }, "Evaluate"),
        ),
        snippets(reply),
      ];
    },
  );
  return {
    controls,
    element: make(
      "section",
      {},
      make(
        "div",
        { class: "form" },
        field("Rig or vehicle", rig),
        field("Tester", tester),
        field("Loss of damping", wear),
        field("Wheel", wheel),
        field("Record", out),
        question.button,
      ),
      question.place,
    ),
  };
}

interface Stored {
  number: number;
  date: string;
  plate: string;
  vehicle: string;
  axle: string;
  tester: string;
  name: string;
  verdict: string | null;
}

function search(store: HTMLSelectElement, choices: Choices): HTMLElement {
  const plate = textBox("", "B-AB*"),
    verdict = optional("any", ["pass", "advise", "fail", "not graded"]),
    tester = optional("any", choices.testers),
    since = textBox("", "2026-01-31"),
    until = textBox("", "2026-12-31");
  const history = make("div", { "aria-live": "polite" });
  const question = new Question(
    "Search",
    () => ({
      kind: "search",
      store: store.value,
      plate: plate.value,
      verdict: verdict.value,
      tester: tester.value,
      since: since.value,
      until: until.value,
    }),
    (reply: Reply<{ records: Stored[] }>, asked) => {
      const { records } = reply.result;
      if (!records.length)
        return [make("p", { class: "empty" }, "No matching records."), snippets(reply)];
      const rows = records.map((stored) => {
        const button = make(
          "button",
          { type: "button", "aria-label": `history of ${stored.plate}` },
          tr("history"),
        );
        button.addEventListener("click", () => {
          const past = new Question<{
            plate: string;
            vehicle: string;
            trends: Trend[];
            wheels: { record: number; date: string; axle: string }[];
          }>(
            "Again",
            () => ({ kind: "history", store: asked.store, plate: stored.plate }),
            (reply) => [
              make("h3", {}, `History of ${reply.result.plate}`),
              ...trends(reply.result.trends),
              visits(asked.store, reply.result.wheels, history),
              report(reply.report, "Every visit"),
              snippets(reply),
            ],
          );
          history.replaceChildren(past.place);
          void past.ask();
        });
        return [
          String(stored.number),
          ...[
            stored.date,
            stored.plate,
            stored.vehicle,
            stored.axle,
            stored.tester,
            stored.name,
          ].map((text) => text || "–"),
          stored.verdict ? mark(stored.verdict) : "–",
          make("span", { class: "bar" }, opens(asked.store, visitOf(stored, records), history)),
          stored.plate ? button : "",
        ];
      });
      return [
        table(
          "records",
          ["record", "date", "plate", "vehicle", "axle", "tester", "file", "verdict", "", ""],
          rows,
          [],
          `${records.length} record${records.length === 1 ? "" : "s"}`,
        ),
        snippets(reply),
      ];
    },
  );
  return make(
    "section",
    {},
    make(
      "div",
      { class: "form" },
      field("Store", store),
      field("Number plate, or a pattern", plate),
      field("Verdict", verdict),
      field("Tester", tester),
      field("First day", since),
      field("Last day", until),
      question.button,
    ),
    question.place,
    history,
  );
}

/** The protocols of a vehicle, one of each record. */
function visits(
  store: string,
  wheels: { record: number; date: string; axle: string }[],
  place: HTMLElement,
): HTMLElement {
  const records = new Map(wheels.map((wheel) => [wheel.record, wheel]));
  return make(
    "ul",
    {},
    ...[...records.values()].map(({ record, date, axle }) =>
      make(
        "li",
        { class: "bar" },
        [date, axle && tr(axle)].filter(Boolean).join(", ") || "–",
        opens(store, [{ number: record, date, axle }], place),
      ),
    ),
  );
}

function trends(rows: Trend[]): HTMLElement[] {
  if (!rows.length) return [make("p", { class: "muted" }, "One visit shows no trend.")];
  return [
    table(
      "change per year",
      ["axle", "wheel", "value", "change per year", "unit", "visits"],
      rows.map((row) => {
        const [, words = row.quantity, unit = "", factor = 1] =
          WHEEL_QUANTITIES.find(([name]) => name === row.quantity) ?? [];
        return [
          row.axle || "–",
          row.wheel,
          words,
          written(row.change_per_year * factor, 3),
          unit,
          String(row.visits),
        ];
      }),
      [3, 5],
      "Change per year",
    ),
  ];
}
