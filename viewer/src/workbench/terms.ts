/** German terms of what Python names; `german` fills them in. */

type Terms = Record<string, string>;

/** Of quantities of the kinematic catalogue (as short as a header), parts, keys of a description, and channels and metrics. */
export const TERMS: Record<"quantities" | "parts" | "keys" | "words", Terms> = {
  quantities: {},
  parts: {},
  keys: {},
  words: {},
};
