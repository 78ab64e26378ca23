// Geminga for Node: services of a robot team are offered and asked for, and messages sent and received.
export { connect, Node } from './node.js';
export { Publisher } from './publisher.js';
export { Subscriber } from './subscriber.js';
export * from './protocol/errors.js';
export { identity } from './protocol/identity.js';
export { lifeText } from './protocol/life.js';
export * as limits from './protocol/limits.js';
