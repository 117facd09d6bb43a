/** The campaign that new files enter: one of the project, or a new one with its rig and obstacle. */

import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { type Arrivals, countedFiles, NEW } from "./arrivals";
import { OwnValues } from "./ownvalues";
import { field, once, select, textBox } from "./parts";
import { Refused } from "./refusals";

const OBSTACLES = ["half-sine", "versine", "triangle", "rectangle"];

interface Entered {
  entered: string[];
  refused: { file: string; message: string; german: string | null }[];
}

export class Target {
  readonly button = make("button", { type: "button", class: "main" });
  /** Obstacles of trains among the trials, by name. */
  readonly trains: Record<string, object> = {};
  private readonly own: OwnValues;

  constructor(
    private readonly arrivals: Arrivals,
    readonly entries: api.Entry[],
    private readonly library: { name: string }[],
    wanted: string,
    private readonly changed: () => void,
  ) {
    this.own = new OwnValues(arrivals, () => this.folder);
    const { target } = arrivals.list;
    if (wanted && this.campaigns.includes(wanted)) target.campaign = wanted;
    if (!this.campaigns.includes(target.campaign ?? ""))
      target.campaign = this.campaigns.length === 1 ? this.campaigns[0]! : NEW;
  }

  private get campaigns(): string[] {
    return this.entries.filter(({ kind }) => kind === "campaign").map(({ path }) => path);
  }

  /** Folder of a new campaign. */
  get folder(): string {
    return (this.arrivals.list.target.folder || "campaign").replace(/\/+$/, "");
  }

  /** Says how many files the button enters. */
  count(files: number): void {
    this.button.disabled = !files;
    this.button.textContent = this.arrivals.isNew
      ? countedFiles(files, "Make the campaign with 1 file", "Make the campaign with # files")
      : countedFiles(files, "Enter 1 file into the campaign", "Enter # files into the campaign");
  }

  /** Names of the roads that trials can have in this campaign. */
  async roads(): Promise<string[]> {
    if (this.arrivals.isNew) return [...new Set(["A", ...Object.keys(this.trains)])];
    const path = this.arrivals.list.target.campaign!;
    return api.get<{ roads: string[] }>(`/api/campaign?${api.query({ path })}`).then(
      ({ roads }) => roads,
      () => [],
    );
  }

  form(): HTMLElement {
    const to = this.arrivals.list.target;
    const choice = select([...this.campaigns, NEW], to.campaign, (path) =>
      path === NEW ? tr("a new campaign") : path,
    );
    const control = (key: string, made: HTMLInputElement | HTMLSelectElement) => {
      if (to[key] !== undefined) made.value = to[key];
      to[key] = made.value;
      made.addEventListener("change", () => {
        to[key] = made.value;
        this.arrivals.keep();
      });
      return made;
    };
    const own = this.entries
        .filter((entry) => entry.kind === "rig" && !entry.path.includes("@"))
        .map((entry) => entry.path),
      rigs = [...own, ...this.library.map(({ name }) => name)],
      usual = own[0] ?? (rigs.includes("kart-quarter-car") ? "kart-quarter-car" : rigs[0]);
    const rig = control("rig", select(rigs, usual)),
      folder = control("folder", textBox("campaign"));
    rig.addEventListener("change", () => void this.own.offer(rig.value));
    folder.addEventListener("change", () => void this.own.show());
    const parts = make(
      "span",
      { class: "sizes", hidden: !this.arrivals.isNew },
      field("Folder", folder),
      field("Rig", rig),
      field(
        "Obstacle",
        control(
          "obstacle",
          select(OBSTACLES, "half-sine", (kind) => tr(kind.replace("-", " "))),
        ),
      ),
      field("Height", control("height", textBox("10 mm"))),
      field("Length", control("length", textBox("60 mm"))),
    );
    choice.addEventListener("change", () => {
      to.campaign = choice.value;
      this.arrivals.keep();
      this.changed();
    });
    if (this.arrivals.isNew) void this.own.offer(rig.value);
    else this.own.element.replaceChildren();
    return make(
      "div",
      {},
      make("div", { class: "form" }, field("Campaign", choice), parts),
      this.own.element,
      make("p", { class: "bar" }, this.button),
    );
  }

  /** Enters the ticked files; returns the path of the campaign and the files that are in it now. */
  async enter(): Promise<{ path: string; entered: string[] }> {
    const { arrivals } = this,
      to = arrivals.list.target,
      isNew = arrivals.isNew;
    const path = isNew ? `${this.folder}/campaign.toml` : to.campaign!;
    const changes = isNew ? await this.own.entered() : {};
    const obstacle = { kind: to.obstacle, height: to.height, length: to.length };
    const answer = await once(
      this.button,
      api.asked("POST", "/api/campaign/files", {
        campaign: path,
        ...(isNew ? { new: { rig: to.rig, changes, obstacle, roads: this.trains } } : {}),
        files: arrivals.chosen.map((preview) => arrivals.entry(preview)),
      }),
    );
    const { entered, refused } = (await answer.json()) as Entered;
    arrivals.refused = new Map(
      refused.map(({ file, message, german }) => [file, new Refused(message, german).message]),
    );
    arrivals.drop(entered);
    if (entered.length) {
      to.campaign = path;
      if (isNew && !this.entries.some((entry) => entry.path === path))
        this.entries.push({ path, kind: "campaign" } as api.Entry);
    }
    return { path, entered };
  }
}
