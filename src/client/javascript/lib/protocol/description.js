// A counterpart as the application sees it.
/** The facts about a provider or consumer, as the application sees them. */
export function describe(counterpart) {
  const { id, change, command, peer, attributes, ...event } = counterpart.event;
  const { channel, ...own } = attributes;
  return Object.freeze({ life: counterpart.life, peer, ...event, attributes: Object.freeze({ ...own }) });
}

/** The payload of the events `provider` and `consumer`. */
export const changeOf = (change, counterpart, reason) => Object.freeze({ change, reason, ...describe(counterpart) });
