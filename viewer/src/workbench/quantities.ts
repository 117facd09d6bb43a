/** German of what is computed, by its English words: quantities of the catalogues, channels, parts, and the keys of forms. */

import type { Store } from "../data";
import { isGerman, tr } from "../words";
import generated from "./quantities.json"; // written by `make faces`
import { TERMS } from "./terms";

const { quantities: NAMES, parts: PARTS, keys: KEYS, words: WORDS } = TERMS;

/** A quantity as a page shows it: its key in results, its label, its unit and the factor from SI. */
export type Quantity = [name: string, words: string, unit: string, factor: number];
type Unit = [name: string, factor: number];
type Estimate = [words: string, unit: string, factor: number];

/** Values of a wheel on a tester. */
export const WHEEL_QUANTITIES = (
  generated.inspection as [string, string, string, string, number][]
).map(
  ([name, english, german, unit, factor]): Quantity => [
    name,
    isGerman ? german : english,
    unit,
    factor,
  ],
);
/** Columns of a comparison of rides; smaller is better. */
export const MERITS = generated.merits as Quantity[];
/** Estimates of fits, by kind of fit and key. */
export const ESTIMATES = generated.estimates as unknown as Record<
  "decay" | "stiffness",
  Record<string, Estimate>
>;
const UNITS = generated.units as unknown as Record<string, Unit>;
/** Display unit of an SI unit, and the factor to it. */
export const shownUnit = (si: string): Unit => UNITS[si] ?? [si, 1];

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";
/** A unit as a file writes it, with raised powers and dots. */
export const unitText = (unit: string): string =>
  unit
    .replace(
      /(?:\^|\*\*)(-?)(\d)(?!\d)/g,
      (_, sign, digit) => (sign && "⁻") + RAISED[Number(digit)],
    )
    .replaceAll("*", "·");

/** A quantity of the catalogue as a head names it; of an axle, with its side. */
export function quantity(name: string): string {
  const [side, own] = /^(left|right)\.(.*)$/.exec(name)?.slice(1) ?? ["", name];
  const said = isGerman ? NAMES[own!] : undefined;
  if (!said) return name.replaceAll("_", " ");
  return side ? `${said} ${PARTS[side]}` : said;
}

/** A key of a description, as its form names it. */
export function key(name: string): string {
  const plain = name.replaceAll("_", " ");
  return (isGerman && (KEYS[plain] ?? PARTS[plain])) || plain;
}

/** A hardpoint or a part. */
export function part(name: string): string {
  const plain = name.replaceAll("_", " ");
  return (isGerman && PARTS[plain]) || plain;
}

/** What a channel is, in the words of the page; its name, which files and commands use, stays. */
export function spoken(words: string): string {
  return isGerman ? (translated(words) ?? words) : words;
}

/** Curves that came from the server, with what they are in the words of the page. */
export function inWords(store: Store): Store {
  if (isGerman) {
    for (const model of store.content.viewers) {
      model.x.words = spoken(model.x.words);
      for (const role of model.roles) role.label = tr(spoken(role.label));
      for (const scene of model.scenes)
        for (const pane of scene.panes) {
          pane.words = spoken(pane.words);
          for (const curve of pane.curves) curve.label = tr(spoken(curve.label));
        }
    }
  }
  return store;
}

function translated(text: string): string | undefined {
  const own = text.trim();
  if (Object.hasOwn(WORDS, own)) return WORDS[own];
  const known = PARTS[own.replaceAll("_", " ")];
  if (known) return known;
  let match = /^(.*), difference from (.*)$/.exec(own);
  if (match) return `${match[1]}, Abweichung von ${spoken(match[2]!)}`;
  match = /^(.*), reaction (force|torque) along ([xyz])$/.exec(own);
  if (match)
    return `${translated(match[1]!) ?? match[1]}, ${match[2] === "force" ? "Reaktionskraft" : "Reaktionsmoment"} entlang ${match[3]}`;
  match = /^place of (\w+)\.([xyz])$/.exec(own);
  if (match) return `Ort von ${part(match[1]!)}, ${match[2]}`;
  match = /^(left|right): (.*)$/.exec(own);
  if (match) {
    const said = translated(match[2]!);
    return said && `${PARTS[match[1]!]}: ${said}`;
  }
  match = /^(Δ )?([a-z0-9_]+\.[a-z0-9_.]+), (.*)$/.exec(own); // a channel and what it is
  if (match) {
    const said = translated(match[3]!);
    return said && `${match[1] ?? ""}${match[2]}, ${said}`;
  }
  match = /^(.*)([,;]) (.*)$/.exec(own); // two things that are known, the last of them alone
  if (match) {
    const [one, other] = [
      translated(match[1]!),
      /^[xyz]$/.test(match[3]!) ? match[3]! : translated(match[3]!),
    ];
    return one && other ? `${one}${match[2]} ${other}` : undefined;
  }
  return undefined;
}
