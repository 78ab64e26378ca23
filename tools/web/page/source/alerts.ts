// Alerts of the past hour, read off what happened: when something began to be wrong, and when it was mended.
import { identityText, type Participant, type Request } from './answers.js';
import type { Happening } from './team.js';

export interface Alert {
  time: number;
  isMended: boolean;
  text: string;
}

interface Unserved {
  time: number;
  isTold: boolean;
  isMended: boolean;
  text: string;
}

/** A request that is served within this time after it was stated is none that nobody serves, in milliseconds. */
const patience = 3000;

/** Ascending by time. Cost: the happenings. */
export function alertsOf(happenings: Happening[], now: number): Alert[] {
  const alerts: Alert[] = [];
  const unserved = new Map<string, Unserved>();
  const pending: Unserved[] = [];
  let next = 0;
  const gone = new Set<string>();
  const deaf = new Set<string>();
  /** Tells of the requests that nobody has served for long enough until then. */
  const flush = (until: number): void => {
    for (; next < pending.length; ++next) {
      const one = pending[next];
      if (one === undefined || one.time + patience > until) return;
      if (one.isMended) continue;
      one.isTold = true;
      alerts.push({ time: one.time, isMended: false, text: one.text });
    }
  };
  const mend = (key: string, time: number): void => {
    const known = unserved.get(key);
    if (known === undefined) return;
    known.isMended = true;
    if (known.isTold) alerts.push({ time, isMended: true, text: known.text });
    unserved.delete(key);
  };
  for (const one of happenings) {
    flush(one.time);
    if (one.kind === 'participants') {
      const { name, id, hears_us } = one.record as Participant;
      const isDeaf = one.event !== 'del' && (hears_us === false || hears_us === 0);
      if (one.event === 'del') alerts.push({ time: one.time, isMended: false, text: `${name} is gone` });
      else if (one.event === 'add' && gone.has(name)) alerts.push({ time: one.time, isMended: true, text: `${name} is gone` });
      if (isDeaf !== deaf.has(id)) alerts.push({ time: one.time, isMended: !isDeaf, text: `${name} does not hear this host` });
      if (one.event === 'del') gone.add(name);
      else gone.delete(name);
      if (isDeaf) deaf.add(id);
      else deaf.delete(id);
    } else if (one.kind === 'requests') {
      const request = one.record as Request;
      if (one.event === 'del' || request.served) mend(one.key, one.time);
      else if (!unserved.has(one.key)) {
        const text = `Nobody serves ${identityText(request)} for ${request.participant_name} ${request.name}`;
        const began = { time: one.time, isTold: false, isMended: false, text };
        unserved.set(one.key, began);
        pending.push(began);
      }
    }
  }
  flush(now);
  return alerts.sort((a, b) => a.time - b.time);
}
