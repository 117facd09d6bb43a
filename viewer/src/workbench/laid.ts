/** What the parts of the page of recordings share. */

import { written } from "../page";
import { localised, tr } from "../words";
import type { Layout } from "./layout";
import { unitText } from "./quantities";

export interface Said {
  text: string;
  german: string | null;
}
/** A recording of the layout as the server sees it. */
export interface Track {
  path: string;
  digest: string;
  problem: Said | null;
  ends: [number, number] | null;
  count: number;
  channels: { name: string; unit: string }[];
  formulas: { name: string; unit: string; problem: Said | null; notes: Said[] }[];
}

/** What the parts of the page share: the layout, what is known of its recordings, and the call after a change. */
export interface Laid {
  layout: Layout;
  tracks: Track[];
  /** Unit of the common axis. */
  unit: string;
  /** The layout was changed: everything follows. */
  changed(): void;
}

/** Number of a recording's samples and where it lies, in words. */
export const extent = ({ count, ends }: Track, unit: string): string =>
  ends
    ? `${tr("# samples", localised(String(count)))}, ${written(ends[0], 6)} … ${written(ends[1], 6)} ${unitText(unit)}`
    : "";
