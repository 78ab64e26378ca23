// Limits of channels and of GCNP, and the times that channels keep (src/client/CHANNELS.md, src/discovery/gcnp/GCNP.md).

/** Octets of a message over UDP. */
export const maxDatagramMessage = 65_000;
/** Octets of a message over TCP. */
export const maxStreamMessage = 16 * 1024 * 1024;
/** Octets that may wait for one TCP consumer; one message may always wait. */
export const maxWaiting = 4 * 1024 * 1024;
/** Frames that may wait for it. */
export const maxWaitingFrames = 16_384;
/** Waiting octets from which on `send` gives false: wait for `drained`. */
export const enoughWaiting = 1024 * 1024;
/** The same of frames. */
export const enoughWaitingFrames = 4096;
/** Octets of datagrams that the system has not taken yet. */
export const maxWaitingDatagrams = 4 * 1024 * 1024;
/** Listeners of one `otm/stream` over UDP. */
export const maxListeners = 1024;
/** TCP connections of one publisher that have not become a consumer's. */
export const maxStrangers = 64;
/** TCP consumers of a publisher. */
export const maxConsumers = 256;
/** Octets that may wait for all TCP consumers of a publisher, each frame counted once. */
export const maxWaitingForAll = 64 * 1024 * 1024;
/** Providers over TCP of a subscriber. */
export const maxTcpProviders = 256;
/** Floors and fulls of a publisher that answer datagrams: at once, and in a second. */
export const maxAnswers = 512;
/** The greatest step of the sequence that is believed without a key. */
export const maxStep = 65_536;
/** Runs of delivered sequences that are remembered of a life. */
export const maxRanges = 256;
/** Keys of one channel, and lives of which a subscriber keeps the keys beside those of its providers. */
export const maxKeysOfRing = 64;
export const maxKeptKeys = 1024;
/** Messages of one subscriber that wait to be received, unless its `queue` says otherwise. */
export const queueLength = 1024;
/** Octets of their payloads; one message may always wait. */
export const maxQueuedOctets = 16 * 1024 * 1024;
/** Early frames of one subscriber. */
export const maxEarlyFrames = 64;
/** Octets of their payloads. */
export const maxEarlyOctets = 256 * 1024;
/** Lives of which a subscriber remembers the last sequence. */
export const maxRemembered = 1024;
/** Network interfaces on which a multicast publisher sends. */
export const maxInterfaces = 8;

/** Milliseconds without a daemon that are said. */
export const awayPatience = 1000;
/** Milliseconds that a daemon has to answer the hello. */
export const answerPatience = 5000;
/** Milliseconds until a hello that is not accepted is said again; twice as many each time. */
export const firstHello = 20;
/** Milliseconds after which a publisher makes other cookies. Those of the time before are accepted, too. */
export const cookiePatience = 8000;
/** Milliseconds without a message after which a straggler is believed that a lower one came before. */
export const stragglerPatience = 2000;
/** Milliseconds that an end without a key is remembered, and that a match lasts after an end until its consumer connects again. */
export const endHintPatience = 10_000;
/** Milliseconds that a provider without a connection keeps its place from others. */
export const unconnectedPatience = 5000;
/** Milliseconds that an early frame is kept. */
export const earlyPatience = 1000;
/** Milliseconds between two hellos to an `otm/stream` over UDP. */
export const helloInterval = 1000;
/** Milliseconds between two looks at the interfaces of a group. */
export const interfaceInterval = 2000;
/** Milliseconds without a hello after which a listener is forgotten. */
export const listenerPatience = 3000;
/** Milliseconds until a consumer is asked again for a sealed hello. */
export const askInterval = 500;
/** Milliseconds that a TCP connection has to become a consumer's, and a consumer for a sealed hello where plain ones are taken no more. */
export const strangerPatience = 5000;
/** Milliseconds that a subscriber waits for more of a provider that was withdrawn over TCP. */
export const endPatience = 2000;
/** Milliseconds of the same wait over UDP, where messages are here already and only the end can be lost. */
export const datagramEndPatience = 200;
/** Milliseconds that a channel over UDP goes on after the daemons have lost sight of its other end. */
export const orphanPatience = 10_000;
/** Milliseconds that a daemon that is back has to confirm a channel. */
export const confirmPatience = 10_000;
/** Milliseconds that `close` waits for a consumer that takes nothing. */
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
