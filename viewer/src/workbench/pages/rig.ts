/** A rig as text, what is wrong with it, and its numbers. */

import { make, written } from "../../page";
import * as api from "../api";
import { problem } from "../parts";
import { address, choose, type Page, type Values } from "../shell";

export const rig: Page = { label: "Rig", show };

async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("name");
  if (!name) { await choose(place, "rig", "Rig", "name"); return; }
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
