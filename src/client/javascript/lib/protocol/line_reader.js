// Lines put together from the octets of a stream.
import { maxLine } from './limits.js';

/** Lines end in LF or CR LF. Keeps at most one unfinished line. */
export class LineReader {
  #rest = [];
  #restLength = 0;

  /** Whether the unfinished line is longer than GCNP allows: what says so long a line is no daemon. */
  get isBroken() {
    return this.#restLength > maxLine + 1;
  }

  /** The lines that are whole now, without their ends. */
  *feed(octets) {
    let begin = 0;
    for (let end = octets.indexOf(10); end >= 0; end = octets.indexOf(10, begin)) {
      let line = octets.subarray(begin, end);
      begin = end + 1;
      if (this.#restLength > 0) {
        line = Buffer.concat([...this.#rest, line]);
        this.#rest = [];
        this.#restLength = 0;
      }
      yield line.at(-1) === 13 ? line.subarray(0, -1) : line;
    }
    if (begin === octets.length) return;
    this.#rest.push(octets.subarray(begin));
    this.#restLength += octets.length - begin;
  }
}
