// The session of a node over all its connections to a daemon: it states requests again, and matches answers to statements.
import { readChannelKeys } from './channel_keys.js';
import { ClosedError, GemingaError, RefusedError } from './errors.js';
import { isEvent, readEvent } from './event.js';
import { lifeOf } from './life.js';
import { canonicalRequest } from './request.js';
import { decodeLine, formatStatement, formatValue, parseStatement } from './statement.js';

const identityKeys = new Set(['id', 'text', 'concept', 'representation']);

/** The parameters of a request after a change. A given value takes the place of the former one; an empty one takes a key back. */
export function merged(parameters, change) {
  const given = new Map(change);
  const isSemantic = given.has('concept') || given.has('representation');
  const isIdentity = isSemantic || given.has('id') || given.has('text');
  const kept = parameters.filter(([key]) => {
    if (given.has(key)) return false;
    if (!isIdentity || !identityKeys.has(key)) return true;
    return isSemantic && (key === 'concept' || key === 'representation');
  });
  const isAttribute = (key) => !canBeEmptied.has(key);
  return [...kept, ...change.filter(([key, value]) => value !== '' || isAttribute(key))];
}
const canBeEmptied =
  new Set(['representation', 'address', 'provider', 'scope', 'favour', 'prefer', 'rank', 'where', 'for', 'protocol', 'on']);

/** One publication or subscription. `parameters` are those that are stated again to the next daemon. */
class Request {
  constructor(id, command, parameters, { onEvent, onProblem, onKeys }) {
    this.id = id;
    this.command = command;
    this.parameters = parameters;
    this.onEvent = onEvent;
    this.onProblem = onProblem;
    this.onKeys = onKeys;
    /** Whether the daemon has refused it or taken it back; then it is not stated again. */
    this.isRefused = false;
    this.isHeld = false;
    this.waiters = [];
    this.changes = [];
  }
}

/** The mode of sealing that the answer to a hello tells; `plain` where the daemon has no keys. */
export const sealingOf = (hello) => (hello.keys === 'yes' && hello.sealing) || 'plain';

/** The mode and the identity of a request, by which a person knows it. */
const shown = ({ parameters }) =>
  parameters.filter(([key]) => key === 'mode' || identityKeys.has(key)).map(([key, value]) => `${key}=${formatValue(value)}`).join(' ');

/**
 * Hooks: `write(line)`, `onConnected(hello)`, `onSealing(mode)`, `onProblem(error)`, `log(line)`. The owner calls `start` and
 * `lose` for connections, and `receive` for each line without its end.
 */
export class Session {
  #hooks;
  #name;
  #requests = new Map();
  #answers = [];
  #nextId = 1;
  #isUp = false;
  /** Lines that could not be read or had no meaning here. */
  dropped = 0;

  constructor(name, hooks) {
    this.#name = name;
    this.#hooks = hooks;
  }

  /** A connection is open: says hello and states all requests. */
  start() {
    this.#isUp = true;
    const name = this.#name === undefined ? [] : [['name', this.#name]];
    this.#write(0, 'sys', 'hello', [...name, ['keys', 'yes']]);
    for (const request of this.#requests.values()) {
      if (request.isRefused) continue;
      this.#state(request);
      for (const change of request.changes) this.#stateChange(request, change);
    }
  }

  /** The connection is lost. Requests and changes without an answer are stated again to the next daemon. */
  lose() {
    this.#isUp = false;
    const answers = this.#answers;
    this.#answers = [];
    for (const { lost } of answers) lost?.();
  }

  /**
   * States a publication ('pub') or subscription ('sub'). Gives `{request, taken}`: the promise is fulfilled when a daemon has
   * accepted it. Hooks: `onEvent(event)`, `onProblem(error)`, and `onKeys(life, keys, error)`, where `keys` is undefined if they
   * cannot be used. Throws StatementError.
   */
  create(command, parameters, hooks) {
    const statement = canonicalRequest({ id: this.#nextId, command, subcommand: 'create', parameters });
    const request = new Request(this.#nextId++, command, statement.parameters, hooks);
    this.#requests.set(request.id, request);
    const taken = new Promise((resolve, reject) => request.waiters.push({ resolve, reject }));
    if (this.#isUp) this.#state(request);
    return { request, taken };
  }

  /** Changes a request. The promise is fulfilled when the daemon has accepted the change. Throws StatementError. */
  modify(request, parameters) {
    const { id, command } = request;
    const statement = canonicalRequest({ id, command, subcommand: 'modify', parameters });
    if (request.isRefused) throw new RefusedError(404, 'the request was refused or taken back');
    return new Promise((resolve, reject) => {
      const change = { parameters: statement.parameters, resolve, reject };
      request.changes.push(change);
      if (this.#isUp) this.#stateChange(request, change);
    });
  }

  /** Withdraws a request. The promise is fulfilled when the daemon has handled that, or is gone. */
  remove(request) {
    if (!this.#requests.delete(request.id)) return Promise.resolve();
    const closed = new ClosedError(request.command === 'pub' ? 'publisher' : 'subscriber');
    for (const waiter of [...request.waiters.splice(0), ...request.changes.splice(0)]) waiter.reject(closed);
    if (!this.#isUp || request.isRefused) return Promise.resolve();
    return new Promise((resolve) => {
      this.#write(request.id, request.command, 'remove', []);
      this.#expect({ request, done: resolve, lost: resolve });
    });
  }

  bye() {
    if (this.#isUp) this.#write(0, 'sys', 'bye', []);
  }

  /** Takes one line of the daemon, its octets without the end. */
  receive(octets) {
    try {
      const statement = parseStatement(decodeLine(octets));
      if (statement.code !== undefined) this.#onError(statement);
      else if (isEvent(statement)) this.#onEvent(readEvent(statement));
      else if (statement.command === 'pub' && statement.subcommand === 'keys') this.#onKeys(statement);
      else if (statement.command === 'msg') this.#onMessage(statement);
      else ++this.dropped;
    } catch (error) {
      if (error.code !== 'GEMINGA_STATEMENT') throw error;
      ++this.dropped;
    }
  }

  #write(id, command, subcommand, parameters) {
    this.#hooks.write(formatStatement({ id, command, subcommand, parameters }));
  }

  /** Sends a ping after a statement. The daemon answers the statement before the pong, if at all. */
  #expect(answer) {
    this.#answers.push(answer);
    this.#write(0, 'sys', 'ping', []);
  }

  #state(request) {
    this.#write(request.id, request.command, 'create', request.parameters);
    this.#expect({
      request,
      done: (error) => {
        if (error?.status === 503) return;
        if (error) {
          this.#refuse(request, error);
          return;
        }
        request.isHeld = true;
        for (const { resolve } of request.waiters.splice(0)) resolve();
      },
    });
  }

  #stateChange(request, change) {
    this.#write(request.id, request.command, 'modify', change.parameters);
    this.#expect({
      request,
      done: (error) => {
        if (error?.status === 503 || !request.changes.includes(change)) return;
        request.changes.splice(request.changes.indexOf(change), 1);
        if (error) {
          this.#hooks.log(`the request ${shown(request)} is refused: ${error.message}`);
          change.reject(error);
          return;
        }
        request.parameters = canonicalRequest({
          id: request.id,
          command: request.command,
          subcommand: 'create',
          parameters: merged(request.parameters, change.parameters),
        }).parameters;
        change.resolve();
      },
    });
  }

  /** The daemon has refused this request or taken it back. */
  #refuse(request, error) {
    const wasAwaited = request.waiters.length > 0;
    request.isRefused = true;
    request.isHeld = false;
    this.#hooks.log(`the request ${shown(request)} is refused: ${error.message}`);
    for (const waiter of [...request.waiters.splice(0), ...request.changes.splice(0)]) waiter.reject(error);
    if (!wasAwaited) request.onProblem(error);
  }

  #onError({ id, code, text }) {
    const error = new RefusedError(code, text);
    const [next] = this.#answers;
    const request = this.#requests.get(id);
    if (request && next?.request === request && !next.error) {
      next.error = error;
    } else if (request && !request.isRefused && code !== 503) {
      this.#refuse(request, error);
    } else if (id === 0) {
      this.#hooks.onProblem(error);
    }
  }

  #onMessage({ id, subcommand, parameters }) {
    if (id !== 0) return;
    if (subcommand === 'hello') {
      const hello = Object.fromEntries(parameters.map(([key, value]) => [key, value ?? '']));
      this.#hooks.onConnected(hello);
    } else if (subcommand === 'sealing') {
      this.#hooks.onSealing(new Map(parameters).get('mode') || 'plain');
    } else if (subcommand === 'pong') {
      const answer = this.#answers.shift();
      answer?.done(answer.error);
    }
  }

  /** Keys go to the owner of the request, and nowhere else. */
  #onKeys(statement) {
    const request = this.#requests.get(statement.id);
    if (!request) return;
    try {
      const { life, keys } = readChannelKeys(statement);
      request.onKeys(life, keys);
    } catch (error) {
      if (!(error instanceof GemingaError)) throw error;
      request.onKeys(lifeOf(new Map(statement.parameters).get('life')), undefined, error);
    }
  }

  #onEvent(event) {
    const request = this.#requests.get(event.id);
    // Events of a subscription are about publications, and the other way round.
    if (request && request.command !== event.command) request.onEvent(event);
    else ++this.dropped;
  }
}
