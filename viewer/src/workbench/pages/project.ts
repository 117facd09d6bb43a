/** Files of the folder, next steps, copying a first rig, and saved runs. */

import { Store } from "../../data";
import { make, written } from "../../page";
import { tr } from "../../words";
import * as api from "../api";
import { Against, type Differences, Differing } from "../comparing";
import { savable } from "../curves";
import { discard, draftsOf, type Lying, moment } from "../drafts";
import { files } from "../files";
import { choosers } from "../incoming";
import { field, once, problem, snippets } from "../parts";
import { inWords } from "../quantities";
import { address, goTo } from "../shell";
import { gallery, kindOf } from "../shipped";
import { table } from "../table";

interface Kept {
  path: string;
  rig: string;
  changes: Record<string, number | string>;
  trial: { road: Record<string, string>; speed: string; duration: string };
  seed: number | null;
  version: string;
  rig_digest: string;
  trial_digest: string;
  when: number;
}

/** A job, as far as it says what it was begun with. */
interface Begun {
  asked: Record<string, unknown> | null;
}

/** Labels of the pages with unsaved changes. */
const LABELS: Record<string, string> = {
  rig: "Rig",
  kinematics: "Kinematics",
  kc: "K&C",
  campaign: "Campaign",
  ride: "Ride and control",
  inspection: "Inspection",
  studies: "Studies",
};
export async function show(place: HTMLElement): Promise<void> {
  const [{ name, folder, entries }, library, kept, jobs] = await Promise.all([
    api.project(),
    api.library(),
    api.get<Kept[]>("/api/history"),
    api.get<Begun[]>("/api/jobs"),
  ]);
  document.getElementById("project")!.textContent = name;
  const rig = await usable(entries);
  if (!place.isConnected) return;
  const choice = make(
    "select",
    {},
    ...library.map((shippedRig) =>
      make("option", { value: shippedRig.name }, `${shippedRig.name} (${kindOf(shippedRig)})`),
    ),
  );
  const target = make("input", {
    type: "text",
    value: `${library[0]?.name ?? "rig"}.toml`,
    spellcheck: "false",
  });
  choice.addEventListener("change", () => {
    target.value = `${choice.value}.toml`;
  });
  const status = make("div", { "aria-live": "polite" });
  const copy = make("button", { type: "submit", class: "main" }, tr("Copy into this project"));
  const form = make(
    "form",
    { class: "form" },
    field(tr("Shipped rig"), choice),
    field(tr("Name of your file"), target),
    copy,
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    once(copy, api.start(choice.value, target.value)).then(
      (made) => goTo(place, "rig", { name: made.path }),
      (error) => status.replaceChildren(problem(error)),
    );
  });
  place.replaceChildren(
    make("h1", {}, name),
    make("p", { class: "muted" }, folder),
    unsaved(draftsOf(folder)),
    next(entries, kept, jobs, rig),
    make(
      "p",
      { class: "muted" },
      tr("Drop measured files, rigs or roads anywhere on a page, or choose them:"),
    ),
    choosers(),
    entries.length
      ? files(folder, entries)
      : make(
          "p",
          { class: "empty" },
          tr(
            "This project has no rigs, roads or records yet. Start from a rig shipped with jounce, or copy your files into the folder.",
          ),
        ),
    make("h2", {}, tr("Start from an example")),
    form,
    status,
    gallery(library, (shipped) => [
      make(
        "button",
        {
          type: "button",
          "aria-label": `${tr("choose")}: ${shipped.name}`,
          click: () => {
            choice.value = shipped.name;
            choice.dispatchEvent(new Event("change"));
            target.focus();
            target.select();
          },
        },
        tr("choose"),
      ),
      shipped.is_dependent
        ? make("a", { href: address("kc", { rig: shipped.name }) }, tr("K&C"))
        : make("a", { href: address("trial", { rig: shipped.name }) }, tr("drive")),
    ]),
    ...(kept.length ? [make("h2", {}, tr("Saved runs")), history(kept)] : []),
    ...comparison(entries, kept, library),
  );
}

const MOST_RUNS = 7; // curves: as many as there are colours
const MOST_FILES = 20;
const MOST_OTHERS = 5; // beside a rig that may be changed

/** Rigs, campaigns and runs in a table of what differs, with links to their curves. */
function comparison(
  entries: api.Entry[],
  savedRuns: Kept[],
  library: { name: string; has_hardpoints: boolean }[],
): HTMLElement[] {
  const of = (...kinds: string[]) =>
    entries
      .filter(({ kind }) => kinds.includes(kind))
      .map(({ path }): [string, string] => [path, path]);
  const corners = new Set(
    [...entries.map((entry) => ({ ...entry, name: entry.path })), ...library]
      .filter((one) => one.has_hardpoints)
      .map((one) => one.name),
  );
  const runs = new Set(savedRuns.map(({ path }) => path)),
    rigs = new Set([
      ...of("rig", "vehicle").map(([path]) => path),
      ...library.map((shippedRig) => shippedRig.name),
    ]);
  const differing = new Differing(true),
    out = make("div", { "aria-live": "polite" });
  const compare = async () => {
    const names = chosen.values,
      [first, ...others] = names;
    if (!first || !others.length) {
      differing.show(null);
      out.replaceChildren(make("p", { class: "muted" }, tr("Choose at least two.")));
      return;
    }
    try {
      const found = await differences(names);
      if (chosen.values.join("\n") !== names.join("\n")) return; // others were chosen meanwhile
      differing.show(found);
      const link = (page: string, rig: string, words: string) => {
        const against = JSON.stringify(names.filter((name) => name !== rig));
        return make("a", { href: address(page, { rig, against }) }, tr(words));
      };
      const links =
        names.length > MOST_OTHERS + 1
          ? []
          : [
              ...(names.every((name) => corners.has(name))
                ? [link("kinematics", first, "Compare their kinematics")]
                : []),
              ...(names.every((name) => rigs.has(name) || runs.has(name)) && rigs.has(first)
                ? [link("trial", first, "Drive them over one obstacle")]
                : []),
            ];
      out.replaceChildren(
        ...(links.length ? [make("p", { class: "bar" }, ...links)] : []),
        ...(found.python ? [snippets(found)] : []),
      );
    } catch (error) {
      differing.show(null);
      out.replaceChildren(problem(error));
    }
  };
  const groups: [string, [string, string][]][] = [
    [tr("this project"), of("rig", "vehicle")],
    [tr("saved runs"), savedRuns.map(({ path }) => [path, path.replace(/^runs\//, "")])],
    [tr("campaigns"), of("campaign")],
    [
      tr("results of campaigns"),
      of("results").filter(
        ([path]) => /(^|\/)results\.json$/.test(path) && !/^designs\//.test(path),
      ),
    ],
    [tr("shipped"), library.map(({ name }) => [name, name])],
  ];
  const chosen = new Against(
    tr("Rigs, runs, campaigns or results"),
    groups,
    () => void compare(),
    MOST_FILES,
  );
  return [
    make("h2", {}, tr("Compare files and runs")),
    make("div", { class: "form" }, chosen.element),
    differing.element,
    out,
  ];
}

const differences = async (names: string[]) =>
  (await (await api.asked("POST", "/api/differences", { names })).json()) as Differences &
    api.Answer;

/** Unsaved changes of other pages. */
function unsaved(drafts: Lying[]): HTMLElement {
  const section = make("section", {
    class: "drafts",
    hidden: !drafts.length,
    tabindex: "-1",
    "aria-label": tr("Unsaved changes"),
  });
  section.append(
    make("h2", {}, tr("Unsaved changes")),
    make(
      "ul",
      {},
      ...drafts.map(({ key, page, at }) => {
        const [name = "", values] = page.replace(/^#\//, "").split("?"),
          file = [...new URLSearchParams(values).values()][0] ?? "",
          words = [tr(LABELS[name] ?? name), file].filter(Boolean).join(": ");
        const away = make(
            "button",
            { type: "button", "aria-label": `${tr("Discard")}: ${words}` },
            tr("Discard"),
          ),
          row = make("li", {}, make("a", { href: page }, words), `, ${moment(at)} `, away);
        away.addEventListener("click", () => {
          discard(key);
          row.remove();
          section.focus();
          section.hidden = !section.querySelector("li");
        });
        return row;
      }),
    ),
  );
  return section;
}

/** The first rig that can be simulated, and those before it that are invalid. */
interface Usable {
  rig: api.Entry | null;
  broken: string[];
}
async function usable(entries: api.Entry[]): Promise<Usable> {
  const broken: string[] = [];
  for (const rig of entries
    .filter((entry) => entry.kind === "rig" && !entry.is_dependent)
    .slice(0, MOST_TRIED)) {
    try {
      await api.rig(rig.path);
      return { rig, broken };
    } catch {
      broken.push(rig.path);
    }
  }
  return { rig: null, broken };
}
const MOST_TRIED = 5;

/** Suggested next steps. */
function next(
  entries: api.Entry[],
  savedRuns: Kept[],
  jobs: Begun[],
  { rig, broken }: Usable,
): HTMLElement {
  const of = (kind: string) => entries.filter((entry) => entry.kind === kind),
    record = of("record").find((entry) => !savedRuns.some(({ path }) => path === entry.path));
  const steps: HTMLElement[] = [];
  for (const { path } of of("campaign")) {
    const isRun =
      jobs.some((job) => job.asked?.campaign === path) ||
      of("results").some((entry) => entry.path.startsWith(path.replace(/[^/]*$/, "results")));
    if (!isRun)
      steps.push(
        make(
          "li",
          {},
          make("a", { href: address("campaign", { file: path }) }, tr("Run #", path)),
          tr(": characterise the parts, update the model and compare every trial."),
        ),
      );
  }
  for (const path of broken)
    steps.push(
      make(
        "li",
        {},
        make("a", { href: address("rig", { name: path }) }, tr("Correct #", path)),
        tr(": it cannot be read as a rig."),
      ),
    );
  if (!rig && !broken.length)
    steps.push(
      make("li", {}, tr("Start from a shipped rig (below).")),
      make(
        "li",
        {},
        make(
          "a",
          { href: address("campaign") },
          tr("Start from an example campaign that is ready to run"),
        ),
        ".",
      ),
    );
  else if (rig) {
    if (!savedRuns.length)
      steps.push(
        make(
          "li",
          {},
          make(
            "a",
            { href: address("trial", { rig: rig.path }) },
            tr("Drive # over an obstacle", rig.path),
          ),
          tr(" and save the run."),
        ),
      );
    if (savedRuns.length === 1)
      steps.push(
        make(
          "li",
          {},
          make(
            "a",
            { href: address("trial", { rig: rig.path }) },
            tr("Change # and save another run", rig.path),
          ),
          tr(" to compare the two."),
        ),
      );
    if (record && !of("campaign").length)
      steps.push(
        make(
          "li",
          {},
          make(
            "a",
            { href: address("trial", { rig: rig.path, record: record.path }) },
            tr("Compare # with a simulation", record.path),
          ),
          ".",
        ),
      );
    if (!of("sweep").length && !of("swept").length)
      steps.push(
        make(
          "li",
          {},
          make("a", { href: address("studies") }, tr("Vary its parameters in a study")),
          ".",
        ),
      );
  }
  return steps.length
    ? make(
        "section",
        { class: "next", "aria-label": tr("Next steps") },
        make("h2", {}, tr("Next steps")),
        make("ul", {}, ...steps),
      )
    : make("section", { hidden: true });
}

/** Saved runs with their inputs; selected ones are overlaid. */
function history(savedRuns: Kept[]): HTMLElement {
  const boxes = savedRuns.map((savedRun, i) =>
      make("input", {
        type: "checkbox",
        "aria-label": tr("compare #", savedRun.path),
        checked: i < 2,
      }),
    ),
    out = make("div", {}),
    differing = new Differing(true);
  const compare = make("button", { type: "button" }, tr("Compare selected runs"));
  const short = (digest: string) => make("code", { title: digest }, digest.slice(0, 8));
  compare.addEventListener("click", () => {
    const paths = savedRuns.filter((_, i) => boxes[i]!.checked).map((savedRun) => savedRun.path);
    if (!paths.length || paths.length > MOST_RUNS) {
      const words = paths.length
        ? tr("Select at most # runs: more curves cannot be told apart.", String(MOST_RUNS))
        : tr("Select at least one run.");
      out.replaceChildren(make("p", { class: "muted" }, words));
      return;
    }
    once(compare, api.binary("/api/compare", { paths })).then(
      (answer) => {
        const store = inWords(Store.of(answer));
        const listed = make("div", {});
        void (paths.length > 1 ? differences(paths) : Promise.resolve(null)).then(
          (found) => {
            differing.show(found);
            listed.replaceChildren(differing.element);
          },
          (error) => listed.replaceChildren(problem(error)),
        );
        out.replaceChildren(
          listed,
          savable(store.content.viewers[0]!, store).element,
          snippets(store.content as unknown as api.Answer),
        );
      },
      (error) => out.replaceChildren(problem(error)),
    );
  });
  const road = ({ trial }: Kept) =>
    `${tr(String(trial.road.kind ?? "").replace("-", " "))} ${Object.entries(trial.road)
      .filter(([key]) => !["kind", "start"].includes(key))
      .map(([, value]) => value)
      .join(" × ")}, ${trial.speed}`;
  return make(
    "section",
    {},
    table(
      "Saved runs",
      [
        make("span", { class: "hidden" }, tr("compare")),
        "run",
        "rig",
        "changes",
        "trial",
        "inputs",
        "seed",
        "version",
        "saved",
      ],
      make(
        "tbody",
        {},
        ...savedRuns.map((savedRun, i) =>
          make(
            "tr",
            {},
            make("td", {}, boxes[i]!),
            make(
              "th",
              { scope: "row" },
              make(
                "a",
                { href: address("record", { path: savedRun.path }) },
                savedRun.path.replace(/^runs\//, ""),
              ),
            ),
            make("td", {}, savedRun.rig),
            make(
              "td",
              {},
              Object.entries(savedRun.changes)
                .map(
                  ([path, value]) =>
                    `${path} = ${typeof value === "number" ? written(value, 5) : value}`,
                )
                .join(", ") || "–",
            ),
            make("td", {}, road(savedRun)),
            make("td", {}, short(savedRun.rig_digest), " ", short(savedRun.trial_digest)),
            make("td", {}, savedRun.seed === null ? "–" : String(savedRun.seed)),
            make("td", {}, savedRun.version),
            make("td", {}, moment(1000 * savedRun.when)),
          ),
        ),
      ),
    ),
    make("p", { class: "bar" }, compare),
    out,
  );
}
