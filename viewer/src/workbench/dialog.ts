/** Dialogs, and sentences for those who cannot see that something happened elsewhere on the page. */

import { make } from "../page";

/** A dialog that is removed when it closes; a click beside it closes it. */
export function dialog(kind: string, label: string, ...content: Node[]): HTMLDialogElement {
  const whole = make("dialog", { class: kind, "aria-label": label }, ...content);
  whole.addEventListener("close", () => whole.remove());
  whole.addEventListener("click", (event) => {
    if (event.target === whole) whole.close();
  });
  document.body.append(whole);
  whole.showModal();
  return whole;
}

const spoken = make("div", { class: "hidden", role: "status" });

/** Says a sentence to screen readers. */
export function announce(text: string): void {
  (document.querySelector("dialog[open]") ?? document.body).append(spoken); // what lies behind a dialog is not heard
  spoken.textContent = "";
  setTimeout(() => {
    spoken.textContent = text;
  }, 50); // the same text twice is heard twice
}
