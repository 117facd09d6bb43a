/** The viewer's words, in the language of its page. */

const ENGLISH = {
  light: "Light",
  dark: "Dark",
  showLight: "Show this page light",
  showDark: "Show this page dark",
  failed: "The interactive plots could not be made (#); the figures of this page show the same.",
  choice: "what is shown",
  previous: "previous ([)",
  next: "next (])",
  curves: "curves",
  channels: "channels",
  more: "# more",
  seek: "find a channel",
  seekHint: "names or words, separated by commas; Enter shows the channels found",
  otherChannels: "all other channels",
  zoomIn: "zoom in (+)",
  zoomOut: "zoom out (−)",
  all: "All",
  everything: "everything (0, or double click)",
  event: "Event",
  zoomToEvent: "zoom to the event (9)",
  wide: "Full window",
  fillWindow: "fill the window (f)",
  play: "Play",
  pause: "Pause",
  speed: "speed",
  realTime: "real time",
  fast: "fast",
  hint: "Drag to zoom, double click for everything; Ctrl + wheel zooms, Shift + wheel pans. Keys: space plays, ← → step, + − 0 zoom, [ ] change what is shown, f fills the window.",
  view: "view",
  space: "3-D",
  front: "front",
  side: "side",
  top: "top",
  asSeen: "as seen",
  wheel: "wheel",
  names: "names",
  paths: "paths",
  mechanism: "The mechanism: drag it or press arrow keys to turn it, + or − to zoom",
  mechanismKeys: "← ↑ → ↓ turn, with Shift move; + − zoom, 0 everything",
  noContact: "no contact",
  strut: "spring and damper",
  contactPoint: "contact point",
};

const GERMAN: typeof ENGLISH = {
  light: "Hell",
  dark: "Dunkel",
  showLight: "Seite hell darstellen",
  showDark: "Seite dunkel darstellen",
  failed:
    "Die interaktiven Diagramme konnten nicht erstellt werden (#); die Abbildungen der Seite zeigen dasselbe.",
  choice: "Auswahl",
  previous: "zurück ([)",
  next: "weiter (])",
  curves: "Kurven",
  channels: "Kanäle",
  more: "# weitere",
  seek: "Kanal suchen",
  seekHint: "Namen oder Wörter, durch Kommas getrennt; Eingabe zeigt die gefundenen Kanäle",
  otherChannels: "alle weiteren Kanäle",
  zoomIn: "vergrößern (+)",
  zoomOut: "verkleinern (−)",
  all: "Alles",
  everything: "gesamter Bereich (0 oder Doppelklick)",
  event: "Ereignis",
  zoomToEvent: "auf das Ereignis zoomen (9)",
  wide: "Großansicht",
  fillWindow: "ganzes Fenster nutzen (f)",
  play: "Abspielen",
  pause: "Pause",
  speed: "Tempo",
  realTime: "Echtzeit",
  fast: "schnell",
  hint: "Bereich aufziehen zum Zoomen, Doppelklick zeigt alles; Strg + Mausrad zoomt, Umschalt + Mausrad verschiebt. Tasten: Leertaste spielt ab, ← → Einzelschritt, + − 0 Zoom, [ ] wechselt die Auswahl, f Großansicht.",
  view: "Ansicht",
  space: "3-D",
  front: "vorn",
  side: "Seite",
  top: "oben",
  asSeen: "wie gesehen",
  wheel: "Rad",
  names: "Namen",
  paths: "Bahnkurven",
  mechanism: "Die Radaufhängung: Ziehen oder Pfeiltasten drehen sie, + und − zoomen",
  mechanismKeys: "← ↑ → ↓ drehen, mit Umschalt verschieben; + − Zoom, 0 alles",
  noContact: "kein Bodenkontakt",
  strut: "Feder und Dämpfer",
  contactPoint: "Radaufstandspunkt",
};

export const isGerman = document.documentElement.lang.startsWith("de");
const words = isGerman ? GERMAN : ENGLISH;

/** A text of the viewer; `given` replaces `#`. */
export function say(word: keyof typeof ENGLISH, given = ""): string {
  return words[word].replace("#", () => given);
}

/** Formats a number in the language of the page: minus signs and decimal mark. */
export function localised(text: string): string {
  const signed = text.replaceAll("-", "−");
  return isGerman ? signed.replace(".", ",") : signed;
}

const NUMBER = String.raw`\s*[-+−±]?\d+(?:[.,]\d+)?(?:\s*[a-zA-Z°%µ][^\s,;:]*)?\s*`,
  QUANTITY = new RegExp(`^${NUMBER}(?:(?::|\\.\\.)${NUMBER})*$`);

/** A number with its unit, or a range of them, with the decimal mark of the page. */
export const inField = (text: string): string =>
  isGerman && QUANTITY.test(text) ? text.replace(/(\d)\.(\d)/g, "$1,$2") : text;

/** The same as the server reads it: on German pages, comma and point are both decimal marks. */
export const fromField = (text: string): string =>
  isGerman && QUANTITY.test(text) ? text.replace(/(\d),(\d)/g, "$1.$2").replaceAll("−", "-") : text;

/** A text with the decimal mark of the page in its numbers, such as "22.8 N/mm, 301 rows". */
export const withComma = (text: string): string =>
  isGerman ? text.replace(/(?<![\w.])(\d+)\.(\d+)(?=(?:e[-−]?\d+)?(?!\w|\.\w))/g, "$1,$2") : text;

const SAID: Record<string, string> = {};

const LONGEST = 1200; // characters of a text that is looked up by its template

let patterns: [RegExp, string][] | null = null;

/** Adds German for English texts of a page; `#` stands for any text. */
export function translate(texts: Record<string, string>): void {
  Object.assign(SAID, texts);
  patterns = null;
}

/** German of a known text, also by its template; names and numbers stay. */
function german(text: string): string | undefined {
  if (Object.hasOwn(SAID, text)) return SAID[text];
  if (text.length > LONGEST) return undefined;
  patterns ??= Object.entries(SAID)
    .filter(([words]) => words.includes("#") && words.replaceAll("#", "").trim().length > 4)
    .sort(([one], [other]) => other.length - one.length) // the one that says most first
    .map(([words, said]) => [
      new RegExp(
        `^${words
          .split("#")
          .map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"))
          .join("(.+?)")}$`,
        "s",
      ),
      said,
    ]);
  for (const [pattern, said] of patterns) {
    const [, ...given] = pattern.exec(text) ?? [];
    if (given.length)
      return said.replace(/#/g, () => {
        return heard(given.shift() ?? "");
      });
  }
  return undefined;
}

/** Translates the text of an element if it is a sentence or begins with a capital, which names and paths do not. */
export function heard(text: string): string {
  return (isGerman && /^[A-Z]|\s/.test(text) && german(text)) || text;
}

/** Translates an English text; `given` replaces `#`. */
export function tr(text: string, given = ""): string {
  return ((isGerman && SAID[text]) || text).replace("#", () => given);
}
