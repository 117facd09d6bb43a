/** Basic functions for all components: elements, numbers, colours. */

import { heard, inField, localised, say, tr } from "./words";

const HEARD = ["aria-label", "title", "placeholder"];
type Attributes = Record<string, string | boolean | ((event: never) => void)>;

/** Makes an element; texts become text, never markup. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...content: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, given] of Object.entries(attributes)) {
    const value =
      name === "value" && typeof given === "string" && attributes.type === "text"
        ? inField(given)
        : given;
    if (typeof value === "function") element.addEventListener(name, value as EventListener);
    else if (typeof value === "boolean") element.toggleAttribute(name, value);
    else
      element.setAttribute(
        name,
        HEARD.includes(name)
          ? attributes.role === "region" && tr(value) !== value
            ? tr(value)
            : heard(value)
          : value,
      ); // regions are words, however they begin
  }
  const own = attributes.scope === "col" || /^mark\b/.test(String(attributes.class ?? "")); // heads and verdicts are words, however they begin
  element.append(
    ...content.map((item) =>
      typeof item !== "string" ? item : own && tr(item) !== item ? tr(item) : heard(item),
    ),
  );
  return element;
}

export function toggle(
  label: string,
  pressed: boolean,
  change: (pressed: boolean) => void,
  title = "",
): HTMLButtonElement {
  const button = make("button", { type: "button", "aria-pressed": String(pressed), title }, label);
  button.addEventListener("click", () => {
    const now = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(now));
    change(now);
  });
  return button;
}

/** Formats a number with significant digits, without an exponent if that is easier to read. */
export function written(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e") as [string, string];
  const power = Number(exponent);
  const text =
    power < -4 || power > 5
      ? `${mantissa}e${power}`
      : value.toFixed(Math.max(0, digits - 1 - power));
  return localised(text);
}

/** Formats a value and its interval with enough digits to distinguish the ends. */
export function withInterval(
  value: number,
  [low, high]: [number, number],
  digits = 4,
): [string, string] {
  const apart = Math.abs(high - low),
    size = Math.max(Math.abs(low), Math.abs(high));
  const enough =
    apart > 0 && Number.isFinite(size / apart)
      ? Math.min(Math.max(digits, Math.ceil(Math.log10(size / apart)) + 2), 12)
      : digits;
  return [written(value, enough), `${written(low, enough)} … ${written(high, enough)}`];
}

/** The same of a value that is known to a step only: digits below it are not written. */
export function writtenTo(value: number, step: number): string {
  if (!Number.isFinite(value) || !(step > 0)) return written(value);
  const decimals = Math.min(Math.max(0, Math.ceil(-Math.log10(step))), 100);
  const rounded = Number(value.toFixed(decimals));
  return rounded === 0 ? "0" : written(rounded);
}

export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim() || "#888";
}

let fast: boolean | null = null;

/** Whether a graphics card renders. */
export function isFast(): boolean {
  if (fast === null) {
    const probe = document
      .createElement("canvas")
      .getContext("webgl2", { failIfMajorPerformanceCaveat: true });
    const info = probe?.getExtension("WEBGL_debug_renderer_info"); // not every browser says that it draws in software
    const name = info ? String(probe!.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
    fast = probe !== null && !/swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
    probe?.getExtension("WEBGL_lose_context")?.loseContext();
  }
  return fast;
}

/** Sets the size of a canvas in CSS pixels at the resolution of the screen, and clears it. */
export function sized(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D {
  const scale = Math.min(devicePixelRatio || 1, 3);
  canvas.width = Math.round(width * scale);
  canvas.height = Math.round(height * scale);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.scale(scale, scale);
  return context;
}

const listeners = new Set<() => void>();

/** Calls back when the colour scheme or the resolution changes. */
export function whenColoursChange(change: () => void): void {
  listeners.add(change);
}

const left = new Set<() => void>();

/** Calls back when the current page is left. */
export function whenLeft(does: () => void): void {
  left.add(does);
}

/** Notifies listeners that the current page was left, and frees its resources. */
export function leave(): void {
  for (const does of left) does();
  left.clear();
  listeners.clear();
}

function changed(): void {
  for (const change of listeners) change();
}

function watchPixels(): void {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
    "change",
    () => {
      changed();
      watchPixels();
    },
    { once: true },
  );
}
watchPixels();

/** Light, dark, or the system's setting. */
export function themeButton(): HTMLButtonElement {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const root = document.documentElement;
  const isDark = () => (root.dataset.theme ? root.dataset.theme === "dark" : system.matches);
  const button = make("button", { type: "button", class: "theme" });
  const name = () => {
    button.textContent = say(isDark() ? "light" : "dark");
    button.title = say(isDark() ? "showLight" : "showDark");
  };
  button.addEventListener("click", () => {
    root.dataset.theme = isDark() ? "light" : "dark";
    name();
    changed();
  });
  system.addEventListener("change", () => {
    name();
    changed();
  });
  name();
  return button;
}

/** Set-up of every page, with or without curves. */
export function dress(): void {
  document.documentElement.classList.add("live");
  document.querySelector("header")?.append(themeButton());
  const all = <K extends string>(selector: K) =>
    document.querySelectorAll<HTMLDetailsElement>(selector);
  addEventListener("beforeprint", () =>
    all("details:not([open])").forEach((element) => {
      element.dataset.folded = "";
      element.open = true;
    }),
  );
  addEventListener("afterprint", () =>
    all("details[data-folded]").forEach((element) => {
      delete element.dataset.folded;
      element.open = false;
    }),
  );
}
