/** Features that some browsers lack: a language and storage. */

// uPlot reads the browser's language when it loads, and fails if that is not a language tag ("C", as in containers).
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
/** Storage for later visits and for this tab; null if the settings forbid it. */
export const lasting = allowed(() => localStorage),
  passing = allowed(() => sessionStorage);
