/** Which language the page speaks: the one that was chosen here, else the browser's; known before any other text is made. */

import { lasting } from "../browser";

const KEY = "jounce-language",
  chosen = lasting?.getItem(KEY);
export const language =
  chosen === "de" || chosen === "en" ? chosen : navigator.language.startsWith("de") ? "de" : "en";
document.documentElement.lang = language;

/** A button to the other language; the page is made anew in it. */
export function languageButton(): HTMLButtonElement {
  const button = document.createElement("button"),
    other = language === "de" ? "en" : "de";
  button.type = "button";
  button.className = "language";
  button.lang = other;
  button.textContent = other === "de" ? "Deutsch" : "English";
  button.addEventListener("click", () => {
    lasting?.setItem(KEY, other);
    location.reload();
  });
  return button;
}
