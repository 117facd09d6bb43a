/** What the server says is wrong: an English text with its German, which the server knows; a text without is said to be English. */

import { make } from "../page";
import { heard, isGerman, tr } from "../words";

/** German of texts that stand in answers by themselves, by the English; it comes with the answers. */
const TRANSLATIONS = new Map<string, string>();

/** Takes the German that came with an answer, and gives the answer. */
export function learnt<T>(answer: T): T {
  const { translations, result } = (answer ?? {}) as {
    translations?: Record<string, string>;
    result?: unknown;
  };
  for (const [english, german] of Object.entries(translations ?? {}))
    TRANSLATIONS.set(english, german);
  if (result) learnt(result);
  return answer;
}

/** Units in sentences as tables write them: m/s², m³. */
export const raised = (text: string) =>
  text.replace(/(?<=\b(?:k?m|s|N|rad))\^([23])/g, (_, power: string) =>
    power === "2" ? "²" : "³",
  );

/** A message in the language of the page, and English where it has no German. */
export const inLanguage = (english: string, german?: string | null): string =>
  raised((isGerman && (german ?? TRANSLATIONS.get(english))) || english);

/** What the server refuses, with its German. */
export class Refused extends Error {
  constructor(
    readonly english: string,
    readonly german?: string | null,
  ) {
    super(inLanguage(english, german));
  }
}

/** A sentence of the library in the language of the page, else as it is, and said to be English. */
export function asSaid(english: string, german?: string | null): Node | string {
  const text = inLanguage(english, german);
  return isGerman && text === raised(english) && heard(text) === text && /[a-z] [a-z]/.test(text)
    ? make("span", { lang: "en" }, text)
    : heard(text);
}

/** What a finding is about, where that is no name. */
const PLACES: Record<string, string> = {
  "linear law": "lineares Gesetz",
  law: "Gesetz",
  intervals: "Intervalle",
  "operating point": "Betriebspunkt",
  "tyre pressure": "Reifendruck",
  trials: "Versuche",
  decays: "Ausschwingversuche",
  posterior: "Posterior",
  predictions: "Vorhersagen",
  starts: "Suchläufe",
  variants: "Varianten",
  statistics: "Statistik",
  sensitivity: "Abhängigkeiten",
  spreads: "Streuungen",
  "closed forms": "geschlossene Formeln",
  "lumped model": "Ersatzmodell",
  curve: "Kurve",
  intercept: "Achsenabschnitt",
};
const placed = (place: string) =>
  isGerman
    ? place
        .split(": ")
        .map((part) => PLACES[part] ?? part)
        .join(": ")
    : place;

/** A finding of the library; those of a catalogue come with their German sentence. */
export interface Finding {
  severity?: string;
  place?: string;
  message: string;
  german?: string;
}

/** Findings, each with how grave it is and what it is about. */
export function advised(findings: Finding[], tag: "p" | "li"): HTMLElement[] {
  const shown = new Map<string, HTMLElement>();
  for (const finding of findings) {
    const { severity, place, message } = finding;
    shown.set(
      `${severity} ${place} ${message}`,
      make(
        tag,
        { class: severity === "problem" ? "problem" : tag === "p" ? "muted" : "" },
        ...(severity ? [`${tr(severity)}: `] : []),
        ...(place ? [`${placed(place)}: `] : []),
        asSaid(message, finding.german),
      ),
    );
  }
  return [...shown.values()];
}

/** What went wrong, as a paragraph. */
export function problem(error: unknown): HTMLElement {
  return make(
    "p",
    { class: "problem", role: "alert" },
    error instanceof Refused
      ? asSaid(error.english, error.german)
      : error instanceof Error
        ? error.message
        : String(error),
  );
}
