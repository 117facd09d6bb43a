/** The workbench in German, by its English texts; what the server refuses is in `refusals`. Only a German page loads it. */

import { translate } from "../words";
import texts from "./german.json";
import { TERMS } from "./terms";
import terms from "./terms.json";

translate(texts);
translate({
  ...Object.fromEntries(Object.entries(terms.words).filter(([english]) => /\s/.test(english))),
  ...terms.parts,
});
Object.assign(TERMS, terms);
