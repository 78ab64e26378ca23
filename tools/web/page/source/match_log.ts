// The matches as they were read, so that the picture of a past moment shows those of that moment and no others.
import type { Degree, Link } from './matches.js';
import { hour, type Moment } from './team.js';

/** Ended matches that are kept, of which the eldest give way, and the times without a reading between. */
const maxEnded = 20_000;
const maxSpans = 400;

interface Held {
  subscription: string;
  service: string;
  degree: Degree;
  word: string;
  steps?: string;
  from: number;
  /** Infinity: it holds. */
  to: number;
}

export class MatchLog {
  private readonly holding = new Map<string, Held>();
  private ended: Held[] = [];
  /** The times over which matches were read, ascending. */
  private spans: { from: number; to: number }[] = [];

  /** Takes what was read at `now`. What was so before and is so no more may have ended at `stale`, when the last reading no longer held. */
  take(links: Link[], stale: number, now: number): void {
    const keys = new Set<string>();
    for (const { request, service, degree, word, steps } of links) {
      const key = [request.subscription, service.service, degree, word, steps ?? ''].join('\n');
      keys.add(key);
      if (this.holding.has(key)) continue;
      const held = { subscription: request.subscription, service: service.service, degree, word, from: now, to: Infinity };
      this.holding.set(key, steps === undefined ? held : { ...held, steps });
    }
    for (const [key, held] of this.holding) if (!keys.has(key)) this.end(key, held, stale);
    if (this.spans.at(-1)?.to !== Infinity) this.spans.push({ from: now, to: Infinity });
    this.forget(now - hour);
  }

  /** Says that matches are known no more from this instant on, until the next reading. */
  lose(now: number): void {
    const last = this.spans.at(-1);
    if (last?.to !== Infinity) return;
    last.to = now;
    for (const [key, held] of this.holding) this.end(key, held, now);
  }

  /** The links of a moment at an instant; nothing: nobody read them then. */
  at(time: number, moment: Moment): Link[] | undefined {
    if (!this.spans.some((span) => span.from <= time && time < span.to)) return undefined;
    return [...this.ended, ...this.holding.values()].flatMap(({ subscription, service: key, from, to, ...held }) => {
      if (time < from || time >= to) return [];
      const [request, service] = [moment.requests.get(subscription), moment.services.get(key)];
      return request === undefined || service === undefined ? [] : [{ request, service, ...held }];
    });
  }

  private end(key: string, held: Held, time: number): void {
    this.holding.delete(key);
    if (time <= held.from) return;
    held.to = time;
    this.ended.push(held);
  }

  private forget(before: number): void {
    if (this.ended.length > maxEnded || (this.ended[0]?.to ?? before) < before) {
      this.ended = this.ended.slice(-maxEnded).filter((one) => one.to >= before);
    }
    this.spans = this.spans.slice(-maxSpans).filter((span) => span.to >= before);
  }
}
