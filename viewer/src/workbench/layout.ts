/** The state of the page of recordings as one plain layout, in its address: kept over a reload, shared as a link. */

export interface LaidRecording {
  path: string;
  shown: boolean;
  shifts: Record<string, number>;
}
export interface Formula {
  name: string;
  formula: string;
  unit: string;
}
export interface Event {
  at: number;
  text: string;
  recording: string;
  axis: string;
}
export interface Chart {
  kind: "" | "spectrum" | "histogram" | "scatter";
  channel: string;
  across: string;
  bins: number;
}
/** The same as `jounce.analysis.layouts.Layout`. */
export interface Layout {
  schema: "jounce.layout/1";
  recordings: LaidRecording[];
  axis: string;
  graphs: { channels: string[] }[];
  formulas: Formula[];
  events: Event[];
  window: [number, number] | null;
  cursors: [number, number] | null;
  chart: Chart;
  note: string;
}

export const MOST_RECORDINGS = 6,
  MOST_GRAPHS = 12,
  MOST_CHANNELS = 6;

export const emptyLayout = (): Layout => ({
  schema: "jounce.layout/1",
  recordings: [],
  axis: "time",
  graphs: [],
  formulas: [],
  events: [],
  window: null,
  cursors: null,
  chart: { kind: "", channel: "", across: "", bins: 40 },
  note: "",
});

async function through(bytes: Uint8Array<ArrayBuffer>, stream: GenericTransformStream) {
  const passed = new Blob([bytes]).stream().pipeThrough(stream as TransformStream);
  return new Uint8Array(await new Response(passed).arrayBuffer());
}

/** A layout as a short text for an address. */
export async function packed(layout: Layout): Promise<string> {
  const bytes = await through(
    new TextEncoder().encode(JSON.stringify(layout)),
    new CompressionStream("deflate-raw"),
  );
  const text = btoa(String.fromCharCode(...bytes));
  return text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** The layout of such a text; null if it is damaged. The server checks what it holds. */
export async function unpacked(text: string): Promise<Layout | null> {
  try {
    const raw = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(raw, (sign) => sign.charCodeAt(0));
    const plain = await through(bytes, new DecompressionStream("deflate-raw"));
    const found: unknown = JSON.parse(new TextDecoder().decode(plain));
    return found && typeof found === "object" && !Array.isArray(found)
      ? whole(found as Partial<Layout>)
      : null;
  } catch {
    return null;
  }
}

/** A layout with everything that it leaves out. */
export const whole = (given: Partial<Layout>): Layout => ({ ...emptyLayout(), ...given });
