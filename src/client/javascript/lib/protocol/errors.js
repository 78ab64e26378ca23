// Errors of this library: each kind is a class with a `code`.

/** The base of all errors of this library. */
export class GemingaError extends Error {
  constructor(message, code, options) {
    super(message, options);
    this.name = new.target.name;
    this.code = code;
  }
}

/** The daemon refused a request, or took it back. `status` is GCNP's code: 400, 404, 409, 413, 422, 429. */
export class RefusedError extends GemingaError {
  constructor(status, text) {
    super(text, 'GEMINGA_REFUSED');
    this.status = status;
  }
}

/** A statement that GCNP does not have, found before the daemon is asked. `status` is the code that the daemon would give. */
export class StatementError extends GemingaError {
  constructor(message, status = 400, id = 0) {
    super(message, 'GEMINGA_STATEMENT');
    this.status = status;
    this.id = id;
  }
}

/** A message is longer than its protocol allows. */
export class MessageTooLargeError extends GemingaError {
  constructor(size, limit, hint) {
    super(`a message of ${size} octets: at most ${limit} ${hint}`, 'GEMINGA_MESSAGE_TOO_LARGE');
    this.size = size;
    this.limit = limit;
  }
}

/** A stated port is taken, or may not be used. */
export class PortError extends GemingaError {
  constructor(port, cause) {
    super(`port ${port} cannot be used: ${cause.message}`, 'GEMINGA_PORT', { cause });
    this.port = port;
  }
}

/** Publisher, subscriber or node has been closed. */
export class ClosedError extends GemingaError {
  constructor(what, why) {
    super(`the ${what} is closed${why ? `: ${why}` : ''}`, 'GEMINGA_CLOSED');
  }
}

/** The AbortSignal of a call was aborted. Its name is AbortError, as everywhere in Node. */
export class AbortError extends Error {
  constructor(signal) {
    super('The operation was aborted', { cause: signal?.reason });
    this.name = 'AbortError';
    this.code = 'ABORT_ERR';
  }
}
