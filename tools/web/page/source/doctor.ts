// Findings of geminga-web's doctor about this host, its daemon and the link, beside what the page sees of the team by itself.
import { ask, type Diagnosis, type Participant } from './answers.js';
import type { Finding } from './wrong.js';

/** An examination takes some intervals, so that there is one in so many milliseconds while the page is seen. */
const each = 60_000;
/** The codes of what the page sees by itself, and at once. */
const seenHere = new Set(['daemon_away', 'daemon_silent', 'deaf_to_us', 'loss_high', 'key_lacking', 'ontologies_differ', 'ontology_failed', 'ontology_contradiction', 'unmatched']);

export class Doctor {
  private diagnoses: Diagnosis[] = [];
  private timer: number | undefined;

  /** `then` is called after each examination. */
  constructor(private readonly then: () => void) {
    document.addEventListener('visibilitychange', () => this.wake());
    this.wake();
  }

  findings(participants: Map<string, Participant>): Finding[] {
    return this.diagnoses.filter((one) => !seenHere.has(one.code)).map((one) => ({
      key: `doctor ${one.code} ${one.what}`,
      level: one.severity === 'failure' ? 'error' : 'warning',
      title: one.what, text: one.remedy, seen: one.seen, ...(one.command === '' ? {} : { command: one.command }),
      // It names a participant with its identifier: `robot3 (1a2b3c4d)`.
      places: [...participants.keys()].filter((id) => one.what.includes(`(${id})`)),
    }));
  }

  private wake(): void {
    clearTimeout(this.timer);
    if (!document.hidden) void this.examine();
  }

  private async examine(): Promise<void> {
    clearTimeout(this.timer);
    try {
      this.diagnoses = (await ask<{ findings: Diagnosis[] }>('doctor')).findings;
    } catch {
      this.diagnoses = []; // without a daemon there is one finding, which stands above all
    }
    this.then();
    if (!document.hidden) this.timer = window.setTimeout(() => void this.examine(), each);
  }
}
