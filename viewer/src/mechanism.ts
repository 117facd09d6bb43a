/** A corner of a car in space: its parts, its wheel and the road under it, in mm; x forward, y left, z up. */

import {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, CatmullRomCurve3, Color, CylinderGeometry, DirectionalLight,
  DoubleSide, Group, Line, LineBasicMaterial, LineDashedMaterial, LineSegments, Mesh, MeshLambertMaterial, OrthographicCamera, Quaternion, Scene as Space,
  SphereGeometry, TorusGeometry, TubeGeometry, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { before, type Mechanism, type Motion } from "./data";
import { colour, isFast, make, toggle, whenLeft } from "./page";
import { say, tr } from "./words";

/** `roll` in rad, the left side up positive, about the middle of the car at the height of the road at design. */
export interface Moment { body: number; travel: number; ground: number; load: number; time: number; roll?: number }

/** What a corner turns about at each pose, mm: (y, z) in front view, (x, z) beside, the roll centre (y, z). */
export interface Centres { front: ([number, number] | null)[]; side: ([number, number] | null)[]; roll: ([number, number] | null)[] }

const UP = new Vector3(0, 1, 0);
const NEAR = 16; // px to a point that is meant
const SMALL = matchMedia("(max-width: 40rem)");
const LINE = 13; // px from one name to the next
type View = "space" | "front" | "side" | "top";
const VIEWS: Record<View, [number, number, number]> = { space: [1, 0.75, 0.5], front: [1, 0, 0], side: [0, 1, 0], top: [0, 0, 1] };

class Rod {
  readonly mesh: Mesh;
  constructor(group: Group, material: MeshLambertMaterial, radius: number) {
    this.mesh = new Mesh(new CylinderGeometry(radius, radius, 1, 10), material);
    group.add(this.mesh);
  }
  between(a: Vector3, b: Vector3): void {
    const along = b.clone().sub(a), length = along.length() || 1e-6;
    this.mesh.position.copy(a).addScaledVector(along, 0.5);
    this.mesh.quaternion.setFromUnitVectors(UP, along.divideScalar(length));
    this.mesh.scale.set(1, length, 1);
  }
}

/** A helix of length 1 along y. */
function helix(radius: number, coils: number): BufferGeometry {
  const points: Vector3[] = [];
  for (let i = 0; i <= 16 * coils; i++) {
    const s = i / (16 * coils), a = 2 * Math.PI * coils * s;
    points.push(new Vector3(radius * Math.cos(a), s, radius * Math.sin(a)));
  }
  return new BufferGeometry().setFromPoints(points);
}

export class MechanismView {
  readonly element = make("div", { class: "mechanism" });
  private readonly canvas = make("canvas", { tabindex: "0", "aria-label": say("mechanism") });
  private readonly state = make("div", { class: "state" });
  private readonly names = make("div", { class: "names" });
  private readonly legend = make("ul", { class: "legend" });
  private readonly space = new Space();
  private readonly camera = new OrthographicCamera();
  private renderer: WebGLRenderer | null = null;
  private controls: OrbitControls | null = null;
  private group = new Group(); // what rolls with the body
  private level = new Group(); // what does not: the road
  private shown: Mechanism | null = null;
  private motion: Motion | null = null;
  private points: Vector3[] = [];
  private update: (() => void)[] = [];
  private spin = new Vector3(0, 1, 0);
  private now: Moment = { body: 0, travel: 0, ground: 0, load: 1, time: 0 };
  private wheelGroup = new Group();
  private pathGroup = new Group();
  private labels: HTMLElement[] = [];
  private wide: number[] = []; // of the labels, px
  private named: number[] = []; // points that the labels belong to
  private isDirty = true;
  private due = 0; // the frame that draws it
  private isLost = false;
  private isSeen = false;
  private size = 300;
  private reach: [number, number] = [300, 300];
  private centres: Centres | null = null;
  private turned: { line: Line; mark: Mesh; of: keyof Centres }[] = [];
  private chosen: string | null = null;
  private halo: Mesh | null = null;
  /** Hears that a hardpoint is dragged, by how much (mm) from where it was taken, and whether it was let go. */
  grabbed: ((name: string, by: [number, number, number], done: boolean) => void) | null = null;
  /** Where a dragged point goes: in the plane of the picture, or along an axis. */
  way: "view" | "x" | "y" | "z" = "view";

  /** `large`: the mechanism is what the page is about; its points are named, its parts listed and paths drawn at first. */
  constructor(large = false) {
    const views = make("div", { class: "group", role: "group", "aria-label": say("view") });
    for (const name of Object.keys(VIEWS) as View[])
      views.append(make("button", { type: "button", click: () => this.look(name) }, say(name)));
    const wheel = toggle(say("wheel"), true, (on) => { this.wheelGroup.visible = on; this.stale(); });
    const paths = toggle(say("paths"), large, (on) => { this.pathGroup.visible = on; this.stale(); });
    const isNamed = large && !SMALL.matches;
    const words = toggle(say("names"), isNamed, (on) => { this.names.hidden = !on; this.stale(); });
    this.names.hidden = !isNamed;
    this.pathGroup.visible = large;
    this.element.append(make("div", { class: "bar" }, views, make("div", { class: "group" }, wheel, paths, words)),
      make("div", { class: "stage" }, this.canvas, this.names, this.state));
    if (large) this.element.append(this.legend);
    this.space.add(new AmbientLight(0xffffff, 1.9), this.group, this.level);
    const sun = new DirectionalLight(0xffffff, 1.9);
    sun.position.set(0.6, 0.3, 1);
    this.space.add(sun);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableZoom = false; // until it is clicked on: the page scrolls over it
    this.canvas.addEventListener("focus", () => { this.controls!.enableZoom = true; });
    this.canvas.addEventListener("blur", () => { this.controls!.enableZoom = false; });
    this.canvas.addEventListener("pointerdown", () => this.canvas.focus());
    this.canvas.addEventListener("dblclick", () => this.look("space"));
    this.controls.addEventListener("change", () => { this.stale(); });
    this.canvas.parentElement!.addEventListener("pointerdown", (event) => this.take(event), { capture: true });
    new ResizeObserver(() => this.resize()).observe(this.canvas.parentElement!);
    whenLeft(() => this.giveBack());
    new IntersectionObserver((entries) => { this.isSeen = entries.some((entry) => entry.isIntersecting); if (this.isDirty) this.stale(); }, { rootMargin: "300px" }).observe(this.element);
  }

  /** Begins to draw, once: making a context takes long where there is no graphics card, so not before it is seen. */
  private begin(): boolean {
    if (this.renderer || this.isLost) return !this.isLost;
    try {
      this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: isFast(), alpha: true });
      this.renderer.setPixelRatio(isFast() ? Math.min(devicePixelRatio, 2) : 1);
    } catch {
      this.isLost = true;
      this.state.textContent = say("noWebGL");
      return false;
    }
    this.resize();
    return true;
  }

  /** Gives back what the graphics card holds: a browser has few contexts. */
  private giveBack(): void {
    this.isLost = true;
    this.shown = null;
    this.controls?.dispose();
    this.space.traverse((one) => { if (one instanceof Mesh || one instanceof Line) one.geometry.dispose(); });
    this.renderer?.dispose();
    this.renderer?.forceContextLoss();
    this.renderer = null;
  }

  show(mechanism: Mechanism, motion: Motion | null): void {
    const before = this.shown;
    this.motion = motion;
    this.shown = mechanism;
    if (before === null || kind(before) !== kind(mechanism)) {
      this.build(mechanism);
      this.look("space");
    } else if (before !== mechanism) this.redraw(mechanism);
    this.set(this.now);
  }

  /** Everything as it is at one moment. */
  set(moment: Moment): void {
    const m = this.shown;
    this.now = moment;
    if (!m) return;
    const { travel } = moment, grid = m.travel, n = grid.length;
    const k = Math.min(before(grid, travel), Math.max(n - 2, 0)), next = Math.min(k + 1, n - 1);
    const share = next > k ? (travel - grid[k]!) / (grid[next]! - grid[k]!) : 0; // beyond the ends, straight on
    m.points.forEach((poses, i) => {
      const a = poses[k]!, b = poses[next]!;
      this.points[i]!.set(a[0]! + share * (b[0]! - a[0]!), a[1]! + share * (b[1]! - a[1]!), a[2]! + share * (b[2]! - a[2]!) + moment.body);
    });
    const a = m.spin[k]!, b = m.spin[next]!;
    this.spin.set(a[0]! + share * (b[0]! - a[0]!), a[1]! + share * (b[1]! - a[1]!), a[2]! + share * (b[2]! - a[2]!)).normalize();
    this.tilt(m, share < 0.5 ? k : next);
    for (const step of this.update) step();
    this.turnAbout(share < 0.5 ? k : next);
    if (!this.isLost) this.state.textContent = moment.load > 0 ? "" : say("noContact");
    this.stale();
  }

  /** Rolls all but the road, which stays level and under the wheel. */
  private tilt(m: Mechanism, pose: number): void {
    const roll = this.now.roll ?? 0, contact = m.contact[pose], design = m.contact[before(m.travel, 0)]?.[2] ?? 0;
    this.group.rotation.x = roll;
    this.group.position.set(0, design * Math.sin(roll), design * (1 - Math.cos(roll)));
    this.group.updateMatrixWorld();
    if (roll && contact) this.now = { ...this.now, ground: new Vector3(contact[0]!, contact[1]!, contact[2]!).applyMatrix4(this.group.matrixWorld).z };
  }

  /** A place in space of one that rolls with the body. */
  private outside(point: Vector3, into = new Vector3()): Vector3 {
    return into.copy(point).applyMatrix4(this.group.matrixWorld);
  }

  /** Something has changed: the next frame shows it. */
  private stale(): void {
    this.isDirty = true;
    this.due ||= requestAnimationFrame(() => { this.due = 0; this.draw(); });
  }

  /** Draws now, where something has changed. */
  draw(): void {
    if (!this.isDirty || !this.isSeen || !this.shown || !this.begin()) return;
    this.isDirty = false;
    this.renderer!.render(this.space, this.camera);
    if (!this.names.hidden) this.place();
  }

  /** Draws what the corner turns about, or nothing. */
  showCentres(centres: Centres | null): void {
    this.centres = centres;
    this.set(this.now);
  }

  /** Marks one hardpoint. */
  choose(name: string | null): void {
    this.chosen = name;
    this.set(this.now);
  }

  private turnAbout(pose: number): void {
    const m = this.shown!, contact = m.contact[pose];
    for (const { line, mark, of } of this.turned) {
      const place = this.centres?.[of][pose];
      line.visible = mark.visible = !!place && !!contact;
      if (!place || !contact) continue;
      const start = new Vector3(contact[0]!, contact[1]!, contact[2]! + this.now.body);
      const end = of === "side" ? new Vector3(place[0], start.y, place[1]) : new Vector3(start.x, place[0], place[1]);
      end.z += this.now.body;
      line.geometry.setFromPoints([start, end]);
      mark.position.copy(end);
    }
    if (!this.halo) return;
    const index = this.chosen === null ? -1 : m.names.indexOf(this.chosen);
    this.halo.visible = index >= 0;
    if (index >= 0) this.halo.position.copy(this.points[index]!);
  }

  /** Begins to drag the hardpoint under the pointer, where there is one. */
  private take(event: PointerEvent): void {
    const m = this.shown;
    if (!this.grabbed || !m || event.button !== 0 || event.target !== this.canvas) return;
    const box = this.canvas.getBoundingClientRect(), one = new Vector3();
    let best = NEAR, found = -1;
    m.names.forEach((_, i) => {
      if (m.feet.includes(i)) return;
      this.outside(this.points[i]!, one).project(this.camera);
      const away = Math.hypot(box.left + (0.5 + 0.5 * one.x) * box.width - event.clientX, box.top + (0.5 - 0.5 * one.y) * box.height - event.clientY);
      if (away < best) { best = away; found = i; }
    });
    if (found < 0) return;
    event.stopPropagation();
    event.preventDefault();
    this.canvas.focus({ preventScroll: true });
    const name = m.names[found]!, scale = (this.camera.right - this.camera.left) / this.camera.zoom / box.width;
    const across = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0), upward = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    for (const one of [across, upward]) one.applyQuaternion(this.group.quaternion.clone().invert()); // hardpoints are those of a body that does not roll
    const moved = (now: PointerEvent): [number, number, number] => {
      const x = scale * (now.clientX - event.clientX), y = -scale * (now.clientY - event.clientY);
      if (this.way === "view") return across.clone().multiplyScalar(x).addScaledVector(upward, y).toArray();
      const axis = "xyz".indexOf(this.way), a = across.getComponent(axis), b = upward.getComponent(axis), size = a * a + b * b;
      const by: [number, number, number] = [0, 0, 0];
      if (size > 0.02) by[axis] = (x * a + y * b) / size; // an axis that is looked along cannot be followed
      return by;
    };
    const move = (now: PointerEvent) => this.grabbed?.(name, moved(now), false);
    const end = (now: PointerEvent) => {
      removeEventListener("pointermove", move); removeEventListener("pointerup", end); removeEventListener("pointercancel", end);
      this.grabbed?.(name, now.type === "pointerup" ? moved(now) : [0, 0, 0], true);
    };
    addEventListener("pointermove", move); addEventListener("pointerup", end); addEventListener("pointercancel", end);
    this.grabbed(name, [0, 0, 0], false);
  }

  look(name: View): void {
    if (!this.controls || !this.shown) return;
    const [x, y, z] = VIEWS[name], side = this.shown.side;
    const low = new Vector3(Infinity, Infinity, Infinity), high = low.clone().negate();
    for (const point of this.points) { low.min(point); high.max(point); }
    const { centre, radius, width } = this.shown.wheel, hub = this.points[centre]!;
    low.min(new Vector3(hub.x - radius, hub.y - width / 2, hub.z - radius));
    high.max(new Vector3(hub.x + radius, hub.y + width / 2, hub.z + radius));
    const middle = low.clone().add(high).multiplyScalar(0.5);
    this.size = 0.5 * low.distanceTo(high);
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(new Vector3(x, side * y, z + (name === "top" ? 0 : 1e-3)).normalize().multiplyScalar(6 * this.size));
    if (name === "top") this.camera.position.x -= 1e-2 * this.size; // up is along x
    this.camera.zoom = 1;
    this.camera.near = 0.1; this.camera.far = 20 * this.size;
    this.controls.update();
    this.camera.updateMatrixWorld();
    const half = high.clone().sub(low).multiplyScalar(0.5), to = new Vector3();
    this.reach = [0, 1].map((column) => { // of the box around everything, across and upward on the screen
      to.setFromMatrixColumn(this.camera.matrixWorld, column);
      return Math.abs(to.x) * half.x + Math.abs(to.y) * half.y + Math.abs(to.z) * half.z;
    }) as [number, number];
    this.frame();
    this.stale();
  }

  repaint(): void {
    if (this.shown) { this.build(this.shown); this.set(this.now); }
  }

  private frame(): void {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement!;
    const [across, upward] = this.reach, shape = Math.max(w, 1) / Math.max(h, 1);
    const tall = 1.15 * Math.max(upward, across / shape), wide = tall * shape;
    Object.assign(this.camera, { left: -wide, right: wide, top: tall, bottom: -tall });
    this.camera.updateProjectionMatrix();
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement!;
    if (!this.renderer || w < 10 || h < 10) return;
    this.renderer.setSize(w, h, false);
    this.frame();
    this.stale();
  }

  /** Other places of the same mechanism: only its ways are drawn anew, all else moves. */
  private redraw(m: Mechanism): void {
    for (const [i, child] of this.pathGroup.children.entries()) {
      const line = child as Line, places = way(i ? m.contact : m.points[m.wheel.centre]!);
      if (line.geometry.getAttribute("position").count !== places.length) {  // buffers keep their size
        line.geometry.dispose();
        line.geometry = new BufferGeometry();
      }
      line.geometry.setFromPoints(places);
    }
  }

  private build(m: Mechanism): void {
    for (const one of [this.group, this.level]) {
      this.space.remove(one);
      one.traverse((shape) => { if (shape instanceof Mesh || shape instanceof Line) shape.geometry.dispose(); });
    }
    this.group = new Group();
    this.level = new Group();
    this.space.add(this.group, this.level);
    this.update = [];
    this.points = m.points.map((poses) => new Vector3(poses[0]![0], poses[0]![1], poses[0]![2]));
    const size = m.wheel.radius / 22;
    const dark = colour("ink");
    const tint = (name: string) => (name === "#22262b" ? dark : name); // the upright is drawn in ink
    for (const part of m.parts) {
      const material = new MeshLambertMaterial({ color: new Color(tint(part.colour)) });
      if (part.coil) {
        this.coil(material, part.points[0]!, part.points[1]!, m, size);
        continue;
      }
      const ends = part.points.map((_, i) => [i, i + 1] as [number, number]).slice(0, -1);
      if (part.plate) ends.push([part.points.length - 1, 0]);
      for (const [i, j] of ends) {
        const rod = new Rod(this.group, material, size);
        this.update.push(() => rod.between(this.points[part.points[i]!]!, this.points[part.points[j]!]!));
      }
      if (part.plate && part.points.length >= 3) this.plate(part.points, tint(part.colour));
    }
    for (const [i, [point, first, second, , name]] of m.brackets.entries()) {
      const rod = new Rod(this.group, new MeshLambertMaterial({ color: new Color(tint(name)) }), 0.5 * size);
      this.update.push(() => rod.between(this.points[point]!, this.points[first]!.clone().lerp(this.points[second]!, this.shown!.brackets[i]![3])));
    }
    this.strut(m, size);
    this.joints(m, size);
    this.wheel(m);
    this.road(m);
    this.axis(m);
    this.paths(m);
    this.marks(size);
    this.named = m.names.map((_, i) => i).filter((i) => !m.feet.includes(i));
    this.wide = [];
    this.names.replaceChildren(...(this.labels = this.named.map((i) => make("span", {}, tr(m.names[i]!.replaceAll("_", " "))))));
    this.legend.replaceChildren(...[...m.parts, { words: say("strut"), colour: m.strut.colour }].map((part) => {
      const swatch = make("i", { class: "swatch" });
      swatch.style.background = tint(part.colour);
      return make("li", {}, swatch, tr(part.words));
    }));
  }

  /** What is drawn of centres and of a chosen point. */
  private marks(size: number): void {
    const colours: Record<keyof Centres, string> = { front: colour("other-1"), side: colour("other-3"), roll: colour("accent") };
    this.turned = (Object.keys(colours) as (keyof Centres)[]).map((of) => {
      const line = new Line(new BufferGeometry().setFromPoints([UP, UP]), new LineBasicMaterial({ color: new Color(colours[of]) }));
      const mark = new Mesh(of === "roll" ? new BoxGeometry(3 * size, 3 * size, 3 * size) : new SphereGeometry(2 * size, 12, 8), new MeshLambertMaterial({ color: new Color(colours[of]) }));
      line.frustumCulled = false;
      line.visible = mark.visible = false;
      this.group.add(line, mark);
      return { line, mark, of };
    });
    this.halo = new Mesh(new SphereGeometry(2.6 * size, 16, 12), new MeshLambertMaterial({ color: new Color(colour("accent")), transparent: true, opacity: 0.7 }));
    this.halo.visible = false;
    this.group.add(this.halo);
  }

  /** The steering axis, where two points mark it. */
  private axis(m: Mechanism): void {
    if (!m.axis) return;
    const [low, high] = m.axis, geometry = new BufferGeometry().setFromPoints([UP, UP]);
    const line = new Line(geometry, new LineDashedMaterial({ color: new Color(colour("muted")), dashSize: 12, gapSize: 7 }));
    line.frustumCulled = false;
    this.group.add(line);
    this.update.push(() => {
      const a = this.points[low]!, along = this.points[high]!.clone().sub(a);
      geometry.setFromPoints([a.clone().addScaledVector(along, -0.3), a.clone().addScaledVector(along, 1.3)]);
      line.computeLineDistances();
    });
  }

  /** The ways of the wheel's centre and of the contact point through all poses. */
  private paths(m: Mechanism): void {
    const visible = this.pathGroup.visible, material = new LineBasicMaterial({ color: new Color(colour("accent")) });
    this.pathGroup = new Group();
    this.pathGroup.visible = visible;
    for (const places of [m.points[m.wheel.centre]!, m.contact])
      this.pathGroup.add(new Line(new BufferGeometry().setFromPoints(way(places)), material));
    this.group.add(this.pathGroup);
    this.update.push(() => this.pathGroup.position.setZ(this.now.body));
  }

  private plate(corners: number[], name: string): void {
    const geometry = new BufferGeometry(), count = corners.length - 2;
    const places = new Float32Array(9 * count);
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    const material = new MeshLambertMaterial({ color: new Color(name), transparent: true, opacity: 0.25, side: DoubleSide, depthWrite: false });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.group.add(mesh);
    this.update.push(() => {
      for (let i = 0; i < count; i++)
        [corners[0]!, corners[i + 1]!, corners[i + 2]!].forEach((corner, j) => this.points[corner]!.toArray(places, 9 * i + 3 * j));
      geometry.attributes.position!.needsUpdate = true;
      geometry.computeVertexNormals();
    });
  }

  private strut(m: Mechanism, size: number): void {
    const material = new MeshLambertMaterial({ color: new Color(m.strut.colour) });
    const rod = new Rod(this.group, material, 0.6 * size), tube = new Rod(this.group, material, 1.7 * size);
    const [low, high] = m.strut.damper;
    this.update.push(() => {
      const a = this.points[low]!, b = this.points[high]!;
      rod.between(a, b);
      tube.between(a, a.clone().addScaledVector(b.clone().sub(a).normalize(), m.strut.tube));
    });
    const [bottom, top] = m.strut.spring;
    this.coil(material, bottom, top, m, size);
  }

  /** A spring between two points, with the turns of the strut's. */
  private coil(material: MeshLambertMaterial, bottom: number, top: number, m: Mechanism, size: number): void {
    const wire = helix(m.strut.radius, m.strut.coils), along = new CatmullRomCurve3(pointsOf(wire));
    const flat = new TubeGeometry(along, 14 * m.strut.coils, 1, 5), base = (flat.attributes.position!.array as Float32Array).slice();
    const centres = along.getSpacedPoints(14 * m.strut.coils);
    const coil = new Mesh(flat, material);
    this.group.add(coil);
    const thick = 0.55 * size, turn = new Quaternion();
    this.update.push(() => {
      const a = this.points[bottom]!, axis = this.points[top]!.clone().sub(a), length = axis.length();
      turn.setFromUnitVectors(UP, axis.normalize());
      const place = flat.attributes.position as BufferAttribute, one = new Vector3(), ring = 6;
      for (let i = 0; i < place.count; i++) {
        const centre = centres[Math.floor(i / ring)]!;
        one.set(base[3 * i]! - centre.x, 0, base[3 * i + 2]! - centre.z);
        const rise = base[3 * i + 1]! - centre.y;
        one.multiplyScalar(thick).add(new Vector3(centre.x, (0.08 + 0.84 * centre.y) * length + thick * rise, centre.z));
        one.applyQuaternion(turn).add(a);
        place.setXYZ(i, one.x, one.y, one.z);
      }
      place.needsUpdate = true;
      flat.computeVertexNormals();
    });
    coil.frustumCulled = false;
  }

  private joints(m: Mechanism, size: number): void {
    const ball = new SphereGeometry(1.5 * size, 12, 8), box = new BoxGeometry(2.6 * size, 2.6 * size, 2.6 * size);
    const held = new MeshLambertMaterial({ color: new Color(colour("muted")) }), free = new MeshLambertMaterial({ color: new Color(colour("ink")) });
    m.names.forEach((_, i) => {
      if (i === m.wheel.centre || m.feet.includes(i)) return;
      const mesh = new Mesh(m.onBody[i] ? box : ball, m.onBody[i] ? held : free);
      this.group.add(mesh);
      this.update.push(() => mesh.position.copy(this.points[i]!));
    });
  }

  private wheel(m: Mechanism): void {
    const { radius, width, centre } = m.wheel, visible = this.wheelGroup.visible;
    this.wheelGroup = new Group();
    this.wheelGroup.visible = visible;
    this.group.add(this.wheelGroup);
    const rubber = new MeshLambertMaterial({ color: new Color(colour("rubber")), transparent: true, opacity: 0.3, depthWrite: false, side: DoubleSide });
    const tread = new Mesh(new CylinderGeometry(radius, radius, 0.8 * width, 48, 1, true), rubber);
    const rings = [-0.4, 0.4].map((share) => {
      const ring = new Mesh(new TorusGeometry(0.93 * radius, 0.07 * radius, 8, 48), rubber);
      ring.rotateX(Math.PI / 2);
      ring.position.y = share * width;
      return ring;
    });
    const spokes = new Group(), dark = new MeshLambertMaterial({ color: new Color(colour("rubber")) });
    for (let i = 0; i < 5; i++) {
      const rod = new Rod(spokes as Group, dark, radius / 60), a = 2 * Math.PI * i / 5;
      const face = 0.4 * width * m.side;
      rod.between(new Vector3(0.12 * radius * Math.cos(a), face, 0.12 * radius * Math.sin(a)), new Vector3(0.8 * radius * Math.cos(a), face, 0.8 * radius * Math.sin(a)));
    }
    this.wheelGroup.add(tread, ...rings, spokes);
    this.update.push(() => {
      this.wheelGroup.position.copy(this.points[centre]!);
      const axis = this.spin.clone().multiplyScalar(m.side); // from outboard to left
      this.wheelGroup.quaternion.setFromUnitVectors(UP, axis);
      const way = this.motion?.road ? this.motion.road.speed * this.now.time : 0;
      spokes.rotation.y = way / radius;
    });
  }

  private road(m: Mechanism): void {
    const reach = 2.4 * m.wheel.radius, half = 0.8 * m.wheel.width, count = 121;
    const geometry = new BufferGeometry(), places = new Float32Array(6 * count), faces: number[] = [];
    for (let i = 0; i < count - 1; i++) faces.push(2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2);
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setIndex(faces);
    const mesh = new Mesh(geometry, new MeshLambertMaterial({ color: new Color(colour("road")), side: DoubleSide }));
    mesh.frustumCulled = false;
    const edge = new BufferGeometry(), rim = new Float32Array(12 * (count - 1));
    edge.setAttribute("position", new BufferAttribute(rim, 3));
    const lines = new LineSegments(edge, new LineBasicMaterial({ color: new Color(colour("muted")) }));
    lines.frustumCulled = false;
    this.level.add(mesh, lines);
    this.update.push(() => {
      const centre = this.outside(this.points[m.wheel.centre]!), road = this.motion?.road;
      const way = road ? road.speed * this.now.time : 0;
      for (let i = 0; i < count; i++) {
        const x = -reach + 2 * reach * i / (count - 1);
        const z = road ? height(road, way + x) : this.now.ground;
        places.set([centre.x + x, centre.y - half, z, centre.x + x, centre.y + half, z], 6 * i);
      }
      for (let i = 0; i < count - 1; i++)
        for (const side of [0, 3])
          rim.set([...places.subarray(6 * i + side, 6 * i + side + 3), ...places.subarray(6 * i + 6 + side, 6 * i + 9 + side)], 12 * i + 2 * side);
      geometry.attributes.position!.needsUpdate = edge.attributes.position!.needsUpdate = true;
      geometry.computeVertexNormals();
    });
  }

  private place(): void {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement!, one = new Vector3();
    if (this.wide.length !== this.labels.length || this.wide.includes(0)) this.wide = this.labels.map((label) => label.offsetWidth); // all are read before any is moved
    const { wide } = this;
    const found = this.labels.map((label, i) => {
      this.outside(this.points[this.named[i]!]!, one).project(this.camera);
      const x = (0.5 + 0.5 * one.x) * w, width = wide[i]!;
      return { label, width, x: x + width + 8 < w ? x + 7 : x - width - 7, y: (0.5 - 0.5 * one.y) * h - 8 };
    }).sort((a, b) => a.y - b.y);
    found.forEach((name, i) => {
      const before = found.slice(0, i).filter((other) => other.x < name.x + name.width && name.x < other.x + other.width);
      name.y = Math.max(name.y, ...before.map((other) => other.y + LINE)); // names stand below each other, not over
      name.label.style.transform = `translate(${name.x}px, ${name.y}px)`;
    });
  }
}

function way(places: ArrayLike<number>[]): Vector3[] {
  return places.map((place) => new Vector3(place[0]!, place[1]!, place[2]!));
}

/** What a mechanism is drawn of, but for its places. */
function kind({ points: _points, spin: _spin, contact: _contact, travel: _travel, brackets, ...rest }: Mechanism): string {
  return JSON.stringify([rest, brackets.map(([point, first, second]) => [point, first, second])]);
}

function pointsOf(geometry: BufferGeometry): Vector3[] {
  const place = geometry.attributes.position!;
  return Array.from({ length: place.count }, (_, i) => new Vector3(place.getX(i), place.getY(i), place.getZ(i)));
}

function height(road: { x: number[]; z: number[] }, place: number): number {
  const { x, z } = road, n = x.length;
  if (place <= x[0]!) return z[0]!;
  if (place >= x[n - 1]!) return z[n - 1]!;
  const k = before(x, place), a = x[k]!, b = x[k + 1]!;
  return b > a ? z[k]! + (z[k + 1]! - z[k]!) * (place - a) / (b - a) : z[k + 1]!;
}
