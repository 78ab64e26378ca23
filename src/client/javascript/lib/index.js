// Geminga for Node: say what you offer or want in one line, and then send and receive.
export { connect, Node } from './node.js';
export { Publisher } from './publisher/publisher.js';
export { Subscriber } from './subscriber/subscriber.js';
export * from './core/errors.js';
export { identity } from './core/identity.js';
export { lifeText } from './core/frame.js';
export * as limits from './core/limits.js';
