/** What the library finds, in German: by the template of each message, `#` being what is filled in. */

import { isGerman } from "../words";
import catalogue from "./findings.json";

const { words, ...messages } = catalogue as Record<string, Record<string, string>>;
let patterns: [RegExp, string][] | null = null;

/** A message in German; nothing where its words are not known. `#2` is the second thing that the English one is filled with, `#` the next; what is filled in and is no finding itself is said by `told`. */
export function found(message: string, told = (text: string) => text): string | undefined {
  if (!isGerman) return undefined;
  patterns ??= Object.entries(
    Object.assign({}, ...Object.values(messages), words) as Record<string, string>,
  )
    .sort(([one], [other]) => other.replaceAll("#", "").length - one.replaceAll("#", "").length) // the one that says most first
    .map(([english, german]) => [
      new RegExp(
        `^${english
          .replace(/\^([23])/g, (_, power: string) => (power === "2" ? "²" : "³"))
          .split("#")
          .map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"))
          .join("(.*?)")}$`,
        "s",
      ),
      german,
    ]);
  for (const [pattern, german] of patterns) {
    const match = pattern.exec(message);
    if (!match) continue;
    const given = match.slice(1);
    let next = 0;
    return german.replace(/#(\d?)/g, (_, which: string) => {
      const one = given[which ? Number(which) - 1 : next++] ?? "";
      return found(one, told) ?? told(one);
    });
  }
  return undefined;
}
