/** Content of the viewers of a page, as `jounce.report.live` writes it. */

export interface Curve {
  label: string;
  role: string; // measured, before, after, other-1 ...
  y: number; // index of an array
}
export interface Pane {
  name: string; // of the channel
  words: string;
  unit: string;
  curves: Curve[]; // none where its numbers were not asked for
  shown: boolean;
}
export interface Motion {
  mechanism: number;
  body: number; // height of the body above its design position, mm
  travel: number; // of the wheel against the body, mm; or what else its poses are counted by, times 1000
  ground: number; // height of the road under the wheel, mm
  load: number; // of the tyre, N
  road: { x: number[]; z: number[]; speed: number } | null; // mm, mm, mm/s
}
export interface Scene {
  name: string;
  label: string;
  note: string;
  tone: string;
  x: number;
  panes: Pane[];
  spans: [number, number][];
  window: [number, number] | null;
  motion: Motion | null;
}
export interface Model {
  title: string;
  roles: { role: string; label: string; shown: boolean }[];
  scenes: Scene[];
  x: { words: string; unit: string };
  stage: boolean; // the mechanism is what it is about
  slower: number | null; // than in reality, at first
}
export interface Part {
  name: string;
  words: string;
  colour: string;
  plate: boolean;
  coil: boolean;
  points: number[];
}
export interface Mechanism {
  other: Mechanism | null; // side of an axle
  side: number;
  travel: number[]; // mm, or what else the poses are counted by, times 1000; ascending
  names: string[];
  onBody: boolean[];
  feet: number[]; // points that are drawn to and are no hardpoints
  points: ArrayLike<number>[][]; // point, pose, xyz in mm, with the body at its design position
  spin: ArrayLike<number>[]; // pose, xyz
  contact: ArrayLike<number>[]; // pose, xyz in mm
  parts: Part[];
  brackets: [number, number, number, number, string][];
  strut: {
    spring: [number, number] | null;
    damper: [number, number] | null;
    radius: number;
    tube: number;
    coils: number;
    colour: string;
  };
  axis: [number, number] | null;
  wheel: { centre: number; radius: number; width: number };
}
interface Packed {
  n: number;
  at: number;
  order: number;
  low: number;
  step: number;
  even?: [number, number];
  form?: "f4" | "f8"; // of an answer, bits of a number: 32 or 64
}
interface Content {
  viewers: Model[];
  mechanisms: Mechanism[];
  arrays: Packed[];
  packed: string;
}
/** In an answer, places of a mechanism are indices of arrays. */
interface Straight {
  points: number[];
  spin: number;
  contact: number;
}

export type Numbers = Float64Array | Float32Array | (number | null)[];

/** All arrays of a page: sixteen bits a number, as differences in two planes of bytes, deflated; or an answer's, as they are. */
export class Store {
  private readonly made: (Numbers | undefined)[] = [];
  private straight: ((index: number) => Float64Array | Float32Array) | null = null;
  private constructor(
    readonly content: Content,
    private readonly bytes: Uint8Array,
  ) {}

  static async open(text: string): Promise<Store> {
    const content = JSON.parse(text) as Content;
    const raw = atob(content.packed);
    content.packed = "";
    const deflated = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; i++) deflated[i] = raw.charCodeAt(i);
    const stream = new Blob([deflated]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Store(content, new Uint8Array(await new Response(stream).arrayBuffer()));
  }

  /** An answer of the workbench's server: the length of its plain part, that, and all numbers. */
  static of(buffer: ArrayBuffer): Store {
    const length = new DataView(buffer).getUint32(0, true),
      start = 4 + length;
    const content = JSON.parse(
      new TextDecoder().decode(new Uint8Array(buffer, 4, length)),
    ) as Content;
    const store = new Store(content, new Uint8Array(0));
    store.straight = (index) => {
      const { n, at, form } = content.arrays[index]!;
      return new (form === "f4" ? Float32Array : Float64Array)(buffer, start + at, n);
    };
    const rows = (index: number) => {
      const flat = store.straight!(index);
      return Array.from({ length: flat.length / 3 }, (_, i) => flat.subarray(3 * i, 3 * i + 3));
    };
    for (const first of content.mechanisms)
      for (let mechanism: Mechanism | null = first; mechanism; mechanism = mechanism.other) {
        const { points, spin, contact } = mechanism as unknown as Straight;
        Object.assign(mechanism, {
          points: points.map(rows),
          spin: rows(spin),
          contact: rows(contact),
        });
      }
    return store;
  }

  /** Smallest step between two values of an array; 0 if it is exact. */
  step(index: number): number {
    const { even, step } = this.content.arrays[index]!;
    return even ? 0 : step || this.finest(index);
  }

  /** Rounding of an array relative to its range, invisible on a screen. */
  private finest(index: number): number {
    const values = this.get(index);
    let low = Infinity,
      high = -Infinity;
    for (let i = 0; i < values.length; i++) {
      const value = values[i];
      if (value !== null && value !== undefined) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return high > low ? (high - low) * 1e-7 : 0;
  }

  get(index: number): Numbers {
    this.made[index] ??= this.straight
      ? withGaps(this.straight(index))
      : unpack(this.content.arrays[index]!, this.bytes);
    return this.made[index];
  }
}

/** Replaces unknown values by null, for plotting. */
function withGaps(values: Float64Array | Float32Array): Numbers {
  return values.some(Number.isNaN)
    ? Array.from(values, (value) => (Number.isNaN(value) ? null : value))
    : values;
}

const GAP = 65535;

function unpack(packed: Packed, bytes: Uint8Array): Numbers {
  const { n, at, order, low, step, even } = packed;
  if (even) return Float64Array.from({ length: n }, (_, i) => even[0] + i * even[1]);
  const result = new Float64Array(n);
  let value = 0,
    slope = 0,
    gaps = false;
  for (let i = 0; i < n; i++) {
    const folded = bytes[at + i]! | (bytes[at + n + i]! << 8);
    if (order === 0) value = folded;
    else {
      const difference = (folded >>> 1) ^ -(folded & 1);
      if (order === 1) value = (value + difference) & 65535;
      else {
        slope = (slope + difference) & 65535;
        value = (value + slope) & 65535;
      }
    }
    if (value === GAP) gaps = true;
    result[i] = value === GAP ? NaN : low + step * value;
  }
  return gaps ? Array.from(result, (value) => (Number.isNaN(value) ? null : value)) : result;
}

/** Value between samples; `x` ascends. */
export function at(x: Numbers, y: Numbers, place: number): number {
  const n = x.length;
  if (n === 0) return NaN;
  const k = before(x, place),
    next = Math.min(k + 1, n - 1);
  const a = x[k] as number,
    b = x[next] as number,
    u = y[k],
    v = y[next];
  if (u === null || v === null || u === undefined || v === undefined) return NaN;
  const share = b > a ? Math.min(1, Math.max(0, (place - a) / (b - a))) : 0;
  return u + share * (v - u);
}

/** Index of the last sample that is not behind `place`. */
export function before(x: ArrayLike<number | null>, place: number): number {
  let low = 0,
    high = x.length - 1;
  while (high > low) {
    const middle = (low + high + 1) >> 1;
    if ((x[middle] as number) <= place) low = middle;
    else high = middle - 1;
  }
  return low;
}
