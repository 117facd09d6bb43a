/** Layouts saved by name in the project, and the present state as a link. */

import { make } from "../page";
import { tr } from "../words";
import * as api from "./api";
import type { Laid } from "./laid";
import { emptyLayout, type Layout, packed, whole } from "./layout";
import { select, textBox } from "./parts";
import { problem } from "./refusals";
import { address } from "./shell";

const FOLDER = "layouts/";
const fileOf = (name: string) => `${FOLDER}${name}.toml`;
const nameOf = (path: string) => path.replace(FOLDER, "").replace(/\.toml$/, "");

export class LayoutBar {
  private readonly choice = select([]);
  private readonly name = textBox("", tr("name"));
  private readonly said = make("span", { "aria-live": "polite", class: "said" });
  readonly element: HTMLElement;
  private path = "";
  private digest = "";
  private saved = "";

  constructor(
    private readonly laid: Laid,
    private readonly paths: string[],
    private readonly open: (layout: Layout) => void,
  ) {
    this.choice.setAttribute("aria-label", tr("Layout"));
    this.name.setAttribute("aria-label", tr("Name of the layout"));
    this.choice.addEventListener("change", () => void this.change());
    this.element = make(
      "div",
      { class: "group layouts" },
      make("label", {}, `${tr("Layout")} `, this.choice),
      this.name,
      make("button", { type: "button", click: () => void this.save() }, tr("Save the layout")),
      make("button", { type: "button", click: () => void this.link() }, tr("Copy a link")),
      this.said,
    );
  }

  /** The part of the address that names the file. */
  get named(): Record<string, string> {
    return this.path ? { layout: this.path } : {};
  }

  /** Reads a saved layout; where the address also has the state, a file that is gone is no matter. */
  async load(path: string, hasState: boolean): Promise<Layout | null> {
    try {
      const found = await api.get<{ layout: Partial<Layout>; digest: string }>(
        `/api/data/layout?${api.query({ path })}`,
      );
      const layout = whole(found.layout);
      this.path = path;
      this.digest = found.digest;
      this.saved = JSON.stringify(layout);
      this.name.value = nameOf(path);
      return layout;
    } catch (error) {
      if (!hasState) throw error;
      this.said.replaceChildren(problem(error));
      return null;
    }
  }

  /** Saved layouts besides the open one. */
  get others(): string[] {
    return this.paths.filter((path) => path !== this.path);
  }

  /** Reads a layout that is not opened. */
  async read(path: string): Promise<Layout | null> {
    try {
      const found = await api.get<{ layout: Partial<Layout> }>(
        `/api/data/layout?${api.query({ path })}`,
      );
      return whole(found.layout);
    } catch (error) {
      this.said.replaceChildren(problem(error));
      return null;
    }
  }

  show(): void {
    const isChanged = this.path && JSON.stringify(this.laid.layout) !== this.saved;
    const paths = [...new Set([...this.paths, ...(this.path ? [this.path] : [])])].sort();
    this.choice.replaceChildren(
      make("option", { value: "" }, tr("new")),
      ...paths.map((path) =>
        make(
          "option",
          { value: path, selected: path === this.path },
          nameOf(path) + (path === this.path && isChanged ? ` (${tr("changed")})` : ""),
        ),
      ),
    );
  }

  private async change(): Promise<void> {
    this.said.replaceChildren();
    const path = this.choice.value;
    if (!path) {
      this.path = this.digest = this.saved = this.name.value = "";
      this.open(emptyLayout());
      return;
    }
    try {
      const layout = await this.load(path, false);
      if (layout) this.open(layout);
    } catch (error) {
      this.said.replaceChildren(problem(error));
      this.show();
    }
  }

  private async save(): Promise<void> {
    const name = this.name.value.trim();
    this.said.replaceChildren();
    if (!/^[\p{L}\p{N}_][\p{L}\p{N}_. -]*$/u.test(name)) {
      this.said.replaceChildren(
        make("span", { class: "problem" }, tr("Name the layout with letters, digits, - or _.")),
      );
      this.name.focus();
      return;
    }
    const path = fileOf(name),
      { layout } = this.laid;
    try {
      const answer = await api.asked("PUT", "/api/data/layout", {
        layout,
        path,
        was: path === this.path ? this.digest : "",
      });
      const saved = (await answer.json()) as { path: string; digest: string };
      this.path = saved.path;
      this.digest = saved.digest;
      this.saved = JSON.stringify(layout);
      if (!this.paths.includes(path)) this.paths.push(path);
      this.said.textContent = tr("Saved as #.", path);
      this.show();
    } catch (error) {
      this.said.replaceChildren(problem(error));
    }
  }

  private async link(): Promise<void> {
    const state = await packed(this.laid.layout);
    const link = `${location.origin}/${address("data", { ...this.named, state })}`;
    try {
      await navigator.clipboard.writeText(link);
      this.said.textContent = tr("The link is copied. It opens the same view of this project.");
    } catch {
      const text = make("input", { type: "text", value: link, "aria-label": tr("Link") });
      this.said.replaceChildren(text);
      text.select();
    }
  }
}
