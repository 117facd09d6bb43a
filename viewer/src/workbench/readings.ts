/** How far recordings are read, while an answer about them is awaited. */

import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";

interface Reading {
  path: string;
  share: number | null;
  seconds: number;
}

const PAUSE = 400; // ms before the first look, and between two

/** Waits for an answer; shows in a place what is being read meanwhile. */
export async function whileReading<T>(place: HTMLElement, answer: Promise<T>): Promise<T> {
  let isOver = false;
  const follow = async () => {
    while (true) {
      await new Promise((done) => setTimeout(done, PAUSE));
      if (isOver) return;
      const readings = await api.get<Reading[]>("/api/data/reading");
      if (isOver) return;
      place.replaceChildren(...readings.map(row));
    }
  };
  follow().catch(() => {}); // the answer itself says what is wrong
  try {
    return await answer;
  } finally {
    isOver = true;
    place.replaceChildren();
  }
}

function row({ path, share, seconds }: Reading): HTMLElement {
  const text = tr("Reading #", path),
    bar = make("progress", { max: "1", "aria-label": text });
  if (share !== null) bar.value = share;
  const spent = `${seconds.toFixed(0)} s`;
  return make(
    "p",
    { class: "being-read" },
    make("span", {}, text),
    bar,
    make(
      "span",
      { class: "muted" },
      share === null ? spent : `${Math.round(100 * share)} %, ${spent}`,
    ),
  );
}
