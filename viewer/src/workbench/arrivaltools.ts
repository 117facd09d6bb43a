/** What mends several new files at once: one value for all, a pasted table of trials, settings of a laboratory. */

import { make } from "../page";
import { tr } from "../words";
import { type Arrivals, CHOICES, INPUTS, KINDS } from "./arrivals";
import { ask } from "./jobs";
import { field, once, textBox } from "./parts";

const TOGETHER: [key: string, words: string][] = [
  ["kind", "type"],
  ["speed", "speed"],
  ["tyre_pressure", "tyre pressure"],
  ["strut_angle", "strut angle"],
  ["road", "road"],
  ["use", "use"],
  ["pressure", "pressure of tyre tests"],
  ["discard_below", "ignore below"],
  ["stroke_positive", "sign of the stroke"],
  ["force_positive", "sign of the force"],
];
const options = (choices: [value: string, words: string][]) =>
  choices.map(([value, words]) => make("option", { value }, tr(words)));

/** One value for all ticked files that have such a field. */
export function together(arrivals: Arrivals): HTMLElement {
  const key = make("select", {}, ...options(TOGETHER)),
    holder = make("label", { class: "field" }, make("span", {}, "Value")),
    set = make("button", { type: "button" }, "Set for all ticked files");
  const control = (): HTMLInputElement | HTMLSelectElement => {
    const choices =
      key.value === "kind"
        ? Object.entries(KINDS)
        : key.value === "road"
          ? arrivals.roads.map((road) => [road, road] as [string, string])
          : CHOICES[key.value];
    const example = Object.values(INPUTS)
      .flat()
      .find(([own]) => own === key.value)?.[2];
    return choices ? make("select", {}, ...options(choices)) : textBox("", example ?? "");
  };
  let value = control();
  holder.append(value);
  key.addEventListener("change", () => {
    const next = control();
    value.replaceWith(next);
    value = next;
  });
  set.addEventListener("click", () => arrivals.setTogether(key.value, value.value));
  return make("div", { class: "form" }, field("All ticked files", key), holder, set);
}

/** A table of trials copied from a spreadsheet. */
export function trialTable(arrivals: Arrivals, look: () => Promise<void>): HTMLElement {
  const { list } = arrivals;
  const area = make("textarea", {
      rows: "4",
      spellcheck: "false",
      placeholder: "trial\tspeed [m/s]\tpressure [MPa]\tprofile",
    }),
    fill = make("button", { type: "button" }, "Fill in from the table");
  area.value = list.table;
  const take = () => {
    list.table = area.value;
    arrivals.keep();
    void once(fill, look());
  };
  fill.addEventListener("click", take);
  area.addEventListener("paste", () => setTimeout(take));
  const details = make(
    "details",
    {},
    make("summary", {}, "Paste the table of trials"),
    field(
      "Number, speed, angle, pressure and profile of each trial, copied from a spreadsheet with its headings",
      area,
    ),
    make("p", { class: "bar" }, fill),
  );
  details.open = list.table !== "";
  return details;
}

/** Settings of a laboratory among the files, which are enough for a campaign in `folder`; `made` hears its file. */
export function settingsOf(
  file: string,
  folder: () => string,
  made: (campaign: string) => void,
  refused: (error: unknown) => void,
): HTMLElement {
  const go = make("button", { type: "button" }, "Make the campaign from the settings file"),
    source = file.slice(0, file.lastIndexOf("/"));
  go.addEventListener("click", () => {
    const out = folder();
    once(go, ask({ kind: "new-campaign", out, source, settings: file })).then(
      () => made(`${out}/campaign.toml`),
      refused,
    );
  });
  return make(
    "p",
    { class: "bar" },
    go,
    make(
      "span",
      { class: "muted" },
      tr("# states masses, obstacle, belt and sensors.", file.split("/").pop()!),
    ),
  );
}
