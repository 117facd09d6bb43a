/** What the server refuses, in the language of the page: its messages have one grammar, and the commonest are known by their words. */

import { make } from "../page";
import { heard, isGerman, tr } from "../words";

const PHRASES: Record<string, string> = {
  "the key is missing and has no default": "der Schlüssel fehlt und hat keinen Vorgabewert",
  "the key 'model' is missing": "der Schlüssel 'model' fehlt",
  "the key 'kind' is missing": "der Schlüssel 'kind' fehlt",
  misplaced: "am falschen Platz",
  "the schema line is missing or another one": "die Zeile schema fehlt oder ist eine andere",
  "no file matches": "keine Datei passt",
  "the decays have too few swings for a logarithmic decrement":
    "die Ausschwingversuche haben zu wenige Schwingungen für ein logarithmisches Dekrement",
  "no motion of a suspension can be seen in the recording":
    "in der Messung ist keine Bewegung einer Federung zu sehen",
  "the recording is shorter than the obstacle pass": "die Messung ist kürzer als die Überfahrt",
  "a trial it needs could not be used": "ein benötigter Fahrversuch war nicht verwendbar",
  "the update it starts from failed": "der Abgleich, von dem er ausgeht, misslang",
  "thousands separators, or decimals?": "Tausendertrennzeichen oder Dezimalzeichen?",
  "the file takes more memory than there is": "die Datei braucht mehr Speicher, als es gibt",
  "a cell of the header is too long": "eine Zelle der Kopfzeile ist zu lang",
  "a folder stands where the file should be": "ein Ordner steht, wo die Datei sein soll",
  "a file stands where the folder should be": "eine Datei steht, wo der Ordner sein soll",
  "the folder of the output does not exist": "den Ordner der Ausgabe gibt es nicht",
  "the output is a file, not a folder": "die Ausgabe ist eine Datei, kein Ordner",
  "no such path can be": "einen solchen Pfad kann es nicht geben",
  "not a file": "keine Datei",
  "the folder of the store does not exist": "den Ordner des Archivs gibt es nicht",
  "a database of another kind": "eine Datenbank anderer Art",
  "a record store of another version": "ein Archiv einer anderen Fassung",
  "no such store": "kein solches Archiv",
  "the store is damaged: the file is empty": "das Archiv ist beschädigt: die Datei ist leer",
  "no record store, or its start is damaged": "kein Archiv, oder sein Anfang ist beschädigt",
  "no such record": "keine solche Messung",
  "the store is open for reading only": "das Archiv ist nur zum Lesen offen",
  "records of two axles must say of which one they are":
    "Messungen zweier Achsen müssen sagen, von welcher sie sind",
  "two records of the same axle": "zwei Messungen derselben Achse",
  "no tester is given, and the record names none that is known":
    "kein Prüfstand ist angegeben, und die Messung nennt keinen bekannten",
  "the tester of this record is not known": "der Prüfstand dieser Messung ist nicht bekannt",
  "too little signal to fit a quarter car to": "zu wenig Signal, um ein Viertelfahrzeug anzupassen",
  "unknown order of the wheels": "unbekannte Reihenfolge der Räder",
  "unknown axle": "unbekannte Achse",
  "no plate force of any wheel": "keine Plattenkraft eines Rades",
  "the plate does not move": "die Platte bewegt sich nicht",
  "one wheel stands on one plate": "ein Rad steht auf einer Platte",
  "not a tester": "kein Prüfstand",
  "not a wear": "kein Verschleiß",
  "an axle on a tester needs wheels on tyres, and lumped":
    "eine Achse auf einem Prüfstand braucht Räder auf Reifen, ohne Lenkergeometrie",
  "the signals have no time in common": "die Signale haben keine gemeinsame Zeit",
  "the column has another unit": "die Spalte hat eine andere Einheit",
  "the column has no unit": "die Spalte hat keine Einheit",
  "no column 'time'": "keine Spalte 'time'",
  "no channel was found": "kein Kanal gefunden",
  "not a table": "keine Tabelle",
  "the signal is recorded at other instants than the others":
    "das Signal hat andere Zeitpunkte als die anderen",
  "parts of the record were never written": "Teile der Messung wurden nie geschrieben",
  "the file holds none of the samples that it announces":
    "die Datei enthält keinen der Werte, die sie ankündigt",
  "reading the file does not end: it is damaged":
    "das Lesen der Datei endet nicht: sie ist beschädigt",
  "time is zero in every row": "die Zeit ist in jeder Zeile null",
  "the file's suffix is of no known format":
    "die Endung der Datei gehört zu keinem bekannten Format",
  "a variable cannot be chosen in a file of this format":
    "in einer Datei dieses Formats lässt sich keine Variable wählen",
  "no numeric channel": "kein Kanal mit Zahlen",
  "no numeric channel over time": "kein Kanal mit Zahlen über der Zeit",
  "no rows": "keine Zeilen",
  "no sheet with numbers": "kein Blatt mit Zahlen",
  "several sheets hold numbers": "mehrere Blätter enthalten Zahlen",
  "no numeric variable with more than one row": "keine Zahlenvariable mit mehr als einer Zeile",
  "the last word of the channel's name is no known quantity":
    "das letzte Wort des Kanalnamens ist keine bekannte Größe",
  "time has another unit": "die Zeit hat eine andere Einheit",
  "time does not ascend strictly": "die Zeit steigt nicht überall an",
  "the channel has no unit": "der Kanal hat keine Einheit",
  "the channel has another unit": "der Kanal hat eine andere Einheit",
  "the channel has not as many samples as time": "der Kanal hat nicht so viele Werte wie die Zeit",
  "the sample rate is not positive": "die Abtastrate ist nicht positiv",
  "other reasons": "andere Gründe",
  "time and values do not fit together": "Zeit und Werte passen nicht zusammen",
  "not a road file": "keine Straßendatei",
  "not a road table": "keine Straßentabelle",
  "not a distance to drive": "keine Fahrstrecke",
  "not a degree of roughness": "kein Grad der Unebenheit",
  "does not enter the model": "kommt im Modell nicht vor",
  "too few variants that ran": "zu wenige Varianten mit Lauf",
  "the sweep that is to be resumed was another one": "die fortzusetzende Variation war eine andere",
  "the folder holds a sweep": "der Ordner enthält eine Variation",
  "the folder holds no sweep": "der Ordner enthält keine Variation",
  "the results are more than the disk has room for":
    "die Ergebnisse sind mehr, als auf die Platte passt",
  "another process works on this sweep": "ein anderer Prozess arbeitet an dieser Variation",
  "too many samples to keep": "zu viele Werte zum Aufbewahren",
  "no variant has a run": "keine Variante hat einen Lauf",
  "a worker process was ended from outside, again and again":
    "ein Arbeitsprozess wurde immer wieder von außen beendet",
  "the files that are there are read otherwise": "die vorhandenen Dateien werden anders gelesen",
  "a tyre's measurements are named by their pressure":
    "Messungen eines Reifens heißen nach ihrem Druck",
  "not the name of a store": "kein Name eines Archivs",
  "columns separated by comma, semicolon or tab":
    "Spalten, getrennt durch Komma, Semikolon oder Tabulator",
  "out of range": "außerhalb des Bereichs",
  "not a number": "keine Zahl",
  "not a finite number": "keine endliche Zahl",
  "not finite numbers": "keine endlichen Zahlen",
  "not a number with a unit": "keine Zahl mit Einheit",
  "not a physical value": "keine physikalische Größe",
  "wrong unit": "falsche Einheit",
  "the unit is missing": "die Einheit fehlt",
  "the unit does not fit": "die Einheit passt nicht",
  "not a size that anything has": "keine Größe, die etwas haben kann",
  "not a text": "kein Text",
  "not a path": "kein Pfad",
  "not a name": "kein Name",
  "not a text file": "keine Textdatei",
  "not a list of values": "keine Liste von Werten",
  "not a list of finite numbers": "keine Liste endlicher Zahlen",
  "not a range": "kein Bereich",
  "not a step": "keine Schrittweite",
  "not a direction": "keine Richtung",
  "not a distance": "keine Strecke",
  "not a seed": "kein Startwert",
  "not a share": "kein Anteil",
  "not a metric": "kein Kennwert",
  "not a weight": "kein Gewicht",
  "not a rig": "kein Fahrwerk",
  "not a road": "keine Straße",
  "not a road class": "keine Straßenklasse",
  "not a hardpoint": "kein Kinematikpunkt",
  "not a folder": "kein Ordner",
  "a file, not a folder": "eine Datei, kein Ordner",
  "not a standard deviation": "keine Standardabweichung",
  "not a distribution": "keine Verteilung",
  "not a number of variants": "keine Anzahl von Varianten",
  "not a number of searches": "keine Anzahl von Suchläufen",
  "not a name for a run": "kein Name für einen Lauf",
  "not a place in this project": "keine Stelle in diesem Projekt",
  "not a description": "keine Beschreibung",
  "not a date": "kein Datum",
  "the file does not lie beside the campaign": "die Datei liegt nicht neben der Kampagne",
  "no such parameter": "keine solche Größe",
  "no such file": "keine solche Datei",
  "no such quantity": "keine solche Kenngröße",
  "no such job": "kein solcher Auftrag",
  "no such version": "keine solche Fassung",
  "no such place in this text": "keine solche Stelle in diesem Text",
  "no rack moves this wheel": "keine Zahnstange bewegt dieses Rad",
  "no file of measurements": "keine Messdatei",
  "no limit": "keine Grenze",
  "nothing to sweep": "nichts zu durchlaufen",
  "nothing to vary": "nichts zu verändern",
  "nothing is given": "nichts angegeben",
  "nothing to spread over": "nichts, worüber gestreut wird",
  "no number varies": "keine Größe verändert sich",
  "a share of zero": "ein Anteil von null",
  "no whole number lies within": "keine ganze Zahl liegt darin",
  "the mode lies outside its range": "der häufigste Wert liegt außerhalb seines Bereichs",
  "too many values": "zu viele Werte",
  "too many poses": "zu viele Stellungen",
  "too many poses to be waited for": "zu viele Stellungen, um darauf zu warten",
  "too long to be waited for": "zu lang, um darauf zu warten",
  "too many results": "zu viele Ergebnisse",
  "too many jobs run": "zu viele Aufträge laufen",
  "too long for a description": "zu lang für eine Beschreibung",
  "this takes too long": "das dauert zu lange",
  "cannot be read or written": "nicht zu lesen oder zu schreiben",
  "the file cannot be written": "die Datei lässt sich nicht schreiben",
  "the folder cannot be written": "der Ordner lässt sich nicht schreiben",
  "the file is empty": "die Datei ist leer",
  "the file exists": "die Datei gibt es schon",
  "the output exists": "die Ausgabe gibt es schon",
  "the file did not arrive whole": "die Datei kam nicht vollständig an",
  "the file is too large for a description": "die Datei ist zu groß für eine Beschreibung",
  "the file would lie outside the folder": "die Datei läge außerhalb des Ordners",
  "a job writes there already": "ein Auftrag schreibt schon dorthin",
  "the job runs": "der Auftrag läuft",
  "the job wrote no report": "der Auftrag schrieb keinen Bericht",
  "the report is not kept any more": "der Bericht ist nicht mehr aufbewahrt",
  "only descriptions are written here": "hier werden nur Beschreibungen geschrieben",
  "the file was changed meanwhile": "die Datei wurde inzwischen geändert",
  "the recording holds nothing of the trial's time":
    "die Messung enthält nichts von der Zeit des Fahrversuchs",
  "no time": "keine Zeit",
  "time does not ascend": "die Zeit steigt nicht an",
  "the values do not ascend": "die Werte steigen nicht an",
  "the values have different lengths": "die Werte sind verschieden lang",
  "the curve does not ascend": "die Kurve steigt nicht an",
  "the curve has one point": "die Kurve hat einen Punkt",
  "the curve does not reach zero": "die Kurve reicht nicht bis null",
  "the number is missing": "die Zahl fehlt",
  "the row does not have as many cells as the header":
    "die Zeile hat nicht so viele Zellen wie die Kopfzeile",
  "text in a number column": "Text in einer Zahlenspalte",
  "the cell is blank": "die Zelle ist leer",
  "decimal comma": "Dezimalkomma",
  "decimal commas and decimal points in one file": "Dezimalkommas und Dezimalpunkte in einer Datei",
  "the header is missing": "die Kopfzeile fehlt",
  "the header has no unit": "die Kopfzeile hat keine Einheit",
  "a header but no rows of numbers": "eine Kopfzeile, aber keine Zeilen mit Zahlen",
  "the channel is missing": "der Kanal fehlt",
  "two points are the same, or three lie on one line":
    "zwei Punkte sind gleich, oder drei liegen auf einer Linie",
  "the spring's lengths contradict each other": "die Längen der Feder widersprechen sich",
  "left and right points lie on the same side":
    "linke und rechte Punkte liegen auf derselben Seite",
  "the wheel is not on the road": "das Rad steht nicht auf der Straße",
  "there is no controller": "es gibt keinen Regler",
  "the loops cannot be closed": "die Schleifen lassen sich nicht schließen",
  "the run did not reach its end": "der Lauf kam nicht ans Ende",
  "the road is shorter than the run": "die Straße ist kürzer als die Fahrt",
  "this rig has no hardpoints": "dieses Fahrwerk hat keine Kinematikpunkte",
  "a trial has its own road": "ein Fahrversuch hat seine eigene Straße",
  "no road to drive over": "keine Straße zum Befahren",
  "no speed to drive at": "keine Geschwindigkeit",
  "the campaign has no update": "die Kampagne hat keine Modellanpassung",
  "no trial to fit": "kein Fahrversuch zum Anpassen",
  "too few samples": "zu wenige Messwerte",
  "too few rows": "zu wenige Zeilen",
  "no static equilibrium": "kein statisches Gleichgewicht",
  "no target is given": "kein Ziel angegeben",
  "nothing is judged by it": "nichts wird danach beurteilt",
  "the output folder is not empty": "der Ausgabeordner ist nicht leer",
  required: "erforderlich",
  "not known here": "hier nicht bekannt",
  "a finite number": "eine endliche Zahl",
  "a whole number": "eine ganze Zahl",
  "a lower and a higher value": "ein kleinerer und ein größerer Wert",
};
const KINDS: Record<string, string> = {
  channel: "Kanal",
  key: "Schlüssel",
  road: "Straße",
  metric: "Kennwert",
  model: "Modell",
  controller: "Regler",
  quantity: "Kenngröße",
  "kind of road": "Art von Straße",
};

/** A message of the server in the language of the page; what is not known by its words stays as it is, names and numbers always do. */
export function told(message: string): string {
  const text = raised(message).replace(
    " or allow it with --force.",
    message.includes("the output folder is not empty")
      ? ", or begin it again, which replaces what is there."
      : ".",
  ); // no page has options
  if (!isGerman) return text;
  return text.split("\n").map(german).join("\n");
}

/** One of the lines of a message, in German. */
function german(text: string): string {
  const [head, ...tail] = text.split(/(?=; (?:found|allowed:) )/);
  const more = tail.map((part) =>
    part
      .replace(/^; found /, "; gefunden ")
      .replace(
        /^(; )allowed: ([^.?]*(?:\.\d[^.?]*)*)/,
        (_, semicolon: string, given: string) => `${semicolon}zulässig: ${limits(given)}`,
      ),
  );
  return hints(phrase(head!) + more.join(""));
}

/** Units in sentences as tables write them: m/s², m³. */
export const raised = (text: string) =>
  text.replace(/(?<=\b(?:k?m|s|N|rad))\^([23])/g, (_, power: string) =>
    power === "2" ? "²" : "³",
  );

function phrase(head: string): string {
  const at = head.indexOf(": "),
    full = /^(.*?)([.?]?(?: .*)?)$/s.exec(head)!;
  if (PHRASES[head]) return PHRASES[head];
  const [, what, end] = /^([^.]*)(\.?(?: [A-Z].*)?)$/s.exec(head) ?? full;
  if (PHRASES[what!]) return PHRASES[what!]! + end;
  const unknown = /^unknown ([a-z ]+) ('.*')(.*)$/s.exec(head);
  if (unknown)
    return `${KINDS[unknown[1]!] ?? unknown[1]} ${unknown[2]} ist nicht bekannt${unknown[3]}`;
  return at > 0 ? head.slice(0, at + 2) + phrase(head.slice(at + 2)) : head; // the place comes before what is wrong there
}

function limits(given: string): string {
  if (PHRASES[given]) return PHRASES[given];
  return /^(above|at least|at most)\b/.test(given)
    ? given
        .replaceAll("above ", "über ")
        .replaceAll("at least ", "mindestens ")
        .replaceAll("at most ", "höchstens ")
    : given;
}

const HINTS: Record<string, string> = {
  "Choose a record of the project.": "Eine Messung aus dem Projekt wählen.",
  "Put the new files in place of those, or give all of them the same columns.":
    "Die neuen Dateien an deren Stelle setzen, oder allen dieselben Spalten geben.",
  "Begin it again, or give another folder.": "Neu beginnen oder einen anderen Ordner angeben.",
  "Choose another name, or begin it again, which replaces what is there.":
    "Einen anderen Namen wählen oder neu beginnen, was Vorhandenes ersetzt.",
  "Upload it there, or copy it.": "Sie dorthin laden oder kopieren.",
  "Choose another name.": "Einen anderen Namen wählen.",
  "Check the path, the permissions and the space on the disk.":
    "Pfad, Rechte und Platz auf der Platte prüfen.",
  "Wait for it, or choose another folder.": "Darauf warten oder einen anderen Ordner wählen.",
  "Wait for one of them, or cancel it.": "Auf einen warten oder ihn abbrechen.",
  "Load it again, and make your change there.": "Neu laden und die Änderung dort machen.",
  "Check the path and the name.": "Pfad und Namen prüfen.",
  "Drive for longer (duration).": "Länger fahren (Dauer).",
  "Fill the gap or remove the row.": "Die Lücke füllen oder die Zeile löschen.",
  "Fill it or remove the row.": "Sie füllen oder die Zeile löschen.",
  "Choose one of the project.": "Eine aus dem Projekt wählen.",
  "Cancel it first.": "Ihn zuerst abbrechen.",
  "Check spelling and case, e.g. ": "Schreibweise prüfen, z. B. ",
  ", line ": ", Zeile ",
  "not valid TOML: ": "kein gültiges TOML: ",
  "Expected newline or end of document after a statement": "nach einer Angabe fehlt ein Zeilenende",
  "Invalid statement": "ungültige Angabe",
  "Invalid value": "ungültiger Wert",
  "Expected '=' after a key in a key/value pair": "nach einem Schlüssel fehlt '='",
  "Cannot overwrite a value": "ein Wert steht schon da",
  "Unclosed array": "eine Liste ist nicht geschlossen",
  "Unclosed inline table": "eine Tabelle in einer Zeile ist nicht geschlossen",
  "Unterminated string": "ein Text ist nicht geschlossen",
  "(at end of document)": "(am Ende)",
  "<number>": "<Zahl>",
  "Map it with columns, or give the sample time.":
    "Sie mit den Spalten zuordnen oder die Abtastzeit angeben.",
  "Map columns to channels with columns.": "Spalten den Kanälen zuordnen.",
};

function hints(given: string): string {
  let text = given.replace(
    /a unit that converts to ([^.;]*?)(?=[.;]|$)/,
    "eine Einheit, die sich in $1 umrechnen lässt",
  );
  for (const [english, german] of Object.entries(HINTS)) text = text.replace(english, german);
  return text
    .replace(/\(at line (\d+), column (\d+)\)/, "(Zeile $1, Spalte $2)")
    .replace(
      /Did you mean (.*?)\?/,
      (_, names: string) => `Ist ${names.replace(" or ", " oder ")} gemeint?`,
    )
    .replace(/All (\d+): /, "Alle $1: ")
    .replace(/Known: /, "Bekannt: ");
}

/** What the server refuses, as an error in the language of the page that knows what was said. */
export class Refused extends Error {
  constructor(readonly said: string) {
    super(told(said));
  }
}

/** A sentence of the library: in the language of the page where it is known by its words, else as it is, and said to be English. */
export function asSaid(message: string): Node | string {
  const given = raised(message),
    text = told(given);
  return isGerman && text === given && heard(given) === given && /[a-z] [a-z]/.test(given)
    ? make("span", { lang: "en" }, given)
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
        .map((one) => PLACES[one] ?? one)
        .join(": ")
    : place;

/** A finding of the library; those of a catalogue come with their German sentence. */
export interface Finding {
  severity?: string;
  place?: string;
  message: string;
  german?: string;
  numbers?: { error?: string };
}

/** The sentence of a finding in the language of the page; an error within it is translated by itself. */
function sentence({ message, german, numbers }: Finding): Node | string {
  if (!isGerman || !german) return asSaid(message);
  const error = numbers?.error ?? "";
  return raised(german.replace(error, () => told(error)));
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
        sentence(finding),
      ),
    );
  }
  return [...shown.values()];
}
