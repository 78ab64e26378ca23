// The functions that turn one representation into another, and the chain of them that a match needs.

/** Names as `A>B`, each with a function from a payload to a payload. */
export class Conversions {
  #functions = new Map();

  constructor(functions = {}) {
    for (const [name, convert] of functions instanceof Map ? functions : Object.entries(functions)) this.set(name, convert);
  }

  set(name, convert) {
    if (!/^[^>]+>[^>]+$/.test(name)) throw new TypeError(`no conversion: '${name}'; write 'A>B'`);
    if (typeof convert !== 'function') throw new TypeError(`the conversion ${name} is no function`);
    this.#functions.set(name, convert);
  }

  /**
   * What turns a payload along `A>B>C`: the function of `A>C` where there is one, else those of `A>B` and `B>C`. It throws a
   * ConversionFailure that names the conversion that is missing or threw.
   */
  along(chain) {
    const names = chain.split('>');
    const direct = `${names[0]}>${names.at(-1)}`;
    const steps = this.#functions.has(direct)
      ? [direct]
      : names.slice(1).map((name, i) => `${names[i]}>${name}`);
    return (payload) => steps.reduce((octets, step) => this.#apply(step, octets), payload);
  }

  #apply(step, payload) {
    const convert = this.#functions.get(step);
    if (!convert) throw new ConversionFailure(`no conversion for ${step}`);
    let converted;
    try {
      converted = convert(payload);
    } catch (error) {
      throw new ConversionFailure(`the conversion ${step} failed: ${error?.message ?? error}`, { cause: error });
    }
    if (converted instanceof Uint8Array) return converted;
    throw new ConversionFailure(`the conversion ${step} gave no Uint8Array`);
  }
}

export class ConversionFailure extends Error {}
