// The keys of publications and subscriptions, in the order in which they are written, and those that are required.
import { attributeName, inOrder, statedKey } from './attribute.js';
import { StatementError } from './errors.js';
import { readers } from './key.js';
import * as limits from './limits.js';

const identityKeys = ['id', 'text', 'concept', 'representation'];
const wishes = ['match', 'provider', 'where', 'protocol', 'favour', 'prefer', 'rank', 'scope', 'convert', 'on', 'reach', 'limit'];
const defaults = { match: 'narrower', priority: '0', convert: 'no', reach: 'routed' };

/**
 * By command and subcommand: the keys in the order in which they are written, those that are required ("identity" is one of
 * the identity keys), and whether values equal to their defaults are kept.
 */
const kinds = Object.freeze({
  'pub create': {
    keys: ['mode', ...identityKeys, 'port', 'address', 'protocol', 'priority', 'scope', 'for'],
    required: ['mode', 'identity', 'port'],
    defaults: { ...defaults, protocol: 'udp' },
  },
  'pub modify': {
    keys: [...identityKeys, 'mode', 'address', 'port', 'priority', 'protocol', 'scope', 'for'],
    keepsAll: true,
  },
  'sub create': {
    keys: ['mode', ...identityKeys, ...wishes, 'priority', 'port', 'address'],
    required: ['mode', 'identity'],
  },
  'sub modify': {
    keys: [...identityKeys, 'mode', 'address', 'port', 'priority', ...wishes],
    keepsAll: true,
  },
});

function checkIdentity(values, isChange) {
  const isSemantic = values.has('concept') || values.has('representation');
  if (Number(values.has('id')) + Number(values.has('text')) + Number(isSemantic) > 1) {
    throw new StatementError('two identities: give one of id=N, text=NAME, and concept=C with representation=R');
  }
  if (!isChange && values.has('representation') && !values.has('concept')) {
    throw new StatementError('concept is missing: a representation belongs to a concept');
  }
  return values.has('id') || values.has('text') || values.has('concept');
}

function checkAttributes(attributes) {
  const entries = Object.entries(attributes);
  if (entries.length > limits.maxAttributes) {
    throw new StatementError(`too many attributes: at most ${limits.maxAttributes}`, 413);
  }
  for (const [name, value] of entries) {
    if (Buffer.byteLength(name) > limits.maxAttributeName || Buffer.byteLength(value) > limits.maxAttributeValue) {
      throw new StatementError(`attribute ${name} is too long: at most ${limits.maxAttributeName} octets of name ` +
          `and ${limits.maxAttributeValue} of value`, 413);
    }
  }
}

/** Reads parameters by a kind. Gives the values by key, and the attributes. */
function readKeys(kind, parameters, isPub) {
  const values = new Map();
  const attributes = Object.create(null);
  for (const [key, given] of parameters) {
    if (kind.keys.includes(key)) {
      if (values.has(key)) throw new StatementError(`${key} is given twice: give each key once`);
      if (given === undefined) throw new StatementError(`${key} has no value: write ${key}=VALUE`);
      const read = isPub && key === 'protocol' ? readers['protocol:pub'] : readers[key];
      values.set(key, read(given, key));
    } else {
      const name = attributeName(key, kind.keys);
      if (name in attributes) throw new StatementError(`${key} is given twice, with and without its prefix`);
      attributes[name] = given ?? '';
    }
  }
  checkAttributes(attributes);
  return { values, attributes };
}

function checkRequired(kind, values) {
  const hasIdentity = checkIdentity(values, kind.keepsAll === true);
  for (const key of kind.required ?? []) {
    if (key === 'identity' ? !hasIdentity : !values.has(key)) throw new StatementError(`${key} is missing`);
  }
}

function written(kind, values) {
  const usual = kind.defaults ?? defaults;
  return kind.keys
    .filter((key) => values.has(key))
    .map((key) => [key, values.get(key)])
    .filter(([key, value]) => kind.keepsAll || (value !== '' && usual[key] !== value));
}

/** A client's statement in its canonical form. Throws StatementError if the daemon would refuse it unread. */
export function canonicalRequest(statement) {
  const { id, command, subcommand } = statement;
  try {
    const kind = Object.hasOwn(kinds, `${command} ${subcommand}`) ? kinds[`${command} ${subcommand}`] : undefined;
    if (!kind) throw new StatementError(`no statement ${command} ${subcommand}`);
    if (id === 0) throw new StatementError('the id 0 belongs to sys');
    const { values, attributes } = readKeys(kind, statement.parameters, command === 'pub');
    checkRequired(kind, values);
    const own = inOrder(attributes).map(([name, value]) => [statedKey(name), value]);
    return { id, command, subcommand, parameters: [...written(kind, values), ...own] };
  } catch (error) {
    if (error instanceof StatementError) error.id = id;
    throw error;
  }
}

const asText = (value) => (Array.isArray(value) ? value.join(',') : value === true ? 'yes' : value === false ? 'no' : String(value));

/** The parameters of `{mode: 'oto', text: 'x', attributes: {rate: 30}}`. Keys that GCNP does not have are errors. */
export function parametersOf(options, command) {
  const keys = kinds[`${command} modify`].keys;
  const parameters = [];
  for (const [key, value] of Object.entries(options)) {
    if (value === undefined || key === 'attributes') continue;
    if (!keys.includes(key)) throw new StatementError(`${key} is no option; an attribute stands in attributes: {${key}: ...}`);
    parameters.push([key, asText(value)]);
  }
  for (const [name, value] of Object.entries(options.attributes ?? {})) {
    parameters.push([statedKey(name), value === true ? '' : String(value)]);
  }
  return parameters;
}

/** A port as the user states it; 0 and undefined are any. */
export function portOf(port = 0) {
  if (Number.isInteger(port) && port >= 0 && port <= 65535) return port;
  throw new StatementError(`port=${port}: a port is a number from 0 to 65535, where 0 is any`);
}

/** Throws StatementError for options that cannot change while a channel is open. */
export function checkFixed(options, keys) {
  for (const key of keys) {
    if (options[key] !== undefined) throw new StatementError(`${key} cannot be changed: close it and make another one`);
  }
  if (options.attributes?.channel !== undefined) throw new StatementError('channel is stated by the library');
}
