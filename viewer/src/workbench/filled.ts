/** Lists that are filled anew after every change keep the keyboard where it was. */

/** Replaces the content of an element; what has the same name as what had the focus gets it back. */
export function fill(element: HTMLElement, ...content: (Node | string)[]): void {
  const active = document.activeElement,
    name = element.contains(active) ? nameOf(active) : "";
  element.replaceChildren(...content);
  if (!name) return;
  const same = [...element.querySelectorAll<HTMLElement>("button, input, select, a")];
  (same.find((element) => nameOf(element) === name) ?? same[0])?.focus();
}

const nameOf = (element: Element | null): string =>
  element?.getAttribute("aria-label") || element?.textContent || "";
