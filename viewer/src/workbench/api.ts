/** Requests to the server; answers are plain data, refusals are errors with the server's message. */

import { fromField, tr } from "../words";
import type * as answers from "./answers";
import { type Finding, inLanguage, learnt, Refused } from "./refusals";
import { token } from "./token";

export type { FormProblem, Text, Version } from "./answers";

export interface Entry extends answers.Entry {
  address: string;
}
export interface Project {
  name: string;
  folder: string;
  entries: Entry[];
}
export interface Checked {
  kind: string;
  what: string;
  problems: Error[];
  notes: (string | Finding)[];
}
export interface RigNumber {
  path: string;
  value: number;
  si: string;
  unit: string;
  factor: number;
  /** A constant of nature, which nobody changes. */
  is_constant: boolean;
  /** A spring, a damper, a hardpoint: what a designer chooses, unlike masses or the track. */
  is_chosen: boolean;
}
export interface Rig {
  name: string;
  model: string;
  digest: string;
  spatial: boolean;
  /** Two wheels on one beam: only the K&C rig takes it. */
  is_dependent: boolean;
  numbers: RigNumber[];
  findings: { place: string; severity: string; message: string }[];
}
/** A text of a rig beside what it says. */
export interface Form extends Omit<answers.Form, "rig"> {
  rig: Rig | null;
}
/** Content of a viewer (see ../data), and the same in Python and on the command line. */
export interface Answer {
  python: string;
  command: string;
  files: Record<string, string>;
}
/** Digest of the saved rig that the sent changes refer to. */
export interface OfRig {
  digest: string;
}

export const asked = (
  method: string,
  path: string,
  body?: unknown,
  accept = "application/json",
): Promise<Response> =>
  sent(path, {
    method,
    ...(body === undefined
      ? {}
      : {
          body: JSON.stringify(body, (_, value) =>
            typeof value === "string" ? fromField(value) : value,
          ),
          headers: { "Content-Type": "application/json", Accept: accept },
        }),
  });

async function sent(path: string, given: RequestInit): Promise<Response> {
  let answer: Response;
  try {
    answer = await fetch(path, {
      ...given,
      headers: { ...given.headers, Authorization: `Bearer ${token}` },
      credentials: "omit",
    });
  } catch {
    throw new Error(tr("The server does not respond: restart it with jounce serve."));
  }
  if (answer.ok) return answer;
  if (answer.status === 401)
    throw new Error(
      tr("This session is no longer valid: open the address that jounce serve printed."),
    );
  const refusal = (await answer.json().catch(() => null)) as {
    error?: { text: string; german?: string | null };
    detail?: { msg: string; loc: string[] }[];
  } | null;
  throw new Refused(
    refusal?.error?.text ??
      refusal?.detail?.map?.((item) => `${item.loc.slice(1).join(".")}: ${item.msg}`).join("; ") ??
      answer.statusText,
    refusal?.error?.german,
  );
}

export const query = (values: Record<string, string>) => new URLSearchParams(values).toString();
export const get = async <T>(path: string): Promise<T> =>
  learnt((await (await asked("GET", path)).json()) as T);

export const project = () => get<Project>("/api/project");
let place: Promise<string> | null = null;
/** Folder of the workbench, requested once. */
export function folder(): Promise<string> {
  place ??= project().then((project) => project.folder);
  place.catch(() => {
    place = null;
  });
  return place;
}
/** A shipped rig or vehicle. */
export interface Shipped {
  name: string;
  model: string;
  source: string;
  has_hardpoints: boolean;
  has_axle: boolean;
  is_dependent: boolean;
}
export const library = () => get<Shipped[]>("/api/library");
export const file = (path: string) => get<answers.Text>(`/api/file?${query({ path })}`);
export const versions = (path: string) =>
  get<answers.Version[]>(`/api/versions?${query({ path })}`);
export const check = async (path: string): Promise<Checked> => {
  const answer = await get<{
    kind: string;
    what: string;
    problems: { text: string; german: string | null }[];
    notes: Checked["notes"];
  }>(`/api/check?${query({ path })}`);
  return {
    ...answer,
    problems: answer.problems.map(({ text, german }) => new Refused(text, german)),
  };
};
export const rig = (name: string) => get<Rig>(`/api/rig?${query({ name })}`);
export const start = async (name: string, path: string) =>
  (await asked("POST", "/api/library", { name, path })).json() as Promise<answers.Text>;
export const save = async (path: string, text: string, was: string) =>
  (await asked("PUT", "/api/file", { path, text, was })).json() as Promise<answers.Text>;
const schemas = new Map<string, Promise<object>>();
/** Schema of a model, requested once. */
export function schema(model: string): Promise<object> {
  let schema = schemas.get(model);
  if (!schema) {
    schema = get<object>(`/api/schema?${query({ model })}`);
    schemas.set(model, schema);
    schema.catch(() => schemas.delete(model));
  }
  return schema;
}
export const form = async (
  path: string,
  text: string,
  sets: unknown[],
  changes: Record<string, number>,
): Promise<Form> => {
  const form = (await (
    await asked("POST", "/api/form", { path, text, sets, changes })
  ).json()) as Form;
  return {
    ...form,
    problems: form.problems.map((problem) => ({
      ...problem,
      text: inLanguage(problem.text, problem.german),
    })),
    notes: form.notes.map((note) => ({ ...note, text: inLanguage(note.text, note.german) })),
  };
};
export const binary = async (path: string, body: unknown) =>
  (await asked("POST", path, body, "application/octet-stream")).arrayBuffer();
/** Uploads a file into the project. */
export const upload = async (path: string, file: File): Promise<void> => {
  await sent(`/api/upload?${query({ path })}`, { method: "PUT", body: file });
};
export const curves = (question: "simulate" | "kinematics" | "kc", body: unknown) =>
  binary(`/api/${question}`, body);
