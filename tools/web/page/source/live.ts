// The stream of geminga-web. It is open while the page is seen, since a browser gives all pages of one site six connections.
import type { Change } from './answers.js';
import { kinds, type Kind, type Team } from './team.js';
import { takeTime, teamNow } from './time.js';

const retry = 2000;

export interface Watcher {
  changed(kind: Kind): void;
  /** The daemon, or geminga-web, is away, and why; an empty reason: all is well. */
  absent(reason: string): void;
  /** Nobody looks at the page from here on. */
  asleep(): void;
  /** The page is looked at again, after it was not since that instant. The stream is opened when this is done. */
  awake(since: number): Promise<void>;
}

export class Live {
  private stream: EventSource | undefined;
  private hiddenSince: number | undefined;

  constructor(
    private readonly team: Team,
    private readonly watcher: Watcher,
  ) {
    document.addEventListener('visibilitychange', () => void this.look());
    void this.look();
  }

  private async look(): Promise<void> {
    if (document.hidden) {
      this.stream?.close();
      this.stream = undefined;
      this.hiddenSince ??= teamNow();
      return this.watcher.asleep();
    }
    if (this.hiddenSince !== undefined) {
      const since = this.hiddenSince;
      this.hiddenSince = undefined;
      await this.watcher.awake(since);
    }
    // While that was waited for, the page may have been left again, or another call have opened it.
    if (!document.hidden) this.stream ??= this.open();
  }

  private open(): EventSource {
    const stream = new EventSource(`api/events?of=${kinds.join()}`);
    stream.onopen = () => {
      this.team.begin();
      this.say('');
    };
    for (const kind of kinds) {
      stream.addEventListener(kind, (message: MessageEvent<string>) => {
        const change = JSON.parse(message.data) as Change & Record<string, unknown>;
        takeTime(Date.parse(change.time));
        this.team.take(kind, change);
        this.watcher.changed(kind);
      });
    }
    stream.addEventListener('whole', () => {
      this.team.settle(teamNow());
      for (const kind of kinds) this.watcher.changed(kind);
    });
    stream.addEventListener('daemon', (message: MessageEvent<string>) => {
      const { up, reason } = JSON.parse(message.data) as { up: boolean; reason?: string };
      const why = reason ?? 'it does not answer';
      this.say(up ? '' : `The daemon is away: ${why}`, up ? '' : why);
    });
    stream.onerror = () => {
      if (this.stream !== stream) return;
      stream.close();
      this.stream = undefined;
      this.say('geminga-web does not answer');
      setTimeout(() => void this.look(), retry);
    };
    return stream;
  }

  private say(words: string, reason = words): void {
    this.team.beAbsent(teamNow(), reason);
    this.watcher.absent(words);
  }
}
