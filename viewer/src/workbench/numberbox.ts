/** Fields for plain numbers, with the decimal mark of the page instead of that of the browser. */

import { make } from "../page";
import { inField, isGerman } from "../words";

const SHOWN = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")!;

/**
 * Makes a field for a number. Its `value` has a point, as in code; a German page shows a comma, takes comma or point,
 * and marks what is no number between `min` and `max`; the arrow keys change it as elsewhere.
 */
export function numberBox(attributes: Record<string, string> = {}): HTMLInputElement {
  const { value = "", min, max, step, ...others } = attributes;
  if (!isGerman) return make("input", { type: "number", class: "number", ...attributes });
  const input = make("input", { type: "text", inputmode: "decimal", class: "number", ...others }),
    [least, greatest] = [Number(min ?? -Infinity), Number(max ?? Infinity)];
  const read = () => {
    const plain = SHOWN.get!.call(input).trim().replace(",", ".").replaceAll("−", "-");
    return plain !== "" && Number.isFinite(Number(plain)) ? plain : "";
  };
  input.defaultValue = inField(value);
  Object.defineProperties(input, {
    value: { get: read, set: (text: string) => SHOWN.set!.call(input, inField(String(text))) },
    valueAsNumber: { get: () => (read() === "" ? Number.NaN : Number(read())) },
    defaultValue: { value },
  });
  input.addEventListener("input", () => {
    const number = input.valueAsNumber,
      isEmpty = SHOWN.get!.call(input).trim() === "";
    if (isEmpty || (number >= least && number <= greatest)) input.removeAttribute("aria-invalid");
    else input.setAttribute("aria-invalid", "true");
  });
  input.addEventListener("keydown", (event) => {
    const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const next = (input.valueAsNumber || 0) + way * (Number(step) || 1);
    input.value = String(Number(Math.min(greatest, Math.max(least, next)).toPrecision(12)));
    for (const name of ["input", "change"]) input.dispatchEvent(new Event(name, { bubbles: true }));
  });
  return input;
}
