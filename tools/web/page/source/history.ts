// The hour that geminga-web has kept, for a page that is opened now.
import type { Change, Participant, Request, Service } from './answers.js';
import type { Kind } from './team.js';

export interface History {
  /** Where it begins; null: geminga-web keeps nothing, or has not reached the daemon yet. */
  begin: string | null;
  before: { absence?: string; participants?: Participant[]; services?: Service[]; requests?: Request[] };
  changes: { of: Kind | 'daemon'; event: Change['event']; time: string; reason: string; record: Participant | Service | Request | null }[];
  /** Time, services, requests, requests without a service, worst and mean loss, datagrams heard since the daemon started. */
  samples: [string, number, number, number, number, number, number][];
  /** The name of the recording that this is the whole of, and where it ends. */
  recording?: string;
  end?: string;
}

const none: History = { begin: null, before: {}, changes: [], samples: [] };

/** The history, or an empty one where it cannot be had. */
export async function askHistory(): Promise<History> {
  try {
    const response = await fetch('api/history', { cache: 'no-store' });
    return response.ok ? { ...none, ...((await response.json()) as Partial<History>) } : none;
  } catch {
    return none;
  }
}
