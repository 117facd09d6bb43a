/** A form for a description, made from its JSON schema: values as they are typed, errors at their fields. */

import { make } from "../page";
import { fromField, tr } from "../words";
import type { FormProblem } from "./api";
import { pasteCurve } from "./pasting";
import { key } from "./quantities";

export type Key = string | number;
export type Value = string | number | boolean | null | Value[] | { [key: string]: Value };
interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  type?: string | string[];
  properties?: Record<string, Schema>;
  required?: string[];
  title?: string;
  description?: string;
  enum?: string[];
  const?: string;
  default?: Value;
  anyOf?: Schema[];
  oneOf?: Schema[];
  prefixItems?: Schema[];
  items?: Schema;
}
const HEAD = ["schema", "model"];
const isTable = (value: Value | undefined): value is { [key: string]: Value } =>
  typeof value === "object" && value !== null && !Array.isArray(value);
const path = (keys: Key[]) =>
  keys.map((key, i) => (typeof key === "number" ? `[${key}]` : i ? `.${key}` : key)).join("");

export class Form {
  readonly element = make("div", { class: "described" });
  private readonly open = new Set<string>(["hardpoints", "strut", "sprung", "unsprung", "tyre"]);
  private definitions: Record<string, Schema> = {};
  private problems: FormProblem[] = [];
  private notes: FormProblem[] = [];

  /** The field that is typed into, and what is to be shown once that is done. */
  private typing: EventTarget | null = null;
  private next: (() => void) | null = null;

  /** `changed` hears what is to be written at some keys; null takes it away. */
  constructor(
    private readonly changed: (keys: Key[], value: Value) => void,
    private readonly together: (sets: [Key[], Value][]) => void,
  ) {
    this.element.addEventListener("input", (event) => {
      this.typing = event.target;
    });
    this.element.addEventListener("change", () => {
      this.typing = this.next = null;
    }); // what was typed is asked about, and then shown
    this.element.addEventListener("focusout", () => {
      this.typing = null;
      setTimeout(() => this.follow());
    });
  }

  /** Whether something is typed that is not in the text yet. */
  get isTyped(): boolean {
    return this.typing !== null;
  }

  /** Shows what a text says; nothing is taken from under the hands of somebody who types. */
  show(
    schema: Schema,
    values: { [key: string]: Value },
    problems: FormProblem[],
    notes: FormProblem[] = [],
  ): void {
    this.next = () => {
      this.notes = notes;
      this.made(schema, values, problems);
    };
    this.follow();
  }

  private follow(): void {
    if (this.typing) return;
    const next = this.next;
    this.next = null;
    next?.();
  }

  private made(schema: Schema, values: { [key: string]: Value }, problems: FormProblem[]): void {
    const active = document.activeElement,
      focused = active?.closest<HTMLElement>("[data-path]")?.dataset.path,
      inside = this.element.contains(active);
    const marked =
      active instanceof HTMLInputElement
        ? ([active.selectionStart, active.selectionEnd] as const)
        : null;
    this.definitions = schema.$defs ?? {};
    this.problems = problems;
    this.element.replaceChildren(...this.rows(schema, values, []));
    const known = new Set(
      [...this.element.querySelectorAll<HTMLElement>("[data-path]")].map(
        (element) => element.dataset.path,
      ),
    );
    const lost = problems.filter((problem) => !known.has(problem.path));
    if (lost.length)
      this.element.prepend(
        ...lost.map((problem) =>
          make(
            "p",
            { class: "problem", role: "alert" },
            `${problem.line ? `${tr("line #", String(problem.line))}: ` : ""}${problem.path ? `${problem.path}: ` : ""}${problem.text}`,
          ),
        ),
      );
    if (!inside || !focused) return;
    const again = this.element
      .querySelector<HTMLElement>(`[data-path="${CSS.escape(focused)}"]`)
      ?.querySelector<HTMLInputElement | HTMLSelectElement>("input, select");
    again?.focus();
    if (again instanceof HTMLInputElement && again.type === "text" && marked)
      again.setSelectionRange(...marked); // what is typed next replaces what was marked
  }

  private resolved(schema: Schema): Schema {
    return schema.$ref ? this.definitions[schema.$ref.split("/").pop()!]! : schema;
  }

  /** What a value may be, without nothing. */
  private choices(schema: Schema): Schema[] {
    const own = this.resolved(schema),
      inner = own.anyOf ?? own.oneOf;
    return inner
      ? inner.flatMap((schema) => this.choices(schema)).filter((schema) => schema.type !== "null")
      : [own];
  }

  private rows(schema: Schema, values: { [key: string]: Value }, keys: Key[]): HTMLElement[] {
    const own = this.resolved(schema),
      properties = own.properties ?? {};
    const names = [
      ...Object.keys(values),
      ...(own.required ?? []).filter((name) => !(name in values)),
    ].filter((name) => keys.length || !HEAD.includes(name));
    const plain: HTMLElement[] = [],
      tables: HTMLElement[] = [];
    for (const name of names) {
      const made = this.field(
        name,
        properties[name] ?? {},
        values[name],
        [...keys, name],
        (own.required ?? []).includes(name) ||
          (!properties[name]?.$ref && properties[name]?.default === undefined),
      );
      (made.tagName === "DETAILS" ? tables : plain).push(made);
    }
    const missing = Object.keys(properties).filter(
      (name) =>
        !(name in values) && !names.includes(name) && !(HEAD.includes(name) && !keys.length),
    );
    return [...plain, ...tables, ...(missing.length ? [this.more(missing, properties, keys)] : [])];
  }

  /** What may be added to a table. */
  private more(missing: string[], properties: Record<string, Schema>, keys: Key[]): HTMLElement {
    const choice = make(
      "select",
      { "aria-label": tr("Add to #", path(keys) || tr("the rig")) },
      make("option", { value: "" }, tr("add …")),
      ...missing.map((name) => make("option", { value: name }, key(name))),
    );
    choice.addEventListener("change", () => {
      if (choice.value) {
        this.open.add(path([...keys, choice.value]));
        this.changed([...keys, choice.value], this.first(properties[choice.value]!));
      }
    });
    return make("p", { class: "add" }, choice);
  }

  /** What a new value is until it is typed: its default, or a mark that asks for it. */
  private first(schema: Schema): Value {
    if (schema.default !== undefined && schema.default !== null && !isTable(schema.default))
      return schema.default;
    const first = this.choices(schema)[0]!;
    if (first.const !== undefined) return first.const;
    if (first.enum) return first.enum[0]!;
    if (first.properties)
      return Object.fromEntries(
        Object.entries(first.properties)
          .filter(([name, own]) => first.required?.includes(name) || own.const !== undefined)
          .map(([name, own]) => [name, this.first(own)]),
      );
    if (first.prefixItems) return first.prefixItems.map((item) => this.first(item));
    return first.type === "array" ? [] : first.type === "boolean" ? false : "?";
  }

  private field(
    name: string,
    schema: Schema,
    value: Value | undefined,
    keys: Key[],
    needed: boolean,
  ): HTMLElement {
    const place = path(keys),
      problems = this.problems.filter((problem) => problem.path === place),
      id = `f-${place}`;
    const label =
      typeof keys[keys.length - 1] === "number" ? String(keys[keys.length - 1]) : key(name);
    const said = problems.length
      ? [
          make(
            "span",
            { class: "wrong", role: "alert", id: `${id}-wrong` },
            problems.map((problem) => problem.text).join(" "),
          ),
        ]
      : [];
    const noted = this.notes
      .filter((note) => note.path === place || note.path.startsWith(`${place}[`))
      .map((note) => make("span", { class: "noted", role: "status" }, note.text));
    const away = needed
      ? []
      : [
          make(
            "button",
            {
              type: "button",
              class: "away",
              title: tr("Remove #", place),
              "aria-label": tr("Remove #", place),
              click: () => this.changed(keys, null),
            },
            "×",
          ),
        ];
    const choices = this.choices(schema);
    if (isTable(value) || (value === undefined && choices.some((choice) => choice.properties))) {
      const details = make("details", {
        "data-path": place,
        open:
          this.open.has(place) || this.problems.some((problem) => problem.path.startsWith(place)),
      });
      details.addEventListener("toggle", () => {
        if (details.open) this.open.add(place);
        else this.open.delete(place);
      });
      const table = isTable(value) ? value : {},
        kinds = choices.filter((choice) => choice.properties),
        kind = this.kindOf(kinds, table);
      const choose = make(
        "select",
        { "aria-label": tr("kind of #", place) },
        ...kinds.map((schema, i) =>
          make(
            "option",
            { value: String(i), ...(schema === kind ? { selected: true } : {}) },
            key(spoken(schema.title ?? "")),
          ),
        ),
      );
      choose.addEventListener("change", () =>
        this.changed(keys, this.become(kinds[Number(choose.value)]!, table)),
      );
      const rows = this.rows(kind ?? {}, table, keys);
      if (away.length && !rows.at(-1)?.matches(".add")) rows.push(make("p", { class: "add" }));
      rows.at(-1)?.append(...away);
      details.append(
        make("summary", {}, label),
        ...(kinds.length > 1 ? [make("p", { class: "kind" }, choose)] : []),
        ...said,
        ...rows,
        ...this.pasting(table, keys),
      );
      return details;
    }
    const attributes = {
      id,
      ...(problems.length ? { "aria-invalid": "true", "aria-describedby": `${id}-wrong` } : {}),
    };
    if (Array.isArray(value) && value.every((item) => typeof item !== "object")) {
      const items = choices.find((choice) => choice.prefixItems)?.prefixItems;
      if (items && items.length === value.length) {
        const wrong = this.problems.filter((problem) => problem.path.startsWith(`${place}[`));
        const inputs = value.map((item, i) =>
          this.typed(String(item), items[i]!, [...keys, i], {
            "aria-label": `${place}[${i}]`,
            ...(wrong.some((own) => own.path === `${place}[${i}]`)
              ? { "aria-invalid": "true" }
              : {}),
          }),
        );
        return make(
          "div",
          { class: "row", "data-path": place },
          make("span", { class: "name" }, label),
          make(
            "span",
            { class: "three" },
            ...inputs.map((input, i) => make("span", { "data-path": `${place}[${i}]` }, input)),
          ),
          ...away,
          ...said,
          ...wrong.map((problem) =>
            make("span", { class: "wrong", role: "alert" }, `${problem.path}: ${problem.text}`),
          ),
          ...noted,
        );
      }
    }
    let control: HTMLElement;
    const fixed = choices.find((choice) => choice.enum);
    if (fixed?.enum && typeof value === "string") {
      const select = make(
        "select",
        attributes,
        ...[...new Set([value, ...fixed.enum])].map((text) =>
          make("option", { value: text, ...(text === value ? { selected: true } : {}) }, text),
        ),
      );
      select.addEventListener("change", () => this.changed(keys, select.value));
      control = select;
    } else if (typeof value === "boolean") {
      const box = make("input", { type: "checkbox", ...attributes, checked: value });
      box.addEventListener("change", () => this.changed(keys, box.checked));
      control = box;
    } else if (choices.length === 1 && choices[0]!.const !== undefined)
      control = make("output", attributes, String(value));
    else
      control = this.typed(
        value === undefined
          ? ""
          : typeof value === "object"
            ? JSON.stringify(value)
            : String(value),
        schema,
        keys,
        attributes,
        typeof value === "object",
      );
    const allowed =
      schema.description ?? choices.find((choice) => choice.description)?.description ?? "";
    return make(
      "div",
      { class: "row", "data-path": place },
      make("label", { class: "name", for: id, title: allowed }, label),
      control,
      ...away,
      ...said,
      ...noted,
    );
  }

  /** A table of a force over deflection or velocity can be pasted. */
  private pasting(values: { [key: string]: Value }, keys: Key[]): HTMLElement[] {
    const over = (["deflection", "velocity"] as const).find((name) => Array.isArray(values[name]));
    const { force } = values;
    if (!over || "length" in values || !Array.isArray(force)) return [];
    return [
      pasteCurve(over, [values[over], force], (x, y) =>
        this.together([
          [[...keys, over], x],
          [[...keys, "force"], y],
        ]),
      ),
    ];
  }

  private typed(
    value: string,
    schema: Schema,
    keys: Key[],
    attributes: Record<string, string>,
    isList = false,
  ): HTMLInputElement {
    const input = make("input", { type: "text", spellcheck: "false", value, ...attributes });
    const types = this.choices(schema).map((choice) => choice.type);
    input.addEventListener("change", () => {
      const text = fromField(input.value.trim());
      if (isList) {
        try {
          this.changed(keys, JSON.parse(text) as Value);
        } catch {
          this.changed(keys, text);
        }
      } else
        this.changed(
          keys,
          text !== "" &&
            !Number.isNaN(Number(text)) &&
            types.some((type) => type === "number" || type === "integer")
            ? Number(text)
            : text,
        );
    });
    return input;
  }

  /** Which of several kinds a table is: the one that says so, or that knows most of its keys. */
  private kindOf(kinds: Schema[], table: { [key: string]: Value }): Schema | undefined {
    const named = kinds.find(
      (kind) =>
        kind.properties?.kind?.const !== undefined && kind.properties.kind.const === table.kind,
    );
    const fit = (schema: Schema) =>
      Object.keys(table).filter((name) => name in schema.properties!).length -
      Object.keys(table).filter((name) => !(name in schema.properties!)).length -
      (schema.required ?? []).filter((name) => !(name in table)).length;
    return named ?? [...kinds].sort((a, b) => fit(b) - fit(a))[0];
  }

  /** A table as another kind: what both know stays. */
  private become(kind: Schema, table: { [key: string]: Value }): Value {
    const fresh = this.first(kind) as { [key: string]: Value };
    for (const [name, value] of Object.entries(table))
      if (name !== "kind" && name in kind.properties!) fresh[name] = value;
    return fresh;
  }
}

/** `BilinearDamper` as people write it. */
function spoken(title: string): string {
  return title.replace(/([a-z])([A-Z])/g, "$1 $2").toLowerCase();
}
