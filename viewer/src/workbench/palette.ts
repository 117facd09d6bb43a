/** What the keyboard opens from every page: a search over pages, files, curves and actions, and a list of the keys. */

import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { dialog } from "./dialog";
import { address, canShow, OPENS } from "./shell";
import { kindOf } from "./shipped";

/** Something that can be gone to or done; `where` says what kind of thing it is. */
interface Goal {
  words: string;
  where: string;
  go: () => void;
}

const MOST = 40; // goals in the list: more are not read but searched

const open =
  (page: string, values: Record<string, string> = {}) =>
  () => {
    location.hash = address(page, values);
  };

function show(element: HTMLElement): void {
  element.scrollIntoView({ block: "center" });
  element.animate(
    [{ outline: "2px solid var(--accent)" }, { outline: "2px solid transparent" }],
    1500,
  );
}

/** Headings, curves, channels that can be shown, fields and buttons of the open page. */
function onThisPage(): Goal[] {
  const main = document.getElementById("main")!,
    words = (element: Element) => (element.textContent ?? "").replace(/\s+/g, " ").trim();
  const seen = (element: HTMLElement) => element.offsetParent !== null;
  const of = (selector: string) => [...main.querySelectorAll<HTMLElement>(selector)].filter(seen);
  const goals = (selector: string, where: string, does: (element: HTMLElement) => void): Goal[] =>
    of(selector).map((element) => ({
      words: words(element),
      where: tr(where),
      go: () => does(element),
    }));
  return [
    ...goals("h2, h3", "on this page", show),
    ...goals(".multiples figure b, .pane-head b", "curve", (element) => {
      const whole = element.closest<HTMLElement>("figure, .pane-head")!;
      show(whole);
      whole.querySelector<HTMLElement>(".enlarge")?.focus({ preventScroll: true });
    }),
    ...[...main.querySelectorAll<HTMLElement>("[data-channel][aria-pressed=false]")].map(
      (element) => ({
        words: [words(element), element.title].filter(Boolean).join(", "),
        where: tr("show the curve"),
        go: () => element.click(), // also of those behind a button
      }),
    ),
    ...of(".field > :is(input, select), .slider input.number").map((element) => ({
      words:
        element.getAttribute("aria-label") ??
        words(element.closest(".field")!.firstElementChild ?? element),
      where: tr("quantity"),
      go: () => {
        show(element);
        element.focus({ preventScroll: true });
      },
    })),
    ...of("button:not(:disabled, [data-channel])")
      .filter((element) => words(element).length > 2 && !element.closest("details:not([open])"))
      .map((element) => ({
        words: element.getAttribute("aria-label") ?? words(element),
        where: tr("action"),
        go: () => element.click(),
      })),
  ];
}

async function everywhere(pages: Record<string, string>): Promise<Goal[]> {
  const [{ entries }, library] = await Promise.all([api.project(), api.library()]);
  return [
    ...Object.entries(pages).map(([page, label]) => ({
      words: tr(label),
      where: tr("page"),
      go: open(page),
    })),
    ...entries.flatMap((entry) =>
      (OPENS[entry.kind] ?? [])
        .filter(([page]) => canShow(page, entry))
        .map(([page, key, words]) => ({
          words: `${entry.path}: ${tr(words)}`,
          where: tr(entry.kind),
          go: open(page, { [key]: entry.path }),
        })),
    ),
    ...library.flatMap((shipped) =>
      (
        [
          ["trial", "drive"],
          ["kinematics", "kinematics"],
          ["kc", "K&C"],
        ] as const
      )
        .filter(([page]) => canShow(page, shipped))
        .map(([page, words]) => ({
          words: `${shipped.name}: ${tr(words)}`,
          where: `${tr("shipped with jounce")}, ${kindOf(shipped)}`,
          go: open(page, { rig: shipped.name }),
        })),
    ),
  ];
}

/** Goals that hold all words of a text, those that begin with it first. */
function matching(goals: Goal[], text: string): Goal[] {
  const wanted = text.toLowerCase().trim(),
    words = wanted.split(/\s+/);
  const rank = (goal: Goal) => (goal.words.toLowerCase().startsWith(wanted) ? 0 : 1);
  return goals
    .filter((goal) =>
      words.every((word) => `${goal.words} ${goal.where}`.toLowerCase().includes(word)),
    )
    .sort((a, b) => rank(a) - rank(b))
    .slice(0, MOST);
}

async function search(pages: Record<string, string>): Promise<void> {
  const field = make("input", {
    type: "text",
    role: "combobox",
    "aria-expanded": "true",
    "aria-controls": "palette-list",
    "aria-label": tr("Search pages, files, rigs, curves, quantities and actions"),
    placeholder: tr("Search pages, files, rigs, curves, quantities and actions"),
  });
  const list = make("ul", { id: "palette-list", role: "listbox", "aria-label": tr("matches") });
  let goals = onThisPage(),
    found: Goal[] = [],
    at = 0;
  const whole = dialog("palette", tr("Go to"), field, list);
  const choose = (k: number) => {
    const goal = found[k];
    if (!goal) return;
    whole.close();
    goal.go();
  };
  const mark = () => {
    [...list.children].forEach((child, k) => {
      child.setAttribute("aria-selected", String(k === at));
      if (k === at) child.scrollIntoView({ block: "nearest" });
    });
    field.setAttribute("aria-activedescendant", found.length ? `palette-${at}` : "");
  };
  const fill = () => {
    found = matching(goals, field.value);
    at = 0;
    list.replaceChildren(
      ...(found.length
        ? found.map(({ words, where }, k) =>
            make(
              "li",
              { id: `palette-${k}`, role: "option", click: () => choose(k) },
              make("span", {}, words),
              make("small", {}, where),
            ),
          )
        : [make("li", { class: "muted", role: "option" }, tr("nothing found"))]),
    );
    mark();
  };
  field.addEventListener("input", fill);
  field.addEventListener("keydown", (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by && found.length) {
      event.preventDefault();
      at = (at + by + found.length) % found.length;
      mark();
    } else if (event.key === "Enter") {
      event.preventDefault();
      choose(at);
    }
  });
  fill();
  field.focus();
  goals = [...(await everywhere(pages)), ...goals];
  if (whole.open) fill();
}

const KEYS: [string, string][] = [
  ["Ctrl K", "search pages, files, rigs, curves, quantities and actions"],
  ["?", "show this list"],
  ["Ctrl Z, Ctrl Y", "undo and redo what was entered"],
  ["Space", "play the curves that have the focus"],
  ["← →", "step through the curves, with Shift in large steps; pan a record"],
  ["+ − 0", "zoom in, zoom out, show everything"],
  ["← ↑ → ↓", "turn the mechanism that has the focus, with Shift move it; + − 0 zoom it"],
  ["PgUp PgDn", "previous and next curve in the large view of a curve"],
  ["[ ]", "previous and next trial"],
  ["9", "zoom to the event"],
  ["f", "fill the window with the curves"],
  ["Esc", "close a menu or a dialog"],
];

function keys(): void {
  const rows = KEYS.flatMap(([key, words]) => [
    make("dt", {}, make("kbd", {}, tr(key))),
    make("dd", {}, tr(words)),
  ]);
  const close = make("button", { type: "button" }, tr("Close"));
  const whole = dialog(
    "palette",
    tr("Keys"),
    make("h2", {}, tr("Keys")),
    make("dl", {}, ...rows),
    close,
  );
  close.addEventListener("click", () => whole.close());
}

/** Listens for Ctrl-K and the question mark; `pages` are the labels of all pages by their addresses. */
export function listenForKeys(pages: Record<string, string>): void {
  addEventListener("keydown", (event) => {
    if (document.querySelector("dialog[open]")) return;
    const target = event.target as HTMLElement,
      isTyped = target.matches("input:not([type=range]):not([type=checkbox]), textarea, select");
    if (event.key.toLowerCase() === "k" && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      void search(pages);
    } else if (event.key === "?" && !isTyped && !event.ctrlKey && !event.metaKey) {
      event.preventDefault();
      keys();
    }
  });
}

/** A button that opens the search, for those who do not know the key. */
export const searchButton = (pages: Record<string, string>): HTMLButtonElement =>
  make(
    "button",
    {
      type: "button",
      class: "search",
      title: `${tr("Search pages, files, rigs, curves, quantities and actions")} (Ctrl K)`,
      "aria-label": tr("Go to"), // pages have a button "Search" of their own
      click: () => void search(pages),
    },
    "⌕",
  );
