/** The workbench: pages over one folder. Nothing is computed here; all curves and verdicts come from the server. */

import { leave, make, themeButton } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { mayLeave } from "./drafts";
import { listenForDrops } from "./incoming";
import { languageButton } from "./language";
import { listenForKeys, searchButton } from "./palette";
import { problem } from "./parts";
import { key, quantity, spoken } from "./quantities";
import { savePage } from "./saving";
import { address, carried, carry, live, type Page, setLive } from "./shell";

/** Every page, by the word in its address, in the order of the head; its script is loaded when it is opened. */
const PAGES: Record<string, Page> = {
  project: { label: "Project", load: () => import("./pages/project") },
  rig: { label: "Rig", load: () => import("./pages/rig") },
  trial: { label: "Trial", load: () => import("./pages/trial") },
  kinematics: { label: "Kinematics", load: () => import("./pages/kinematics") },
  kc: { label: "K&C", load: () => import("./pages/kc") },
  dampers: { label: "Dampers", load: () => import("./pages/dampers") },
  record: { label: "Records", load: () => import("./pages/record") },
  data: { label: "Data", load: () => import("./pages/data") },
  campaign: { label: "Campaign", load: () => import("./pages/campaign") },
  ride: { label: "Ride and control", load: () => import("./pages/ride") },
  inspection: { label: "Inspection", load: () => import("./pages/inspection") },
  studies: { label: "Studies", load: () => import("./pages/studies") },
  jobs: { label: "Jobs", load: () => import("./pages/jobs") },
  files: { label: "New files", load: () => import("./pages/files") },
};
/** Pages that the head does not list: they are opened from others. */
const APART = ["files"];

const UNLOADED =
  "This page could not be loaded: check that jounce serve is running, then reload the page.";
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
    const { show: fill } = await PAGES[chosen]!.load().catch(() => {
      throw new Error(tr(UNLOADED));
    });
    if (place.isConnected) await fill(place, new URLSearchParams(values));
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
document.getElementById("pages")!.append(
  ...Object.entries(PAGES)
    .filter(([page]) => !APART.includes(page))
    .map(([page, { label }]) => make("a", { href: address(page), "data-page": page }, label)),
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
listenForDrops();
api.project().then(
  ({ name }) => {
    document.getElementById("project")!.textContent = name;
  },
  () => {},
);
void show()
  .then(() => import("./jobs"))
  .then(({ tellRunning }) => tellRunning())
  .catch(() => {}); // the page says itself that the server does not respond

/** For benchmarks and tests. */
Object.assign(globalThis, {
  jounce: {
    key,
    quantity,
    spoken,
    get live() {
      return live;
    },
  },
});
