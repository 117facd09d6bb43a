/** The workbench: pages over one folder. Nothing is computed here; all curves and verdicts come from the server. */

import { languageButton } from "./language";
import "./german";
import "uplot/dist/uPlot.min.css";
import "../../../src/jounce/report/templates/colours.css";
import "../viewer.css";
import "./workbench.css";
import "./work.css";
import { leave, make, themeButton } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { mayLeave } from "./drafts";
import { campaign } from "./pages/campaign";
import { inspection } from "./pages/inspection";
import { jobs } from "./pages/jobs";
import { kinematics } from "./pages/kinematics";
import { project } from "./pages/project";
import { record } from "./pages/record";
import { ride } from "./pages/ride";
import { rig } from "./pages/rig";
import { studies } from "./pages/studies";
import { trial } from "./pages/trial";
import { listenForKeys, searchButton } from "./palette";
import { problem } from "./parts";
import { savePage } from "./saving";
import { address, carried, carry, type Page, setLive } from "./shell";

export { key, quantity, spoken } from "./quantities";
export { live } from "./shell";

/** Every page, by the word in its address, in the order of the head. */
const PAGES: Record<string, Page> = {
  project,
  rig,
  trial,
  kinematics,
  record,
  campaign,
  ride,
  inspection,
  studies,
  jobs,
};

const LABELS = Object.fromEntries(Object.entries(PAGES).map(([page, { label }]) => [page, label]));

async function show(): Promise<void> {
  const [page = "", values = ""] = location.hash.replace(/^#\//, "").split("?");
  const chosen = page in PAGES ? page : "project";
  leave();
  setLive(null);
  const place = make("div", {}, make("p", { class: "muted" }, "loading …")); // its own: a page that was left fills nothing any more
  document.querySelectorAll("#pages a").forEach((link) => {
    if ((link as HTMLAnchorElement).dataset.page === chosen)
      link.setAttribute("aria-current", "page");
    else link.removeAttribute("aria-current");
  });
  carry(carried(chosen, new URLSearchParams(values)));
  document.title = `${tr(PAGES[chosen]!.label)} – jounce workbench`;
  document.getElementById("main")!.replaceChildren(savePage(), place);
  try {
    await PAGES[chosen]!.show(place, new URLSearchParams(values));
  } catch (error) {
    carry(""); // it may be gone
    place.replaceChildren(
      make("h1", {}, PAGES[chosen]!.label),
      problem(error),
      make("p", {}, make("a", { href: address("project") }, "Back to the project")),
    );
  }
  if (!place.isConnected) return;
  const heading = place.querySelector("h1")?.textContent ?? "";
  if (heading && heading !== tr(PAGES[chosen]!.label))
    document.title = `${heading} – ${document.title}`; // which rig or record is in which tab
  document.documentElement.dataset.ready = chosen;
}

document.documentElement.classList.add("live");
document
  .getElementById("pages")!
  .append(
    ...Object.entries(PAGES).map(([page, { label }]) =>
      make("a", { href: address(page), "data-page": page }, label),
    ),
  );
document.querySelector("header")!.append(searchButton(LABELS), languageButton(), themeButton());
listenForKeys(LABELS);
document.getElementById("pages")!.setAttribute("aria-label", tr("Pages"));
const skip = document.querySelector(".skip")!;
skip.textContent = tr("Skip to the content");
skip.addEventListener("click", (event) => {
  event.preventDefault();
  document.getElementById("main")!.focus();
}); // an address names a page here
let shown = location.hash;
addEventListener("hashchange", () => {
  if (location.hash !== shown && !mayLeave()) {
    history.replaceState(null, "", shown || address("project"));
    return;
  }
  shown = location.hash;
  delete document.documentElement.dataset.ready;
  void show().then(() => {
    if (document.activeElement === document.body)
      document.getElementById("main")!.focus({ preventScroll: true });
  }); // the link that led here is gone
});
for (const one of ["dragover", "drop"] as const)
  addEventListener(one, (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  }); // a file that misses its place does not take that of the page
api.project().then(
  ({ name }) => {
    document.getElementById("project")!.textContent = name;
  },
  () => {},
);
void show();
