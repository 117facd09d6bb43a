/** A corner of a car in space: its parts, its wheel and the road under it, in mm; x forward, y left, z up. */

import { before, type Mechanism, type Motion } from "./data";
import { colour, make, sized, toggle } from "./page";
import { Recorder } from "./recorder";
import { offerDrawings, type ShownDrawing } from "./shown";
import { across, add, along, Camera, dot, minus, Picture, type Point, unit } from "./space";
import { say, tr } from "./words";

/** `roll` in rad, the left side up positive, about the middle of the car at the height of the road at design. */
export interface Moment {
  body: number;
  travel: number;
  ground: number;
  load: number;
  time: number;
  roll?: number;
}

/** Centres of rotation of a corner at each pose, mm: (y, z) in front view, (x, z) in side view, roll centre (y, z). */
export interface Centres {
  front: ([number, number] | null)[];
  side: ([number, number] | null)[];
  roll: ([number, number] | null)[];
}

const NEAR = 16; // px to a point that is meant
const SMALL = matchMedia("(max-width: 40rem)");
const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const [TURN, STEP] = [Math.PI / 36, 20]; // rad and px of one press
const LINE = 13; // px from one name to the next
/** A side of an axle at a moment: its points, of a body that does not roll, and its spin axis. */
interface Posed {
  mechanism: Mechanism;
  points: Point[];
  spin: Point;
  ground: number;
}
type View = "space" | "front" | "side" | "top";
/** Azimuth and elevation of the viewer of a left corner. */
const VIEWS: Record<View, [number, number]> = {
  space: [0.64, 0.38],
  front: [0, 0],
  side: [Math.PI / 2, 0],
  top: [Math.PI, Math.PI / 2],
};
const MARKS: Record<keyof Centres, string> = { front: "other-1", side: "other-3", roll: "accent" };

export class MechanismView {
  readonly element = make("div", { class: "mechanism" });
  private readonly canvas = make("canvas", {
    tabindex: "0",
    role: "application", // its keys are its own, also for screen readers
    "aria-label": say("mechanism"),
    "aria-keyshortcuts": "ArrowLeft ArrowRight ArrowUp ArrowDown + - 0",
  });
  private readonly stage: HTMLElement;
  private context: CanvasRenderingContext2D | null = null;
  private readonly state = make("div", { class: "state" });
  private readonly names = make("div", { class: "names" });
  private readonly legend = make("ul", { class: "legend" });
  private readonly camera = new Camera();
  private zoom = 1;
  private shown: Mechanism | null = null;
  private motion: Motion | null = null;
  private points: Point[] = []; // of a body that does not roll
  private posed: Posed[] = []; // first the side whose points can be dragged
  private pose = 0; // the nearest that is known
  private now: Moment = { body: 0, travel: 0, ground: 0, load: 1, time: 0 };
  private hasWheel = true;
  private hasPaths: boolean;
  private labels: HTMLElement[] = [];
  private wide: number[] = []; // of the labels, px
  private named: number[] = []; // points that the labels belong to
  private isDirty = true;
  private due = 0; // the frame that draws it
  private isSeen = false;
  private reach: [number, number] = [300, 300];
  private centres: Centres | null = null;
  private chosen: string | null = null;
  /** Called while a hardpoint is dragged: by how much (mm) from its start, and whether it was released. */
  grabbed: ((name: string, by: Point, done: boolean) => void) | null = null;
  /** How a dragged point moves: in the view plane, or along an axis. */
  way: "view" | "x" | "y" | "z" = "view";

  /** `large`: the mechanism is what the page is about; its points are `named`, its parts listed and paths drawn at first. */
  constructor(large = false, named = large) {
    const views = make("div", { class: "group", role: "group", "aria-label": say("view") });
    for (const name of Object.keys(VIEWS) as View[])
      views.append(make("button", { type: "button", click: () => this.look(name) }, say(name)));
    const wheel = toggle(say("wheel"), true, (on) => {
      this.hasWheel = on;
      this.stale();
    });
    const paths = toggle(say("paths"), large, (on) => {
      this.hasPaths = on;
      this.stale();
    });
    const isNamed = named && !SMALL.matches;
    const words = toggle(say("names"), isNamed, (on) => {
      this.names.hidden = !on;
      this.stale();
    });
    this.names.hidden = !isNamed;
    this.hasPaths = large;
    const keys = make("p", { class: "keys", "aria-hidden": "true" }, say("mechanismKeys"));
    this.stage = make("div", { class: "stage" }, this.canvas, keys, this.names, this.state);
    this.element.append(
      make("div", { class: "bar" }, views, make("div", { class: "group" }, wheel, paths, words)),
      this.stage,
    );
    if (large) this.element.append(this.legend);
    this.canvas.addEventListener("dblclick", () => this.look("space"));
    this.canvas.addEventListener("contextmenu", (event) => event.preventDefault()); // its button moves the picture
    this.canvas.addEventListener(
      "wheel",
      (event) => {
        if (document.activeElement !== this.canvas) return; // until it is clicked on, the page scrolls over it
        event.preventDefault();
        this.enlarge(0.95 ** (Math.sign(event.deltaY) || 0));
      },
      { passive: false },
    );
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    offerDrawings(this.element, (isAll) => this.recorded(isAll && large));
    this.turned();
    this.stage.addEventListener("pointerdown", (event) => this.take(event), { capture: true });
    new ResizeObserver(() => this.resize()).observe(this.stage);
    new IntersectionObserver(
      (entries) => {
        this.isSeen = entries.some((entry) => entry.isIntersecting);
        if (this.isDirty) this.stale();
      },
      { rootMargin: "300px" },
    ).observe(this.element);
  }

  show(mechanism: Mechanism, motion: Motion | null): void {
    const before = this.shown;
    this.motion = motion;
    this.shown = mechanism;
    this.set(this.now);
    if (before !== null && kind(before) === kind(mechanism)) return;
    this.list(mechanism);
    this.look("space");
  }

  /** Sets the state at one moment. */
  set(moment: Moment): void {
    const m = this.shown;
    this.now = moment;
    if (!m) return;
    const { travel } = moment,
      grid = m.travel,
      n = grid.length;
    const k = Math.min(before(grid, travel), Math.max(n - 2, 0)),
      next = Math.min(k + 1, n - 1);
    const share = next > k ? (travel - grid[k]!) / (grid[next]! - grid[k]!) : 0; // beyond the ends, straight on
    const at = (poses: ArrayLike<number>[]) => along(point(poses[k]!), point(poses[next]!), share);
    this.posed = [m, ...(m.other ? [m.other] : [])].map((mechanism) => ({
      mechanism,
      points: mechanism.points.map((poses) => add(at(poses), [0, 0, 1], moment.body)),
      spin: unit(at(mechanism.spin)),
      ground: mechanism === m ? moment.ground : at(mechanism.contact)[2],
    }));
    this.points = this.posed[0]!.points;
    this.pose = share < 0.5 ? k : next;
    const contact = m.contact[this.pose];
    if (moment.roll && contact) this.now = { ...moment, ground: this.outside(point(contact))[2] }; // the road stays level and under the wheel
    this.state.textContent = moment.load > 0 ? "" : say("noContact");
    this.stale();
  }

  /** A direction that rolls with the body, in space; `back` from there. */
  private rolled([x, y, z]: Point, back = false): Point {
    const roll = (back ? -1 : 1) * (this.now.roll ?? 0),
      c = Math.cos(roll),
      s = Math.sin(roll);
    return [x, c * y - s * z, s * y + c * z];
  }

  /** A place in space of one that rolls with the body. */
  private outside(place: Point): Point {
    const m = this.shown!,
      middle: Point = [0, 0, m.contact[before(m.travel, 0)]?.[2] ?? 0];
    return add(middle, this.rolled(minus(place, middle)));
  }

  /** Requests a redraw in the next frame. */
  private stale(): void {
    this.isDirty = true;
    this.due ||= requestAnimationFrame(() => {
      this.due = 0;
      this.draw();
    });
  }

  /** Shows centres of rotation, or hides them. */
  showCentres(centres: Centres | null): void {
    this.centres = centres;
    this.stale();
  }

  /** Marks one hardpoint. */
  choose(name: string | null): void {
    this.chosen = name;
    this.stale();
  }

  /** One finger or the mouse rotates the view; two fingers, or another button or key, move it. */
  private turned(): void {
    const fingers = new Map<number, PointerEvent>();
    const lift = (event: PointerEvent) => fingers.delete(event.pointerId);
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.focus({ preventScroll: true });
      this.canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, event);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      const was = fingers.get(event.pointerId),
        { camera } = this;
      if (!was) return;
      const x = event.clientX - was.clientX,
        y = event.clientY - was.clientY;
      const other = [...fingers.values()].find((finger) => finger !== was),
        share = other ? 0.5 : 1;
      const away = (event: PointerEvent) =>
        Math.hypot(event.clientX - other!.clientX, event.clientY - other!.clientY) || 1;
      fingers.set(event.pointerId, event);
      if (other) this.enlarge(away(event) / away(was));
      if (
        other ||
        was.button > 0 ||
        event.buttons > 1 ||
        event.shiftKey ||
        event.ctrlKey ||
        event.metaKey
      )
        camera.target = add(
          add(camera.target, camera.right, (-share * x) / camera.scale),
          camera.up,
          (share * y) / camera.scale,
        );
      else {
        const rate = (2 * Math.PI) / Math.max(camera.height, 1);
        camera.turn(camera.azimuth - rate * x, camera.elevation + rate * y);
      }
      this.stale();
    });
    this.canvas.addEventListener("pointerup", lift);
    this.canvas.addEventListener("pointercancel", lift);
  }

  /** Arrow keys turn it as the pointer does, with Shift move it; + and − zoom, 0 shows everything. */
  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { camera } = this,
      [x, y] = ARROWS[event.key] ?? [0, 0];
    if (x || y) {
      if (event.shiftKey)
        camera.target = add(
          add(camera.target, camera.right, (-x * STEP) / camera.scale),
          camera.up,
          (-y * STEP) / camera.scale,
        );
      else camera.turn(camera.azimuth - x * TURN, camera.elevation - y * TURN);
      this.stale();
    } else if (event.key === "+" || event.key === "=") this.enlarge(1.15);
    else if (event.key === "-") this.enlarge(1 / 1.15);
    else if (event.key === "0") this.look("space");
    else return;
    event.preventDefault();
    event.stopPropagation(); // the curves around it have the same keys
  }

  private enlarge(by: number): void {
    this.zoom = Math.min(Math.max(this.zoom * by, 0.1), 100);
    this.frame();
  }

  /** Starts to drag the hardpoint under the pointer, if there is one. */
  private take(event: PointerEvent): void {
    const m = this.shown,
      { camera } = this;
    if (!this.grabbed || !m || event.button !== 0 || event.target !== this.canvas) return;
    const box = this.canvas.getBoundingClientRect();
    let best = NEAR,
      nearest = -1;
    this.points.forEach((place, i) => {
      if (m.feet.includes(i)) return;
      const [x, y] = camera.seen(this.outside(place)),
        away = Math.hypot(box.left + x - event.clientX, box.top + y - event.clientY);
      if (away < best) {
        best = away;
        nearest = i;
      }
    });
    if (nearest < 0) return;
    event.stopPropagation();
    event.preventDefault();
    this.canvas.focus({ preventScroll: true });
    const name = m.names[nearest]!,
      { scale } = camera;
    const [right, up] = [this.rolled(camera.right, true), this.rolled(camera.up, true)]; // hardpoints are those of a body that does not roll
    const moved = (now: PointerEvent): Point => {
      const x = (now.clientX - event.clientX) / scale,
        y = -(now.clientY - event.clientY) / scale;
      if (this.way === "view") return add(add([0, 0, 0], right, x), up, y);
      const axis = "xyz".indexOf(this.way),
        a = right[axis]!,
        b = up[axis]!,
        size = a * a + b * b;
      const by: Point = [0, 0, 0];
      if (size > 0.02) by[axis] = (x * a + y * b) / size; // an axis that is looked along cannot be followed
      return by;
    };
    const move = (now: PointerEvent) => this.grabbed?.(name, moved(now), false);
    const end = (now: PointerEvent) => {
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
      removeEventListener("pointercancel", end);
      this.grabbed?.(name, now.type === "pointerup" ? moved(now) : [0, 0, 0], true);
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
    addEventListener("pointercancel", end);
    this.grabbed(name, [0, 0, 0], false);
  }

  look(name: View): void {
    if (!this.shown) return;
    const all = this.posed.flatMap(({ mechanism, points }) => {
      const { centre, radius, width } = mechanism.wheel,
        hub = points[centre]!,
        size: Point = [radius, width / 2, radius];
      return [...points, add(hub, size), minus(hub, size)];
    });
    const ends = [Math.min, Math.max].map(
      (end) => [0, 1, 2].map((i) => end(...all.map((point) => point[i]!))) as Point,
    ) as [Point, Point];
    const [azimuth, elevation] = VIEWS[name],
      half = add([0, 0, 0], minus(ends[1], ends[0]), 0.5);
    this.camera.target = along(...ends, 0.5);
    this.camera.turn(name === "top" ? azimuth : azimuth * this.shown.side, elevation);
    this.reach = [this.camera.right, this.camera.up].map((to) =>
      dot(half, to.map(Math.abs) as Point),
    ) as [number, number]; // of the box around everything
    this.zoom = 1;
    this.frame();
  }

  repaint(): void {
    if (this.shown) this.list(this.shown);
    this.resize();
  }

  private frame(): void {
    const { width: w, height: h } = this.camera,
      [wide, tall] = this.reach;
    this.camera.scale = (this.zoom * Math.min(w / wide, h / tall)) / 2.3;
    this.stale();
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.stage;
    if (w < 10 || h < 10) return;
    this.context = sized(this.canvas, w, h);
    Object.assign(this.camera, { width: w, height: h });
    this.frame();
  }

  /** Names of points and parts. */
  private list(m: Mechanism): void {
    this.named = m.names.map((_, i) => i).filter((i) => !m.feet.includes(i));
    this.wide = [];
    this.labels = this.named.map((i) => make("span", {}, tr(m.names[i]!.replaceAll("_", " "))));
    this.names.replaceChildren(...this.labels);
    this.legend.replaceChildren(
      ...[
        ...m.parts,
        ...(m.strut.spring ? [{ words: say("strut"), colour: m.strut.colour }] : []),
      ].map((part) => {
        const swatch = make("i", { class: "swatch" });
        swatch.style.background = tint(part.colour);
        return make("li", {}, swatch, tr(part.words));
      }),
    );
  }

  /** Draws now if something has changed. */
  draw(): void {
    if (!this.isDirty || !this.isSeen || !this.shown || !this.context) return;
    this.isDirty = false;
    this.paint(this.context, this.shown);
    if (!this.names.hidden) this.place();
  }

  /** The drawing as it is seen, or also in front, side and top view; in the colours of paper. */
  private recorded(isAll: boolean): ShownDrawing[] {
    const m = this.shown,
      { camera, zoom, reach } = this,
      seen = { ...camera };
    if (!m || camera.width < 10) return [];
    const views: (View | null)[] = isAll ? [null, "front", "side", "top"] : [null];
    const { dataset } = document.documentElement,
      theme = dataset.theme;
    dataset.theme = "light";
    try {
      return views.map((view) => {
        if (view) this.look(view);
        const recorder = new Recorder();
        this.paint(recorder as unknown as CanvasRenderingContext2D, m);
        const names = this.names.hidden
          ? []
          : this.places().map(({ label, x, y }) => ({
              text: label.textContent,
              x: x + 2,
              y: y + LINE - 2,
            }));
        return {
          title: say(view ?? "asSeen"),
          width: Math.round(camera.width),
          height: Math.round(camera.height),
          shapes: recorder.shapes,
          names,
        };
      });
    } finally {
      if (theme) dataset.theme = theme;
      else delete dataset.theme;
      Object.assign(camera, seen);
      Object.assign(this, { zoom, reach });
      this.stale();
    }
  }

  private paint(context: CanvasRenderingContext2D, m: Mechanism): void {
    const picture = new Picture(context, this.camera),
      size = m.wheel.radius / 22;
    for (const posed of this.posed) this.side(picture, posed, size);
    this.turnsAbout(picture, m, (place) => this.risen(place), 2 * size);
    const chosen = this.chosen === null ? -1 : m.names.indexOf(this.chosen);
    if (chosen >= 0)
      picture.ball(this.outside(this.points[chosen]!), 2.6 * size, colour("accent"), 0.7);
    picture.paint();
  }

  /** A place of a body that neither moved nor rolled. */
  private risen(place: ArrayLike<number>): Point {
    return this.outside(add(point(place), [0, 0, 1], this.now.body));
  }

  private side(
    picture: Picture,
    { mechanism: m, points, spin, ground }: Posed,
    size: number,
  ): void {
    const places = points.map((place) => this.outside(place)),
      at = (i: number) => places[i]!;
    for (const part of m.parts) {
      const name = tint(part.colour),
        corners = part.points.map(at),
        ends = part.plate ? [...corners, corners[0]!] : corners;
      if (part.coil) {
        coil(picture, corners[0]!, corners[1]!, m, name);
        continue;
      }
      ends.slice(1).forEach((end, i) => picture.rod(ends[i]!, end, size, name));
      if (part.plate && corners.length >= 3) picture.area(corners, name, 0.25);
    }
    for (const [from, first, second, share, name] of m.brackets)
      picture.rod(at(from), along(at(first), at(second), share), 0.5 * size, tint(name));
    if (m.strut.damper) {
      const [low, high] = m.strut.damper.map(at) as [Point, Point];
      picture.rod(low, high, 0.6 * size, m.strut.colour);
      picture.rod(low, add(low, unit(minus(high, low)), m.strut.tube), 1.7 * size, m.strut.colour);
    }
    if (m.strut.spring)
      coil(picture, ...(m.strut.spring.map(at) as [Point, Point]), m, m.strut.colour);
    places.forEach((place, i) => {
      if (i === m.wheel.centre || m.feet.includes(i)) return;
      if (m.onBody[i]) picture.cube(place, 1.3 * size, colour("muted"));
      else picture.ball(place, 1.5 * size, colour("ink"));
    });
    this.road(picture, m, at(m.wheel.centre), this.now.roll ? this.now.ground : ground);
    if (this.hasWheel) this.wheel(picture, m, at(m.wheel.centre), spin);
    if (m.axis) {
      // of steering
      const [from, to] = m.axis.map(at) as [Point, Point];
      picture.line([along(from, to, -0.3), along(from, to, 1.3)], colour("muted"), {
        dash: [6, 4],
      });
    }
    if (this.hasPaths)
      for (const way of [m.points[m.wheel.centre]!, m.contact])
        picture.line(
          way.map((place) => this.risen(place)),
          colour("accent"),
        );
  }

  private turnsAbout(
    picture: Picture,
    m: Mechanism,
    risen: (place: Point) => Point,
    size: number,
  ): void {
    const contact = m.contact[this.pose];
    for (const of of Object.keys(MARKS) as (keyof Centres)[]) {
      const centre = this.centres?.[of][this.pose],
        name = colour(MARKS[of]);
      if (!centre || !contact) continue;
      const start = point(contact),
        end = risen(of === "side" ? [centre[0], start[1], centre[1]] : [start[0], ...centre]);
      picture.line([risen(start), end], name);
      if (of === "roll") picture.cube(end, 0.75 * size, name);
      else picture.ball(end, size, name);
    }
  }

  private wheel(picture: Picture, m: Mechanism, centre: Point, spin: Point): void {
    const { radius, width } = m.wheel,
      rubber = colour("rubber"),
      { toward, scale } = this.camera;
    const axis = add([0, 0, 0], this.rolled(spin), m.side),
      [first, second] = across(axis); // from outboard to left
    const at = (angle: number, far: number, aside: number): Point =>
      add(
        add(add(centre, first, far * Math.cos(angle)), second, far * Math.sin(angle)),
        axis,
        aside * width,
      );
    const arc = (from: number, turn: number, far: number, aside: number) =>
      Array.from({ length: 49 }, (_, i) => at(from + (turn * i) / 48, far, aside));
    const edge = Math.atan2(-dot(first, toward), dot(second, toward)); // from where on the tread looks at the viewer
    for (const from of [edge, edge + Math.PI])
      picture.area(
        [...arc(from, Math.PI, radius, -0.4), ...arc(from + Math.PI, -Math.PI, radius, 0.4)],
        rubber,
        0.3,
      );
    for (const aside of [-0.4, 0.4])
      picture.line(arc(0, 2.05 * Math.PI, 0.93 * radius, aside), rubber, {
        width: 0.14 * radius * scale,
        alpha: 0.5,
      });
    const rolled = ((this.motion?.road?.speed ?? 0) * this.now.time) / radius;
    for (let i = 0; i < 5; i++) {
      const angle = rolled + (2 * Math.PI * i) / 5;
      picture.rod(
        at(angle, 0.12 * radius, 0.4 * m.side),
        at(angle, 0.8 * radius, 0.4 * m.side),
        radius / 60,
        rubber,
        1,
      );
    }
  }

  /** Under all else, or over it where it is seen from below. */
  private road(picture: Picture, m: Mechanism, centre: Point, level: number): void {
    const reach = 2.4 * m.wheel.radius,
      half = 0.8 * m.wheel.width,
      count = 121,
      road = this.motion?.road;
    const edges = [-half, half].map((aside) =>
      Array.from({ length: count }, (_, i): Point => {
        const x = -reach + (2 * reach * i) / (count - 1);
        return [
          centre[0] + x,
          centre[1] + aside,
          road ? height(road, road.speed * this.now.time + x) : level,
        ];
      }),
    ) as [Point[], Point[]];
    const depth = this.camera.elevation < 0 ? Infinity : -Infinity;
    const outline = [...edges[0], ...edges[1].reverse(), edges[0][0]!];
    picture.area(outline, colour("road"), 1, depth);
    picture.line(outline, colour("muted"), { depth });
  }

  private place(): void {
    for (const { label, x, y } of this.places())
      label.style.transform = `translate(${x}px, ${y}px)`;
  }

  /** Names beside their points, below each other where they would overlap. */
  private places(): { label: HTMLElement; width: number; x: number; y: number }[] {
    const { width: w } = this.camera;
    if (this.wide.length !== this.labels.length || this.wide.includes(0))
      this.wide = this.labels.map((label) => label.offsetWidth); // all are read before any is moved
    const placed = this.labels
      .map((label, i) => {
        const [x, y] = this.camera.seen(this.outside(this.points[this.named[i]!]!)),
          width = this.wide[i]!;
        return { label, width, x: x + width + 8 < w ? x + 7 : x - width - 7, y: y - 8 };
      })
      .sort((a, b) => a.y - b.y);
    placed.forEach((name, i) => {
      const before = placed
        .slice(0, i)
        .filter((other) => other.x < name.x + name.width && name.x < other.x + other.width);
      name.y = Math.max(name.y, ...before.map((other) => other.y + LINE)); // names stand below each other, not over
    });
    return placed;
  }
}

const point = (place: ArrayLike<number>): Point => [place[0]!, place[1]!, place[2]!];
const tint = (name: string) => (name === "#22262b" ? colour("ink") : name); // the upright is drawn in ink

/** A spring between two points, with the turns of the strut's. */
function coil(picture: Picture, bottom: Point, top: Point, m: Mechanism, name: string): void {
  const axis = minus(top, bottom),
    [first, second] = across(unit(axis)),
    { radius, coils } = m.strut,
    piece = 3,
    turn = 24;
  const wire = Array.from({ length: turn * coils + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / turn;
    return add(
      add(along(bottom, top, 0.08 + (0.84 * i) / (turn * coils)), first, radius * Math.cos(angle)),
      second,
      radius * Math.sin(angle),
    );
  });
  for (let i = 0; i < turn * coils; i += piece)
    picture.tube(wire.slice(i, i + piece + 1), 0.025 * m.wheel.radius, name);
}

/** What a mechanism is drawn of, but for its places. */
function kind({
  points: _points,
  spin: _spin,
  contact: _contact,
  travel: _travel,
  brackets,
  other,
  ...rest
}: Mechanism): string {
  return JSON.stringify([
    rest,
    brackets.map(([point, first, second]) => [point, first, second]),
    other && kind(other),
  ]);
}

function height(road: { x: number[]; z: number[] }, place: number): number {
  const { x, z } = road,
    n = x.length;
  if (place <= x[0]!) return z[0]!;
  if (place >= x[n - 1]!) return z[n - 1]!;
  const k = before(x, place),
    a = x[k]!,
    b = x[k + 1]!;
  return b > a ? z[k]! + ((z[k + 1]! - z[k]!) * (place - a)) / (b - a) : z[k + 1]!;
}
