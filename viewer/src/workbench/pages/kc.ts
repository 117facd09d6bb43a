/** An axle on the K&C rig: overview of all tests, curves of the open one, hardpoints and stiffnesses to move. */

import { type Mechanism, Store, before as sampleBefore } from "../../data";
import { inStyle } from "../../lines";
import { MechanismView } from "../../mechanism";
import { make, whenColoursChange, whenLeft, written } from "../../page";
import { inField, tr, withComma } from "../../words";
import * as api from "../api";
import { Against, type Differences, Differing } from "../comparing";
import { Drafts } from "../drafts";
import { type Band, Multiples } from "../multiples";
import { field, LiveSnippets, Newest, Outdated, Sliders, Steps, select, textBox } from "../parts";
import { Points } from "../points";
import { inWords, quantity, spoken } from "../quantities";
import { advised, type Finding, inLanguage } from "../refusals";
import { saveChart, saveDrawing } from "../saving";
import { address, choose, setLive, type Values, VEHICLES } from "../shell";
import { type Cell, row, table } from "../table";
import { Writing } from "../writing";

/** Tests in the order of the sheet: words, and the usual range with its unit. */
const TESTS: Record<string, [words: string, range: string]> = {
  bounce: ["Bounce", "50 mm"],
  roll: ["Roll", "3 deg"],
  steer: ["Steer", "40 mm"],
  "lateral-in-phase": ["Lateral force, in phase", "2 kN"],
  "lateral-opposed": ["Lateral force, opposed", "2 kN"],
  "lateral-left": ["Lateral force, left wheel", "2 kN"],
  "lateral-right": ["Lateral force, right wheel", "2 kN"],
  "lateral-trail": ["Lateral force with trail", "2 kN"],
  braking: ["Braking, brakes at the wheels", "2 kN"],
  "braking-inboard": ["Braking, inboard brakes", "2 kN"],
  driving: ["Driving by shafts", "2 kN"],
  "driving-hub": ["Driving by hub motors", "2 kN"],
  "aligning-in-phase": ["Aligning moment, in phase", "100 N*m"],
  "aligning-opposed": ["Aligning moment, opposed", "100 N*m"],
};
const words = (test: string): string => tr(TESTS[test]?.[0] ?? test);
const FIRST = /^(bushings\.\w+\.stiffness\[[01]\]|beam\.torsional_stiffness|strut\.spring\.rate)$/;
const MAGNIFIED = ["1", "5", "20", "100"];
const PAUSE = 250; // ms without a change, until the overview follows

interface OverviewRow {
  test: string;
  label: string;
  positive: string;
  unit: string;
  now: string[];
  was: string[];
}
interface Verdict {
  test: string;
  quantity: string;
  slope_unit: string;
  unit: string;
  input_unit: string;
  verdict: "within" | "outside" | "not judged";
  slope_simulated: string;
  slope_measured: string;
  difference: string;
  tolerance: string;
  leaves_at: string;
  offset: string;
}
interface Extra extends api.Answer, api.OfRig {
  test: string;
  tests: string[];
  is_steered: boolean;
  missing: number;
  overview: OverviewRow[] | null;
  failed: Record<string, { text: string; german: string | null }>;
  findings: Finding[];
  remarks: Finding[];
  compared: Verdict[] | null;
  bands: Band[];
  measured: string[];
  differences: Differences | null;
}
/** Changes made while a file was written. */
let stored: { rig: string; said: string; changes: Record<string, number> } | null = null;

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) {
    await choose(place, "kc", tr("K&C"), "rig", true, VEHICLES);
    return;
  }
  const isOwn = name.endsWith(".toml");
  const [rig, { entries }, folder, digest] = await Promise.all([
    api.rig(name),
    api.project(),
    api.folder(),
    isOwn ? api.file(name).then((file) => file.digest) : "",
  ]);
  if (!place.isConnected) return;
  const before = stored?.rig === name ? stored : null;
  stored = null;
  const isCar = rig.model === "full-car-3d";
  if (!isCar && !rig.spatial && !rig.is_dependent) {
    place.replaceChildren(
      make("h1", {}, name),
      make(
        "p",
        { class: "empty" },
        tr("This rig has no hardpoints, so it cannot be tested on the K&C rig: "),
        make("a", { href: address("kc") }, tr("choose another one")),
        ".",
      ),
    );
    return;
  }
  const newest = new Newest(),
    times: number[] = [];
  setLive({ times });
  const state = make("p", { class: "state", role: "status" }),
    problems = make("div", { "aria-live": "polite" }),
    notes = make("div", {}),
    legend = make("ul", { class: "legend" }),
    verdicts = make("div", {}),
    same = new LiveSnippets(),
    outdated = new Outdated(rig),
    differing = new Differing();

  // settings
  const changed = () => void ask();
  const axle = select(["front", "rear"], values.get("axle") ?? "front", tr);
  const setting = (label: string, placeholder: string) => {
    const box = textBox("", inField(placeholder));
    box.addEventListener("change", changed);
    return { box, element: field(label, box) };
  };
  const travel = setting(tr("Height of the pads before the tests"), "0 mm"),
    rack = setting(tr("Rack travel before the tests"), "0 mm"),
    range = setting(tr("End of the range"), ""),
    fit = setting(tr("Slopes fitted over, either side of zero"), tr("half of the range"));
  const held = select(["load", "height"], "load", (value) =>
      tr(value === "load" ? "load of each wheel" : "height of each pad"),
    ),
    handwheel = select(["locked", "free"], "locked", tr);
  for (const choice of [held, handwheel]) choice.addEventListener("change", changed);
  const to: Record<string, string> = {},
    within: Record<string, string> = {};
  range.box.addEventListener("change", () => {
    to[test.value] = range.box.value.trim();
  });
  fit.box
    .addEventListener("change", () => {
      within[test.value] = fit.box.value.trim();
    });
  const measured = new Against(
    tr("Measured sheet"),
    [
      [
        tr("this project"),
        entries
          .filter((entry) => entry.kind === "record")
          .map((entry): [string, string] => [entry.path, entry.path]),
      ],
    ],
    changed,
  );
  const test = select(Object.keys(TESTS), values.get("test") ?? "bounce", words);
  const opened = () => {
    range.box.value = to[test.value] ?? "";
    range.box.placeholder = inField(TESTS[test.value]![1]);
    fit.box.value = within[test.value] ?? "";
    magnified.value = magnify[test.value] ?? (TESTS[test.value]![1].includes("N") ? "20" : "1");
    void ask();
  };
  test.addEventListener("change", opened);
  const loads = make("input", { type: "checkbox" });
  loads.addEventListener("change", changed);
  const step = (by: number, label: string, text: string) =>
    make(
      "button",
      {
        type: "button",
        title: label,
        "aria-label": label,
        click: () => {
          const known = test.options.length;
          test.selectedIndex = (test.selectedIndex + by + known) % known;
          opened();
        },
      },
      text,
    );
  const filter = make("input", { type: "search", placeholder: tr("camber, roll centre …") });
  filter.addEventListener("input", () => multiples.filter(filter.value));

  // the axle in the test
  const view = new MechanismView(true, false), // names of two sides would lie over each other
    stage = make("div", { class: "player bare" }, view.element);
  saveDrawing(view.element);
  whenColoursChange(() => view.repaint());
  const input = make("input", {
      type: "range",
      step: "any",
      value: "0",
      "aria-label": tr("Input of the test"),
    }),
    reading = make("output", {}),
    magnified = select(MAGNIFIED, "1", (times) =>
      times === "1" ? tr("true to scale") : `× ${times}`,
    ),
    driven = make("label", { class: "driven" }, make("span", {}), input, reading);
  let drawn: Mechanism | null = null,
    toDrawn = 1,
    inputUnit = "";
  const magnify: Record<string, string> = {};
  magnified.addEventListener("change", () => {
    magnify[test.value] = magnified.value;
    void ask();
  });
  /** Moves the axle to an input of the test. */
  const pose = (x: number) => {
    const low = Number(input.min),
      high = Number(input.max),
      at = Math.min(Math.max(x, low), high);
    input.value = String(at);
    reading.textContent = `${written(at, 3)} ${inputUnit}`;
    multiples.mark(at);
    if (!drawn) return;
    const travel = at * toDrawn,
      { contact } = drawn;
    view.set({
      body: 0,
      travel,
      ground: contact[sampleBefore(drawn.travel, travel)]?.[2] ?? 0,
      load: 1,
      time: 0,
    });
  };
  input.addEventListener("input", () => pose(Number(input.value)));
  const posed = (store: Store) => {
    const model = store.content.viewers[0],
      scene = model?.scenes[0];
    stage.hidden = driven.hidden = !scene?.motion;
    if (!model || !scene?.motion) return;
    const mechanism = store.content.mechanisms[scene.motion.mechanism]!,
      x = store.get(scene.x),
      ends = [x[0] as number, x[x.length - 1] as number] as const,
      { travel } = mechanism;
    const isNew = driven.firstElementChild!.textContent !== model.x.words;
    driven.firstElementChild!.textContent = model.x.words;
    toDrawn = (travel[travel.length - 1]! - travel[0]!) / (ends[1] - ends[0] || 1);
    inputUnit = model.x.unit;
    [input.min, input.max] = [String(ends[0]), String(ends[1])];
    drawn = exaggerated(mechanism, Number(magnified.value));
    view.show(drawn, scene.motion);
    pose(isNew ? ends[1] : Number(input.value));
  };

  // what is moved
  const prefix = () => (isCar ? `${axle.value}.corner.` : "");
  const sliders = new Sliders(
    rig,
    rig.numbers
      .filter(({ path, value }) => value && FIRST.test(path))
      .map(({ path }) => path)
      .slice(0, 6),
    () => {
      points.set(moved());
      void ask();
    },
    before?.changes,
  );
  const moved = () =>
    rig.numbers
      .filter(({ path }) => path.startsWith(prefix()))
      .map(({ path, value }) => ({
        path: path.slice(prefix().length),
        value: sliders.changes[path] ?? value,
      }));
  const points = new Points(view, (changes) => {
    for (const [path, value] of Object.entries(changes)) sliders.set(`${prefix()}${path}`, value);
    void ask();
  });
  points.set(moved());
  axle.addEventListener("change", () => {
    points.set(moved());
    void ask();
  });
  const entered = () => ({ changes: sliders.changes });
  const put = (was: ReturnType<typeof entered>) => {
    sliders.reset();
    for (const [path, value] of Object.entries(was.changes)) sliders.take(path, value);
    points.set(moved());
    return ask();
  };
  const drafts = new Drafts(
      folder,
      address("kc", { rig: name }),
      { changes: {} },
      entered,
      put,
      () => digest,
    ),
    steps = new Steps(entered, put, place);
  const writes = new Writing(
    rig,
    () => sliders.changes,
    (changes, asWritten) => {
      if (!place.isConnected) return;
      const later = Object.entries(sliders.changes).filter(
        ([path, value]) => asWritten(path, value) !== changes[path],
      );
      stored = {
        rig: name,
        said: tr("Saved. The previous state is under earlier versions."),
        changes: Object.fromEntries(later),
      };
      drafts.drop();
      dispatchEvent(new HashChangeEvent("hashchange"));
    },
  );

  // what is shown
  const multiples = new Multiples((x) => pose(x));
  const rows = make("tbody", {});
  const overview = table(
    tr("Overview"),
    ["test", "quantity", "unit", "left", "right", "axle", "ideal joints"],
    rows,
    [3, 4, 5, 6],
    tr("Slopes over half of each test's range, unless stated otherwise. In brackets: as saved."),
  );
  const listed = (all: OverviewRow[]) => {
    let last = "";
    rows.replaceChildren(
      ...all.map(({ test: own, label, positive, unit, now, was }) => {
        const open = make("button", { type: "button", class: "link" }, words(own));
        open.addEventListener("click", () => {
          test.value = own;
          opened();
          heading.scrollIntoView({ block: "nearest" });
        });
        const cells = now.map((value, k): Cell => {
          const earlier = was[k] ?? "";
          return earlier && earlier !== value
            ? [withComma(value), make("span", { class: "muted" }, ` (${withComma(earlier)})`)]
            : withComma(value);
        });
        const first = own === last ? "" : open;
        last = own;
        const line = row([first, spoken(label), unit, ...cells], [3, 4, 5, 6]);
        line.cells[1]!.title = `${tr("positive")}: ${spoken(positive)}`;
        return line;
      }),
    );
  };
  const judged = (all: Verdict[]) => {
    const order = ["outside", "within", "not judged"];
    const sorted = [...all].sort((a, b) => order.indexOf(a.verdict) - order.indexOf(b.verdict));
    const good = all.filter(({ verdict }) => verdict === "within").length,
      count = all.filter(({ verdict }) => verdict !== "not judged").length;
    verdicts.replaceChildren(
      make("h2", {}, tr("Model and measurement")),
      make(
        "p",
        {},
        tr("# measured curves are within their tolerance of the model.", `${good}/${count}`),
      ),
      table(
        tr("Model and measurement"),
        [
          "test",
          "quantity",
          "unit",
          "slope, model",
          "slope, measured",
          "difference",
          "tolerance",
          "leaves it at",
          "verdict",
        ],
        sorted.map((one) => [
          words(one.test),
          quantity(one.quantity).replace(/^(left|right)\./, "$1 "),
          one.slope_unit,
          withComma(one.slope_simulated),
          withComma(one.slope_measured),
          `${withComma(one.difference)} ${one.unit}`,
          `${withComma(one.tolerance)} ${one.unit}`,
          one.verdict === "outside" ? `${withComma(one.leaves_at)} ${one.input_unit}` : "–",
          make(
            "span",
            {
              class: `verdict ${{ within: "good", outside: "missed", "not judged": "" }[one.verdict]}`,
            },
            tr(one.verdict),
          ),
        ]),
        [3, 4, 5, 6, 7],
        tr("Changes from zero input are compared; measured curves are drawn from the model there."),
      ),
    );
  };
  const heading = make("h2", {}, words(test.value));

  let waiting = 0;
  whenLeft(() => clearTimeout(waiting));
  const ask = () => {
    drafts.changed();
    steps.changed();
    clearTimeout(waiting);
    return asked(false);
  };
  /** Asks for the open test, and after a pause for the overview, part by part. */
  const asked = (isWhole: boolean): Promise<void> =>
    newest.ask(async () => {
      if (!place.isConnected) return;
      const began = performance.now();
      const slow = setTimeout(() => {
        state.textContent = tr("computing …");
      }, 500);
      try {
        const store = inWords(
          Store.of(
            await api.curves("kc", {
              rig: name,
              changes: sliders.changes,
              test: test.value,
              axle: isCar ? axle.value : "",
              to: Object.fromEntries(Object.entries(to).filter(([, value]) => value)),
              within: Object.fromEntries(Object.entries(within).filter(([, value]) => value)),
              travel: travel.box.value.trim(),
              steer: rack.box.value.trim(),
              held: held.value,
              handwheel: handwheel.value,
              measured: measured.values,
              overview: isWhole,
              loads: loads.checked,
            }),
          ),
        );
        if (!place.isConnected) return;
        shown(store, isWhole);
        if (!isWhole) times.push(performance.now() - began);
        const extra = store.content as unknown as Extra;
        if (!isWhole || extra.missing)
          waiting = window.setTimeout(() => void asked(true), isWhole ? 0 : PAUSE);
        state.textContent =
          isWhole && extra.missing
            ? tr("tests of the overview still to be computed: #", String(extra.missing))
            : `${tr("computed and drawn in")} ${written(times[times.length - 1] ?? 0, 2)} ms`;
        state.classList.remove("problem");
      } catch (error) {
        state.textContent = error instanceof Error ? error.message : String(error);
        state.classList.add("problem");
      } finally {
        clearTimeout(slow);
      }
    });
  const shown = (store: Store, isWhole: boolean) => {
    const extra = store.content as unknown as Extra,
      model = store.content.viewers[0];
    for (const option of test.options) option.disabled = !extra.tests.includes(option.value);
    test.value = extra.test;
    heading.textContent = words(extra.test);
    rack.element.hidden = handwheel.closest("label")!.hidden = !extra.is_steered;
    multiples.element.hidden = !model;
    if (model) {
      multiples.show(model, store, extra.bands);
      legend.replaceChildren(
        ...model.roles.map(({ role, label }) =>
          make("li", {}, make("i", { class: `swatch ${role}` }), inStyle(label, role)),
        ),
      );
    }
    posed(store);
    problems.replaceChildren(
      ...Object.entries(extra.failed).map(([failed, { text, german }]) =>
        make("p", { class: "problem" }, `${words(failed)}: ${inLanguage(text, german)}`),
      ),
    );
    notes.replaceChildren(...advised([...extra.findings, ...extra.remarks], "p"));
    if (isWhole) {
      listed(extra.overview ?? []);
      if (extra.compared) judged(extra.compared);
    }
    if (!measured.values.length) verdicts.replaceChildren();
    differing.show(extra.differences);
    same.show(extra);
    outdated.show(extra);
  };

  const heldField = field(tr("Tests with forces keep"), held),
    handwheelField = field(tr("Handwheel"), handwheel);
  place.replaceChildren(
    make("h1", {}, tr("K&C of #", name)),
    make(
      "p",
      { class: "bar" },
      ...(isOwn ? [make("a", { href: address("rig", { name }) }, tr("Open its file"))] : []),
      ...(rig.spatial
        ? [make("a", { href: address("kinematics", { rig: name }) }, tr("Show its kinematics"))]
        : []),
    ),
    drafts.element,
    make(
      "div",
      { class: "form" },
      ...(isCar ? [field(tr("Axle"), axle)] : []),
      travel.element,
      rack.element,
      heldField,
      handwheelField,
      measured.element,
    ),
    outdated.element,
    state,
    problems,
    make(
      "div",
      { class: "beside" },
      make(
        "div",
        { class: "stuck movers" },
        stage,
        driven,
        field(tr("Movements are drawn"), magnified),
        make("h2", {}, tr("Hardpoints")),
        points.element,
        make("h2", {}, tr("Parameters")),
        sliders.element,
        steps.element,
        ...(isOwn ? [writes.element] : []),
      ),
      make(
        "div",
        {},
        make("h2", {}, tr("Overview")),
        make("div", { class: "sheet" }, overview),
        verdicts,
        heading,
        make(
          "div",
          { class: "form" },
          field(tr("Test"), test),
          make(
            "div",
            { class: "bar" },
            step(-1, tr("previous test"), "‹"),
            step(1, tr("next test"), "›"),
          ),
          range.element,
          fit.element,
          field(tr("Show curves with"), filter),
          make("label", { class: "check" }, loads, tr("loads of links and bushings")),
          saveChart(multiples.element, () => `${name}: ${words(test.value)}`),
        ),
        legend,
        notes,
        multiples.element,
        differing.element,
      ),
    ),
    same.element,
  );
  if (before) writes.say(before.said);
  range.box.placeholder = inField(TESTS[test.value]![1]);
  await ask();
}

/** An axle whose movements in a test are drawn larger than they are. */
function exaggerated(mechanism: Mechanism, times: number): Mechanism {
  if (times === 1) return mechanism;
  const { travel, points, contact, spin, other } = mechanism,
    start = sampleBefore(travel, 0);
  const larger = (poses: ArrayLike<number>[]) =>
    poses.map((place) =>
      Array.from(place, (value, k) => {
        const from = poses[start]![k]!;
        return from + times * (value - from);
      }),
    );
  return {
    ...mechanism,
    points: points.map(larger),
    contact: larger(contact),
    spin: larger(spin),
    other: other && exaggerated(other, times),
  };
}
