/** Files of the folder, next steps, copying a first rig, and saved runs. */

import { Store } from "../../data";
import { make, written } from "../../page";
import { tr } from "../../words";
import * as api from "../api";
import { savable } from "../curves";
import { discard, draftsOf, type Lying, moment } from "../drafts";
import { files } from "../files";
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
  const choice = make(
    "select",
    {},
    ...library.map((one) => make("option", { value: one.name }, `${one.name} (${kindOf(one)})`)),
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
    next(entries, kept, jobs),
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
    gallery(library, (one) => [
      make(
        "button",
        {
          type: "button",
          "aria-label": `${tr("choose")}: ${one.name}`,
          click: () => {
            choice.value = one.name;
            choice.dispatchEvent(new Event("change"));
            target.focus();
            target.select();
          },
        },
        tr("choose"),
      ),
      make("a", { href: address("trial", { rig: one.name }) }, tr("drive")),
    ]),
    ...(kept.length ? [make("h2", {}, tr("Saved runs")), history(kept)] : []),
  );
}

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

/** Suggested next steps. */
function next(entries: api.Entry[], kept: Kept[], jobs: Begun[]): HTMLElement {
  const of = (kind: string) => entries.filter((one) => one.kind === kind),
    [rig] = of("rig"),
    record = of("record").find((one) => !kept.some(({ path }) => path === one.path));
  const steps: HTMLElement[] = [];
  for (const { path } of of("campaign")) {
    const isRun =
      jobs.some((job) => job.asked?.campaign === path) ||
      of("results").some((one) => one.path.startsWith(path.replace(/[^/]*$/, "results")));
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
  if (!rig)
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
  else {
    if (!kept.length)
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
    if (kept.length === 1)
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
function history(kept: Kept[]): HTMLElement {
  const boxes = kept.map((one, i) =>
      make("input", { type: "checkbox", "aria-label": tr("compare #", one.path), checked: i < 2 }),
    ),
    out = make("div", {});
  const compare = make("button", { type: "button" }, tr("Compare selected runs"));
  const short = (digest: string) => make("code", { title: digest }, digest.slice(0, 8));
  compare.addEventListener("click", () => {
    const paths = kept
      .filter((_, i) => boxes[i]!.checked)
      .map((one) => one.path)
      .slice(0, 6);
    if (!paths.length) {
      out.replaceChildren(make("p", { class: "muted" }, tr("Select at least one run.")));
      return;
    }
    once(compare, api.binary("/api/compare", { paths })).then(
      (answer) => {
        const store = inWords(Store.of(answer));
        out.replaceChildren(
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
        ...kept.map((one, i) =>
          make(
            "tr",
            {},
            make("td", {}, boxes[i]!),
            make(
              "th",
              { scope: "row" },
              make(
                "a",
                { href: address("record", { path: one.path }) },
                one.path.replace(/^runs\//, ""),
              ),
            ),
            make("td", {}, one.rig),
            make(
              "td",
              {},
              Object.entries(one.changes)
                .map(
                  ([path, value]) =>
                    `${path} = ${typeof value === "number" ? written(value, 5) : value}`,
                )
                .join(", ") || "–",
            ),
            make("td", {}, road(one)),
            make("td", {}, short(one.rig_digest), " ", short(one.trial_digest)),
            make("td", {}, one.seed === null ? "–" : String(one.seed)),
            make("td", {}, one.version),
            make("td", {}, moment(1000 * one.when)),
          ),
        ),
      ),
    ),
    make("p", { class: "bar" }, compare),
    out,
  );
}
