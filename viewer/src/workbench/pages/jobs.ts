/** Every job of the project. */

import { make } from "../../page";
import { type Job, jobList } from "../jobs";
import { noticeButton } from "../notices";
import { address } from "../shell";

export const PAGES_OF: Record<string, string> = {
  sweep: "studies",
  campaign: "campaign",
  compare: "ride",
  pareto: "ride",
  design: "kinematics",
  evaluate: "inspection",
};

/** The page on which the results of a job are shown. */
export function results(job: Job): void {
  const page = PAGES_OF[job.kind];
  if (page && page !== "kinematics") location.hash = address(page, { job: job.id });
  else window.open(job.report, "_blank", "noopener");
}

export async function show(place: HTMLElement): Promise<void> {
  place.replaceChildren(
    make("h1", {}, "Jobs"),
    make("p", { class: "muted" }, "Jobs continue when you close the page or stop the server."),
    noticeButton(),
    jobList(null, results, "No jobs yet. Studies, campaigns, rides and designs start them."),
  );
}
