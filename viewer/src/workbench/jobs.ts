/** Jobs: their state as the server reports it, and starting, stopping and restarting them. */

import { make, whenLeft, written } from "../page";
import { heard, isGerman, tr } from "../words";
import { asked, get, upload } from "./api";
import { moment } from "./drafts";
import { notify } from "./notices";
import { InTurn, problem, snippets } from "./parts";
import { type Finding, learnt, Refused } from "./refusals";
import { address } from "./shell";
import { token } from "./token";

export interface Step {
  evaluation: number;
  objective: number;
  parameters: Record<string, { value: number; initial: number; lower: number; upper: number }>;
}
export interface Job {
  id: string;
  kind: string;
  asked: Record<string, unknown>;
  title: string;
  state: "running" | "cancelling" | "done" | "failed" | "cancelled" | "stopped";
  python: string;
  command: string;
  files: Record<string, string>;
  out: string;
  report: string;
  begun: number;
  ended: number | null;
  lasted: number | null;
  said: string;
  said_german: string | null;
  share: number | null;
  left: number | null;
  stage: [number, number] | null;
  steps: Step[];
  error: string | null;
  german: string | null;
  code?: number;
}
export interface Whole<T = unknown> extends Job {
  result: T;
  has_page: boolean;
}
/** Answer to a short task. */
export interface Reply<T> {
  result: T;
  python: string;
  command: string;
  files: Record<string, string>;
  report: string;
}

const send = async <T>(method: string, path: string, body?: unknown): Promise<T> =>
  learnt((await (await asked(method, path, body)).json()) as T);
export const begin = async (task: object): Promise<Job> => {
  const job = await send<Job>("POST", "/api/jobs", task);
  tellEnds([job]);
  return job;
};
export const ask = <T>(task: object) => send<Reply<T>>("POST", "/api/ask", task);
export const whole = <T>(id: string) => get<Whole<T>>(`/api/jobs/${encodeURIComponent(id)}`);

type Listener = (jobs: Job[]) => void;
const listeners = new Map<Listener, { node: Node; shown: boolean; isOfEnds?: boolean }>();
let latest: Job[] | null = null,
  socket: WebSocket | null = null,
  pause = 1000;
const lost = make(
  "p",
  { class: "problem", role: "alert" },
  "The server no longer reports on jobs; running jobs continue. Restart it with jounce serve and open the address that it prints.",
);

function open(): void {
  socket = new WebSocket(
    `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/live`,
    token ? ["jounce", token] : [],
  );
  const take = (jobs: Job[]) => {
    pause = 1000;
    lost.remove();
    latest = jobs;
    tell();
  };
  socket.addEventListener("message", (event) => take(JSON.parse(event.data as string) as Job[]));
  socket.addEventListener("close", async () => {
    socket = null;
    if (![...listeners.values()].some((listener) => listener.node.isConnected)) {
      listeners.clear();
      return;
    }
    try {
      take(await get<Job[]>("/api/jobs"));
    } catch {
      // what lets no socket through answers all the same
      document.getElementById("main")!.prepend(lost);
    }
    setTimeout(() => {
      if (listeners.size && !socket) open();
    }, pause);
    pause = Math.min(2 * pause, 30_000);
  });
}

function tell(): void {
  for (const [listener, one] of listeners) {
    if (one.node.isConnected) one.shown = true;
    if (one.node.isConnected || !one.shown) listener(latest!);
    else listeners.delete(listener);
  }
}

/** Calls back with all jobs, now and whenever one changes, as long as a node is on the page. */
export function follow(node: Node, listener: Listener): void {
  listeners.set(listener, { node, shown: false });
  whenLeft(() => listeners.delete(listener));
  if (latest) listener(latest);
  if (!socket) open();
}

const runs = (job: Job) => job.state === "running" || job.state === "cancelling";
const ends = new Set<string>(); // jobs that were seen running

/** Tells of every job that ends from now on, on whichever page, until none runs. */
function tellEnds(jobs: Job[]): void {
  for (const job of jobs) if (runs(job)) ends.add(job.id);
  if (!ends.size || [...listeners.values()].some((listener) => listener.isOfEnds)) return;
  const listener: Listener = (jobs) => {
    for (const job of jobs) {
      if (runs(job)) ends.add(job.id);
      else if (ends.delete(job.id))
        notify(`${titled(job.title)}: ${tr(WORDS[job.state])}`, job.state === "done");
    }
    if (!ends.size) listeners.delete(listener);
  };
  listeners.set(listener, { node: document.body, shown: true, isOfEnds: true });
  if (!socket) open();
}

/** Tells of the jobs that run while the workbench opens. */
export async function tellRunning(): Promise<void> {
  tellEnds(await get<Job[]>("/api/jobs?running=true"));
}

const WORDS: Record<Job["state"], string> = {
  running: "running",
  cancelling: "stopping",
  done: "done",
  failed: "failed",
  cancelled: "cancelled",
  stopped: "stopped",
};
const TONES: Record<Job["state"], string> = {
  running: "plain",
  cancelling: "fair",
  done: "good",
  failed: "bad",
  cancelled: "fair",
  stopped: "bad",
};

export function lasting(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  if (whole < 60) return `${whole} s`;
  return whole < 3600
    ? `${Math.floor(whole / 60)} min ${whole % 60} s`
    : `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
}

/** What a job is called, in the language of the page; names of files and roads stay. */
export const titled = (title: string) =>
  isGerman ? heard(title).replace(/^(.+) on (\S+) at (\S+(?: \S+)?)$/, "$1 auf $2 mit $3") : title;

const INPUTS: Record<string, string> = { out: "into", changes: "with", holding: "road holding" },
  NOT_INPUTS = ["kind", "force", "resume", "language"],
  MOST_INPUTS = 8,
  LONGEST_INPUT = 60;

/** What a job was asked for: names as in its form, values as they were typed. */
function inputsOf({ asked }: Job): string {
  const written = (value: unknown): string => {
    if (Array.isArray(value)) return value.map(written).join(", ");
    if (value !== null && typeof value === "object")
      return Object.entries(value)
        .map(([name, one]) => `${name} = ${written(one)}`)
        .join(", ");
    return value === null || value === false ? "" : String(value);
  };
  const inputs = Object.entries(asked ?? {})
    .filter(([name]) => !NOT_INPUTS.includes(name))
    .map(([name, value]): [string, string] => [name, written(value)])
    .filter(([, text]) => text)
    .map(([name, text]) => {
      const short = text.length > LONGEST_INPUT ? `${text.slice(0, LONGEST_INPUT)} …` : text;
      const own = isGerman ? tr(`input: ${name}`).replace(/^input: /, "") : (INPUTS[name] ?? name);
      return `${own} ${short}`;
    });
  return [...inputs.slice(0, MOST_INPUTS), ...(inputs.length > MOST_INPUTS ? ["…"] : [])].join(
    " · ",
  );
}

/** Opens the form of a job with what was asked, by kind. */
const CHANGED: Record<string, (job: Job) => void> = {
  compare: (job) => {
    const set = JSON.stringify(job.asked.changes ?? {});
    location.hash = address("ride", { again: job.id, ...(set === "{}" ? {} : { set }) });
  },
  pareto: (job) => {
    location.hash = address("ride", { again: job.id });
  },
  campaign: (job) => {
    location.hash = address("campaign", { file: String(job.asked.campaign) });
  },
};

/** Card of one job: its task, progress, errors and actions. */
export class JobCard {
  readonly element = make("article", { class: "job" });
  private readonly state = make("span", { class: "mark" });
  private readonly times = make("span", { class: "muted" });
  private readonly inputs = make("p", { class: "inputs muted" });
  private readonly said = make("p", { class: "state", role: "status" });
  private readonly bar = make("progress", { max: "1" });
  private readonly actions = make("div", { class: "bar" });
  private readonly status = make("div", {});
  private shown = "";

  constructor(
    public job: Job,
    private readonly open?: (job: Job) => void,
  ) {
    this.inputs.textContent = inputsOf(job);
    this.inputs.hidden = !this.inputs.textContent;
    this.bar.setAttribute("aria-label", heard(`progress of ${titled(job.title)}`));
    this.element.append(
      make("div", { class: "bar" }, make("h3", {}, titled(job.title)), this.state, this.times),
      this.inputs,
      this.bar,
      this.said,
      this.status,
      this.actions,
    );
    this.show(job);
  }

  show(job: Job): void {
    if (this.job.ended && !job.ended) return; // what ended does not go on: this was told before
    this.job = job;
    const isRunning = runs(job);
    if (isRunning) tellEnds([job]);
    this.state.textContent = tr(WORDS[job.state]);
    this.state.className = `mark ${TONES[job.state]}`;
    this.bar.hidden = !isRunning;
    if (job.share === null) this.bar.removeAttribute("value");
    else this.bar.value = job.share;
    this.said.hidden = !isRunning;
    this.said.textContent = tr(
      job.state === "cancelling"
        ? "stopping; finished results are kept"
        : (isGerman && job.said_german) || job.said || "starting",
    );
    this.tick();
    if (this.shown === job.state) return;
    this.shown = job.state;
    this.status.replaceChildren(
      ...(job.error ? [problem(new Refused(job.error, job.german))] : []),
    );
    const act = (text: string, does: () => Promise<unknown>, main = false) => {
      const button = make(
        "button",
        {
          type: "button",
          ...(main ? { class: "main" } : {}),
          "aria-label": `${text}: ${titled(job.title)}`,
        },
        text,
      );
      button.addEventListener("click", () => {
        button.disabled = true;
        does().catch((error) => {
          this.status.replaceChildren(problem(error));
          button.disabled = false;
        });
      });
      return button;
    };
    const goes = (text: string, does: (job: Job) => void) => {
      const named = `${text}: ${titled(job.title)}`,
        button = make("button", { type: "button", class: "main", "aria-label": named }, text);
      button.addEventListener("click", () => does(this.job));
      return button;
    };
    const path = `/api/jobs/${encodeURIComponent(job.id)}`;
    this.actions.replaceChildren(
      ...(job.state === "running" ? [act("Cancel", () => send("POST", `${path}/cancel`, {}))] : []),
      ...(this.open && (job.state === "done" || job.kind === "sweep")
        ? [goes("Show the results", this.open)]
        : []),
      ...(!isRunning && job.state !== "done"
        ? [
            ...(job.kind in CHANGED ? [goes("Change and start again", CHANGED[job.kind]!)] : []),
            act(
              job.kind === "sweep" ? "Resume" : "Restart",
              () => send("POST", `${path}/again`, {}),
              !(job.kind in CHANGED),
            ),
          ]
        : []),
      ...(!isRunning ? [act("Remove", () => send("DELETE", path))] : []),
    );
    this.actions.append(
      make("details", {}, make("summary", {}, "In Python and on the command line"), snippets(job)),
    );
  }

  private tick(): void {
    const { begun, ended, lasted, share, left, stage, state } = this.job; // by the server's clock that does not jump: it tells every second
    const parts = [tr("started #", moment(1000 * begun))];
    if (lasted !== null) parts.push(tr(ended ? "took #" : "for #", lasting(lasted)));
    if (state === "running" && stage) parts.push(tr("stage # of ", String(stage[0])) + stage[1]);
    else if (state === "running" && share !== null) parts.push(`${written(100 * share, 3)} %`);
    if (state === "running" && left !== null && left >= 1)
      parts.push(tr("about # left", lasting(left)));
    this.times.textContent = parts.join(" · ");
  }
}

/** Calls back whenever a job changes, and once with its result. */
export async function accompany<T>(
  place: HTMLElement,
  first: Whole<T>,
  goes: (job: Job) => void,
  ended: (end: Whole<T>) => void,
): Promise<void> {
  let isDone = false;
  const take = async (job: Job) => {
    goes(job);
    if (job.state !== "done" || isDone) return;
    isDone = true;
    try {
      ended(job === first ? first : await whole<T>(first.id));
    } catch (error) {
      isDone = false;
      throw error;
    }
  };
  await take(first);
  follow(place, (jobs) => {
    const job = jobs.find((job) => job.id === first.id);
    if (job) take(job).catch((error) => place.append(problem(error)));
  });
}

/** Live list of all jobs, or those of some kinds, newest first. */
export function jobList(
  kinds: string[] | null,
  shown: (job: Job) => void,
  none: string,
): HTMLElement {
  const place = make("div", { class: "jobs" }, make("p", { class: "muted" }, "loading …"));
  const cards = new Map<string, JobCard>();
  follow(place, (jobs) => {
    const own = jobs.filter((job) => !kinds || kinds.includes(job.kind));
    for (const job of own) {
      const card = cards.get(job.id);
      if (card) card.show(job);
      else cards.set(job.id, new JobCard(job, shown));
    }
    for (const id of [...cards.keys()]) if (!own.some((job) => job.id === id)) cards.delete(id);
    const elements = own.map((job) => cards.get(job.id)!.element);
    if (!elements.length) place.replaceChildren(make("p", { class: "empty" }, none));
    else if (
      elements.some((element, k) => place.children[k] !== element) ||
      place.children.length !== elements.length
    )
      place.replaceChildren(...elements);
  });
  return place;
}

/** Problems of a command that succeeded but could not write or draw everything. */
export function failures(result: unknown): HTMLElement[] {
  const findings = (result as { findings?: Finding[] } | null)?.findings ?? [];
  return findings
    .filter((finding) => finding.severity === "problem")
    .map((finding) => problem(new Refused(finding.message, finding.german)));
}

/** A report in a frame of its own, where its script can ask nothing; German pages say which is English. */
export function report(
  address: string,
  title: string,
  language = "en",
  ...more: HTMLElement[]
): HTMLElement {
  return make(
    "section",
    { class: "whole" },
    make(
      "div",
      { class: "bar" },
      make("h2", {}, title),
      ...(isGerman && language === "en" ? [make("span", { class: "muted" }, "(englisch)")] : []),
      make("a", { href: address, target: "_blank", rel: "noopener" }, "open in a new tab"),
      ...more,
    ),
    make("iframe", { src: address, title, sandbox: "allow-scripts", class: "report" }),
  );
}

/** Uploads files into the project one by one. `coming` is called when files are dropped; the function it returns is called with their paths. `many` takes several files at once, if given. */
export function dropZone(
  folder: () => string,
  words: string,
  coming: () => (paths: string[]) => void,
  many?: (files: File[]) => void,
): HTMLElement {
  const input = make("input", { type: "file", multiple: true, "aria-label": words });
  const status = make("div", { "aria-live": "polite" }),
    turn = new InTurn((error) => status.append(problem(error)));
  const zone = make("div", { class: "drop" }, make("p", {}, words), input, status);
  const take = (given: FileList | null) => {
    const files = [...(given ?? [])];
    if (many && files.length > 1) {
      input.value = "";
      many(files);
      return;
    }
    const into = folder().replace(/\/+$/, ""),
      done = coming(),
      said = make("div", {});
    input.value = "";
    if (!files.length) return;
    if (!turn.waiting) status.replaceChildren();
    status.append(said);
    void turn.do(async () => {
      const paths: string[] = [],
        wrong: HTMLElement[] = [];
      for (const file of files) {
        const path = [into, file.name].filter(Boolean).join("/");
        said.replaceChildren(
          make(
            "p",
            { class: "state" },
            `${file.name}: uploading ${written(file.size / 1e6, 3)} MB …`,
          ),
        );
        try {
          if (file.size > MOST)
            throw new Error(
              `${file.name}: ${written(file.size / 1e6, 3)} MB; at most ${MOST / 1e6} MB can be uploaded. Copy it into the folder instead.`,
            );
          await file
            .slice(0, 1)
            .arrayBuffer()
            .catch(() => {
              throw new Error(
                tr("#: a folder, or a file that cannot be read. Choose files.", file.name),
              );
            });
          await upload(path, file);
          paths.push(path);
        } catch (error) {
          wrong.push(problem(error));
        }
      }
      said.replaceChildren(
        ...wrong,
        ...(paths.length ? [make("p", { class: "good" }, `${paths.join(", ")}: uploaded.`)] : []),
      );
      if (paths.length && zone.isConnected) done(paths);
    });
  };
  input.addEventListener("change", () => take(input.files));
  zone.addEventListener("dragover", (event) => {
    event.preventDefault();
    zone.classList.add("over");
  });
  zone.addEventListener("dragleave", () => zone.classList.remove("over"));
  zone.addEventListener("drop", (event) => {
    event.preventDefault();
    zone.classList.remove("over");
    take(event.dataTransfer?.files ?? null);
  });
  return zone;
}

const MOST = 250e6;

/** A button that runs a short task and shows its result or error; `show` gets the task as it was asked, since the form may have changed. */
export class Question<T, A extends object = object> {
  readonly button: HTMLButtonElement;
  readonly place = make("div", { "aria-live": "polite" });
  private asked = 0;

  constructor(
    label: string,
    private readonly task: () => A,
    private readonly show: (reply: Reply<T>, asked: A) => (Node | string)[],
  ) {
    this.button = make("button", { type: "button", class: "main" }, label);
    this.button.addEventListener("click", () => void this.ask());
  }

  /** Ask; where somebody asks again before the answer is there, the earlier answer is not shown. */
  async ask(): Promise<void> {
    const turn = ++this.asked;
    this.button.disabled = true;
    const waiting = make("p", { class: "state" }, "working …");
    this.place.prepend(waiting);
    let shown: () => (Node | string)[];
    try {
      const task = this.task(),
        reply = await ask<T>(task);
      shown = () => this.show(reply, task);
    } catch (error) {
      shown = () => [problem(error)];
    }
    waiting.remove();
    if (turn !== this.asked || !this.place.isConnected) return;
    this.place.replaceChildren(...shown());
    this.button.disabled = false;
  }
}
