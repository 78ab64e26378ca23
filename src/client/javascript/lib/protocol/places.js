// Places that are limited, and shared by address where all are taken (src/client/CHANNELS.md, "Places").

/** So many places. A holder is any object or word, an address is a text without the port. */
export class Places {
  #count;
  /** By holder: its address. In the order in which places were taken. */
  #held = new Map();
  /** By address: its holders with the number of each place. */
  #byAddress = new Map();
  #served = new Set();
  #last = 0;

  constructor(count) {
    this.#count = count;
  }

  get count() {
    return this.#count;
  }

  get size() {
    return this.#held.size;
  }

  /** Whether all places are taken. */
  get isFull() {
    return this.#held.size >= this.#count;
  }

  /** Whether three quarters of the places are taken at most. */
  get hasRoomAgain() {
    return 4 * this.#held.size <= 3 * this.#count;
  }

  has(holder) {
    return this.#held.has(holder);
  }

  /** The holders, in the order in which they took their places. */
  [Symbol.iterator]() {
    return this.#held.keys();
  }

  /** A newcomer: `{isTaken, loser}`, whether it gets a place, and the holder that loses its own for it. */
  take(holder, address) {
    let loser;
    if (this.isFull) {
      loser = this.#loser(address);
      if (loser === undefined) return { isTaken: false, loser };
      this.leave(loser);
    }
    this.#held.set(holder, address);
    if (!this.#byAddress.has(address)) this.#byAddress.set(address, new Map());
    this.#byAddress.get(address).set(holder, ++this.#last);
    return { isTaken: true, loser };
  }

  /** Gives a place back, if it was held. */
  leave(holder) {
    const address = this.#held.get(holder);
    if (address === undefined) return;
    this.#held.delete(holder);
    this.#served.delete(holder);
    const ofAddress = this.#byAddress.get(address);
    ofAddress.delete(holder);
    if (ofAddress.size === 0) this.#byAddress.delete(address);
  }

  /** A provider has delivered a message. */
  serve(holder) {
    if (this.#held.has(holder)) this.#served.add(holder);
  }

  /** The newest place of the address that holds most, if that holds two more than the newcomer's; one not served first. */
  #loser(address) {
    let most;
    for (const ofAddress of this.#byAddress.values()) {
      const newest = Math.max(...ofAddress.values());
      if (!most || ofAddress.size > most.size || (ofAddress.size === most.size && newest > most.newest)) {
        most = { size: ofAddress.size, newest, ofAddress };
      }
    }
    if ((this.#byAddress.get(address)?.size ?? 0) + 2 > (most?.size ?? 0)) return undefined;
    const holders = [...most.ofAddress];
    const free = holders.filter(([holder]) => !this.#served.has(holder));
    return (free.length > 0 ? free : holders).reduce((a, b) => (a[1] > b[1] ? a : b))[0];
  }
}
