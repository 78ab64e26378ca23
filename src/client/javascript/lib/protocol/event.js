// Events of the daemon about the other side of a publication or subscription, read from their lines.
import { shownAttribute } from './attribute.js';
import { StatementError } from './errors.js';
import { modes, readNumber } from './key.js';

/** Keys beside `convert`, and otherwise names of attributes. */
const ofChain = ['cost', 'via'];
/** The way to the other side's host: `path` is a key beside `hops`, and otherwise the name of an attribute. */
const ofWay = ['hops', 'path', 'reachable'];
const degrees = ['exact', 'equivalent', 'narrower', 'converted', 'broader', 'overlapping'];
const changes = ['add', 'modify', 'del'];

/** By command: the keys of the other side and of its peer, all keys, and the required ones. */
const shapes = Object.freeze({
  pub: {
    service: 'service',
    peer: 'provider',
    keys: ['service', 'provider', 'name', 'id', 'text', 'concept', 'representation', 'degree', 'distance', 'mode', 'address',
      'port', 'protocol', 'priority', 'participant_name', 'convert', 'cost', 'via', ...ofWay],
    required: ['service', 'provider', 'degree', 'mode', 'port', 'protocol'],
  },
  sub: {
    service: 'subscription',
    peer: 'consumer',
    keys: ['subscription', 'consumer', 'name', 'id', 'text', 'concept', 'representation', 'degree', 'distance', 'mode',
      'address', 'port', 'priority', 'participant_name', ...ofWay],
    required: ['subscription', 'consumer', 'degree', 'mode'],
  },
});

const fail = (id, text) => {
  throw new StatementError(text, 400, id);
};

function numberOf(id, values, key, most) {
  const value = values.get(key);
  if (value === undefined) return undefined;
  return readNumber(value, most) ?? fail(id, `${key}=${value} is no number`);
}

/** Whether a statement is an event. */
export const isEvent = ({ command, subcommand }) => Object.hasOwn(shapes, command ?? '') && changes.includes(subcommand);

/**
 * The event of a statement: `id`, `change`, `command`, `service` (the word of the other side's service or subscription),
 * `peer`, `name`, `identity`, `degree`, `distance`, `mode`, `address`, `port`, `protocol`, `priority`, `participantName`,
 * `convert`, `cost`, `via`, `hops`, `path`, `reachable`, `attributes`; of a `del` only the first four and `reason`. Throws StatementError.
 */
export function readEvent({ id, command, subcommand, parameters }) {
  const shape = shapes[command];
  const values = new Map();
  const attributes = Object.create(null);
  const isRelayed = parameters.some(([key]) => key === 'hops');
  const isConverted = parameters.some(([key]) => key === 'convert');
  for (const [key, value = ''] of parameters) {
    const isKey = shape.keys.includes(key) && (isConverted || !ofChain.includes(key)) && (isRelayed || key !== 'path');
    if (isKey || key === 'reason') {
      if (values.has(key)) fail(id, `${key} is given twice`);
      values.set(key, value);
    } else {
      const name = shownAttribute(key);
      if (name !== undefined && name !== '') attributes[name] = value;
    }
  }
  const service = values.get(shape.service) ?? fail(id, `${shape.service} is missing`);
  if (subcommand === 'del') return { id, command, change: 'del', service, reason: values.get('reason') ?? '' };
  for (const key of shape.required) if (!values.has(key)) fail(id, `${key} is missing`);
  if (!degrees.includes(values.get('degree'))) fail(id, 'no degree');
  if (!modes.includes(values.get('mode'))) fail(id, 'no mode');
  const identity = {};
  if (values.has('id')) identity.id = numberOf(id, values, 'id', 0xffffffff);
  for (const key of ['text', 'concept', 'representation']) if (values.has(key)) identity[key] = values.get(key);
  return {
    id,
    command,
    change: subcommand,
    service,
    peer: values.get(shape.peer),
    name: values.get('name'),
    identity,
    degree: values.get('degree'),
    distance: numberOf(id, values, 'distance', 0xffffffff) ?? 0,
    mode: values.get('mode'),
    address: values.get('address') || undefined,
    port: numberOf(id, values, 'port', 65535) || undefined,
    protocol: values.get('protocol'),
    priority: Number(values.get('priority') ?? 0),
    participantName: values.get('participant_name'),
    convert: values.get('convert') || undefined,
    cost: numberOf(id, values, 'cost', 0xffffffff),
    via: values.get('via') || undefined,
    hops: numberOf(id, values, 'hops', 0xffffffff) ?? 0,
    path: values.get('path') || undefined,
    reachable: values.get('reachable') !== 'no',
    attributes,
  };
}
