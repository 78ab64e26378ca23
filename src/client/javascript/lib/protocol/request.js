// The statements of a client: their keys in the order in which they are written, and the keys that are required.
import { attributeName, inOrder, statedKey } from './attribute.js';
import { StatementError } from './errors.js';
import { flags, readers } from './key.js';
import * as limits from './limits.js';
import { parseStatement } from './statement.js';

const identityKeys = ['id', 'text', 'concept', 'representation'];
const wishes = ['match', 'provider', 'where', 'protocol', 'favour', 'prefer', 'rank', 'scope', 'convert', 'limit'];
const filters = [...identityKeys, 'mode', 'provider', 'filter'];
const offerKeys = [...identityKeys, 'mode', 'port', 'address', 'protocol', 'priority', 'provider', 'scope', 'for'];
const defaults = { match: 'narrower', degree: 'narrower', priority: '0', convert: 'no', unused: '0', unmatched: '0' };

/**
 * By command and subcommand: the keys in the order in which they are written, those that are required ("identity" is one of
 * the identity keys), whether attributes are allowed, and whether values equal to their defaults are kept.
 */
const kinds = Object.freeze({
  'sys hello': { keys: ['name', 'room'], keepsAll: true },
  'sys ping': { keys: [] },
  'sys bye': { keys: [] },
  'pub create': {
    keys: ['mode', ...identityKeys, 'port', 'address', 'protocol', 'priority', 'scope', 'for'],
    required: ['mode', 'identity', 'port'],
    attributes: true,
    defaults: { ...defaults, protocol: 'udp' },
  },
  'pub modify': {
    keys: [...identityKeys, 'mode', 'address', 'port', 'priority', 'protocol', 'scope', 'for'],
    attributes: true,
    keepsAll: true,
  },
  'pub remove': { keys: [] },
  'sub create': {
    keys: ['mode', ...identityKeys, ...wishes, 'priority', 'port', 'address'],
    required: ['mode', 'identity'],
    attributes: true,
  },
  'sub modify': {
    keys: [...identityKeys, 'mode', 'address', 'port', 'priority', ...wishes],
    attributes: true,
    keepsAll: true,
  },
  'sub remove': { keys: [] },
  'query participants': { keys: [] },
  'query services': { keys: [...filters, 'unused'] },
  'query requests': { keys: [...filters, 'unmatched', 'unused'] },
  'query match': {
    keys: [...identityKeys, 'degree', 'mode', 'provider', 'where', 'limit', 'convert'],
    defaults: { ...defaults, limit: '0' },
  },
  'query explain': { keys: ['sub', 'super'], required: ['sub', 'super'] },
  'query why': { keys: ['subscription', ...identityKeys, 'mode', ...wishes, 'service'] },
  'query ontology': { keys: [] },
  'query status': { keys: [] },
  'query interfaces': { keys: [] },
  'query peers': { keys: [] },
  'query security': { keys: [] },
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

/** Reads parameters by a kind. Gives the values by key, the attributes, and the parameters that are left for the caller. */
function readKeys(kind, parameters, { isPub, behind = () => false }) {
  const values = new Map();
  const attributes = Object.create(null);
  const rest = [];
  for (const [key, given] of parameters) {
    if (kind.keys.includes(key)) {
      if (values.has(key)) throw new StatementError(`${key} is given twice: give each key once`);
      if (given === undefined && !flags.has(key)) {
        throw new StatementError(`${key} has no value: write ${key}=VALUE`);
      }
      const read = isPub && key === 'protocol' ? readers['protocol:pub'] : readers[key];
      values.set(key, read(given ?? '1', key));
    } else if (behind(key)) {
      rest.push([key, given]);
    } else if (kind.attributes) {
      const name = attributeName(key, kind.keys);
      if (name in attributes) throw new StatementError(`${key} is given twice, with and without its prefix`);
      attributes[name] = given ?? '';
    } else {
      throw new StatementError(`${key} is no key here`);
    }
  }
  checkAttributes(attributes);
  return { values, attributes, rest };
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

/** Reads the keys behind `offer.`, which describe a possible offer. */
function readOffer(parameters) {
  const kind = { keys: offerKeys, attributes: true, required: ['identity'], defaults: { ...defaults, protocol: 'udp' } };
  const inner = parameters.map(([key, value]) => [key.slice('offer.'.length), value]);
  if (inner.some(([key]) => key === '')) throw new StatementError('a key is missing behind offer.');
  const { values, attributes } = readKeys(kind, inner, { isPub: true });
  checkRequired(kind, values);
  if (values.get('provider')?.includes(',')) throw new StatementError('provider: one service has one provider');
  const own = [...written(kind, values), ...inOrder(attributes).map(([name, value]) => [statedKey(name), value])];
  return own.map(([key, value]) => [`offer.${key}`, value]);
}

function readWhy(parameters) {
  const kind = kinds['query why'];
  const behind = (key) => key.startsWith('offer.') || key.startsWith('attr.');
  const { values, rest } = readKeys(kind, parameters, { behind });
  const offered = rest.filter(([key]) => key.startsWith('offer.'));
  const attributes = rest.filter(([key]) => key.startsWith('attr.')).map(([key, value]) => [key, value ?? '']);
  const isAsked = checkIdentity(values, false);
  const isOfferAlone = attributes.length === 0 &&
    (values.has('service') ? values.size === 1 : values.size === 0 && offered.length > 0);
  const isBeside = values.size > 1 + Number(values.has('service')) || attributes.length > 0;
  if (values.has('subscription') ? isBeside : !isAsked && !isOfferAlone) {
    throw new StatementError('say subscription=PARTICIPANT/PEER/NUMBER, or what might be asked for as in sub create');
  }
  if (values.has('service') && offered.length > 0) throw new StatementError('service and offer. together');
  const asked = written(kind, values);
  const service = asked.filter(([key]) => key === 'service');
  attributes.sort(([a], [b]) => Buffer.compare(Buffer.from(a), Buffer.from(b)));
  return [...asked.filter(([key]) => key !== 'service'), ...attributes, ...service,
    ...(offered.length > 0 ? readOffer(offered) : [])];
}

/** A client's statement in its canonical form. Throws StatementError if the daemon would refuse it unread. */
export function canonicalRequest(statement) {
  const { id, command, subcommand } = statement;
  try {
    const kind = Object.hasOwn(kinds, `${command} ${subcommand}`) ? kinds[`${command} ${subcommand}`] : undefined;
    if (!kind) throw new StatementError(`no statement ${command} ${subcommand}`);
    if ((command === 'sys') !== (id === 0)) throw new StatementError('the id 0 belongs to sys');
    if (subcommand === 'why') return { id, command, subcommand, parameters: readWhy(statement.parameters) };
    const { values, attributes } = readKeys(kind, statement.parameters, { isPub: command === 'pub' });
    checkRequired(kind, values);
    if (values.get('unused') === '1' && values.get('unmatched') === '1') {
      throw new StatementError('unmatched and unused together: ask for one of them');
    }
    const own = inOrder(attributes).map(([name, value]) => [statedKey(name), value]);
    return { id, command, subcommand, parameters: [...written(kind, values), ...own] };
  } catch (error) {
    if (error instanceof StatementError) error.id = id;
    throw error;
  }
}

/** The canonical statement of a client's line. Throws StatementError with the id and status of the daemon's answer. */
export function parseRequest(line) {
  const statement = parseStatement(line);
  if (statement.code !== undefined) throw new StatementError('an error, which only the daemon states', 400, statement.id);
  return canonicalRequest(statement);
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
