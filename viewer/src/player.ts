/** Curves and mechanism of one of several scenes, played in step. */

import { at, type Model, type Pane, type Scene, type Store } from "./data";
import { inStyle } from "./lines";
import { MechanismView } from "./mechanism";
import { make, toggle, whenColoursChange, whenLeft, written } from "./page";
import { LinkedPlots } from "./plots";
import { type Offer, seeker, sorted } from "./shown";
import { localised, say } from "./words";

const SLOWER = [1, 2, 5, 10, 20, 50, 100];
/** Up to this many channels have buttons at once; further ones are behind a button unless shown. */
const FEW = matchMedia("(max-width: 40rem)").matches ? 6 : 16;
const MOST_SOUGHT = 6; // channels that Enter shows at once
const STILL = matchMedia("(prefers-reduced-motion: reduce)");

export class Player {
  readonly element = make("div", { class: "player", tabindex: "-1" });
  private readonly plots: LinkedPlots;
  private readonly view: MechanismView | null;
  private readonly choice = make("select", { "aria-label": say("choice") });
  private readonly note = make("span", { class: "mark" });
  private readonly overlays = make("div", {
    class: "group overlays",
    role: "group",
    "aria-label": say("curves"),
  });
  private readonly channels = make("div", {
    class: "group channels",
    role: "group",
    "aria-label": say("channels"),
  });
  private readonly sought = make("input", {
    type: "search",
    placeholder: say("seek"),
    "aria-label": say("seek"),
    title: say("seekHint"),
  });
  private readonly play = make("button", { type: "button", class: "play" }, say("play"));
  private readonly slider = make("input", {
    type: "range",
    min: "0",
    max: "1",
    step: "any",
    value: "0",
    "aria-label": "",
  });
  private readonly clock = make("output", { class: "clock" });
  private readonly speed = make("select", { "aria-label": say("speed") });
  private readonly roles = new Map<string, boolean>();
  private readonly panes = new Map<string, boolean>();
  private readonly livelyPart = make(
    "button",
    { type: "button", title: say("zoomToEvent"), click: () => this.lively() },
    say("event"),
  );
  private scene: Scene;
  private now = 0;
  private playing = false;
  private isStepping = false;
  private isGone = false;
  private way = 1;
  private last = 0;
  /** Called with the position on the axis under the cursor. */
  moved: ((place: number) => void) | null = null;
  /** Called when a channel without loaded data is to be shown. */
  lacking: (() => void) | null = null;
  /** Milliseconds between the pictures shown while playing, the last of them last. */
  readonly frames: number[] = [];

  constructor(
    private model: Model,
    private store: Store,
    private readonly offered: Offer | null = null,
  ) {
    this.plots = new LinkedPlots(
      (x) => {
        if (!this.playing) this.goTo(x);
      },
      (range) => this.seen(range),
      offered,
    );
    this.scene = model.scenes[0]!;
    this.view = model.scenes.some((scene) => scene.motion) ? new MechanismView(model.stage) : null;
    model.scenes.forEach((scene, i) =>
      this.choice.append(make("option", { value: String(i) }, scene.label)),
    );
    this.build();
    this.show(this.scene);
    whenLeft(() => {
      this.isGone = true;
    });
    whenColoursChange(() => {
      this.plots.repaint();
      this.view?.repaint();
    });
  }

  /** Shows the scene of this name; returns whether it exists. */
  choose(name: string): boolean {
    const value = this.model.scenes.findIndex((scene) => scene.name === name);
    if (value < 0) return false;
    this.choice.value = String(value);
    this.show(this.model.scenes[value]!);
    return true;
  }

  /** Replaces the content by similar content; selection and zoom stay. */
  replace(model: Model, store: Store): void {
    const isOther = model.x.words !== this.model.x.words;
    const index = Math.max(this.model.scenes.indexOf(this.scene), 0),
      before = this.plots.window,
      [first, last] = this.plots.whole;
    const scene = model.scenes[Math.min(index, model.scenes.length - 1)]!;
    const all = isOther || (before[0] <= first && before[1] >= last);
    if (
      model.roles.map((role) => role.label).join() !==
        this.model.roles.map((role) => role.label).join() ||
      model.roles.length !== this.model.roles.length
    )
      this.offerRoles(model);
    this.model = model;
    this.store = store;
    this.scene = scene;
    const x = store.get(scene.x);
    if (isOther) this.offer(scene);
    if (this.view) this.view.element.hidden = !scene.motion;
    this.slider.min = String(x[0]);
    this.slider.max = String(x[x.length - 1]);
    this.plot(all ? null : before);
    if (scene.motion && this.view)
      this.view.show(store.content.mechanisms[scene.motion.mechanism]!, scene.motion);
    this.goTo(this.now);
  }

  zoom(low: number, high: number): void {
    this.plots.zoom(low, high);
  }

  /** Names of the channels that are shown. */
  get shown(): string[] {
    return this.scene.panes.filter((pane) => this.isShown(pane)).map((pane) => pane.name);
  }

  goTo(time: number): void {
    const [first, last] = this.plots.whole;
    this.now = Math.min(Math.max(time, first), last);
    this.slider.value = String(this.now);
    this.clock.textContent = `${localised(this.now.toFixed(3))} ${this.model.x.unit}`;
    this.plots.mark(this.now);
    this.moved?.(this.now);
    const motion = this.scene.motion;
    if (motion && this.view) {
      const x = this.store.get(this.scene.x),
        read = (index: number) => at(x, this.store.get(index), this.now);
      this.view.set({
        body: read(motion.body),
        travel: read(motion.travel),
        ground: read(motion.ground),
        load: read(motion.load),
        time: this.now,
      });
    }
  }

  private build(): void {
    const { model } = this;
    this.offerRoles(model);
    const step = (by: number) => () => this.stepScene(by);
    const scenes = make(
      "div",
      { class: "group" },
      make("button", { type: "button", title: say("previous"), click: step(-1) }, "‹"),
      this.choice,
      make("button", { type: "button", title: say("next"), click: step(1) }, "›"),
      this.note,
    );
    this.choice.addEventListener("change", () =>
      this.show(this.model.scenes[Number(this.choice.value)]!),
    );
    if (model.scenes.length < 2) scenes.hidden = true;
    const zooms = make(
      "div",
      { class: "group" },
      make(
        "button",
        { type: "button", title: say("zoomIn"), click: () => this.plots.zoomBy(0.5, this.now) },
        "+",
      ),
      make(
        "button",
        { type: "button", title: say("zoomOut"), click: () => this.plots.zoomBy(2, this.now) },
        "−",
      ),
      make(
        "button",
        { type: "button", title: say("everything"), click: () => this.plots.reset() },
        say("all"),
      ),
      this.livelyPart,
    );
    const wide = toggle(
      say("wide"),
      false,
      (on) => {
        this.element.classList.toggle("wide", on);
        document.body.classList.toggle("behind", on);
      },
      say("fillWindow"),
    );
    wide.classList.add("widen");
    const isTime = model.x.unit === "s";
    const slow = model.slower ?? (isTime ? 10 : 2),
      speeds = [...new Set([...SLOWER, slow])].sort((a, b) => a - b);
    for (const slower of speeds)
      this.speed.append(
        make(
          "option",
          { value: String(slower) },
          slower > 1 ? `1/${slower}` : say(isTime ? "realTime" : "fast"),
        ),
      );
    this.speed.value = String(slow);
    this.play.addEventListener("click", () => this.toggle());
    this.slider.addEventListener("input", () => {
      this.pause();
      this.goTo(Number(this.slider.value));
    });
    const main = make(
      "div",
      {
        class: !this.view
          ? "plots-only"
          : model.stage
            ? "stage-and-plots stage-first"
            : "stage-and-plots",
      },
      this.plots.element,
    );
    if (this.view) main.append(this.view.element);
    this.element.append(
      make(
        "div",
        { class: "bar" },
        scenes,
        this.overlays,
        make("span", { class: "grow" }),
        zooms,
        wide,
      ),
      make("div", { class: "bar" }, this.channels),
      main,
      make(
        "div",
        { class: "bar transport" },
        this.play,
        this.slider,
        this.clock,
        make("label", {}, `${say("speed")} `, this.speed),
      ),
      make("p", { class: "hint" }, say("hint")),
    );
    this.sought.addEventListener("input", () => this.seek());
    this.element.addEventListener("keydown", (event) => this.key(event));
  }

  /** A button for each curve of a channel. */
  private offerRoles(model: Model): void {
    const buttons = model.roles.map(({ role, label, shown }) => {
      if (!this.roles.has(role)) this.roles.set(role, shown);
      const button = toggle(
        label,
        this.roles.get(role)!,
        (on) => {
          this.roles.set(role, on);
          this.plots.setShown(role, on);
        },
        model.roles.length > 1 ? inStyle(label, role) : "",
      );
      button.prepend(make("i", { class: `swatch ${role}` }));
      return button;
    });
    this.overlays.replaceChildren(...buttons);
    this.overlays.hidden = buttons.length < 2;
  }

  private show(scene: Scene): void {
    const keep = this.scene === scene ? null : this.keptWindow(scene);
    this.scene = scene;
    this.note.textContent = scene.note;
    this.note.parentElement!.className = `group ${scene.tone}`;
    this.note.hidden = !scene.note;
    this.livelyPart.hidden = !scene.window;
    const x = this.store.get(scene.x);
    this.offer(scene);
    this.slider.min = String(x[0]);
    this.slider.max = String(x[x.length - 1]);
    this.plot(keep);
    if (scene.motion && this.view)
      this.view.show(this.store.content.mechanisms[scene.motion.mechanism]!, scene.motion);
    this.goTo(this.now);
  }

  /** A button for each channel. */
  private offer(scene: Scene): void {
    const many = scene.panes.length > FEW;
    let others = 0;
    const buttons =
      scene.panes.length < 2
        ? []
        : scene.panes.map((pane) => {
            const shown = this.isShown(pane);
            const button = toggle(
              pane.name,
              shown,
              (on) => {
                this.panes.set(pane.name, on);
                if (
                  on &&
                  this.scene.panes.some((other) => other.name === pane.name && !other.curves.length)
                )
                  this.lacking?.();
                else this.plot(this.plots.window);
              },
              pane.words,
            );
            button.dataset.channel = pane.name;
            if (many && !shown) {
              button.classList.add("other");
              others++;
            }
            return button;
          });
    if (others) {
      const open = this.channels.classList.contains("every");
      buttons.push(
        toggle(
          say("more", String(others)),
          open,
          (on) => {
            this.channels.classList.toggle("every", on);
          },
          say("otherChannels"),
        ),
      );
    }
    this.channels.replaceChildren(...(many ? [this.sought] : []), ...buttons);
    this.seek();
  }

  /** Offers only the channels whose names or words are sought. */
  private seek(): void {
    const isSought = seeker(this.sought.value),
      isSeeking = this.sought.value.trim() !== "";
    this.channels.classList.toggle("seeking", isSeeking);
    for (const button of this.channels.querySelectorAll<HTMLElement>("[data-channel]"))
      button.classList.toggle("sought", isSought(`${button.textContent} ${button.title}`));
  }

  /** The channels that come first have changed: they are shown, and on top. */
  reorder(): void {
    const isFirst = (pane: Pane) => Number.isFinite(this.rank(pane));
    for (const pane of this.scene.panes) if (isFirst(pane)) this.panes.set(pane.name, true);
    this.offer(this.scene);
    if (this.scene.panes.some((pane) => isFirst(pane) && !pane.curves.length)) this.lacking?.();
    this.plot(this.plots.window);
  }

  private rank(pane: Pane): number {
    return this.offered?.rank(pane.name) ?? Infinity;
  }

  private plot(window: [number, number] | null): void {
    const { scene } = this;
    let panes = scene.panes.filter((pane) => this.isShown(pane) && pane.curves.length);
    if (!panes.length) panes = scene.panes.filter((pane) => pane.curves.length).slice(0, 1);
    panes = sorted(panes, (pane) => this.rank(pane));
    this.slider.setAttribute("aria-label", this.model.x.words);
    this.plots.show(
      {
        x: this.store.get(scene.x),
        xLabel: `${this.model.x.words} [${this.model.x.unit}]`,
        spans: scene.spans,
        window: scene.window,
        panes: panes.map((pane) => ({
          name: pane.name,
          title: pane.words,
          unit: pane.unit,
          lines: pane.curves.map((curve) => ({
            label: this.model.roles.length > 1 ? curve.label : "",
            role: curve.role,
            y: this.store.get(curve.y),
            step: this.store.step(curve.y),
            shown: this.roles.get(curve.role) ?? true,
          })),
        })),
      },
      window,
    );
    this.plots.mark(this.now);
  }

  private isShown(pane: Pane): boolean {
    return this.panes.get(pane.name) ?? (pane.shown || Number.isFinite(this.rank(pane)));
  }

  /** The part that was looked at, where the next scene has it and it was not all of the last one. */
  private keptWindow(next: Scene): [number, number] | null {
    const [low, high] = this.plots.window,
      [first, last] = this.plots.whole,
      x = this.store.get(next.x);
    if (low <= first && high >= last) return [x[0] as number, x[x.length - 1] as number];
    const chosen = this.scene.window;
    if (chosen && Math.abs(low - chosen[0]) < 1e-9 && Math.abs(high - chosen[1]) < 1e-9)
      return null; // each its own
    return low >= (x[0] as number) && high <= (x[x.length - 1] as number) ? [low, high] : null;
  }

  private lively(): void {
    if (this.scene.window) this.plots.zoom(...this.scene.window);
    else this.plots.reset();
  }

  private stepScene(by: number): void {
    const { scenes } = this.model,
      next = (scenes.indexOf(this.scene) + by + scenes.length) % scenes.length;
    this.choose(scenes[next]!.name);
  }

  private seen([low, high]: [number, number]): void {
    if (this.now < low || this.now > high) this.goTo(low);
  }

  private toggle(): void {
    if (this.playing) this.pause();
    else this.start();
  }

  private start(): void {
    const [low, high] = this.plots.window;
    if (this.now >= high - 1e-9 * (high - low) || this.now < low) this.goTo(low);
    this.playing = true;
    this.way = 1;
    this.last = 0;
    this.frames.length = 0;
    this.play.textContent = say("pause");
    if (!this.isStepping) requestAnimationFrame((time) => this.step(time));
    this.isStepping = true;
  }

  /** What is passed in a second at full speed: a second, or all of what was swept in two. */
  private get rate(): number {
    const [first, last] = this.plots.whole;
    return this.model.x.unit === "s" ? 1 : (last - first) / 2;
  }

  private pause(): void {
    this.playing = false;
    this.play.textContent = say("play");
  }

  /** What is seen is played, again and again. */
  private step(time: number): void {
    this.isStepping = this.playing && !this.isGone;
    if (!this.isStepping) return;
    const passed = this.last ? time - this.last : 0;
    if (this.last) {
      this.frames.push(passed);
      if (this.frames.length > 600) this.frames.shift();
    }
    this.last = time;
    const [low, high] = this.plots.window;
    let next =
      this.now + (this.way * this.rate * Math.min(passed, 250)) / 1000 / Number(this.speed.value);
    if (next > high || next < low) {
      if (STILL.matches) this.pause();
      if (this.model.x.unit !== "s") this.way = -this.way; // a sweep goes back the way it came
      next = STILL.matches || this.model.x.unit !== "s" ? Math.min(Math.max(next, low), high) : low;
    }
    this.goTo(next);
    this.view?.draw();
    requestAnimationFrame((next) => this.step(next));
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLSelectElement)
      return;
    if (event.target === this.sought) {
      if (event.key === "Enter")
        this.channels
          .querySelectorAll<HTMLButtonElement>(".sought[aria-pressed=false]")
          .forEach((element, k) => {
            if (k < MOST_SOUGHT) element.click();
          });
      return;
    }
    const inButton = event.target instanceof HTMLButtonElement,
      inSlider = event.target === this.slider;
    const x = this.store.get(this.scene.x),
      sample = ((x[x.length - 1] as number) - (x[0] as number)) / Math.max(x.length - 1, 1);
    const actions: Record<string, () => void> = {
      "+": () => this.plots.zoomBy(0.5, this.now),
      "=": () => this.plots.zoomBy(0.5, this.now),
      "-": () => this.plots.zoomBy(2, this.now),
      "0": () => this.plots.reset(),
      "9": () => this.lively(),
      "[": () => this.stepScene(-1),
      "]": () => this.stepScene(1),
      f: () => this.element.querySelector<HTMLButtonElement>(".widen")!.click(),
      ...(inButton ? {} : { " ": () => this.toggle() }),
      ...(inSlider
        ? {}
        : {
            ArrowLeft: () => {
              this.pause();
              this.goTo(this.now - sample * (event.shiftKey ? 20 : 1));
            },
            ArrowRight: () => {
              this.pause();
              this.goTo(this.now + sample * (event.shiftKey ? 20 : 1));
            },
          }),
    };
    if (event.key === "Escape" && this.element.classList.contains("wide"))
      actions.Escape = actions.f!;
    const action = actions[event.key];
    if (action) {
      event.preventDefault();
      action();
    }
  }
}

export { written };
