// The streams of geminga-web. They are open while the page is seen, since a browser gives all pages of one site six connections.
import type { Change } from './answers.js';
import type { Kind, Team } from './team.js';

/** The silence after which a stream that was opened has told all that is there, in milliseconds. */
const settled = 700;
const retry = 2000;

export interface Watcher {
  changed(kind: Kind): void;
  /** The daemon, or geminga-web, is away, and why; an empty reason: all is well. */
  absent(reason: string): void;
}

export class Live {
  private readonly streams = new Map<Kind, EventSource>();
  private readonly absences = new Map<Kind, string>();

  constructor(
    private readonly team: Team,
    private readonly watcher: Watcher,
  ) {
    document.addEventListener('visibilitychange', () => this.look());
    this.look();
  }

  private look(): void {
    for (const kind of ['participants', 'services', 'requests'] as const) {
      if (document.hidden) {
        this.streams.get(kind)?.close();
        this.streams.delete(kind);
      } else if (!this.streams.has(kind)) {
        this.open(kind);
      }
    }
  }

  private open(kind: Kind): void {
    const stream = new EventSource(`/api/events?of=${kind}`);
    this.streams.set(kind, stream);
    let settling: number | undefined;
    let isUp = true;
    const isCurrent = () => this.streams.get(kind) === stream;
    const settle = () => {
      clearTimeout(settling);
      settling = window.setTimeout(() => {
        if (!isCurrent() || !isUp) return;
        this.team.settle(kind, Date.now());
        this.watcher.changed(kind);
      }, settled);
    };
    stream.onopen = () => {
      this.say(kind, '');
      this.team.beAbsent(Date.now(), '');
      isUp = true;
      this.team.begin(kind);
      settle();
    };
    stream.onmessage = (message: MessageEvent<string>) => {
      this.team.take(kind, JSON.parse(message.data) as Change & Record<string, unknown>);
      settle();
      this.watcher.changed(kind);
    };
    stream.addEventListener('daemon', (message: MessageEvent<string>) => {
      const { up, reason } = JSON.parse(message.data) as { up: boolean; reason?: string };
      isUp = up;
      this.say(kind, up ? '' : `The daemon is away: ${reason ?? 'it does not answer'}`);
      this.team.beAbsent(Date.now(), up ? '' : (reason ?? 'it did not answer'));
      if (up) settle();
    });
    stream.onerror = () => {
      if (!isCurrent()) return;
      isUp = false;
      this.say(kind, 'geminga-web does not answer');
      this.team.beAbsent(Date.now(), 'geminga-web did not answer');
      stream.close();
      this.streams.delete(kind);
      setTimeout(() => this.look(), retry);
    };
  }

  private say(kind: Kind, reason: string): void {
    this.absences.set(kind, reason);
    this.watcher.absent([...this.absences.values()].find((text) => text !== '') ?? '');
  }
}
