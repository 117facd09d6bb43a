/** A rig: its form and its text in step, its mechanism with hardpoints that are dragged, what a save would change. */

import { Store } from "../../data";
import { MechanismView } from "../../mechanism";
import { make, whenColoursChange } from "../../page";
import { tr } from "../../words";
import * as api from "../api";
import { Form, type Key, type Value } from "../form";
import { InTurn, Newest, once, problem } from "../parts";
import { Points } from "../points";
import { address, choose, type Page, type Values } from "../shell";
import { asSaid } from "../refusals";

export const rig: Page = { label: "Rig", show };

async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("name");
  if (!name) { await choose(place, "rig", tr("Rig"), "name"); return; }
  let saved = await api.file(name), state: api.Form | null = null;
  const past: string[] = [], future: string[] = [];
  const text = make("textarea", { spellcheck: "false", "aria-label": tr("text of #", name), rows: "28" });
  text.value = saved.text;
  let shown = saved.text; // what the form shows
  const told = make("div", { class: "told", "aria-live": "polite" }), difference = make("div", {});
  const save = make("button", { type: "button", class: "main", disabled: true }, tr("Save")), undo = make("button", { type: "button", disabled: true }, tr("Undo")), redo = make("button", { type: "button", disabled: true }, tr("Redo"));
  const edits = new InTurn((error) => told.replaceChildren(problem(error))), pictures = new Newest();
  let drawing = Promise.resolve();
  const form = new Form((keys: Key[], value: Value) => void edit({ sets: [[keys, value]] }));
  const view = new MechanismView(true), stage = make("div", { class: "player bare", hidden: true }, view.element);
  const points = new Points(view, (changes, done) => { if (done) void edit({ changes }); else void draw(changes); });
  const picture = make("section", { hidden: true, "aria-label": tr("The mechanism") }, make("h2", {}, tr("The mechanism")), make("p", { class: "muted" }, tr("Drag a hardpoint, or choose it and type its place; drag beside them to turn the picture.")), points.element, stage);

  const buttons = () => { save.disabled = text.value === saved.text; undo.disabled = !past.length; redo.disabled = !future.length; };
  const draw = (changes: Record<string, number> = {}) => pictures.ask(async () => {
    if (!state?.rig?.spatial) return;
    try {
      const store = Store.of(await api.curves("kinematics", { rig: name, text: text.value, changes, travel: "-20 mm:20 mm:10 mm", channels: ["camber"] }));
      const motion = store.content.viewers[0]!.scenes[0]!.motion;
      if (!motion) return;
      picture.hidden = stage.hidden = false;
      view.show(store.content.mechanisms[motion.mechanism]!, motion);
      view.set({ body: 0, travel: 0, ground: store.content.mechanisms[motion.mechanism]!.contact[2]![2]!, load: 1, time: 0 });
    } catch (error) { told.replaceChildren(problem(error)); }
  });
  const take = async (found: api.Form, isNew: boolean) => {
    if (isNew && found.text !== shown) { past.push(shown); future.length = 0; }
    shown = found.text;
    if (text.value !== found.text) text.value = found.text;
    state = found;
    buttons();
    if (found.model) {
      try { form.show(await api.schema(found.model), found.values as { [key: string]: Value }, found.problems); } catch { form.element.replaceChildren(); }
    }
    const all = found.problems.map((one) => problem(new Error(`${one.line ? `${tr("line #", String(one.line))}: ` : ""}${one.path ? `${one.path}: ` : ""}${one.text}`)));
    told.replaceChildren(...(all.length ? all : [make("p", { class: "good" }, tr("#: nothing is wrong with it.", `${found.model}, ${tr("# numbers", String(found.rig?.numbers.length ?? 0))}`))]), ...(found.rig?.findings ?? []).map((one) => make("p", {}, asSaid(one))));
    difference.replaceChildren();
    if (found.rig) { points.set(found.rig.numbers); drawing = draw(); }
    if (found.rig && !found.rig.spatial) picture.hidden = true;
  };
  /** What is typed into the text while an answer is under way is not overwritten by it: what was set is set in that text, too. */
  const edit = ({ sets = [], changes = {} }: { sets?: [Key[], Value][]; changes?: Record<string, number> }) => edits.do(async () => {
    for (;;) {
      const before = text.value, found = await api.form(name, before, sets, changes);
      if (text.value === before) { await take(found, true); return; }
      if (!sets.length && !Object.keys(changes).length) return; // the text itself is asked about again
    }
  });
  let typing = 0;
  text.addEventListener("input", () => { save.disabled = text.value === saved.text; clearTimeout(typing); typing = setTimeout(() => void edit({}), 400); });
  const back = (from: string[], to: string[]) => { const other = from.pop(); if (other === undefined) return; to.push(shown); shown = other; text.value = other; void edits.do(async () => { const found = await api.form(name, other, [], {}); if (text.value === other) await take(found, false); }); };
  undo.addEventListener("click", () => back(past, future));
  redo.addEventListener("click", () => back(future, past));
  place.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.target === text) return;
    if (event.key === "z" && !event.shiftKey) { event.preventDefault(); back(past, future); }
    if (event.key === "y" || (event.key === "Z" && event.shiftKey)) { event.preventDefault(); back(future, past); }
  });
  save.addEventListener("click", () => {
    const yes = make("button", { type: "button", class: "main" }, tr("Write it")), no = make("button", { type: "button" }, tr("Back"));
    no.addEventListener("click", () => difference.replaceChildren());
    let reviewed = "";
    yes.addEventListener("click", () => {
      if (text.value !== reviewed) { save.click(); return; } // what is written has been seen
      once(yes, api.save(name, reviewed, saved.digest)).then(async (made) => { saved = made; buttons(); await take(await api.form(name, made.text, [], {}), false); told.prepend(make("p", { class: "good" }, tr("Saved."))); }, (error) => difference.replaceChildren(problem(error), make("div", { class: "bar" }, again)));
    });
    const again = make("button", { type: "button" }, tr("Load it again"));
    again.addEventListener("click", () => void edits.do(async () => { // what was typed here is one step back
      try {
        saved = await api.file(name);
        await take(await api.form(name, saved.text, [], {}), true);
      } catch (error) { difference.prepend(problem(error)); }
    }));
    void edits.do(async () => {
      reviewed = text.value;
      const found = await api.form(name, reviewed, [], {});
      difference.replaceChildren(make("section", { class: "difference", "aria-label": tr("What is changed") }, make("h2", {}, tr("What is changed")), ...(found.problems.length ? [make("p", { class: "problem" }, tr("Something is still wrong with it; it can be saved all the same."))] : []),
        make("pre", { tabindex: "0", "aria-label": tr("What is changed") }, ...found.changed.map((line) => make("span", { class: line.startsWith("+") ? "added" : line.startsWith("-") ? "removed" : line.startsWith("@@") ? "muted" : "" }, `${line}\n`))), make("div", { class: "bar" }, yes, no)));
      yes.focus();
    });
  });
  whenColoursChange(() => { view.repaint(); });
  place.replaceChildren(make("h1", {}, name),
    make("p", { class: "bar" }, make("a", { href: address("trial", { rig: name }) }, tr("Drive it over an obstacle")), make("a", { href: address("kinematics", { rig: name }) }, tr("Look at its kinematics"))),
    told, make("div", { class: "bar" }, save, undo, redo), difference, picture,
    make("div", { class: "two" }, make("section", { "aria-label": tr("Form") }, make("h2", {}, tr("Form")), form.element), make("section", { "aria-label": tr("File") }, make("h2", {}, tr("File")), text)));
  await take(await api.form(name, saved.text, [], {}), false);
  await drawing;
}
