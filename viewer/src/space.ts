/** Points and bodies in space, and their parallel projection, painted from back to front. */

import { RecordedPath, Recorder } from "./recorder";

export type Point = [number, number, number];

export const add = (a: Point, b: Point, share = 1): Point => [
  a[0] + share * b[0],
  a[1] + share * b[1],
  a[2] + share * b[2],
];
export const minus = (a: Point, b: Point): Point => add(a, b, -1);
export const along = (a: Point, b: Point, share: number): Point => add(a, minus(b, a), share);
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const unit = (a: Point): Point => add([0, 0, 0], a, 1 / (Math.hypot(...a) || 1));
const AXES: Point[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Two directions across `axis`, which make a right-handed system with it. */
export function across(axis: Point): [Point, Point] {
  const first = unit(cross(axis, AXES[Math.abs(axis[0]) < 0.9 ? 0 : 1]!));
  return [first, cross(axis, first)];
}

/** A parallel projection. Angles in rad: `azimuth` from x to the viewer, `elevation` of the viewer above the ground. */
export class Camera {
  azimuth = 0;
  elevation = 0;
  target: Point = [0, 0, 0];
  scale = 1; // px/mm
  width = 0;
  height = 0;
  right: Point = [0, 1, 0];
  up: Point = [0, 0, 1];
  toward: Point = [1, 0, 0]; // the viewer

  turn(azimuth: number, elevation: number): void {
    this.azimuth = azimuth;
    this.elevation = Math.min(Math.max(elevation, -Math.PI / 2), Math.PI / 2);
    const [c, s, level, rise] = [
      Math.cos(azimuth),
      Math.sin(azimuth),
      Math.cos(this.elevation),
      Math.sin(this.elevation),
    ];
    this.right = [-s, c, 0];
    this.up = [-rise * c, -rise * s, level];
    this.toward = [level * c, level * s, rise];
  }

  /** Where a point is in the picture, px. */
  seen(point: Point): [number, number] {
    const from = minus(point, this.target);
    return [
      this.width / 2 + this.scale * dot(from, this.right),
      this.height / 2 - this.scale * dot(from, this.up),
    ];
  }
}

const SHADES = new Map<string, [string, string, string]>();

export class Picture {
  private readonly items: { depth: number; paint: () => void }[] = [];

  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly camera: Camera,
  ) {}

  /** A colour in shadow, as it is, and lit. */
  private shades(name: string): [string, string, string] {
    let shades = SHADES.get(name);
    if (!shades) {
      this.context.fillStyle = name;
      const parts = [1, 3, 5].map((i) =>
        parseInt(String(this.context.fillStyle).slice(i, i + 2), 16),
      );
      const mixed = (other: number, share: number) =>
        `rgb(${parts.map((part) => Math.round(part + share * (other - part))).join()})`;
      shades = [mixed(0, 0.28), mixed(0, 0), mixed(255, 0.32)];
      SHADES.set(name, shades);
    }
    return shades;
  }

  private path(points: Point[]): Path2D {
    const path = (this.context as unknown) instanceof Recorder ? new RecordedPath() : new Path2D();
    for (const point of points) path.lineTo(...this.camera.seen(point));
    return path as Path2D;
  }

  /** How near the middle of points is. */
  private depth(points: Point[], nearer = 0): number {
    return (
      points.reduce((sum, point) => sum + dot(point, this.camera.toward), 0) / points.length +
      nearer
    );
  }

  /** A line of so many pixels. */
  line(
    points: Point[],
    colour: string,
    { width = 1.2, dash = [] as number[], alpha = 1, depth = this.depth(points) } = {},
  ): void {
    const path = this.path(points);
    this.items.push({
      depth,
      paint: () => {
        Object.assign(this.context, { strokeStyle: colour, lineWidth: width, globalAlpha: alpha });
        this.context.setLineDash(dash);
        this.context.stroke(path);
        this.context.setLineDash([]);
        this.context.globalAlpha = 1;
      },
    });
  }

  /** A bent tube. */
  tube(points: Point[], radius: number, colour: string): void {
    const path = this.path(points),
      shades = this.shades(colour),
      width = Math.max(2 * radius * this.camera.scale, 1.5);
    this.items.push({
      depth: this.depth(points, radius),
      paint: () =>
        shades.forEach((shade, i) => {
          Object.assign(this.context, {
            strokeStyle: shade,
            lineWidth: [1, 0.66, 0.25][i]! * width,
          });
          this.context.stroke(path);
        }),
    });
  }

  /** A straight rod, in pieces: it may lie before one part and behind another. */
  rod(a: Point, b: Point, radius: number, colour: string, pieces = 8): void {
    for (const end of [a, b]) this.ball(end, radius, colour);
    for (let i = 0; i < pieces; i++)
      this.tube(
        [along(a, b, i / pieces), along(a, b, Math.min((i + 1.1) / pieces, 1))],
        radius,
        colour,
      );
  }

  area(points: Point[], colour: string, alpha = 1, depth = this.depth(points)): void {
    const path = this.path(points);
    this.items.push({
      depth,
      paint: () => {
        Object.assign(this.context, { fillStyle: colour, globalAlpha: alpha });
        this.context.fill(path);
        this.context.globalAlpha = 1;
      },
    });
  }

  ball(middle: Point, radius: number, colour: string, alpha = 1): void {
    const [x, y] = this.camera.seen(middle),
      r = radius * this.camera.scale,
      shades = this.shades(colour);
    this.items.push({
      depth: this.depth([middle], radius),
      paint: () => {
        this.context.globalAlpha = alpha;
        shades.forEach((shade, i) => {
          const share = [1, 0.78, 0.3][i]!,
            aside = [0, 0.1, 0.3][i]! * r;
          this.context.fillStyle = shade;
          this.context.beginPath();
          this.context.arc(x - aside, y - aside, share * r, 0, 2 * Math.PI);
          this.context.fill();
        });
        this.context.globalAlpha = 1;
      },
    });
  }

  /** A cube along the axes: the three faces that look at the viewer. */
  cube(middle: Point, half: number, colour: string): void {
    const shades = this.shades(colour),
      depth = this.depth([middle], half);
    AXES.forEach((axis, i) => {
      const sign = this.camera.toward[i]! < 0 ? -half : half,
        face = add(middle, axis, sign);
      const [b, c] = [AXES[(i + 1) % 3]!, AXES[(i + 2) % 3]!];
      this.area(
        [
          [-1, -1],
          [1, -1],
          [1, 1],
          [-1, 1],
        ].map(([u, v]) => add(add(face, b, u! * half), c, v! * half)),
        shades[i]!,
        1,
        depth,
      );
    });
  }

  paint(): void {
    this.context.clearRect(0, 0, this.camera.width, this.camera.height);
    for (const item of this.items.sort((a, b) => a.depth - b.depth)) item.paint();
  }
}
