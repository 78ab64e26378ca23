// The application's conversions, applied along the chain of a match (src/discovery/matching/conversions/CONVERSIONS.md).

const isConversion = /^(<[^<>]+>|[^<>]+)>(<[^<>]+>|[^<>]+)$/;

/** The names of `A>B>C`. An IRI stands in angle brackets. */
function namesOf(chain) {
  return chain.match(/<[^<>]*>|[^<>]+/g) ?? [];
}

/** The service that does a step, counted from 0, by the words of `via`; undefined if the consumer does it. */
function serviceOf(via, step) {
  const word = (via ?? '').split(',')[step];
  return word && word !== '-' ? word : undefined;
}

/** Functions from a payload to a payload, by names such as `A>B`. */
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
   * The function that converts a payload along `A>B>C`: by the function of `A>C` if there is one, else by those of `A>B` and
   * `B>C`. It throws a ConversionFailure that names the conversion without a function, with the service of `via` that does
   * it, or the one that threw.
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
