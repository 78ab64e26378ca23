// The functions that turn one representation into another, and the chain of them that a match needs.

const isConversion = /^(<[^<>]+>|[^<>]+)>(<[^<>]+>|[^<>]+)$/;

/** The names of `A>B>C`; one that is an IRI stands in angle brackets. */
function namesOf(chain) {
  return chain.match(/<[^<>]*>|[^<>]+/g) ?? [];
}

/** Who does a step, counted from 0, by the words of `via`; undefined: the consumer. */
function serviceOf(via, step) {
  const word = (via ?? '').split(',')[step];
  return word && word !== '-' ? word : undefined;
}

/** Names as `A>B`, each with a function from a payload to a payload. */
export class Converter {
  #functions = new Map();

  constructor(functions = {}) {
    for (const [name, convert] of functions instanceof Map ? functions : Object.entries(functions)) this.set(name, convert);
  }

  set(name, convert) {
    if (!isConversion.test(name)) throw new TypeError(`no conversion: '${name}'; write 'A>B'`);
    if (typeof convert !== 'function') throw new TypeError(`the conversion ${name} is no function`);
    this.#functions.set(name, convert);
  }

  /**
   * What turns a payload along `A>B>C`: the function of `A>C` where there is one, else those of `A>B` and `B>C`. It throws a
   * ConversionFailure that names the conversion that is missing, and who of `via` would do it, or that threw.
   */
  along(chain, via) {
    const names = namesOf(chain);
    const direct = `${names[0]}>${names.at(-1)}`;
    const parts = this.#functions.has(direct)
      ? [direct]
      : names.slice(1).map((name, i) => `${names[i]}>${name}`);
    return (payload) => parts.reduce((octets, step, i) => this.#apply(step, octets, serviceOf(via, i)), payload);
  }

  #apply(step, payload, service) {
    const convert = this.#functions.get(step);
    if (!convert) {
      const by = service ? `, which the service ${service} does` : '';
      throw new ConversionFailure(`there is no function for the conversion ${step}${by}`);
    }
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
