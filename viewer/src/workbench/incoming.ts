/** Files on their way in: dropped on any page or chosen, with their folders; one page uploads and lists them. */

import { make, whenLeft } from "../page";
import { tr } from "../words";
import * as api from "./api";
import { Refused } from "./refusals";
import { address } from "./shell";

/** A file, and its path in the folder that was dropped. */
export interface Given {
  path: string;
  file: File;
}

export const MOST_FILES = 500;
const MOST = 250e6, // bytes of a file
  MOST_NAMES = 50; // tried for a file whose name is taken
let waiting: Given[] = [];
let taker: ((files: Given[]) => void) | null = null;

/** Lets the open page take files that are dropped on it, until it is left. */
export function takeDrops(take: (files: Given[]) => void): void {
  taker = take;
  whenLeft(() => {
    if (taker === take) taker = null;
  });
}

/** The files that were dropped or chosen last, and whether there were more; they are given once. */
export function arrived(): { files: Given[]; isCut: boolean } {
  const files = waiting.slice(0, MOST_FILES),
    isCut = waiting.length > MOST_FILES;
  waiting = [];
  return { files, isCut };
}

/** Opens the page that lists the files; `campaign` is where they are meant to go. */
export function bring(files: Given[], campaign = ""): void {
  if (!files.length) return;
  waiting = [...waiting, ...files];
  location.hash = address("files", { ...(campaign ? { campaign } : {}), at: String(Date.now()) });
}

const plain = (files: Iterable<File>): Given[] =>
  [...files].map((file) => ({ path: file.webkitRelativePath || file.name, file }));

/** Everything in a drop: files, and those in folders. */
async function within(transfer: DataTransfer): Promise<Given[]> {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) return plain(transfer.files);
  const files: Given[] = [];
  const walk = async (entry: FileSystemEntry): Promise<void> => {
    if (files.length > MOST_FILES || entry.name.startsWith(".")) return;
    if (entry.isFile) {
      const file = await new Promise<File>((done, failed) =>
        (entry as FileSystemFileEntry).file(done, failed),
      );
      files.push({ path: entry.fullPath.replace(/^\/+/, ""), file });
      return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    for (;;) {
      const some = await new Promise<FileSystemEntry[]>((done, failed) =>
        reader.readEntries(done, failed),
      ); // a browser gives a hundred at a time
      if (!some.length) return;
      for (const entry of some) await walk(entry);
    }
  };
  for (const entry of entries) if (entry) await walk(entry);
  return files;
}

/** The campaign that is open, which dropped files are meant for. */
const openCampaign = (): string => {
  const [page, values] = location.hash.replace(/^#\//, "").split("?");
  return page === "campaign"
    ? (new URLSearchParams(values).get("file") ?? "")
    : page === "files"
      ? (new URLSearchParams(values).get("campaign") ?? "")
      : "";
};

/** Takes files dropped on any page, and says so while they are dragged over it. A zone of a page has its own files. */
export function listenForDrops(): void {
  const words = make("p", {}),
    said = make("div", { class: "dropping", hidden: true, "aria-hidden": "true" }, words);
  document.body.append(said);
  const isFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  const isOurs = (event: DragEvent) =>
    isFiles(event) && !(event.target instanceof Element && event.target.closest(".drop"));
  let hides = 0;
  addEventListener("dragover", (event) => {
    if (!isFiles(event)) return;
    event.preventDefault();
    said.hidden = !isOurs(event);
    words.textContent = tr(
      taker
        ? "Drop the files: they are stored in the project and added to this page."
        : "Drop the files: they are recognised and listed before anything is entered.",
    );
    clearTimeout(hides);
    hides = window.setTimeout(() => {
      said.hidden = true;
    }, 400); // no longer over the page: nothing tells so reliably
  });
  addEventListener("drop", (event) => {
    said.hidden = true;
    if (!isFiles(event)) return;
    const isTaken = event.defaultPrevented;
    event.preventDefault();
    if (isTaken || !event.dataTransfer) return;
    const campaign = openCampaign(),
      take = taker ?? ((files: Given[]) => bring(files, campaign));
    void within(event.dataTransfer).then(take, () => take(plain(event.dataTransfer?.files ?? [])));
  });
}

/** Buttons that choose files or a folder, as an alternative to dragging. */
export function choosers(
  campaign = "",
  take = (files: Given[]) => bring(files, campaign),
): HTMLElement {
  const chooser = (words: string, isFolder: boolean) => {
    const input = make("input", { type: "file", multiple: true, hidden: true });
    if (isFolder) input.setAttribute("webkitdirectory", "");
    input.addEventListener("change", () => {
      take(plain(input.files ?? []));
      input.value = "";
    });
    const button = make("button", { type: "button" }, words);
    button.addEventListener("click", () => input.click());
    return [button, input];
  };
  return make(
    "p",
    { class: "bar" },
    ...chooser("Choose files", false),
    ...chooser("Choose a folder", true),
  );
}

/** Uploads a file and returns its path in the project: under another name if a different file has that name. */
export async function store({ path, file }: Given, folder: string): Promise<string> {
  if (file.size > MOST)
    throw new Error(
      tr("more than # MB: copy it into the folder of the project instead.", String(MOST / 1e6)),
    );
  await file
    .slice(0, 1)
    .arrayBuffer()
    .catch(() => {
      throw new Error(tr("it cannot be read any more: choose it again."));
    });
  const [, stem = path, suffix = ""] = /^(.*?)(\.[^./]*)?$/.exec(path) ?? [];
  for (let k = 1; ; k++) {
    const name = `${folder ? `${folder}/` : ""}${stem}${k > 1 ? `-${k}` : ""}${suffix}`;
    try {
      await api.upload(name, file);
      return name;
    } catch (error) {
      const isTaken = error instanceof Refused && error.english.includes("the file already exists");
      if (!isTaken || k >= MOST_NAMES) throw error;
    }
  }
}
