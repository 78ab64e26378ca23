// Geminga for Node: say what you offer or want in one line, and then send and receive.
export { connect, Node } from './node.js';
export { Publisher } from './publisher.js';
export { Subscriber } from './subscriber.js';
export * from './protocol/errors.js';
export { identity } from './protocol/identity.js';
export { lifeText } from './protocol/life.js';
export * as limits from './protocol/limits.js';
