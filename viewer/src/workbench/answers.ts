/** Answers of the server: the fields of results in Python, written by `make faces`. */

export interface Entry {
  path: string;
  kind: string;
  size: number;
  modified: number;
  finished: number | null;
  count: number | null;
  has_hardpoints: boolean;
  has_axle: boolean;
  is_dependent: boolean;
}

export interface Text {
  path: string;
  text: string;
  digest: string;
}

export interface Version {
  name: string;
  replaced: number;
}

export interface FormProblem {
  path: string;
  line: number;
  text: string;
  german: string | null;
}

export interface Form {
  text: string;
  values: Record<string, unknown>;
  model: string;
  problems: FormProblem[];
  rig: Record<string, unknown> | null;
  changed: string[];
  notes: FormProblem[];
  python: string;
  command: string;
}

export interface ParetoFront {
  metrics: Record<string, string>;
  units: Record<string, string>;
  comfort: number[];
  holding: number[];
  travel: number[];
  numbers: Record<string, number[]>;
  number_units: Record<string, string>;
  marks: ParetoMark[];
  converged: boolean;
  driven: string;
  findings: Finding[];
  words: Record<string, string>;
}

export interface Trend {
  axle: string;
  wheel: string;
  quantity: string;
  change_per_year: number;
  visits: number;
}

export interface ParetoMark {
  name: string;
  kind: "present" | "closed form" | "searched";
  values: Record<string, number>;
  comfort: number;
  holding: number;
  travel: number;
}

export interface Finding {
  place: string;
  severity: "note" | "warning" | "problem";
  message: string;
  value: number | null;
  code: string;
  numbers: Record<string, unknown>;
}
