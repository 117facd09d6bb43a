/** The workbench in German, by its English texts; what the server refuses is in `refusals`. */

import { translate } from "../words";
import german from "./german.json";

translate(german);
