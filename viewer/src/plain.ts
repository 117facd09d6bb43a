/** A page without curves that move: light and dark, and printing. */

import { dress } from "./page";

dress();
document.documentElement.dataset.ready = "";
