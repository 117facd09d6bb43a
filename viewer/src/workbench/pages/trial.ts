/** A rig over an obstacle, with sliders. */

import { make } from "../../page";
import * as api from "../api";
import { OBSTACLES, USUAL } from "../obstacles";
import { field, Live, Sliders } from "../parts";
import { choose, type Page, setLive, type Values } from "../shell";

export const trial: Page = { label: "Trial", show };

const FIRST = ["strut.spring.rate", "strut.damper.coefficient", "strut.damper.bump_coefficient", "strut.damper.rebound_coefficient", "tyre.stiffness", "sprung.mass", "unsprung.mass"];

async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) { await choose(place, "trial", "Trial", "rig", true); return; }
  const rig = await api.rig(name);
  const kind = make("select", {}, ...Object.keys(OBSTACLES).map((one) => make("option", { value: one }, one.replace("-", " "))));
  const sizes = make("span", { class: "sizes" });
  const road = told<Record<string, string>>(values.get("road")); // what another page opens: sizes and start with their units
  if (road.kind && road.kind in OBSTACLES) kind.value = road.kind;
  const speed = make("input", { type: "text", value: values.get("speed") ?? (rig.name.includes("kart") ? "1.95 m/s" : "30 km/h") }), duration = make("input", { type: "text", value: values.get("duration") ?? "1.5 s" });
  const offered = () => sizes.replaceChildren(...OBSTACLES[kind.value]!.map((one) => {
    const input = make("input", { type: "text", value: road[one] ?? USUAL[one]!, name: one });
    input.addEventListener("change", () => void curves.ask());
    return field(one[0]!.toUpperCase() + one.slice(1), input);
  }));
  const sliders = new Sliders(rig, FIRST, () => void curves.ask(), told<Record<string, number>>(values.get("set")));
  const curves = new Live(() => api.curves("simulate", {
    rig: name, changes: sliders.changes, speed: speed.value, duration: duration.value,
    road: { kind: kind.value, start: road.start ?? "0.2 m", ...Object.fromEntries([...sizes.querySelectorAll("input")].map((one) => [one.name, one.value])) },
  }));
  kind.addEventListener("change", () => { offered(); void curves.ask(); });
  for (const one of [speed, duration]) one.addEventListener("change", () => void curves.ask());
  offered();
  setLive(curves);
  place.replaceChildren(make("h1", {}, `${name} over an obstacle`),
    make("div", { class: "form" }, field("Obstacle", kind), sizes, field("Speed", speed), field("Duration", duration)), sliders.element, curves.element);
  await curves.ask();
}

/** What stands in an address as JSON; nothing where it is none. */
function told<T extends object>(text: string | null): T {
  try { return (JSON.parse(text ?? "{}") ?? {}) as T; } catch { return {} as T; }
}
