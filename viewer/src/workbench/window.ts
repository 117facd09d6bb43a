/** Two cursors as numbers, and the figures of all samples between them. */

import { make, written } from "../page";
import { tr } from "../words";
import * as api from "./api";
import type { Laid } from "./laid";
import { numberBox } from "./numberbox";
import type { Newest } from "./parts";
import { unitText } from "./quantities";
import { ROLES } from "./recordings";
import { row, table } from "./table";

interface Row {
  recording: number;
  graph: number;
  order: number;
  channel: string;
  unit: string;
  a: number | null;
  b: number | null;
  difference: number | null;
  statistics: {
    samples: number;
    missing: number;
    minimum: number;
    maximum: number;
    mean: number;
    rms: number;
    standard_deviation: number;
  } | null;
}
interface Figures {
  difference: number;
  rate: number | null;
  rows: Row[];
}

const DIGITS = 5;

export class WindowTable {
  private readonly inputs = (["A", "B"] as const).map((name) =>
    numberBox({
      step: "any",
      "aria-label": tr(name === "A" ? "cursor A" : "cursor B"),
    }),
  );
  private readonly apart = make("output", {});
  private readonly toggle: HTMLButtonElement;
  private readonly body = make("tbody", {});
  private readonly state = make("p", { class: "state", role: "status" });
  private readonly whole: HTMLElement;
  readonly element: HTMLElement;

  constructor(
    private readonly laid: Laid,
    does: { zoom: () => void; toggle: () => void },
  ) {
    this.toggle = make("button", { type: "button", click: does.toggle });
    const fields = this.inputs.map((input, k) => {
      input.addEventListener("change", () => {
        const { cursors } = laid.layout;
        if (cursors && Number.isFinite(input.valueAsNumber)) cursors[k] = input.valueAsNumber;
        laid.changed();
      });
      return make("label", { class: "cursor" }, make("b", {}, k ? "B" : "A"), input);
    });
    this.whole = make(
      "div",
      {},
      make(
        "div",
        { class: "bar cursors" },
        ...fields,
        this.apart,
        make("button", { type: "button", click: does.zoom }, tr("Zoom to A–B")),
      ),
      table(
        "Figures of the window",
        [
          "channel",
          "A",
          "B",
          "B − A",
          "minimum",
          "maximum",
          "mean",
          "r.m.s.",
          "std. dev.",
          "samples",
        ],
        this.body,
        [1, 2, 3, 4, 5, 6, 7, 8, 9],
      ),
      this.state,
    );
    this.element = make(
      "section",
      {},
      make("div", { class: "bar" }, make("h2", {}, tr("Cursors and window")), this.toggle),
      this.whole,
    );
  }

  /** Shows the cursors of the layout. */
  show(): void {
    const { cursors } = this.laid.layout;
    this.toggle.textContent = tr(cursors ? "Hide the cursors" : "Show two cursors");
    this.whole.hidden = !cursors;
    this.inputs.forEach((input, k) => {
      if (cursors && input.valueAsNumber !== cursors[k]) input.value = String(cursors[k]);
    });
  }

  /** Asks for the figures of the window. */
  measure(newest: Newest): Promise<void> {
    return newest.ask(async () => {
      const { layout } = this.laid,
        { cursors } = layout;
      if (!cursors || !layout.graphs.length) return;
      try {
        const answer = await api.asked("POST", "/api/data/window", {
          layout,
          begin: cursors[0],
          end: cursors[1],
        });
        if (this.element.isConnected) this.fill((await answer.json()) as Figures);
      } catch (error) {
        this.state.textContent = error instanceof Error ? error.message : String(error);
        this.state.classList.add("problem");
      }
    });
  }

  private fill({ difference, rate, rows }: Figures): void {
    const { layout, unit } = this.laid,
      many = new Set(rows.map((row) => row.recording)).size > 1;
    this.state.textContent = "";
    this.state.classList.remove("problem");
    this.apart.textContent = `B − A = ${written(difference, DIGITS)} ${unitText(unit)}${
      rate === null ? "" : ` (${written(rate, 4)} Hz)`
    }`;
    this.body.replaceChildren(
      ...rows.map((one) => {
        const found = one.statistics,
          role = ROLES[many ? one.recording : one.order]!;
        const name = layout.recordings[one.recording]?.path.split("/").at(-1) ?? "";
        return row(
          [
            [
              make("i", { class: `swatch ${role}${many && one.order ? " dashed" : ""}` }),
              `${one.channel} [${unitText(one.unit) || "–"}]`,
              ...(many ? [make("small", { class: "muted" }, ` ${name}`)] : []),
            ],
            written(one.a, DIGITS),
            written(one.b, DIGITS),
            written(one.difference, DIGITS),
            written(found?.minimum, DIGITS),
            written(found?.maximum, DIGITS),
            written(found?.mean, DIGITS),
            written(found?.rms, DIGITS),
            written(found?.standard_deviation, DIGITS),
            found
              ? `${found.samples}${found.missing ? ` (+ ${found.missing} ${tr("missing")})` : ""}`
              : "0",
          ],
          [1, 2, 3, 4, 5, 6, 7, 8, 9],
        );
      }),
    );
  }
}
