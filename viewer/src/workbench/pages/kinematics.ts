/** A corner with hardpoints over its travel, with sliders. */

import { make } from "../../page";
import * as api from "../api";
import { field, Live, Sliders } from "../parts";
import { address, choose, type Page, setLive, type Values } from "../shell";

export const kinematics: Page = { label: "Kinematics", show };

async function show(place: HTMLElement, values: Values): Promise<void> {
  const name = values.get("rig");
  if (!name) { await choose(place, "kinematics", "Kinematics", "rig", true); return; }
  const rig = await api.rig(name);
  if (!rig.spatial) { place.replaceChildren(make("h1", {}, name), make("p", { class: "empty" }, "This rig has no hardpoints, and so no kinematics: ", make("a", { href: address("kinematics") }, "choose another one"), ".")); return; }
  const travel = make("input", { type: "text", value: rig.name.includes("kart") ? "-20 mm:20 mm:2 mm" : "-50 mm:50 mm:5 mm" });
  const points = rig.numbers.map((one) => one.path).filter((path) => /ball_joint\[2\]|tie_rod_(inner|outer)\[2\]/.test(path)).slice(0, 4);
  const sliders = new Sliders(rig, points, () => void curves.ask());
  const curves = new Live(() => api.curves("kinematics", { rig: name, changes: sliders.changes, travel: travel.value }));
  travel.addEventListener("change", () => void curves.ask());
  setLive(curves);
  place.replaceChildren(make("h1", {}, `Kinematics of ${name}`), make("div", { class: "form" }, field("Travel, bump positive (first:last:step)", travel)), sliders.element, curves.element);
  await curves.ask();
}
