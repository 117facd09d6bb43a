/** The workbench: pages over one folder. Nothing is computed here; all curves and verdicts come from the server. */

import "uplot/dist/uPlot.min.css";
import "../../../src/jounce/report/templates/colours.css";
import "../viewer.css";
import "./workbench.css";
import { make, themeButton, written } from "../page";
import * as api from "./api";
import { field, Live, problem, Sliders } from "./parts";

type Values = URLSearchParams;
const PAGES: Record<string, { label: string; show: (place: HTMLElement, values: Values) => Promise<void> }> = {
  project: { label: "Project", show: showProject },
  rig: { label: "Rig", show: showRig },
  trial: { label: "Trial", show: showTrial },
  kinematics: { label: "Kinematics", show: showKinematics },
};
const RIGS = ["rig"];
/** The live curves of this page, for whoever measures them. */
export let live: Live | null = null;

const address = (page: string, values: Record<string, string> = {}) => `#/${page}?${new URLSearchParams(values)}`;

async function showProject(place: HTMLElement): Promise<void> {
  const [{ name, folder, entries }, library] = await Promise.all([api.project(), api.library()]);
  document.getElementById("project")!.textContent = name;
  const rows = entries.map((entry) => make("tr", {},
    make("th", { scope: "row" }, entry.kind === "rig" ? make("a", { href: address("rig", { name: entry.path }) }, entry.path) : entry.path),
    make("td", {}, entry.kind), make("td", { class: "right" }, `${written(entry.size / 1000, 3)} kB`),
    make("td", {}, new Date(entry.modified * 1000).toISOString().slice(0, 16).replace("T", " ")),
    make("td", {}, ...(RIGS.includes(entry.kind) ? [make("a", { href: address("trial", { rig: entry.path }) }, "drive it")] : []))));
  const choice = make("select", {}, ...library.map((one) => make("option", { value: one.name }, one.name)));
  const target = make("input", { type: "text", value: `${library[0]?.name ?? "rig"}.toml`, spellcheck: "false" });
  choice.addEventListener("change", () => { target.value = `${choice.value}.toml`; });
  const told = make("div", { "aria-live": "polite" });
  const copy = make("button", { type: "submit", class: "main" }, "Copy it here");
  const form = make("form", { class: "form" }, field("Shipped rig", choice), field("Name of your file", target), copy);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    api.start(choice.value, target.value).then((made) => { location.hash = address("rig", { name: made.path }); }, (error) => told.replaceChildren(problem(error)));
  });
  place.replaceChildren(
    make("h1", {}, name), make("p", { class: "muted" }, folder),
    entries.length
      ? make("div", { class: "table", tabindex: "0", role: "region", "aria-label": "files" }, make("table", {}, make("thead", {}, make("tr", {}, ...["file", "what it is", "size", "written (UTC)", ""].map((text) => make("th", { scope: "col" }, text)))), make("tbody", {}, ...rows)))
      : make("p", { class: "empty" }, "No rigs, roads or records lie here yet. Start from a rig that comes with jounce, or put your files into the folder."),
    make("h2", {}, "Start from an example"), form, told);
}

async function showRig(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("name");
  if (!name) { await choose(place, "rig", "name"); return; }
  let saved = await api.file(name);
  const text = make("textarea", { spellcheck: "false", "aria-label": `text of ${name}`, rows: "24" });
  text.value = saved.text;
  const told = make("div", { class: "told", "aria-live": "polite" }), numbers = make("div", {});
  const save = make("button", { type: "button", class: "main", disabled: true }, "Save"), undo = make("button", { type: "button", disabled: true }, "Undo all");
  const changed = () => { save.disabled = undo.disabled = text.value === saved.text; };
  text.addEventListener("input", changed);
  undo.addEventListener("click", () => { text.value = saved.text; changed(); });
  const look = async () => {
    const found = await api.check(name);
    told.replaceChildren(...(found.problems.length ? found.problems.map(problem) : [make("p", { class: "good" }, `${found.what}: nothing is wrong with it.`)]), ...found.notes.map((note) => make("p", {}, note)));
    if (found.problems.length) { numbers.replaceChildren(); return; }
    const rig = await api.rig(name);
    numbers.replaceChildren(make("h2", {}, "Numbers"), make("div", { class: "table", tabindex: "0", role: "region", "aria-label": "numbers" }, make("table", {},
      make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "path"), make("th", { scope: "col", class: "right" }, "value"), make("th", { scope: "col" }, "unit"))),
      make("tbody", {}, ...rig.numbers.map((one) => make("tr", {}, make("th", { scope: "row" }, one.path), make("td", { class: "right" }, written(one.value * one.factor)), make("td", {}, one.unit || "–")))))));
  };
  save.addEventListener("click", () => {
    api.save(name, text.value, saved.digest).then(async (made) => { saved = made; changed(); await look(); }, (error) => told.replaceChildren(problem(error)));
  });
  place.replaceChildren(make("h1", {}, name),
    make("p", { class: "bar" }, make("a", { href: address("trial", { rig: name }) }, "Drive it over an obstacle"), make("a", { href: address("kinematics", { rig: name }) }, "Look at its kinematics")),
    told, make("div", { class: "bar" }, save, undo), text, numbers);
  await look();
}

/** Rigs to choose from, where none was. */
async function choose(place: HTMLElement, page: string, key: string, shipped = false): Promise<void> {
  const { entries } = await api.project();
  const names = [...entries.filter((entry) => RIGS.includes(entry.kind)).map((entry) => entry.path), ...(shipped ? (await api.library()).map((one) => one.name) : [])];
  place.replaceChildren(make("h1", {}, PAGES[page]!.label), names.length
    ? make("ul", {}, ...names.map((name) => make("li", {}, make("a", { href: address(page, { [key]: name }) }, name))))
    : make("p", { class: "empty" }, "No rig lies here yet: ", make("a", { href: address("project") }, "start from an example"), "."));
}

const OBSTACLES: Record<string, string[]> = {
  "half-sine": ["height", "length"], versine: ["height", "length"], rectangle: ["height", "length"], triangle: ["height", "length"], step: ["height"], pothole: ["depth", "length"],
};
const USUAL: Record<string, string> = { height: "10 mm", depth: "10 mm", length: "60 mm" };
const FIRST = ["strut.spring.rate", "strut.damper.coefficient", "strut.damper.bump_coefficient", "strut.damper.rebound_coefficient", "tyre.stiffness", "sprung.mass", "unsprung.mass"];

async function showTrial(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) { await choose(place, "trial", "rig", true); return; }
  const rig = await api.rig(name);
  const kind = make("select", {}, ...Object.keys(OBSTACLES).map((one) => make("option", { value: one }, one.replace("-", " "))));
  const sizes = make("span", { class: "sizes" });
  const speed = make("input", { type: "text", value: rig.name.includes("kart") ? "1.95 m/s" : "30 km/h" }), duration = make("input", { type: "text", value: "1.5 s" });
  const offered = () => sizes.replaceChildren(...OBSTACLES[kind.value]!.map((one) => {
    const input = make("input", { type: "text", value: USUAL[one]!, name: one });
    input.addEventListener("change", () => void curves.ask());
    return field(one[0]!.toUpperCase() + one.slice(1), input);
  }));
  const sliders = new Sliders(rig, FIRST, () => void curves.ask());
  const curves = new Live(() => api.curves("simulate", {
    rig: name, changes: sliders.changes, speed: speed.value, duration: duration.value,
    road: { kind: kind.value, start: "0.2 m", ...Object.fromEntries([...sizes.querySelectorAll("input")].map((one) => [one.name, one.value])) },
  }));
  kind.addEventListener("change", () => { offered(); void curves.ask(); });
  for (const one of [speed, duration]) one.addEventListener("change", () => void curves.ask());
  offered();
  live = curves;
  place.replaceChildren(make("h1", {}, `${name} over an obstacle`),
    make("div", { class: "form" }, field("Obstacle", kind), sizes, field("Speed", speed), field("Duration", duration)), sliders.element, curves.element);
  await curves.ask();
}

async function showKinematics(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) { await choose(place, "kinematics", "rig", true); return; }
  const rig = await api.rig(name);
  if (!rig.spatial) { place.replaceChildren(make("h1", {}, name), make("p", { class: "empty" }, "This rig has no hardpoints, and so no kinematics: ", make("a", { href: address("kinematics") }, "choose another one"), ".")); return; }
  const travel = make("input", { type: "text", value: rig.name.includes("kart") ? "-20 mm:20 mm:2 mm" : "-50 mm:50 mm:5 mm" });
  const points = rig.numbers.map((one) => one.path).filter((path) => /ball_joint\[2\]|tie_rod_(inner|outer)\[2\]/.test(path)).slice(0, 4);
  const sliders = new Sliders(rig, points, () => void curves.ask());
  const curves = new Live(() => api.curves("kinematics", { rig: name, changes: sliders.changes, travel: travel.value }));
  travel.addEventListener("change", () => void curves.ask());
  live = curves;
  place.replaceChildren(make("h1", {}, `Kinematics of ${name}`), make("div", { class: "form" }, field("Travel, bump positive (first:last:step)", travel)), sliders.element, curves.element);
  await curves.ask();
}

async function show(): Promise<void> {
  const [page = "", values = ""] = location.hash.replace(/^#\//, "").split("?");
  const chosen = page in PAGES ? page : "project";
  live = null;
  const place = document.getElementById("main")!;
  document.querySelectorAll("#pages a").forEach((link) => {
    if ((link as HTMLAnchorElement).dataset.page === chosen) link.setAttribute("aria-current", "page"); else link.removeAttribute("aria-current");
  });
  document.title = `${PAGES[chosen]!.label} – jounce workbench`;
  place.replaceChildren(make("p", { class: "muted" }, "loading …"));
  try {
    await PAGES[chosen]!.show(place, new URLSearchParams(values));
  } catch (error) {
    place.replaceChildren(make("h1", {}, PAGES[chosen]!.label), problem(error), make("p", {}, make("a", { href: address("project") }, "Back to the project")));
  }
  document.documentElement.dataset.ready = chosen;
}

document.documentElement.classList.add("live");
document.getElementById("pages")!.append(...Object.entries(PAGES).map(([page, { label }]) => make("a", { href: address(page), "data-page": page }, label)));
document.querySelector("header")!.append(themeButton());
addEventListener("hashchange", () => { delete document.documentElement.dataset.ready; void show(); });
api.project().then(({ name }) => { document.getElementById("project")!.textContent = name; }, () => {});
void show();
