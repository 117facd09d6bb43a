/** A corner over travel, rack or roll: mechanism, curves of the catalogue, targets, and designs from targets. */

import { Store } from "../../data";
import { inStyle } from "../../lines";
import { type Centres, MechanismView } from "../../mechanism";
import { make, toggle, whenColoursChange, written } from "../../page";
import { fromField, inField, localised, tr } from "../../words";
import * as api from "../api";
import { Against, type Differences, Differing } from "../comparing";
import { designing, type Target } from "../designing";
import { Drafts, moment } from "../drafts";
import { type Band, Multiples } from "../multiples";
import { numberBox } from "../numberbox";
import { field, LiveSnippets, Newest, Outdated, Sliders, Steps, textBox } from "../parts";
import { pastePoints } from "../pasting";
import { Points } from "../points";
import { inWords, part, quantity } from "../quantities";
import { asSaid } from "../refusals";
import { saveChart, saveDrawing } from "../saving";
import { address, choose, given, goTo, setLive, type Values } from "../shell";
import { row, table } from "../table";
import { savingAs, Writing } from "../writing";

type Over = "travel" | "rack" | "roll";
/** State that survives the reload after saving: targets, and changes made meanwhile. */
interface Kept {
  rig: string;
  said: string;
  targets: Target[];
  changes: Record<string, number>;
}
let stored: Kept | null = null;
interface Extra {
  centres: Centres | null;
  targets: Band[];
  differences: Differences | null;
  notes: string[];
}

/** One of travel, rack and roll: a range where it is swept, and a slider of the pose. */
class Drive {
  readonly slider = make("input", { type: "range", step: "any" });
  readonly number = numberBox({ step: "any", value: "0" });
  readonly range = make("input", { type: "text", spellcheck: "false" });
  readonly element: HTMLElement;
  constructor(
    readonly name: Over,
    readonly words: string,
    readonly unit: string,
    reach: number,
    step: number,
    changed: (isRange: boolean) => void,
  ) {
    this.range.value = inField(`${-reach} ${unit}:${reach} ${unit}:${step} ${unit}`);
    this.slider.min = String(-reach);
    this.slider.max = String(reach);
    this.slider.value = "0";
    this.slider.setAttribute("aria-label", `${words} [${unit}]`);
    this.number.setAttribute("aria-label", `${words} [${unit}], ${tr("typed")}`);
    this.range.setAttribute("aria-label", `${words}: ${tr("first:last:step")}`);
    this.slider.addEventListener("input", () => {
      this.number.value = String(Number(Number(this.slider.value).toPrecision(4)));
      changed(false);
    });
    this.number.addEventListener("input", () => {
      if (this.number.value !== "") {
        this.slider.value = this.number.value;
        changed(false);
      }
    });
    this.range.addEventListener("change", () => {
      const [first, last] = fromField(this.range.value)
        .split(":")
        .map((part) => parseFloat(part));
      if (Number.isFinite(first) && Number.isFinite(last)) {
        this.slider.min = String(first);
        this.slider.max = String(last);
      }
      changed(true);
    });
    this.element = make(
      "div",
      { class: "slider drive" },
      make("span", { class: "name" }, words),
      this.slider,
      this.number,
      make("span", { class: "unit" }, unit.replace("deg", "°")),
      this.range,
    );
  }
  get value(): number {
    return Number(this.number.value) || 0;
  }
  set value(to: number) {
    this.slider.value = String(to);
    this.number.value = String(Number(to.toPrecision(4)));
  }
  swept(isSwept: boolean, isUsed: boolean): void {
    this.range.hidden = !isSwept;
    this.slider.disabled = this.number.disabled = !isUsed;
    this.element.classList.toggle("unused", !isUsed);
  }
}

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) {
    await choose(place, "kinematics", tr("Kinematics"), "rig", true);
    return;
  }
  const [rig, { entries }, shipped] = await Promise.all([
      api.rig(name),
      api.project(),
      api.library(),
    ]),
    isOwn = name.endsWith(".toml");
  const [earlier, digest, folder] = await Promise.all([
    isOwn ? api.versions(name) : [],
    isOwn ? api.file(name).then((file) => file.digest) : "",
    api.folder(),
  ]);
  if (!place.isConnected) return;
  const before = stored?.rig === name ? stored : null;
  stored = null;
  if (!rig.spatial && !rig.is_dependent) {
    place.replaceChildren(
      make("h1", {}, name),
      make(
        "p",
        { class: "empty" },
        tr("This rig has no hardpoints and therefore no kinematics: "),
        make("a", { href: address("kinematics") }, tr("choose another one")),
        ".",
      ),
    );
    return;
  }
  const isSmall = rig.numbers.some(
    (parameter) => parameter.path === "wheel.radius" && parameter.value < 0.18,
  );
  const hasRack = rig.numbers.some((parameter) =>
    /^hardpoints\.(tie_rod|link_5)_inner\[0\]$/.test(parameter.path),
  );
  const reach = isSmall ? 20 : 50,
    newest = new Newest(),
    times: number[] = [];
  setLive({ times });

  const state = make("p", { class: "state", role: "status" }),
    notes = make("div", {}),
    same = new LiveSnippets(),
    outdated = new Outdated(rig);
  const over = make(
    "select",
    {},
    ...(
      [
        ["travel", tr("wheel travel")],
        ...(hasRack ? [["rack", tr("rack travel")]] : []),
        ["roll", tr("roll of the body")],
      ] as [Over, string][]
    ).map(([value, words]) => make("option", { value }, words)),
  );
  const changed = (isRange: boolean, which: Over) => {
    if (which === over.value && !isRange) pose();
    else void ask();
  };
  const drives: Record<Over, Drive> = {
    travel: new Drive(
      "travel",
      tr("Wheel travel, bump positive"),
      "mm",
      reach,
      reach / 10,
      (isRange) => changed(isRange, "travel"),
    ),
    rack: new Drive(
      "rack",
      tr("Rack travel, to the left positive"),
      "mm",
      isSmall ? 10 : 20,
      isSmall ? 1 : 2,
      (isRange) => changed(isRange, "rack"),
    ),
    roll: new Drive("roll", tr("Roll, left side up positive"), "deg", 4, 0.5, (isRange) =>
      changed(isRange, "roll"),
    ),
  };
  const arrange = () => {
    const now = over.value as Over;
    drives.travel.swept(now === "travel", now !== "roll");
    drives.rack.swept(now === "rack", hasRack);
    drives.roll.swept(now === "roll", now === "roll");
  };
  over.addEventListener("change", () => {
    arrange();
    void ask();
  });
  const isAlike = (entry: { has_hardpoints: boolean; is_dependent: boolean }) =>
    rig.is_dependent ? entry.is_dependent : entry.has_hardpoints;
  const rigs = entries
    .filter((entry) => isAlike(entry) && entry.path !== name)
    .map((entry) => entry.path);
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
      [tr("this project"), rigs.map((rig) => [rig, rig])],
      [tr("shipped"), shipped.filter(isAlike).map((shipped) => [shipped.name, shipped.name])],
    ],
    () => void ask(),
  );
  against.values = given<string[]>(values.get("against") ?? "[]");
  const differing = new Differing();

  const view = new MechanismView(true),
    stage = make("div", { class: "player bare" }, view.element);
  saveDrawing(view.element);
  let swept: Over = "travel",
    centres: Centres | null = null,
    isTurned = true,
    factor = 1,
    last: { low: number; high: number } = { low: 0, high: 0 };
  const centred = toggle(
    tr("centres"),
    true,
    (on) => {
      isTurned = on;
      view.showCentres(on ? centres : null);
    },
    tr("instant centres in front and side view, and the roll centre"),
  );
  if (!rig.is_dependent)
    view.element.querySelector(".bar")!.append(make("div", { class: "group" }, centred));
  const multiples = new Multiples((x) => {
    if (swept === over.value) {
      drives[swept].value = x;
      pose();
    }
  });
  /** Moves the mechanism to a pose of the current sweep, which may not be the requested one yet. */
  const pose = () => {
    const drive = drives[swept];
    const x = Math.min(Math.max(drive.value, last.low), last.high);
    view.set({
      body: 0,
      travel: x * factor,
      ground: ground(x * factor),
      load: 1,
      time: 0,
      roll: swept === "roll" ? (x * Math.PI) / 180 : 0,
    });
    multiples.mark(x);
  };
  let ground = (_: number) => 0;
  const points = rig.numbers
    .map((parameter) => parameter.path)
    .filter((path) =>
      /(ball_joint|tie_rod_(inner|outer)|pivot|shear_centre|link_body|panhard_body)\[2\]/.test(
        path,
      ),
    )
    .slice(0, 4);
  const sliders = new Sliders(
    rig,
    points,
    () => {
      dragged.set(moved());
      void ask();
    },
    before?.changes,
  );
  const moved = () =>
    rig.numbers.map(({ path, value }) => ({ path, value: sliders.changes[path] ?? value }));
  const dragged = new Points(view, (changes) => {
    for (const [path, value] of Object.entries(changes)) sliders.set(path, value);
    void ask();
  });
  dragged.set(moved());

  const pasting = pastePoints(
    () => ({ rig: name, changes: sliders.changes }),
    (changes) => {
      for (const [path, value] of Object.entries(changes)) sliders.set(path, value);
      dragged.set(moved());
      void ask();
    },
  );

  const targets: Target[] = before?.targets ?? [],
    chosen = make(
      "select",
      {},
      make("option", { value: "" }, tr("none")),
      ...entries
        .filter((entry) => entry.kind === "design")
        .map((entry) => make("option", { value: entry.path }, entry.path)),
    );
  chosen.addEventListener("change", () => void ask());
  let quantities: { name: string; unit: string }[] = [];
  const wanted = new Targets(
    targets,
    () => quantities,
    () => over.value as Over,
    () => void ask(),
  );

  const entered = () => ({ changes: sliders.changes, targets });
  const put = (was: ReturnType<typeof entered>) => {
    sliders.reset();
    for (const [path, value] of Object.entries(was.changes)) sliders.take(path, value);
    dragged.set(moved());
    targets.splice(0, targets.length, ...was.targets);
    wanted.list();
    return ask();
  };
  const drafts = new Drafts(
      folder,
      address("kinematics", { rig: name }),
      { changes: {}, targets: [] },
      entered,
      put,
      () => digest,
    ),
    steps = new Steps(entered, put, place);
  const ask = () => {
    drafts.changed();
    steps.changed();
    return asked();
  };
  const asked = () =>
    newest.ask(async () => {
      if (!place.isConnected) return;
      const began = performance.now(),
        now = over.value as Over,
        text = (drive: Drive) =>
          drive.name === now
            ? drive.range.value
            : drive.value
              ? `${drive.value} ${drive.unit}`
              : "";
      const waiting = setTimeout(() => {
        state.textContent = tr(
          "computing; the first run compiles the model, which takes a few seconds",
        );
      }, 500);
      try {
        const store = inWords(
          Store.of(
            await api.curves("kinematics", {
              rig: name,
              changes: sliders.changes,
              over: now,
              against: against.values,
              targets,
              study: chosen.value,
              travel: now === "roll" ? "" : text(drives.travel),
              rack: hasRack ? text(drives.rack) : "",
              roll: now === "roll" ? text(drives.roll) : "",
            }),
          ),
        );
        if (!place.isConnected) return;
        const extra = store.content as unknown as Extra & api.Answer & api.OfRig,
          model = store.content.viewers[0]!,
          scene = model.scenes[0]!,
          x = store.get(scene.x);
        centres = extra.centres;
        swept = now;
        last = { low: x[0] as number, high: x[x.length - 1] as number };
        if (scene.motion) {
          const mechanism = store.content.mechanisms[scene.motion.mechanism]!,
            along = mechanism.travel;
          factor =
            Math.abs(last.high) > 0
              ? along[along.length - 1]! / last.high
              : last.low !== 0
                ? along[0]! / last.low
                : 1;
          ground = (travel) => mechanism.contact[nearest(along, travel)]?.[2] ?? 0;
          view.show(mechanism, scene.motion);
          view.showCentres(isTurned ? centres : null);
        }
        quantities = scene.panes
          .filter((pane) => !pane.name.startsWith("Δ"))
          .map(({ name: one, unit }) => ({ name: one, unit }));
        wanted.offer();
        multiples.show(model, store, extra.targets);
        pose();
        notes.replaceChildren(
          ...extra.notes.map((note) => make("p", { class: "muted" }, asSaid(note))),
        );
        legend.replaceChildren(
          ...(model.roles.length > 1 ? model.roles : []).map(({ role, label }) =>
            make("li", {}, make("i", { class: `swatch ${role}` }), inStyle(label, role)),
          ),
        );
        differing.show(extra.differences);
        same.show(extra);
        outdated.show(extra);
        listed();
        view.draw();
        times.push(performance.now() - began);
        state.textContent =
          tr("# curves computed and drawn", String(quantities.length)) +
          ` ${tr("in")} ${written(times[times.length - 1]!, 2)} ms`;
        state.classList.remove("problem");
      } catch (error) {
        state.textContent = error instanceof Error ? error.message : String(error);
        state.classList.add("problem");
      } finally {
        clearTimeout(waiting);
      }
    });
  const places = make("tbody", {});
  /** Coordinates of all hardpoints as they are moved. */
  const listed = () => {
    const rows = new Map<string, string[]>();
    for (const { path, value } of moved()) {
      const [, own, axis] = /^hardpoints\.(\w+)\[([012])\]$/.exec(path) ?? [];
      if (!own) continue;
      const cells = rows.get(own) ?? ["", "", ""];
      cells[Number(axis)] = localised((1000 * value).toFixed(2));
      rows.set(own, cells);
    }
    places.replaceChildren(
      ...[...rows].map(([own, cells]) => row([part(own), ...cells], [1, 2, 3])),
    );
  };
  const legend = make("ul", { class: "legend" }),
    filter = make("input", { type: "search", placeholder: tr("camber, roll centre …") });
  filter.addEventListener("input", () => multiples.filter(filter.value));
  const writes = new Writing(
    rig,
    () => sliders.changes,
    (changes, asWritten) => {
      if (!place.isConnected) return;
      const inFile = new Map(rig.numbers.map(({ path, value }) => [path, changes[path] ?? value])),
        later = moved().filter(({ path, value }) =>
          path in changes ? asWritten(path, value) !== changes[path] : value !== inFile.get(path),
        );
      stored = {
        rig: name,
        said: tr("Saved. The previous state is under earlier versions."),
        targets,
        changes: Object.fromEntries(later.map(({ path, value }) => [path, value])),
      };
      drafts.drop(); // the page that comes has it all
      dispatchEvent(new HashChangeEvent("hashchange"));
    },
  );
  const saves = savingAs(
    rig,
    () => sliders.changes,
    (path) => {
      if (!place.isConnected) return;
      if (isOwn) {
        writes.say(tr("Saved as #. It is among those to compare with.", path));
        against.add([path, path]);
        return;
      }
      stored = { rig: path, said: tr("Copied into the project."), targets, changes: {} };
      drafts.drop(); // the copy has it all
      goTo(place, "kinematics", { rig: path });
    },
  );
  const design = isOwn
    ? designing(name, rig, targets, sliders, (changes) => {
        for (const [path, value] of Object.entries(changes)) sliders.set(path, value);
        dragged.set(moved());
        void ask();
      })
    : make(
        "div",
        {},
        make(
          "p",
          { class: "muted" },
          tr("To design this rig, copy it into the project, with what is changed here."),
        ),
        saves,
      );
  whenColoursChange(() => view.repaint());
  arrange();
  place.replaceChildren(
    make("h1", {}, tr("Kinematics of #", name)),
    ...(isOwn
      ? [
          make(
            "p",
            { class: "bar" },
            make("a", { href: address("rig", { name }) }, tr("Open its file")),
          ),
        ]
      : []),
    drafts.element,
    make(
      "div",
      { class: "form" },
      field(tr("Curves over"), over),
      against.element,
      ...(rig.is_dependent ? [] : [field(tr("Targets of a study"), chosen)]),
      field(tr("Show curves with"), filter),
      saveChart(multiples.element, () => `${name}: ${tr("kinematics")}`),
    ),
    make(
      "div",
      { class: "sliders drives" },
      ...(["travel", ...(hasRack ? ["rack"] : []), "roll"] as Over[]).map(
        (motion) => drives[motion].element,
      ),
    ),
    outdated.element,
    state,
    notes,
    make(
      "div",
      { class: "beside" },
      make("div", { class: "stuck" }, stage, dragged.element, steps.element, pasting),
      make(
        "div",
        {},
        legend,
        differing.element,
        make(
          "div",
          { class: "scrolled", tabindex: "0", role: "region", "aria-label": tr("curves") },
          multiples.element,
        ),
      ),
    ),
    make("h2", {}, tr("Parameters")),
    sliders.element,
    ...(isOwn ? [writes.element, saves] : []),
    make("h2", {}, tr("Hardpoints")),
    table(
      tr("Hardpoints"),
      ["hardpoint", "x [mm]", "y [mm]", "z [mm]"],
      places,
      [1, 2, 3],
      tr("x forward, y left, z up; with the changes of this page"),
    ),
    ...(rig.is_dependent
      ? [
          make("h2", {}, tr("K&C")),
          make(
            "p",
            { class: "muted" },
            tr("Targets of such an axle are rows of its K&C sheet, in a study: "),
            make("a", { href: address("kc", { rig: name }) }, tr("Show its K&C")),
            ".",
          ),
        ]
      : [
          make("h2", {}, tr("Targets")),
          wanted.element,
          make("h2", {}, tr("Design from targets")),
          design,
        ]),
    same.element,
  );
  if (before) writes.say(before.said);
  await ask();
}

function nearest(grid: number[], value: number): number {
  let best = 0;
  grid.forEach((sample, i) => {
    if (Math.abs(sample - value) < Math.abs(grid[best]! - value)) best = i;
  });
  return best;
}

/** Editor of targets: quantity, value, place and tolerance. */
class Targets {
  readonly element = make("div", {});
  private readonly quantity = make("select", {});
  private readonly rows = make("tbody", {});
  private readonly adds = make("button", { type: "submit", disabled: true }, tr("Add the target")); // until there is a quantity
  private known = "";
  constructor(
    private readonly targets: Target[],
    private readonly quantities: () => { name: string; unit: string }[],
    along: () => Over,
    private readonly changed: () => void,
  ) {
    const how = make(
      "select",
      {},
      ...(
        [
          ["value", "="],
          ["at_least", "≥"],
          ["at_most", "≤"],
        ] as const
      ).map(([value, words]) =>
        make("option", { value, title: tr(value.replace("_", " ")) }, words),
      ),
    );
    const value = textBox("0 deg"),
      tolerance = textBox("0.1 deg"),
      where = textBox("-20 mm:20 mm:10 mm");
    const unit = () => {
      const quantity = this.quantities().find((quantity) => quantity.name === this.quantity.value);
      if (quantity) {
        const text = quantity.unit.replace("°", "deg");
        value.value = `0 ${text}`.trim();
        tolerance.value = inField(`${text.endsWith("/m") ? 1 : 0.1} ${text}`.trim()); // 1 deg/m is 0.1 deg in 100 mm
        for (const box of [value, tolerance]) box.dispatchEvent(new Event("change"));
      }
    };
    this.quantity.addEventListener("change", unit);
    const add = make(
      "form",
      { class: "form" },
      field(tr("Quantity"), this.quantity),
      field(tr("Condition"), how),
      field(tr("Value"), value),
      field(tr("Tolerance"), tolerance),
      field(tr("At a value, or over first:last:step"), where),
      this.adds,
    );
    add.addEventListener("submit", (event) => {
      event.preventDefault();
      targets.push({
        quantity: this.quantity.value,
        [how.value]: value.value,
        tolerance: tolerance.value,
        ...(where.value.includes(":")
          ? { over: where.value }
          : where.value
            ? { at: where.value }
            : {}),
        ...(where.value && along() === "rack" ? { along: "rack" } : {}),
      });
      this.list();
      changed();
    });
    this.element.append(make("div", { class: "table" }, make("table", {}, this.rows)), add);
    this.list();
  }
  /** Offers the quantities of the curves. */
  offer(): void {
    const names = this.quantities().map((quantity) => quantity.name);
    if (names.join() === this.known) return;
    this.known = names.join();
    const before = this.quantity.value;
    this.quantity.replaceChildren(
      ...names.map((name) => make("option", { value: name }, quantity(name))),
    );
    if (names.includes(before)) this.quantity.value = before;
    this.adds.disabled = !names.length;
  }
  list(): void {
    this.rows.replaceChildren(
      ...(this.targets.length
        ? this.targets.map((target, i) =>
            make(
              "tr",
              {},
              make("th", { scope: "row" }, quantity(target.quantity)),
              make(
                "td",
                {},
                target.value !== undefined
                  ? `= ${target.value} ± ${target.tolerance}`
                  : target.at_least !== undefined
                    ? `≥ ${target.at_least} − ${target.tolerance}`
                    : `≤ ${target.at_most} + ${target.tolerance}`,
              ),
              make(
                "td",
                {},
                `${target.over ?? target.at ?? tr("at design")}${target.along ? ` (${tr("rack travel")})` : ""}`,
              ),
              make(
                "td",
                {},
                make(
                  "button",
                  {
                    type: "button",
                    "aria-label": tr("Remove #", target.quantity),
                    click: () => {
                      this.targets.splice(i, 1);
                      this.list();
                      this.changed();
                    },
                  },
                  "×",
                ),
              ),
            ),
          )
        : [
            make(
              "tr",
              {},
              make(
                "td",
                { class: "muted" },
                tr("No targets yet. Add one; its tolerance band appears in the curve."),
              ),
            ),
          ]),
    );
  }
}
