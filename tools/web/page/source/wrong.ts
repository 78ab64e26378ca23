// The faults of the team, worst first: each with how it was seen, what would mend it, and its place in the picture.
import { identityText, isDeaf, participantOf, type Ontology, type Participant, type Request, type Security } from './answers.js';
import type { Happening } from './team.js';
import { clock } from './time.js';

type Level = 'error' | 'warning';

export interface Finding {
  key: string;
  level: Level;
  title: string;
  text: string;
  /** The evidence, and one command to copy. */
  seen?: string;
  command?: string;
  /** The participants that it is about, and one of its requests. */
  places: string[];
  request?: Request;
}

/** The share of announcements lost from which deadlines bear no more, which is the doctor's. */
export const tooMuchLoss = 0.4;

/** Whether more than that is lost for certain: few announcements look worse than they are by chance. */
export const isLossy = (one: Participant): boolean => (one.loss_least ?? 0) > tooMuchLoss;

/** Whether a host is silent for longer than its loss explains: at 30 % one of twenty has lost 2.5 announcements in a row. One in a thousand is late by chance. */
export function isLate(one: Participant): boolean {
  const intervals = Math.log(0.001) / Math.log(Math.min(Math.max(one.loss ?? 0, 0.05), 0.99));
  return one.heard > Math.max(2.5, intervals) * one.interval;
}

function gone(happenings: Happening[], now: Map<string, Participant>): Finding[] {
  const last = new Map<string, Happening>();
  for (const happening of happenings) {
    if (happening.kind === 'participants') last.set((happening.record as Participant).name, happening);
  }
  const present = new Set([...now.values()].map((one) => one.name));
  return [...last]
    .filter(([name, happening]) => happening.event === 'del' && !present.has(name))
    .map(([name, happening]) => ({
      key: `gone ${name}`,
      level: 'error',
      title: `${name} is gone, noticed at ${clock(happening.time)}`,
      text: 'Its announcements no longer come. Is it switched off, or out of reach of the radio?',
      places: [happening.key],
    }));
}

function hearing(participants: Participant[]): Finding[] {
  const findings: Finding[] = [];
  for (const one of participants) {
    if (one.self) continue;
    const places = [one.id];
    if (isDeaf(one)) {
      findings.push({ key: `deaf ${one.id}`, level: 'error', title: `${one.name} is heard here and does not hear this host`, places,
        text: 'A firewall, a switch that filters multicast, or a Wi-Fi access point keeps our multicasts from it. Open UDP port 4717 there, or name each host to the other.',
        ...(one.addresses[0] === undefined ? {} : { command: `gemingad --peer ${one.addresses[0]}` }) });
    }
    if (isLossy(one)) {
      findings.push({ key: `loss ${one.id}`, level: 'warning', title: `At least ${Math.round((one.loss_least ?? 0) * 100)} % of the announcements of ${one.name} are lost`, places,
        text: 'It may be taken for gone while it lives. Check the radio link, and what else uses it.' });
    } else if (isLate(one)) {
      findings.push({ key: `late ${one.id}`, level: 'warning', title: `${one.name} was last heard ${one.heard.toFixed(0)} s ago`, places,
        text: `It usually announces itself every ${one.interval} s, and counts as gone after its deadline.` });
    }
  }
  return findings;
}

function ontologies(ontology: Ontology | undefined): Finding[] {
  if (ontology === undefined) return [];
  const findings: Finding[] = [];
  if (ontology.failed.length > 0) {
    findings.push({ key: 'ontology failed', level: 'error', title: 'An ontology could not be read', text: ontology.failed.join('\n'), places: [] });
  }
  if (ontology.contradiction) {
    findings.push({ key: 'contradiction', level: 'error', title: 'The ontology contradicts itself', places: [],
      text: 'No concept matches. See which axioms contradict each other.', command: 'geminga-ontology explain --inconsistent FILES' });
  }
  if (ontology.others.length > 0) {
    findings.push({
      key: 'digests', level: 'warning', places: ontology.others.map((one) => one.participant),
      title: `${ontology.others.map((one) => one.name).join(', ')}: another ontology`,
      text: 'A concept may be understood differently there, or not at all. Give all hosts the same files.',
      seen: ontology.others.map((one) => `${one.name} has ${one.ontology}`).join(', ') + `; this host has ${ontology.digest ?? 'none'}`,
    });
  }
  return findings;
}

function keys(security: Security | undefined): Finding[] {
  return (security?.participants ?? [])
    .filter((one) => one.lacks.length > 0)
    .map((one) => ({ key: `key ${one.participant}`, level: 'error', title: `${one.name} lacks a key of this host: ${one.lacks.join(', ')}`, places: [one.participant],
      text: 'Copy the key file to it, and reload its daemon.', command: 'systemctl reload gemingad' }));
}

/** The reason, in which "it" stands for the identity that the title has. */
const reasonOf = (request: Request): string => (request.because ?? '').replace(/^nobody offers (?:concept|text|id)=.*?(?=, nor |: |$)/, 'Nobody offers it');

/** Requests without a service; those of many hosts for the same are one finding. */
function unmatched(requests: Request[]): Finding[] {
  const groups = new Map<string, Request[]>();
  for (const request of requests) {
    const key = `${request.name} ${identityText(request)} ${request.mode} ${request.why ?? ''}`;
    groups.set(key, [...(groups.get(key) ?? []), request]);
  }
  const most = [...groups].sort(([a, one], [b, other]) => other.length - one.length || a.localeCompare(b));
  return most.map(([key, group]) => {
    const [first] = group as [Request];
    return { key: `request ${key}`, level: 'error', title: `Nobody serves ${identityText(first)}`, text: reasonOf(first), request: first,
      places: [...new Set(group.map((one) => participantOf(one.consumer)))] };
  });
}

export interface Seen {
  participants: Map<string, Participant>;
  happenings: Happening[];
  unmatched: Request[];
  ontology: Ontology | undefined;
  security: Security | undefined;
  /** Findings of the doctor, and of the rules of alerts. */
  diagnosed: Finding[];
  alerted: Finding[];
}

export function findings(seen: Seen): Finding[] {
  const all = [
    ...seen.alerted,
    ...gone(seen.happenings, seen.participants),
    ...hearing([...seen.participants.values()]),
    ...keys(seen.security),
    ...ontologies(seen.ontology),
    ...seen.diagnosed,
    ...unmatched(seen.unmatched),
  ];
  return [...all.filter((one) => one.level === 'error'), ...all.filter((one) => one.level === 'warning')];
}
