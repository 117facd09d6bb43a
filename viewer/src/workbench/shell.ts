/** Pages of the workbench and what they share: addresses, the choice of a rig, and the open live curves. */

import { passing } from "../browser";
import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { gallery } from "./shipped";

export type Values = URLSearchParams;
/** A page has a label in the header, and fills its place once loaded; its errors are shown there with a link back. */
export interface Page {
  label: string;
  load: () => Promise<{ show: (place: HTMLElement, values: Values) => Promise<void> }>;
}

export const RIGS = ["rig"],
  VEHICLES = ["rig", "vehicle"];
export const address = (page: string, values: Record<string, string> = {}) =>
  `#/${page}?${new URLSearchParams(values)}`;

/** Pages that open a kind of file, with the words of their links. */
export const OPENS: Record<string, [page: string, key: string, words: string][]> = {
  rig: [
    ["rig", "name", "edit"],
    ["trial", "rig", "drive"],
    ["kinematics", "rig", "kinematics"],
    ["kc", "rig", "K&C"],
  ],
  vehicle: [
    ["rig", "name", "edit"],
    ["trial", "rig", "drive"],
    ["kc", "rig", "K&C"],
  ],
  record: [
    ["record", "path", "view"],
    ["data", "path", "analyse"],
    ["trial", "record", "compare with a simulation"],
    ["inspection", "record", "inspect"],
  ],
  layout: [["data", "layout", "open"]],
  campaign: [["campaign", "file", "open"]],
  sweep: [["studies", "study", "open"]],
  swept: [["studies", "folder", "results"]],
  store: [["inspection", "store", "search"]],
};

/** Whether a page can open a rig or vehicle. */
export const canShow = (
  page: string,
  rig: { has_hardpoints: boolean; has_axle: boolean; is_dependent: boolean },
): boolean =>
  page === "kinematics"
    ? rig.has_hardpoints || rig.is_dependent
    : page === "kc"
      ? rig.has_axle
      : page === "rig" || !rig.is_dependent;

/** Parses a value of an address as JSON; empty if it is not valid. */
export function given<T extends object>(text: string | null): T {
  try {
    return (JSON.parse(text ?? "{}") ?? {}) as T;
  } catch {
    return {} as T;
  }
}

/** Goes to another page unless the calling page was left meanwhile, so that a late answer moves nobody. */
export function goTo(from: Node, page: string, values: Record<string, string> = {}): void {
  if (from.isConnected) location.hash = address(page, values);
}

/** Key of the rig or vehicle in the address of each page. */
const SHOWS: Record<string, string> = {
    rig: "name",
    kinematics: "rig",
    kc: "rig",
    trial: "rig",
    ride: "vehicle",
  },
  KEY = "jounce-rig";

/** Links in the header keep the open rig; that of the open page leads to the choice. */
export function carry(name: string): void {
  passing?.setItem(KEY, name);
  for (const link of document.querySelectorAll<HTMLAnchorElement>("#pages a")) {
    const page = link.dataset.page!,
      takes = SHOWS[page];
    const fits =
      takes &&
      name &&
      !link.hasAttribute("aria-current") &&
      (page !== "rig" || name.endsWith(".toml")); // what is shipped has no file here
    link.setAttribute("href", address(page, fits ? { [takes]: name } : {}));
  }
}
/** The rig or vehicle that a page shows, else the one that was shown last. */
export const carried = (page: string, values: Values): string =>
  values.get(SHOWS[page] ?? "") ?? passing?.getItem(KEY) ?? "";

/** The live curves of the open page, for benchmarks. */
export let live: { times: number[] } | null = null;
export function setLive(curves: { times: number[] } | null): void {
  live = curves;
}

/** Lets the user choose a rig if none is given. */
export async function choose(
  place: HTMLElement,
  page: string,
  label: string,
  key: string,
  shipped = false,
  kinds = RIGS,
  more: Record<string, string> = {},
): Promise<void> {
  const { entries } = await api.project();
  const list = (names: string[]) =>
    make(
      "ul",
      {},
      ...names.map((name) =>
        make("li", {}, make("a", { href: address(page, { [key]: name, ...more }) }, name)),
      ),
    );
  const own = entries
    .filter((entry) => kinds.includes(entry.kind) && canShow(page, entry))
    .map((entry) => entry.path);
  const others = shipped
    ? (await api.library()).filter((shippedRig) => canShow(page, shippedRig))
    : [];
  place.replaceChildren(
    make("h1", {}, label),
    ...(own.length || others.length
      ? [
          make(
            "p",
            { class: "muted" },
            page === "kinematics"
              ? tr("Choose a rig with hardpoints.")
              : page === "kc"
                ? tr("Choose a corner, a solid axle, a twist beam or a car.")
                : kinds.includes("rig")
                  ? tr("Choose a rig or vehicle.")
                  : tr("Choose a record."),
          ),
        ]
      : []),
    ...(own.length ? [make("h2", {}, tr("In this project")), list(own)] : []),
    ...(others.length
      ? [
          make("h2", {}, tr("Shipped with jounce")),
          gallery(others, (shipped) => [
            make(
              "a",
              {
                href: address(page, { [key]: shipped.name, ...more }),
                "aria-label": `${tr("open")}: ${shipped.name}`,
              },
              tr("open"),
            ),
          ]),
        ]
      : []),
    ...(own.length || others.length
      ? []
      : [
          make(
            "p",
            { class: "empty" },
            kinds.includes("rig")
              ? tr("No rig in this project yet: ")
              : tr("No record in this project yet: "),
            make("a", { href: address("project") }, tr("to the project")),
            ".",
          ),
        ]),
  );
}
