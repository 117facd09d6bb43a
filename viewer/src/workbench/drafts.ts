/** Unsaved changes: stored in the browser until they are saved or discarded, and offered again. No file is written here. */

import { lasting } from "../browser";
import { make, whenLeft } from "../page";
import { isGerman, tr } from "../words";

/** The entries, their time (ms since 1970), and the digest of the saved text they are based on. */
interface Draft {
  at: number;
  was: string;
  state: object;
}
/** Place of a draft: the address of its page. */
export interface Lying {
  key: string;
  page: string;
  at: number;
}

const MOST = 50; // drafts of all projects; the oldest are given up beyond
const PAUSE = 250; // ms after the last key, until what is typed is kept
const prefix = (folder: string, page = "") => `jounce-draft\n${folder}\n${page && `${page}\n`}`;
const open = new Set<Drafts<object>>();

function read(key: string): Draft | null {
  try {
    const draft = JSON.parse(lasting?.getItem(key) ?? "null") as Draft | null;
    return draft && typeof draft.state === "object" && draft.state ? draft : null;
  } catch {
    return null;
  }
}

/** Drafts whose keys begin so, the newest first. */
function lying(begins: string): Lying[] {
  const keys = Object.keys(lasting ?? {}).filter((key) => key.startsWith(begins));
  return keys
    .map((key) => ({ key, page: key.split("\n")[2] ?? "", at: read(key)?.at ?? 0 }))
    .filter(({ at }) => at)
    .sort((first, other) => other.at - first.at);
}

export const draftsOf = (folder: string): Lying[] => lying(prefix(folder));
export const discard = (key: string): void => lasting?.removeItem(key);
/** The state of a draft; nothing where it is gone. */
export const stateOf = (key: string): object | null => read(key)?.state ?? null;

/** A moment as people say it: the time of today, else with its day. */
export function moment(at: number): string {
  const when = new Date(at),
    isToday = when.toDateString() === new Date().toDateString();
  return when.toLocaleString(
    isGerman ? "de-DE" : "en-GB",
    isToday ? { timeStyle: "short" } : { dateStyle: "medium", timeStyle: "short" },
  );
}

/** What a page has been told and not saved. Its state is plain data; whatever differs from what is saved is kept. */
export class Drafts<T extends object> {
  /** The offers of what was left unsaved before; nothing where nothing was. */
  readonly element = make("section", {
    class: "drafts",
    hidden: true,
    tabindex: "-1",
    "aria-label": tr("Unsaved changes"),
  });
  private readonly own: string;
  private timer = 0;
  isKept = true;
  private isLeft = false;
  private lies = false;
  private isOver = false;

  /** `was` is the digest of the file as the page knows it, `waits` whether something is under way that the state does not have yet, `follows` whether the state is of that file, and not of any. */
  constructor(
    private readonly folder: string,
    private readonly page: string,
    private saved: T,
    private readonly state: () => T,
    private readonly restore: (state: T) => Promise<void> | void,
    private readonly was: () => string = () => "",
    private readonly waits: () => boolean = () => false,
    private readonly follows: () => boolean = () => true,
  ) {
    this.own = `${prefix(folder, page)}${Date.now().toString(36)}-${Math.random().toString(36).slice(2, 8)}`;
    open.add(this as unknown as Drafts<object>);
    whenLeft(() => {
      this.isLeft = true;
      this.keep();
    });
    this.offer();
  }

  /** Hears of everything that is entered below an element. */
  hear(root: HTMLElement): void {
    for (const text of ["input", "change", "click"])
      root.addEventListener(text, () => this.changed());
  }

  /** Something may have changed: it is kept once nobody types any more. */
  changed(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.keep(), PAUSE);
  }

  /** All of it, or a part, is saved or used by now. */
  done(part: Partial<T> = this.state()): void {
    this.saved = { ...this.saved, ...part };
    this.keep();
  }

  /** Keeps what there is now, and tells whether it may be left: it is kept, and nothing is under way. */
  keep(): boolean {
    clearTimeout(this.timer);
    if (this.isOver) return true;
    if (this.isLeft && this.lies && !read(this.own)) {
      this.drop();
      return true;
    } // another page took it, or it was discarded: a late answer does not bring it back
    const state = this.state();
    try {
      if (JSON.stringify(state) === JSON.stringify(this.saved)) {
        discard(this.own);
        this.lies = false;
      } else {
        lasting!.setItem(
          this.own,
          JSON.stringify({
            at: Date.now(),
            was: this.follows() ? this.was() : "",
            state,
          } satisfies Draft),
        );
        this.lies = true;
        for (const { key } of lying("jounce-draft\n").slice(MOST)) discard(key);
      }
      this.isKept = true;
    } catch {
      this.isKept = false;
    } // there is no room for it, or the browser keeps nothing
    const isSafe = this.isKept && !this.waits();
    if (this.isLeft && isSafe) open.delete(this as unknown as Drafts<object>);
    return isSafe;
  }

  /** Nothing of this page is to be kept: what follows it has it all. */
  drop(): void {
    clearTimeout(this.timer);
    open.delete(this as unknown as Drafts<object>);
    discard(this.own);
    this.isOver = true;
  }

  private offer(said = ""): void {
    const found = lying(prefix(this.folder, this.page))
      .flatMap(({ key }) => {
        const draft = read(key);
        return draft && key !== this.own ? [{ key, draft }] : [];
      })
      .filter(({ key, draft }) => {
        const isSaved = JSON.stringify(draft.state) === JSON.stringify(this.saved);
        if (isSaved) discard(key);
        return !isSaved;
      });
    const button = (words: string, about: string, does: () => Promise<void> | void) => {
      const button = make("button", { type: "button", "aria-describedby": about }, tr(words));
      button.addEventListener("click", () => void does());
      return button;
    };
    this.element.hidden = !found.length && !said;
    this.element.replaceChildren(
      ...(said ? [make("p", { class: "muted", role: "status" }, tr(said))] : []),
      ...found.map(({ key, draft }, k) => {
        const id = `draft-${k}`;
        return make(
          "div",
          { class: "draft" },
          make("p", { id }, tr("Unsaved changes of #", moment(draft.at)), "."),
          ...(draft.was && draft.was !== this.was()
            ? [
                make(
                  "p",
                  { class: "fair" },
                  tr("The file has changed since then: compare before you save."),
                ),
              ]
            : []),
          make(
            "div",
            { class: "bar" },
            button("Restore", id, async () => {
              await this.restore(draft.state as T);
              this.keep();
              if (this.isKept) discard(key);
              this.announce("Restored.");
            }),
            button("Discard", id, () => {
              discard(key);
              this.announce("Discarded.");
            }),
          ),
        );
      }),
    );
  }

  private announce(words: string): void {
    this.offer(words);
    if (this.element.isConnected) this.element.focus();
  }
}

/** Whether the page may be left: all that is entered is kept, or whoever leaves it wants to lose it. */
export function mayLeave(): boolean {
  (document.activeElement as HTMLElement | null)?.blur(); // what is typed there counts
  const lost = [...open].filter((draft) => !draft.keep() && !draft.isKept);
  return (
    !lost.length ||
    confirm(
      tr(
        "The changes on this page are not saved, and this browser could not store them. Leave anyway?",
      ),
    )
  );
}

addEventListener("beforeunload", (event) => {
  if ([...open].filter((draft) => !draft.keep()).length) event.preventDefault();
});
addEventListener("pagehide", () => {
  for (const draft of open) draft.keep();
});

type Controls = Record<string, HTMLInputElement | HTMLSelectElement>;

/** What stands in controls, by their names. */
export const entered = (controls: Controls): Record<string, string> =>
  Object.fromEntries(
    Object.entries(controls).map(([name, one]) => [
      name,
      one.type === "checkbox" ? String((one as HTMLInputElement).checked) : one.value,
    ]),
  );

/** The same of those that are not as they were at first. */
export const typedIn = (
  controls: Controls,
  first: Record<string, string>,
): Record<string, string> =>
  Object.fromEntries(
    Object.entries(entered(controls)).filter(([name, value]) => value !== first[name]),
  );

/** Enters it again, each as if it were typed, in the order of the controls; a choice that is not there any more stays as it is. */
export function enter(controls: Controls, values: Record<string, string>): void {
  for (const [name, one] of Object.entries(controls)) {
    const value = values[name];
    if (
      value === undefined ||
      (one instanceof HTMLSelectElement &&
        ![...one.options].some((option) => option.value === value))
    )
      continue;
    if (one.type === "checkbox") (one as HTMLInputElement).checked = value === "true";
    else one.value = value;
    one.dispatchEvent(new Event("change", { bubbles: true }));
  }
}
