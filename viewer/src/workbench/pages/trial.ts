/** A rig over an obstacle, with sliders. */

import { make } from "../../page";
import { tr } from "../../words";
import * as api from "../api";
import { Against, type Differences, Differing } from "../comparing";
import { Drafts, enter, entered, moment } from "../drafts";
import { OBSTACLES, USUAL } from "../obstacles";
import {
  field,
  Live,
  Outdated,
  once,
  optional,
  problem,
  Sliders,
  Steps,
  select,
  textBox,
} from "../parts";
import { Phase } from "../phase";
import { address, choose, given, setLive, type Values, VEHICLES } from "../shell";

/** Parameters with sliders at first: those of a corner, or of each axle of a vehicle. */
const FIRST = [
  /^(|(front|rear)\.(corner\.)?)(strut\.)?spring[._]rate$/,
  /^(|(front|rear)\.(corner\.)?)(strut\.damper\.)?(damping_|bump_|rebound_|)coefficient$/,
  /^(|(front|rear)\.(corner\.)?)tyre\.stiffness$/,
  /^(sprung|unsprung|body)\.mass$/,
  /^(front|rear)\.unsprung_mass$/,
];

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) {
    await choose(
      place,
      "trial",
      tr("Trial"),
      "rig",
      true,
      VEHICLES,
      values.get("record") ? { record: values.get("record")! } : {},
    );
    return;
  }
  const [rig, { entries, folder }, shipped, runs, earlier] = await Promise.all([
    api.rig(name),
    api.project(),
    api.library(),
    api.get<{ path: string }[]>("/api/history"),
    name.endsWith(".toml") ? api.versions(name) : [],
  ]);
  if (!place.isConnected) return;
  if (rig.is_dependent) {
    place.replaceChildren(
      make("h1", {}, name),
      make(
        "p",
        { class: "empty" },
        tr("An axle with joined wheels cannot be driven over a road yet. The K&C rig tests it: "),
        make("a", { href: address("kc", { rig: name }) }, tr("Show its K&C")),
        ".",
      ),
    );
    return;
  }
  const kind = select(Object.keys(OBSTACLES), undefined, (text) => tr(text.replace("-", " ")));
  const sizes = make("span", { class: "sizes" });
  const road = given<Record<string, string>>(values.get("road")); // what another page opens: sizes and start with their units
  if (road.kind && road.kind in OBSTACLES) kind.value = road.kind;
  const speed = textBox(
      values.get("speed") ?? (rig.name.includes("kart") ? "1.95 m/s" : "30 km/h"),
    ),
    duration = textBox(values.get("duration") ?? "1.5 s");
  const offered = () =>
    sizes.replaceChildren(
      ...OBSTACLES[kind.value]!.map((text) => {
        const input = textBox(road[text] ?? USUAL[text]!);
        input.name = text;
        input.addEventListener("change", () => void curves.ask());
        return field(tr(text[0]!.toUpperCase() + text.slice(1)), input);
      }),
    );
  const sliders = new Sliders(
    rig,
    FIRST.flatMap((wanted) =>
      rig.numbers.map(({ path }) => path).filter((path) => wanted.test(path)),
    ),
    () => void curves.ask(),
    given<Record<string, number>>(values.get("set")),
  );
  const asked = () => ({
    rig: name,
    changes: sliders.changes,
    speed: speed.value,
    duration: duration.value,
    road: {
      kind: kind.value,
      start: road.start ?? "0.2 m",
      ...Object.fromEntries(
        [...sizes.querySelectorAll("input")].map((element) => [element.name, element.value]),
      ),
    },
  });
  const look = select(["time", "spectra"], "time", (value) =>
    tr(value === "time" ? "time" : "frequency (spectra)"),
  );
  const measured = optional(
    "none",
    entries.filter((entry) => entry.kind === "record").map(({ path }) => path),
  );
  measured.value = values.get("record") ?? "";
  const others = entries.filter((entry) => VEHICLES.includes(entry.kind) && entry.path !== name);
  const against = new Against(
    tr("Compare with"),
    [
      [
        tr("earlier versions"),
        earlier.map((version) => [
          version.name,
          `${tr("replaced")} ${moment(version.replaced * 1000)}`,
        ]),
      ],
      [tr("this project"), others.map(({ path }) => [path, path])],
      [tr("saved runs"), runs.map(({ path }) => [path, path.replace(/^runs\//, "")])],
      [tr("shipped"), shipped.map((shipped) => [shipped.name, shipped.name])],
    ],
    () => void curves.ask(),
  );
  against.values = given<string[]>(values.get("against") ?? "[]");
  const differing = new Differing();
  const begins = textBox("0 s"),
    since = field(tr("Start of the recording"), begins);
  const offset = () => {
    since.hidden = !measured.value;
  };
  const phase = new Phase(() => void curves.ask());
  phase.element.hidden = true; // until there is something to draw
  const curves = new Live((channels) =>
    api.curves("simulate", {
      ...asked(),
      spectra: look.value === "spectra",
      against: against.values,
      measured: measured.value,
      begins: begins.value,
      numbers: [...channels, ...phase.channels],
    }),
  );
  const outdated = new Outdated(rig);
  curves.shown = (model, store) => {
    const answer = store.content as unknown as api.OfRig & { differences: Differences | null };
    outdated.show(answer);
    differing.show(answer.differences);
    const isTime = model.x.unit === "s";
    phase.element.hidden = !isTime;
    if (isTime) phase.show(model, store);
  }; // of what came, not of what is wanted by now
  curves.moved = (place) => {
    if (!phase.element.hidden) phase.mark(place);
  };
  for (const setting of [look, measured, begins])
    setting.addEventListener("change", () => {
      offset();
      void curves.ask();
    });
  offset();
  const title = make("input", {
      type: "text",
      size: "40",
      value: `${name
        .replace(/\.toml$/, "")
        .split("/")
        .pop()} ${new Date().toLocaleString("sv-SE").slice(0, 16).replace(":", ".")}`,
    }),
    status = make("span", { "aria-live": "polite" });
  const press = make("button", { type: "submit" }, tr("Save the run")),
    keep = make("form", { class: "form" }, field(tr("Save this run as"), title), press, status);
  keep.addEventListener("submit", (event) => {
    event.preventDefault();
    const was = state();
    once(
      press,
      api.asked("POST", "/api/keep", { ...asked(), title: title.value, digest: rig.digest }),
    ).then(
      async (answer) => {
        drafts.done(was); // it lies in the project by now
        const { path } = (await answer.json()) as { path: string };
        status.replaceChildren(
          tr("Saved as "),
          make("a", { href: address("record", { path }) }, path),
          ". ",
          make("a", { href: address("data", { path, beside: "yes" }) }, tr("Beside recordings")),
          ". ",
          make("a", { href: address("project") }, tr("Compare in the project")),
        );
      },
      (error) => status.replaceChildren(problem(error)),
    );
  });
  kind.addEventListener("change", () => {
    offered();
    void curves.ask();
  });
  for (const input of [speed, duration]) input.addEventListener("change", () => void curves.ask());
  offered();
  const controls = { kind, speed, duration, measured, begins };
  const state = () => ({
    controls: entered(controls),
    sizes: Object.fromEntries(
      [...sizes.querySelectorAll("input")].map((element) => [element.name, element.value]),
    ),
    changes: { ...sliders.changes },
  });
  const put = (was: ReturnType<typeof state>) => {
    enter(controls, was.controls);
    for (const element of sizes.querySelectorAll("input"))
      element.value = was.sizes[element.name] ?? element.value;
    sliders.reset();
    for (const [path, value] of Object.entries(was.changes)) sliders.take(path, value);
    void curves.ask();
  };
  const drafts = new Drafts(folder, address("trial", { rig: name }), state(), state, put);
  setLive(curves);
  const form = make(
    "div",
    { class: "form" },
    field(tr("Obstacle"), kind),
    sizes,
    field(tr("Speed"), speed),
    field(tr("Duration"), duration),
    field(tr("Curves over"), look),
    against.element,
    field(tr("Recording beside it"), measured),
    since,
  );
  const run = make(
    "div",
    { class: "controls", role: "region", "aria-label": tr("Test conditions") },
    form,
    sliders.element,
  );
  drafts.hear(run);
  run.append(
    new Steps(
      state,
      (was) => {
        put(was);
        drafts.changed();
      },
      run,
    ).element,
  );
  place.replaceChildren(
    make("h1", {}, tr("# over an obstacle", name)),
    drafts.element,
    make(
      "div",
      { class: "bench" },
      run,
      make(
        "div",
        {},
        outdated.element,
        differing.element,
        curves.element,
        phase.element,
        make("h2", {}, tr("Save this run")),
        keep,
      ),
    ),
  );
  await curves.ask();
}
