// A peer and a problem as the application sees them.
import { lifeText } from './frame.js';

/** What the daemon told of a provider or consumer. */
export function describe(peer) {
  const { id, change, command, peer: who, attributes, ...event } = peer.event;
  const { channel, ...own } = attributes;
  return Object.freeze({ life: peer.life, peer: who, ...event, attributes: Object.freeze({ ...own }) });
}

/** The payload of the events `provider` and `consumer`. */
export const changeOf = (change, peer, reason) => Object.freeze({ change, reason, ...describe(peer) });

/** A life as text, for people and logs. */
export { lifeText };
