/** A rig: synchronised form and text, its mechanism with draggable hardpoints, and a review before saving. */

import { Store } from "../../data";
import { MechanismView } from "../../mechanism";
import { make, whenColoursChange } from "../../page";
import { tr } from "../../words";
import * as api from "../api";
import { Drafts, draftsOf, moment, stateOf } from "../drafts";
import { Form, type Key, type Value } from "../form";
import { copied, difference, InTurn, LiveSnippets, Newest, problem } from "../parts";
import { pastePoints } from "../pasting";
import { Points } from "../points";
import { advised } from "../refusals";
import { saveDrawing } from "../saving";
import { address, choose, type Values, VEHICLES } from "../shell";

export async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("name");
  if (!name) {
    await choose(place, "rig", tr("Rig"), "name", false, VEHICLES);
    return;
  }
  const folder = await api.folder(),
    own = address("rig", { name });
  let saved: api.Text;
  try {
    saved = await api.file(name);
  } catch (error) {
    // what was typed for a file that is gone can still be had
    place.replaceChildren(
      make("h1", {}, name),
      problem(error),
      ...draftsOf(folder)
        .filter((draft) => draft.page === own)
        .map(({ key, at }) =>
          copied(tr("Unsaved changes of #", moment(at)), (stateOf(key) as { text: string }).text),
        ),
      make("p", {}, make("a", { href: address("project") }, tr("Back to the project"))),
    );
    return;
  }
  if (!place.isConnected) return;
  let state: api.Form | null = null,
    isOld = false,
    said: HTMLElement | null = null;
  const past: string[] = [],
    future: string[] = [];
  const text = make("textarea", {
    spellcheck: "false",
    "aria-label": tr("text of #", name),
    rows: "28",
  });
  const held = (given: string) => given.replace(/\r\n?/g, "\n"); // as a page has it
  text.value = saved.text;
  let shown = held(saved.text),
    reviewed: string | null = null,
    strokes = 0; // what was asked about last, what a save would write, and how often something was typed
  const status = make("div", { class: "told", "aria-live": "polite" }),
    unseen = make("div", { "aria-live": "polite" }),
    lines = make("div", {});
  const save = make("button", { type: "button", class: "main", disabled: true }, tr("Save")),
    undo = make("button", { type: "button", disabled: true }, tr("Undo")),
    redo = make("button", { type: "button", disabled: true }, tr("Redo"));
  const edits = new InTurn(
      (error) => {
        said?.remove();
        said = problem(error);
        status.prepend(said);
      },
      () => display(),
    ),
    pictures = new Newest();
  let drawing = Promise.resolve();
  const same = new LiveSnippets(),
    form = new Form(
      (keys: Key[], value: Value) => void edit({ sets: [[keys, value]] }),
      (sets) => void edit({ sets }),
    );
  const view = new MechanismView(true),
    stage = make("div", { class: "player bare", hidden: true }, view.element);
  saveDrawing(view.element);
  const points = new Points(view, (changes, done) => {
    if (done) void edit({ changes });
    else void draw(changes);
  });
  const picture = make(
    "section",
    { hidden: true, "aria-label": tr("The mechanism") },
    make("h2", {}, tr("The mechanism")),
    make(
      "p",
      { class: "muted" },
      tr(
        "Drag a hardpoint, or select it and type its coordinates; drag elsewhere to rotate the view.",
      ),
    ),
    points.element,
    pastePoints(
      () => ({ rig: name, text: text.value, changes: {} }),
      (changes) => void edit({ changes }),
    ),
    stage,
  );

  const moves = make(
    "a",
    { href: address("kinematics", { rig: name }), hidden: true },
    tr("Show its kinematics"),
  );
  const tests = make("a", { href: address("kc", { rig: name }), hidden: true }, tr("Show its K&C"));
  const drafts = new Drafts(
    folder,
    own,
    { text: held(saved.text) },
    () => ({ text: text.value }),
    ({ text: to }) =>
      inTurn(async () => {
        step(text.value);
        text.value = to;
        buttons();
        const form = await api.form(name, to, [], {});
        if (text.value === to) take(form);
      }),
    () => saved.digest,
    () => edits.waiting > 0 || form.isTyped,
  );
  const buttons = () => {
    drafts.changed();
    const waits = edits.waiting > 0 || text.value !== shown;
    save.disabled = text.value === held(saved.text);
    undo.disabled = !past.length && !waits;
    redo.disabled = !future.length;
  };
  const draw = (changes: Record<string, number> = {}) =>
    pictures.ask(async () => {
      if (!state?.rig?.spatial || !place.isConnected) return;
      try {
        const store = Store.of(
          await api.curves("kinematics", {
            rig: name,
            text: text.value,
            changes,
            travel: "-20 mm:20 mm:10 mm",
            channels: ["camber"],
          }),
        );
        const motion = store.content.viewers[0]!.scenes[0]!.motion;
        if (!motion || !place.isConnected) return;
        picture.hidden = stage.hidden = false;
        view.show(store.content.mechanisms[motion.mechanism]!, motion);
        view.set({
          body: 0,
          travel: 0,
          ground: store.content.mechanisms[motion.mechanism]!.contact[2]![2]!,
          load: 1,
          time: 0,
        });
        unseen.replaceChildren();
      } catch (error) {
        unseen.replaceChildren(problem(error));
      }
    });
  /** Another text is one step, which can be taken back. */
  const step = (to: string) => {
    if (to !== shown) {
      past.push(shown);
      future.length = 0;
      shown = to;
    }
  };
  const take = (form: api.Form) => {
    step(form.text);
    if (text.value !== form.text) text.value = form.text;
    if (form.text !== reviewed) {
      lines.replaceChildren();
      reviewed = null;
    }
    state = form;
    if (form.rig) {
      moves.hidden = !form.rig.spatial;
      tests.hidden = !form.rig.spatial && !form.rig.is_dependent;
    }
    isOld = true;
  };
  /** Shows the latest state once all requests have finished: earlier answers lack later edits. */
  const display = async () => {
    buttons();
    if (!isOld || !state || !place.isConnected) return;
    isOld = false;
    const snapshot = state;
    if (snapshot.model) {
      try {
        form.show(
          await api.schema(snapshot.model),
          snapshot.values as { [key: string]: Value },
          snapshot.problems,
          snapshot.notes,
        );
      } catch {
        form.element.replaceChildren();
      }
    }
    const all = snapshot.problems.map((item) =>
      problem(
        new Error(
          `${item.line ? `${tr("line #", String(item.line))}: ` : ""}${item.path ? `${item.path}: ` : ""}${item.text}`,
        ),
      ),
    );
    status.replaceChildren(
      ...(said ? [said] : []),
      ...(all.length
        ? all
        : [
            make(
              "p",
              { class: "good" },
              tr(
                "#: no problems found.",
                `${snapshot.model}, ${tr("# parameters", String(snapshot.rig?.numbers.length ?? 0))}`,
              ),
            ),
          ]),
      ...advised(snapshot.rig?.findings ?? [], "p"),
    );
    if (snapshot.rig) {
      points.set(snapshot.rig.numbers);
      drawing = draw();
    }
    same.element.hidden = !snapshot.rig;
    if (snapshot.rig) same.show({ ...snapshot, files: {} });
    if (snapshot.rig && !snapshot.rig.spatial) picture.hidden = true;
  };
  const inTurn = (work: () => Promise<void>) => {
    if (!edits.waiting) said = null;
    return edits.do(work);
  };
  /** What is typed into the text while an answer is under way is not overwritten by it: what was set is set in that text, too. */
  const edit = ({
    sets = [],
    changes = {},
  }: {
    sets?: [Key[], Value][];
    changes?: Record<string, number>;
  }) => {
    const done = inTurn(async () => {
      for (;;) {
        const before = text.value,
          form = await api.form(name, before, sets, changes);
        if (text.value === before) {
          take(form);
          return;
        }
        if (!sets.length && !Object.keys(changes).length) return; // the text itself is asked about again
      }
    });
    buttons();
    return done;
  };
  let typing = 0;
  text.addEventListener("input", () => {
    strokes++;
    buttons();
    clearTimeout(typing);
    typing = setTimeout(() => void edit({}), 400);
  });
  /** One step back, or forth again, in turn: what is under way is the step that is taken back. */
  const back = (from: string[], to: string[]) => {
    const at = strokes;
    void inTurn(async () => {
      if (at !== strokes) return; // somebody types on
      step(text.value); // what was typed and not asked about yet is a step, too
      const other = from.pop();
      if (other === undefined) return;
      to.push(shown);
      shown = text.value = other;
      buttons();
      const form = await api.form(name, other, [], {});
      if (text.value === other) take(form);
    });
  };
  undo.addEventListener("click", () => back(past, future));
  redo.addEventListener("click", () => back(future, past));
  place.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.target === text || form.isTyped) return;
    if (event.key === "z" && !event.shiftKey) {
      event.preventDefault();
      back(past, future);
    }
    if (event.key === "y" || (event.key === "Z" && event.shiftKey)) {
      event.preventDefault();
      back(future, past);
    }
  });
  const review = async () => {
    const now = text.value,
      form = await api.form(name, now, [], {});
    const yes = make("button", { type: "button", class: "main" }, tr("Write to the file")),
      no = make("button", { type: "button" }, tr("Back"));
    no.addEventListener("click", () => {
      reviewed = null;
      lines.replaceChildren();
    });
    yes.addEventListener("click", () => {
      yes.disabled = true;
      void inTurn(() => write(now));
    });
    reviewed = now;
    lines.replaceChildren(
      difference(
        form.changed,
        yes,
        no,
        ...(form.problems.length
          ? [make("p", { class: "problem" }, tr("There are still problems; you can save anyway."))]
          : []),
      ),
    );
    if ([save, document.body].includes(document.activeElement as HTMLElement)) yes.focus(); // whoever types goes on typing
  };
  const write = async (now: string) => {
    if (text.value !== now) {
      await review();
      return;
    } // what is written has been seen
    try {
      saved = await api.save(name, now, saved.digest);
      drafts.done({ text: now });
      reviewed = null;
      lines.replaceChildren();
      said = make("p", { class: "good" }, tr("Saved."));
      isOld = true;
      const form = await api.form(name, now, [], {}).catch(() => null); // how the same is done is told of what is saved now
      if (form && text.value === now) take(form);
    } catch (error) {
      const again = make("button", { type: "button" }, tr("Reload"));
      again.addEventListener(
        "click",
        () =>
          void inTurn(async () => {
            // what was typed here is one step back
            try {
              const file = await api.file(name),
                its = await api.form(name, held(file.text), [], {});
              saved = file;
              drafts.done({ text: held(file.text) });
              step(text.value);
              take(its);
            } catch (error) {
              lines.prepend(problem(error));
            }
          }),
      );
      lines.replaceChildren(problem(error), make("div", { class: "bar" }, again));
    }
  };
  save.addEventListener("click", () => void inTurn(review));
  whenColoursChange(() => {
    view.repaint();
  });
  place.replaceChildren(
    make("h1", {}, name),
    make(
      "p",
      { class: "bar" },
      make("a", { href: address("trial", { rig: name }) }, tr("Drive over an obstacle")),
      moves,
      tests,
    ),
    drafts.element,
    status,
    make("div", { class: "bar" }, save, undo, redo),
    lines,
    unseen,
    picture,
    make(
      "div",
      { class: "two" },
      make("section", { "aria-label": tr("Form") }, make("h2", {}, tr("Form")), form.element),
      make("section", { "aria-label": tr("File") }, make("h2", {}, tr("File")), text),
    ),
    same.element,
  );
  await edit({});
  await drawing;
}
