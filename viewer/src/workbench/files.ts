/** The files of a project in foldable groups: searched, sorted, and each with links to what opens it. */

import { lasting } from "../browser";
import { make, written } from "../page";
import { seeker, sorted } from "../shown";
import { tr } from "../words";
import type { Entry } from "./api";
import { announce } from "./dialog";
import { moment } from "./drafts";
import { field, select } from "./parts";
import { address, canShow, OPENS } from "./shell";
import { table } from "./table";

const SORTS: Record<string, (entry: Entry, other: Entry) => number> = {
  name: (entry, other) => entry.path.localeCompare(other.path, undefined, { numeric: true }),
  "newest first": (entry, other) => other.modified - entry.modified,
  "largest first": (entry, other) => other.size - entry.size,
};
const GROUPS: Record<string, (entry: Entry) => string> = {
  kind: ({ kind }) => kind,
  folder: ({ path }) => path.split("/").slice(0, -1).join("/"),
  nothing: () => "",
};
const ORDER = "rig vehicle campaign record road sweep swept design results page store".split(" ");
const FEW = 25; // files of a group that is open at first

/** How the list was left: kept for each folder. */
interface Look {
  sort: string;
  group: string;
  folded: Record<string, boolean>;
}

/** State of a sweep; an unfinished one can be resumed. */
const how = ({ finished, count }: Entry): string =>
  count === null
    ? tr("sweep's results")
    : `${tr("sweep's results")}, ${finished === count ? tr("finished") : tr("# finished, can be resumed", `${written((100 * (finished ?? 0)) / (count || 1), 3)} %`)}`;

function rowOf(entry: Entry): HTMLTableRowElement {
  const opens = OPENS[entry.kind] ?? [],
    [first] = opens;
  const page = entry.kind === "page" && entry.path.endsWith(".html") ? entry.address : null;
  return make(
    "tr",
    {},
    make(
      "th",
      { scope: "row" },
      first
        ? make("a", { href: address(first[0], { [first[1]]: entry.path }) }, entry.path)
        : page
          ? make("a", { href: page, target: "_blank" }, entry.path)
          : entry.path,
    ),
    make("td", {}, entry.kind === "swept" ? how(entry) : tr(entry.kind)),
    make("td", { class: "right" }, `${written(entry.size / 1000, 3)} kB`),
    make("td", {}, moment(1000 * entry.modified)),
    make(
      "td",
      { class: "links" },
      ...opens
        .slice(1)
        .filter(([to]) => canShow(to, entry))
        .flatMap(([to, key, words]) => [
          make("a", { href: address(to, { [key]: entry.path }) }, tr(words)),
          " ",
        ]),
    ),
  );
}

/** The list of the files of a folder. */
export function files(folder: string, entries: Entry[]): HTMLElement {
  const key = `jounce-files:${folder}`,
    look: Look = { sort: "name", group: "kind", folded: {} };
  try {
    Object.assign(look, JSON.parse(lasting?.getItem(key) ?? "{}"));
  } catch {
    // as at first
  }
  if (!Object.hasOwn(SORTS, look.sort)) look.sort = "name";
  if (!Object.hasOwn(GROUPS, look.group)) look.group = "kind";
  const keep = () => {
    try {
      lasting?.setItem(key, JSON.stringify(look));
    } catch {
      // a full storage: it stays until the page is left
    }
  };
  const sought = make("input", { type: "search", placeholder: tr("front, csv …") }),
    sort = select(Object.keys(SORTS), look.sort, tr),
    group = select(Object.keys(GROUPS), look.group, tr),
    count = make("span", { class: "muted" }),
    groups = make("div", {});
  const place = make(
    "section",
    { class: "files", "aria-label": tr("Files") },
    make(
      "div",
      { class: "form" },
      field(tr("Search files"), sought),
      field(tr("Group by"), group),
      field(tr("Sort by"), sort),
      count,
    ),
    groups,
  );
  const fill = () => {
    const isSought = seeker(sought.value),
      isSeeking = sought.value.trim() !== "";
    const shown = entries
      .filter(({ path, kind }) => isSought(`${path} ${kind} ${tr(kind)}`))
      .sort(SORTS[look.sort]);
    const of = new Map<string, Entry[]>();
    for (const entry of shown) {
      const name = GROUPS[look.group]!(entry);
      of.set(name, [...(of.get(name) ?? []), entry]);
    }
    const names =
      look.group === "kind"
        ? sorted([...of.keys()], (kind) => (ORDER.includes(kind) ? ORDER.indexOf(kind) : 99))
        : [...of.keys()].sort();
    groups.replaceChildren(
      ...names.map((name) => groupOf(name, of.get(name)!, isSeeking)),
      ...(shown.length ? [] : [make("p", { class: "empty" }, tr("No file is so called."))]),
    );
    count.textContent = isSeeking
      ? `${tr("# of", String(shown.length))} ${tr("# files", String(entries.length))}`
      : tr("# files", String(entries.length));
  };
  const groupOf = (name: string, own: Entry[], isSeeking: boolean): HTMLElement => {
    const id = `${look.group}:${name}`,
      title =
        look.group === "kind" ? tr(name) : name || (look.group === "folder" ? "./" : tr("Files"));
    const whole = make(
      "details",
      { open: isSeeking || !(look.folded[id] ?? own.length > FEW) },
      make("summary", {}, make("b", {}, title), ` (${own.length})`),
    );
    const list = () => {
      if (whole.open && !whole.querySelector("table"))
        whole.append(
          table(
            `${tr("files")}: ${title}`,
            ["file", "type", "size", "modified", "actions"],
            make("tbody", {}, ...own.map(rowOf)),
            [2],
          ),
        );
    };
    list();
    whole.addEventListener("toggle", () => {
      list();
      if (isSeeking || whole.open === !(look.folded[id] ?? own.length > FEW)) return;
      look.folded[id] = !whole.open;
      keep();
    });
    return whole;
  };
  let said = 0;
  sought.addEventListener("input", () => {
    fill();
    clearTimeout(said);
    said = setTimeout(() => announce(count.textContent ?? ""), 600);
  });
  for (const [control, name] of [
    [sort, "sort"],
    [group, "group"],
  ] as const)
    control.addEventListener("change", () => {
      look[name] = control.value;
      keep();
      fill();
    });
  fill();
  return place;
}
