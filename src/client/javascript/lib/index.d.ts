/** The identity of a service: a number, a text, or a concept of the ontology with or without a representation. */
export type Identity =
  | { id: number; text?: undefined; concept?: undefined; representation?: undefined }
  | { text: string; id?: undefined; concept?: undefined; representation?: undefined }
  | { concept: string; representation?: string; id?: undefined; text?: undefined };

/** `oto`: one to one. `otm/stream`: one to many, consumers only listen. `otm/pubsub`: one to many, open while somebody asks. */
export type Mode = 'oto' | 'otm/stream' | 'otm/pubsub';
export type Degree = 'exact' | 'equivalent' | 'narrower' | 'converted' | 'broader' | 'overlapping';
export type Protocol = 'udp' | 'tcp';
export type AttributeValue = string | number | boolean;

/** A signal that ends the wait of a call, which then rejects with an AbortError. */
export interface Abortable {
  signal?: AbortSignal;
}

export interface PublicationStatement {
  priority?: number;
  /** The hosts on which consumers may be (src/discovery/matching/conditions/SCOPE.md). */
  scope?: string;
  /** A condition over the consumer (src/discovery/matching/conditions/WHERE.md). */
  for?: string;
  attributes?: Record<string, AttributeValue>;
}

export interface SubscriptionStatement {
  match?: Exclude<Degree, 'converted'>;
  /** `PARTICIPANT[/PEER]`, each by id or name. */
  provider?: string | readonly string[];
  /** Providers that come first, written as in `provider`. */
  favour?: string | readonly string[];
  prefer?: string;
  rank?: string | readonly string[];
  scope?: string;
  /** A class or a class expression that must describe the provider's robot. */
  on?: string;
  where?: string;
  /** Whether representations may be converted, or the largest cost of that. */
  convert?: boolean | 'yes' | 'no' | number;
  /** `any`: also services whose address cannot be reached from this host; `routed` by default. */
  reach?: 'routed' | 'any';
  /** The largest number of providers, the best ones; 0: all. */
  limit?: number;
  priority?: number;
  attributes?: Record<string, AttributeValue>;
}

export type PublishOptions = Identity & PublicationStatement & Abortable & {
  mode: Mode;
  /** `udp` by default. Messages over 65 000 octets need `tcp`. */
  protocol?: Protocol;
  /** Any by default. */
  port?: number;
  /** An IP address in numbers; of `otm/stream` over UDP it may be a group's. */
  address?: string;
};

export type SubscribeOptions = Identity & SubscriptionStatement & Abortable & {
  mode: Mode;
  /** Both by default. */
  protocol?: Protocol | readonly Protocol[];
  port?: number;
  address?: string;
  /** The number of messages that may wait, 1024 by default: see `Subscriber`. */
  queue?: number;
  /** Functions by `A>B`, which turn a payload of representation A into one of B. */
  conversions?: Record<string, Conversion> | ReadonlyMap<string, Conversion>;
};

export type Conversion = (payload: Uint8Array) => Uint8Array;

/** A provider or consumer, in the words of the daemon. */
export interface Peer {
  /** 64 random bits; 0n if no library with channels made it. */
  readonly life: bigint;
  /** `PARTICIPANT/PEER`. */
  readonly peer: string;
  /** `PARTICIPANT/PEER/NUMBER`. */
  readonly service: string;
  readonly name?: string;
  readonly participantName?: string;
  readonly identity: { readonly id?: number; readonly text?: string; readonly concept?: string; readonly representation?: string };
  readonly degree: Degree;
  readonly distance: number;
  readonly mode: Mode;
  readonly address?: string;
  readonly port?: number;
  readonly protocol?: string;
  readonly priority: number;
  readonly convert?: string;
  readonly cost?: number;
  /** The service of each conversion, with commas: `udp://ADDRESS:PORT/SERVICE`, or `-` for the consumer. */
  readonly via?: string;
  /** The number of relays on the way to its host; 0: it is heard directly. */
  readonly hops: number;
  /** The names of those that are known, joined by `/`, the nearest to its host first. */
  readonly path?: string;
  /** False: its address cannot be reached from this host, as far as that is certain. */
  readonly reachable: boolean;
  readonly attributes: Readonly<Record<string, string>>;
}

/** A change of a provider or consumer. The `reason` of a removal: withdrawn, expired, left, outranked, changed, unreachable, disconnected, lost, refused, slow; there may be more. */
export type PeerChange = Peer & { readonly change: 'added' | 'modified' | 'removed'; readonly reason?: string };

export interface Message {
  readonly payload: Uint8Array;
  readonly life: bigint;
  readonly sequence: bigint;
  /** The messages of this life that did not come, or were lost in a full inbox, between the one before and this one. */
  readonly missed: number;
  readonly provider: Peer;
}

/** The part of Node's EventEmitter for the events of `Events`. */
export interface Emitter<Events extends { [name: string]: unknown[] }> {
  on<Name extends keyof Events>(name: Name, listener: (...values: Events[Name]) => void): this;
  once<Name extends keyof Events>(name: Name, listener: (...values: Events[Name]) => void): this;
  off<Name extends keyof Events>(name: Name, listener: (...values: Events[Name]) => void): this;
}

/** A service that is offered. Made by `node.publish`. */
export interface Publisher extends Emitter<{ consumer: [PeerChange]; problem: [Error]; close: [] }> {
  readonly life: bigint;
  readonly port: number;
  readonly consumers: Peer[];
  readonly hasConsumer: boolean;
  /** `leftOut`: the messages without room, counted for each consumer. */
  readonly statistics: { sent: number; leftOut: number; dropped: number };
  /**
   * Sends to all consumers; without one it does nothing. False: better wait for `drained` before the next. Throws
   * MessageTooLargeError (65 000 octets over UDP, 16 MiB over TCP) and ClosedError. The payload may be used again at once.
   */
  send(payload: Uint8Array): boolean;
  /** Fulfilled when nothing waits for any consumer. */
  drained(options?: Abortable): Promise<void>;
  /** Changes options. Fulfilled when the daemon has accepted the change. */
  modify(options: Partial<Identity> & PublicationStatement & Abortable): Promise<void>;
  /** Withdraws the service. Messages that wait are sent first. */
  close(): Promise<void>;
}
export declare const Publisher: { readonly prototype: Publisher };

/**
 * A request for services, with a channel. Made by `node.subscribe`; an async iterable, and leaving its loop closes it.
 *
 * Slow consumers: up to `queue` messages wait, together at most 16 MiB, but always one. Over UDP the eldest message that waits
 * is lost for a new one; over TCP the provider is held back, and leaves out messages when 4 MiB wait for this consumer.
 * `missed` of the next message tells how many were lost.
 */
export interface Subscriber
  extends Emitter<{ provider: [PeerChange]; problem: [Error]; close: [] }>, AsyncIterable<Message> {
  readonly life: bigint;
  /** The UDP port where it listens, if it has one. */
  readonly port?: number;
  readonly providers: Peer[];
  /**
   * `missed`: known to be missing; `overflowed`: those of them that came and were lost in a full inbox; `dropped`: not believed
   * or not converted.
   */
  readonly statistics: { received: number; missed: number; dropped: number; overflowed: number };
  /** Fulfilled when the daemon has accepted the request. Rejects with RefusedError. */
  ready(options?: Abortable): Promise<this>;
  /** The next message; undefined when the subscriber is closed. */
  receive(options?: Abortable): Promise<Message | undefined>;
  /** Adds a function for the conversion `A>B`. */
  convert(name: string, convert: Conversion): void;
  modify(options: Partial<Identity> & SubscriptionStatement & Abortable): Promise<void>;
  close(): Promise<void>;
}
export declare const Subscriber: { readonly prototype: Subscriber };

export interface NodeOptions {
  /** The name that the team sees. */
  name?: string;
  /** `ADDRESS:PORT`, `[ADDRESS]:PORT`, `/PATH` or `unix:PATH`; else GEMINGA_CONNECT, else 127.0.0.1:4717 and [::1]:4717. */
  daemon?: string;
  /** Takes a line for each cause that a person should know of; else lines go to standard error, with `geminga: ` before them. */
  log?: (line: string) => void;
}

/**
 * This program as a peer of its daemon. It finds the daemon whenever it comes, states everything again, and keeps its
 * channels meanwhile.
 */
export declare class Node {
  constructor(options?: NodeOptions);
  readonly isConnected: boolean;
  /** The daemon's answer to the hello: `participant`, `peer`, `participant_name`, `ontology`, ... */
  readonly hello?: Readonly<Record<string, string>>;
  /** Fulfilled when the daemon is there. */
  connected(options?: Abortable): Promise<this>;
  /** Fulfilled when the daemon has accepted the service. Rejects with RefusedError, StatementError and PortError. */
  publish(options: PublishOptions): Promise<Publisher>;
  /** Throws StatementError and PortError. `signal` closes the subscriber. */
  subscribe(options: SubscribeOptions): Subscriber;
  /** Withdraws everything, cleanly. */
  close(): Promise<void>;
  /** Lets the program end although the node is open. */
  unref(): this;
  ref(): this;
}
export interface Node extends Emitter<{
  connected: [Readonly<Record<string, string>>];
  disconnected: [];
  problem: [Error];
  close: [];
}> {}

/** A node that is connected to its daemon. `new Node()` does not wait for the daemon. */
export declare function connect(options?: NodeOptions & Abortable): Promise<Node>;

/** The 32-bit form of an identity (src/identity/IDENTITY.md). Concepts and representations are full IRIs. */
export declare function identity(
  of: Identity | { expression: string; representation?: string },
): number;

/** A life as sixteen hexadecimal digits. */
export declare function lifeText(life: bigint): string;

/** The named limits: maxDatagramMessage, maxStreamMessage, maxWaiting, queueLength, ... */
export declare const limits: Readonly<Record<string, number>>;

export declare class GemingaError extends Error {
  readonly code: string;
}
/** The daemon has refused a request, or taken it back. `status` is GCNP's code. */
export declare class RefusedError extends GemingaError {
  readonly status: number;
}
/** GCNP has no such statement. */
export declare class StatementError extends GemingaError {
  readonly status: number;
}
export declare class MessageTooLargeError extends GemingaError {
  readonly size: number;
  readonly limit: number;
}
/** A stated port is taken, or may not be used. */
export declare class PortError extends GemingaError {
  readonly port: number;
}
export declare class ClosedError extends GemingaError {}
export declare class AbortError extends Error {
  readonly code: 'ABORT_ERR';
}
