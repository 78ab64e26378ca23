// Every size that has a limit, with its name (src/client/CHANNELS.md, src/discovery/gcnp/GCNP.md).

/** Octets of a message over UDP. */
export const maxDatagramMessage = 65_000;
/** Octets of a message over TCP. */
export const maxStreamMessage = 16 * 1024 * 1024;
/** Octets that may wait for one TCP consumer; one message may always wait. */
export const maxWaiting = 4 * 1024 * 1024;
/** From so many waiting octets on, `send` says false: wait for `drained`. */
export const enoughWaiting = 1024 * 1024;
/** Octets of datagrams that the system has not taken yet. */
export const maxWaitingDatagrams = 4 * 1024 * 1024;
/** Listeners of one `otm/stream` over UDP. */
export const maxListeners = 64;
/** TCP connections of a publisher that have not said whose they are. */
export const maxStrangers = 16;
/** TCP consumers of a publisher. */
export const maxConsumers = 256;
/** Messages that wait for the application, of a subscriber, unless its `queue` says otherwise. */
export const queueLength = 1024;
/** Octets that wait for the application, of a subscriber; one message may always wait. */
export const maxQueuedOctets = 16 * 1024 * 1024;
/** Frames over UDP of one subscriber that are of nobody whom it knows yet. */
export const maxEarlyFrames = 64;
/** Octets of payload of these. */
export const maxEarlyOctets = 256 * 1024;
/** Lives of which a subscriber remembers the last sequence. */
export const maxRemembered = 1024;
/** Network interfaces on which a multicast publisher sends. */
export const maxInterfaces = 8;

/** Milliseconds for which an early frame is kept. */
export const earlyPatience = 1000;
/** Milliseconds between two hellos to an `otm/stream` over UDP. */
export const helloInterval = 1000;
/** Milliseconds after which a group's interfaces are looked at again. */
export const interfaceInterval = 2000;
/** Milliseconds after which a listener that says no hello is forgotten. */
export const listenerPatience = 3000;
/** Milliseconds that a TCP connection has to say whose it is, and to meet its `sub add`. */
export const strangerPatience = 5000;
/** Milliseconds for which a withdrawn provider's stream is read while nothing comes. */
export const endPatience = 2000;
/** The same over UDP, where what was sent is here already and only the end can be lost. */
export const datagramEndPatience = 200;
/** Milliseconds for which a channel over UDP goes on that no daemon sees any more. */
export const orphanPatience = 10_000;
/** Milliseconds after which the daemon that is back has confirmed what it will confirm. */
export const confirmPatience = 10_000;
/** Milliseconds that `close` waits for consumers that take nothing. */
export const closePatience = 5000;

/** GCNP: octets of a line, parameters of a statement. */
export const maxLine = 65_536;
export const maxParameters = 256;
export const maxName = 64;
export const maxText = 255;
export const maxConcept = 1024;
export const maxProtocol = 32;
export const maxProtocols = 8;
export const maxProviders = 16;
export const maxAttributes = 32;
export const maxAttributeName = 64;
export const maxAttributeValue = 255;
export const maxScope = 200;
export const maxCondition = 400;
export const maxPrefer = 200;
export const maxRank = 64;
export const maxFilter = 256;
