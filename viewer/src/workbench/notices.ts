/** Telling that long work has ended: to screen readers, in the title of the tab, and by the system if the user allows it. */

import { make } from "../page";
import { tr } from "../words";
import { announce } from "./dialog";

const MARK = /^[✓✗] /;

function clear(): void {
  if (!document.hidden) document.title = document.title.replace(MARK, "");
}
document.addEventListener("visibilitychange", clear);
addEventListener("focus", clear);

/** Tells it. The title is marked, and the system shows it, if the tab is not looked at. */
export function notify(text: string, isGood: boolean): void {
  announce(text);
  if (!document.hidden && document.hasFocus()) return;
  document.title = `${isGood ? "✓" : "✗"} ${document.title.replace(MARK, "")}`;
  if ("Notification" in globalThis && Notification.permission === "granted") {
    try {
      new Notification("jounce", { body: text }).addEventListener("click", () => focus());
    } catch {
      // phones show them from a service worker only: the title tells it
    }
  }
}

/** A button that asks the browser for leave to notify, and what was answered. */
export function noticeButton(): HTMLElement {
  const said = make("span", { class: "muted", role: "status" }),
    press = make("button", { type: "button" }, tr("Notify me when a job ends")),
    whole = make("p", { class: "bar" }, press, said);
  const show = () => {
    const answer = "Notification" in globalThis ? Notification.permission : "denied";
    press.hidden = answer !== "default";
    said.textContent =
      answer === "granted"
        ? tr("The system notifies you when a job ends and this tab is not in front.")
        : answer === "denied"
          ? tr(
              "This browser shows no notifications of this page; the title of the tab is marked when a job ends.",
            )
          : "";
  };
  press.addEventListener("click", () => void Notification.requestPermission().then(show));
  show();
  return whole;
}
