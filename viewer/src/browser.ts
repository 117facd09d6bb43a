/** What not every browser has: a language, a place that keeps things. */

// uPlot asks for the language of the browser as it is loaded, and ends the page where that is no language tag ("C", as in containers).
try {
  new Intl.NumberFormat(navigator.language || "-");
} catch {
  Object.defineProperty(navigator, "language", { value: "en" });
}

const allowed = (storage: () => Storage): Storage | null => {
  try {
    return storage();
  } catch {
    return null;
  }
};
/** What is kept for the next visit, and for as long as the tab is open; nothing where the settings forbid it. */
export const lasting = allowed(() => localStorage),
  passing = allowed(() => sessionStorage);
