// Alerts of the rules of `geminga-web --rules`: findings of the present, and marks in the lane of alerts.
import type { Alert } from './alerts.js';
import { ask, type RuleState } from './answers.js';
import { counted } from './dom.js';
import { hour } from './team.js';
import { spanWords, teamNow } from './time.js';
import type { Finding } from './wrong.js';

/** The pause between two readings while the page is seen, in milliseconds. An answer is at hand in geminga-web, and empty without rules. */
const each = 2000;
/** The most marks that are kept. The eldest give way. */
const maxMarks = 1000;

export class Rules {
  /** Beginnings and ends of alerts that this page has read, in the order of reading. */
  readonly marks: Alert[] = [];
  private states: RuleState[] = [];
  /** The words of the alerts that are raised, by rule. */
  private readonly raised = new Map<string, string>();
  private timer: number | undefined;

  /** `then` is called after each reading that tells of rules. */
  constructor(private readonly then: () => void) {
    document.addEventListener('visibilitychange', () => this.wake());
    this.wake();
  }

  /** Without a daemon nothing is counted, which is told once and above all: `isThere` is false then, and no rule tells it again. */
  findings(isThere: boolean): Finding[] {
    return this.states.flatMap((one): Finding[] => {
      const about = { key: `alert ${one.alert}`, places: [] };
      const problem = isThere ? one.problem : undefined;
      if (one.state === 'raised' || one.state === 'waits') {
        const isRaised = one.state === 'raised';
        return [{ ...about, level: isRaised ? 'error' : 'warning',
          title: `Alert ${one.alert}${isRaised ? '' : ' waits'}: ${countWords(one)}; wrong for ${spanWords(one.seconds ?? 0)}${isRaised ? '' : ` of ${spanWords(one.for)}`}`,
          text: `It counts ${one.of}. What this host does not know of counts as not there.${problem === undefined ? '' : `\nThis is the last count, since there is none at present: ${problem}`}`,
          seen: `a rule of geminga-web --rules, by which it is told after ${spanWords(one.for)}` }];
      }
      if (problem === undefined) return [];
      return [{ ...about, level: 'warning', title: `Alert ${one.alert} is not counted`, text: problem }];
    });
  }

  private wake(): void {
    clearTimeout(this.timer);
    if (!document.hidden) void this.read();
  }

  private async read(): Promise<void> {
    clearTimeout(this.timer);
    try {
      this.take(await ask<RuleState[]>('alerts'));
    } catch {
      // The last reading stays, as all that the page knew does: the stream says that geminga-web is away.
    }
    if (!document.hidden) this.timer = window.setTimeout(() => void this.read(), each);
  }

  private take(states: RuleState[]): void {
    const now = teamNow();
    for (const one of states) {
      const words = this.raised.get(one.alert);
      if (one.state === 'raised' && words === undefined) {
        const text = `${one.alert}: ${countWords(one)} (${one.of})`;
        this.raised.set(one.alert, text);
        this.marks.push({ time: now - (one.seconds ?? 0) * 1000, isMended: false, text });
      } else if (one.state === 'holds' && words !== undefined) {
        this.raised.delete(one.alert);
        this.marks.push({ time: now, isMended: true, text: words });
      }
    }
    while (this.marks.length > maxMarks || (this.marks[0]?.time ?? now) < now - hour) this.marks.shift();
    const isTold = states.length > 0 || this.states.length > 0;
    this.states = states;
    if (isTold) this.then();
  }
}

/** The last count, and what it should be: `0 services, wanted at least 1`. */
const countWords = (one: RuleState): string => `${counted(one.count ?? 0, one.counted === 'services' ? 'service' : 'participant')}, wanted ${wantedWords(one)}`;

function wantedWords({ at_least, at_most }: RuleState): string {
  if (at_most === undefined) return `at least ${at_least}`;
  if (at_most === 0) return 'none';
  return at_least === 0 ? `at most ${at_most}` : `${at_least} to ${at_most}`;
}
