/** The token of the printed address: stored by the first script, so that an address opened right after it is known, too. */

import { lasting } from "../browser";

const KEY = "jounce-token",
  brought = new URLSearchParams(location.search).get("token");
/** Token from the printed address, sent with every request. It is stored for this address, for all tabs, and sent to no other. */
export const token = brought ?? lasting?.getItem(KEY) ?? "";
if (brought !== null) {
  try {
    lasting?.setItem(KEY, token);
  } catch {
    /* full: it is known as long as this page is open */
  }
  history.replaceState(null, "", location.pathname + location.hash);
}
