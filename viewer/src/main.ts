/** Starts a report: a player at each place for one, light and dark colours, and printing. */

import "./browser";
import "uplot/dist/uPlot.min.css";
import "./viewer.css";
import { Store } from "./data";
import { dress, make } from "./page";
import { Player } from "./player";
import { say } from "./words";

export { MechanismView } from "./mechanism";
export { LinkedPlots } from "./plots";
export { Player, Store };

/** Players of this page, in order. */
export const players: Player[] = [];

/** A link to `#show-NAME` shows that scene in the player. */
function links(): void {
  document.addEventListener("click", (event) => {
    const link = (event.target as Element).closest<HTMLAnchorElement>("a[data-show]");
    if (!link) return;
    for (const player of players) {
      if (player.choose(link.dataset.show!)) {
        event.preventDefault();
        player.element.scrollIntoView({ behavior: "smooth", block: "start" });
        player.element.focus({ preventScroll: true });
        return;
      }
    }
  });
}

async function start(): Promise<void> {
  dress();
  const data = document.getElementById("jounce-data");
  if (data) {
    const places = document.querySelectorAll<HTMLElement>("[data-viewer]");
    try {
      const store = await Store.open(data.textContent!);
      places.forEach((place) => {
        const player = new Player(store.content.viewers[Number(place.dataset.viewer)]!, store);
        players.push(player);
        place.replaceChildren(player.element);
      });
      links();
    } catch (error) {
      places.forEach((place) =>
        place.replaceChildren(make("p", { class: "bad" }, say("failed", String(error)))),
      );
    }
  }
  document.documentElement.dataset.ready = "";
}

void start();
