/** What lies in the folder, and the way to a first rig. */

import { make, written } from "../../page";
import * as api from "../api";
import { field, problem } from "../parts";
import { address, type Page, RIGS } from "../shell";

export const project: Page = { label: "Project", show };

async function show(place: HTMLElement): Promise<void> {
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
