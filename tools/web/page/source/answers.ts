// The documents of geminga-web, which are those of `geminga-query --json` (src/discovery/participant/QUERIES.md).

export interface Participant {
  id: string;
  name: string;
  addresses: string[];
  heard: number;
  interval: number;
  loss?: number;
  loss_least?: number;
  ontology: string;
  publications: number;
  subscriptions: number;
  self: boolean;
  hears_us?: boolean | number;
  /** Where it is not heard on our own links: how many relays are on the way, and the names of those that are known, the nearest to it first. */
  hops?: number | string;
  path?: string;
  /** The address from which its words come, where it announces another one: a translation of addresses may lie between. */
  observed?: string;
  /** False: its address cannot be reached from this host. */
  reachable?: boolean;
}

/** The way to a participant that is heard through relays, in words; empty: it is heard on our own links. */
export function wayOf(one: Participant): string {
  const names = (one.path ?? '').split('/').filter((name) => name !== '');
  const count = Number(one.hops ?? names.length);
  if (count === 0) return '';
  return `${count} ${count === 1 ? 'relay' : 'relays'}${names.length === 0 ? '' : `: ${names.join(' → ')} → this host`}`;
}

/** Whether a participant says that it does not hear this host. */
export const isDeaf = (one: Participant): boolean => one.hears_us === false || one.hears_us === 0;

/** The identity of a service or of a request: one of number, text and concept. */
export interface Identity {
  id?: number | string;
  text?: string;
  concept?: string;
  representation?: string;
}

interface Entry extends Identity {
  name: string;
  participant_name: string;
  mode: string;
  protocol?: string;
  priority: number;
  local: boolean;
  scope?: string;
  attributes: Record<string, string>;
}

export interface Service extends Entry {
  service: string;
  provider: string;
  address?: string;
  port?: number;
  /** False: its address cannot be reached from this host, and requests are not given it. */
  reachable?: boolean;
  used: boolean;
  for?: string;
  /** The classes right above an offered expression, or why it has no place here. */
  placed?: string;
  unplaced?: string;
}

export interface Request extends Entry {
  subscription: string;
  consumer: string;
  match: string;
  provider?: string;
  where?: string;
  limit: number;
  favour?: string;
  prefer?: string;
  rank?: string;
  on?: string;
  convert?: string | number | boolean;
  served: boolean;
  why?: string;
  because?: string;
}

export interface Match extends Service {
  degree: string;
  distance: number;
  convert?: string;
  cost?: number;
  via?: string;
}

export interface Check {
  check: string;
  ok: boolean;
  text: string;
  code?: string;
  mend?: string;
  proof?: string[];
}

/** Why a request and a service meet or do not. */
export interface PairAnswer {
  matches: boolean;
  outranked: boolean;
  degree?: string;
  distance?: number;
  convert?: string;
  code?: string;
  checks: Check[];
}

export interface NearService extends Check {
  service: string;
  provider: string;
  name: string;
  participant_name: string;
  offered: string;
  mode: string;
}

/** Why nobody, or somebody, serves a request. */
export interface RequestAnswer {
  served: boolean;
  offers: number;
  matching: number;
  code?: string;
  text?: string;
  mend?: string;
  gaps?: string;
  services: NearService[];
}

export interface Ontology {
  loaded: boolean;
  digest?: string;
  classes?: number;
  complete?: boolean;
  contradiction: boolean;
  loading: boolean;
  files: { file: string; iri?: string }[];
  left_out: { construct: string; count: number; first: string }[];
  gaps: string[];
  others: { participant: string; name: string; ontology: string }[];
  failed: string[];
}

/** A class in the tree of the ontology. */
export interface ClassNode {
  class: string;
  children?: number;
  equivalents?: string[];
  unsatisfiable?: boolean;
  offers: number;
  requests: number;
}

export interface Taxonomy {
  class?: string;
  total: number;
  parents?: string[];
  equivalents?: string[];
  classes: ClassNode[];
}

export interface Explanation {
  subsumed: boolean;
  axioms: { axiom: string; file?: string; line?: number }[];
  text?: string;
}

/** The last words of a participant on whom it hears, by how lately. */
export interface Hearer {
  witness: string;
  name: string;
  quarter?: string[];
  half?: string[];
  whole?: string[];
  longer?: string[];
}

export interface Security {
  mode: string;
  keys: string[];
  participants: { participant: string; name: string; protection: string; keys: string[]; lacks: string[] }[];
}

export interface Status {
  name: string;
  participant: string;
  state: string;
  participants: number;
  publications: number;
  subscriptions: number;
  events: number;
  datagrams_received: number;
  unheard_by?: number;
  /** The moment of a recording that geminga-query replay plays in the place of a daemon. */
  recorded?: string;
  matched_exact?: number;
  matched_narrower?: number;
}

/** A finding of the doctor (tools/doctor/README.md). */
export interface Diagnosis {
  severity: 'failure' | 'risk';
  code: string;
  what: string;
  seen: string;
  remedy: string;
  command: string;
}

/** The state of one rule of `geminga-web --rules`. */
export interface RuleState {
  alert: string;
  /** `waits`: the count is wrong, and not yet for as long as the rule asks; `unknown`: it was not counted. */
  state: 'unknown' | 'holds' | 'waits' | 'raised';
  counted: 'services' | 'participants';
  of: string;
  at_least: number;
  at_most?: number;
  for: number;
  count?: number;
  /** Since when the count is wrong. */
  seconds?: number;
  problem?: string;
}

/** One event of a stream: a record that came, changed or went. */
export interface Change {
  event: 'add' | 'modify' | 'del';
  time: string;
  reason?: string;
  former?: Record<string, unknown>;
}

/** An answer that is none: the sentence of the daemon, and the status of HTTP. */
export class Refusal extends Error {
  constructor(
    text: string,
    readonly status: number,
  ) {
    super(text);
  }
}

/** The answer to a question. Throws a Refusal, or what fetch throws. */
export async function ask<Answer>(kind: string, parameters: Record<string, string> = {}): Promise<Answer> {
  const words = new URLSearchParams(parameters).toString();
  const response = await fetch(`api/${kind}${words === '' ? '' : '?' + words}`, { cache: 'no-store' });
  const body: unknown = await response.json().catch(() => ({}));
  if (!response.ok) {
    const { error } = body as { error?: string };
    throw new Refusal(error ?? `${kind} was answered by ${response.status}`, response.status);
  }
  return body as Answer;
}

/** The participant of `PARTICIPANT/PEER` and `PARTICIPANT/PEER/NUMBER`. */
export const participantOf = (word: string): string => word.split('/')[0] ?? word;

export function identityText(entry: Identity): string {
  if (entry.concept !== undefined) return entry.concept + (entry.representation === undefined ? '' : ` as ${entry.representation}`);
  if (entry.text !== undefined) return `“${entry.text}”`;
  return entry.id === undefined ? 'anything' : `number ${entry.id}`;
}

/** The parameters of `match` and `why` that state an identity. */
export function identityParameters(entry: Identity): Record<string, string> {
  const parameters: Record<string, string> = {};
  if (entry.concept !== undefined) parameters['concept'] = entry.concept;
  else if (entry.text !== undefined) parameters['text'] = entry.text;
  else if (entry.id !== undefined) parameters['id'] = String(entry.id);
  if (entry.representation !== undefined) parameters['representation'] = entry.representation;
  return parameters;
}
