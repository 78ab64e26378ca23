// The state of the team at a moment, and the happenings of the last hour.
import type { Change, Participant, Request, Service } from './answers.js';
import type { History } from './history.js';
import { teamNow } from './time.js';

export interface Moment {
  participants: Map<string, Participant>;
  services: Map<string, Service>;
  requests: Map<string, Request>;
}

export type Kind = keyof Moment;

export const kinds: Kind[] = ['participants', 'services', 'requests'];

/** The key of the records of each kind. */
const keys = { participants: 'id', services: 'service', requests: 'subscription' } as const;

export interface Happening {
  time: number;
  kind: Kind;
  key: string;
  event: Change['event'];
  record: Participant | Service | Request;
  reason: string;
}

/** How long happenings are kept, in milliseconds, and how many at most. The eldest give way. */
export const hour = 3_600_000;
const maxHappenings = 20_000;
const maxAbsences = 200;

const emptyMoment = (): Moment => ({ participants: new Map(), services: new Map(), requests: new Map() });

function apply(moment: Moment, happening: Happening): void {
  const records = moment[happening.kind] as Map<string, Happening['record']>;
  if (happening.event === 'del') records.delete(happening.key);
  else records.set(happening.key, happening.record);
}

/** The team as it is, and as it was within the hour that geminga-web and this page have seen. */
export class Team {
  readonly now = emptyMoment();
  readonly happenings: Happening[] = [];
  /** The state before the first happening. */
  private readonly before = emptyMoment();
  /** Keys that a stream which was opened anew has told, by kind, until it has told all; the others have gone meanwhile. */
  private told: Record<Kind, Set<string>> | undefined;
  /** Whether all that was there has been told once, by a stream or by the hour that was kept. */
  private isKnown = false;
  /** The times at which the daemon was away, and why. */
  private absences: { from: number; to: number; reason: string }[] = [];
  /** Where the happenings begin. */
  since = teamNow();

  /** Takes the hour that geminga-web has kept, in the place of what is known. */
  recall(history: History): void {
    if (history.begin === null) return;
    this.isKnown = true;
    this.since = Date.parse(history.begin);
    this.happenings.length = 0;
    this.absences = [];
    for (const kind of kinds) {
      const records = (history.before[kind] ?? []) as unknown as Record<string, string>[];
      for (const moment of [this.before, this.now]) {
        const map = moment[kind] as Map<string, unknown>;
        map.clear();
        for (const record of records) map.set(record[keys[kind]] ?? '', record);
      }
    }
    const before = history.before.absence ?? '';
    if (before !== '') this.absences.push({ from: this.since, to: Infinity, reason: before });
    for (const { of, event, time, reason, record } of history.changes) {
      const at = Date.parse(time);
      if (of === 'daemon') this.beAbsent(at, event === 'del' ? reason : '');
      else this.keep({ time: at, kind: of, key: (record as unknown as Record<string, string>)[keys[of]] ?? '', event, record: record as Happening['record'], reason }, Infinity);
    }
  }

  /** The daemon is away from this time on, and why; an empty reason: it is there again. */
  beAbsent(time: number, reason: string): void {
    const last = this.absences.at(-1);
    if (last?.to === Infinity) {
      if (reason === '') last.to = time;
    } else if (reason !== '') {
      this.absences.push({ from: time, to: Infinity, reason });
    }
    if (this.absences.length > maxAbsences) this.absences.shift();
  }

  /** The reason why nothing was known at an instant; empty: the daemon was there. */
  absenceAt(time: number): string {
    return this.absences.find((one) => one.from <= time && time < one.to)?.reason ?? '';
  }

  /** A stream begins to tell all that is there. */
  begin(): void {
    this.told = { participants: new Set(), services: new Set(), requests: new Set() };
  }

  /** A stream has told all that is there: what it did not tell has gone. */
  settle(time: number): void {
    const told = this.told;
    this.told = undefined;
    this.isKnown = true;
    for (const kind of kinds) {
      for (const [key, record] of [...this.now[kind]]) {
        if (told?.[kind].has(key) === false) this.keep({ time, kind, key, event: 'del', record, reason: 'gone meanwhile' });
      }
    }
  }

  take(kind: Kind, change: Change & Record<string, unknown>): void {
    const { event, time, reason, ...record } = change;
    delete record['former'];
    const key = String(record[keys[kind]]);
    this.told?.[kind].add(key);
    const known = this.now[kind].has(key);
    const kept = record as unknown as Happening['record'];
    if (event === 'add' && !this.isKnown) {
      // Services that were there when the page was opened have not come now.
      for (const moment of [this.before, this.now]) (moment[kind] as Map<string, Happening['record']>).set(key, kept);
    } else if (event === 'add' && known) {
      (this.now[kind] as Map<string, Happening['record']>).set(key, kept);
    } else {
      this.keep({ time: Date.parse(time), kind, key, event, record: kept, reason: reason ?? '' });
    }
  }

  /** The team at an instant of the last hour. Cost: the happenings until then. */
  at(time: number): Moment {
    const moment: Moment = {
      participants: new Map(this.before.participants),
      services: new Map(this.before.services),
      requests: new Map(this.before.requests),
    };
    for (const happening of this.happenings) {
      if (happening.time > time) break;
      apply(moment, happening);
    }
    return moment;
  }

  /** The robots that had gone before an instant and were not there at it. Cost: the happenings. */
  goneAt(time: number, moment: Moment): { id: string; name: string }[] {
    const present = new Set([...moment.participants.values()].map((one) => one.name));
    const gone = new Map<string, string>();
    for (const one of this.happenings) {
      if (one.kind !== 'participants' || one.event !== 'del' || one.time > time) continue;
      const { name } = one.record as Participant;
      if (!present.has(name)) gone.set(name, one.key);
    }
    return [...gone].map(([name, id]) => ({ id, name }));
  }

  private keep(happening: Happening, span = hour): void {
    apply(this.now, happening);
    this.happenings.push(happening);
    const since = happening.time - span;
    while (this.happenings.length > maxHappenings || (this.happenings[0]?.time ?? since) < since) {
      const eldest = this.happenings.shift();
      if (eldest === undefined) continue;
      apply(this.before, eldest);
      this.since = eldest.time;
    }
  }
}
