// The agent of JavaScript: does what it is told on standard input and says what happened (tests/client/conformance/AGENT.md).
import { createInterface } from 'node:readline';
import { setTimeout as wait } from 'node:timers/promises';

import { shownAttribute } from '../../../src/client/javascript/lib/core/attribute.js';
import { eventStatement, isEvent, readEvent } from '../../../src/client/javascript/lib/core/event.js';
import { frameOfDatagram, kinds } from '../../../src/client/javascript/lib/core/frame.js';
import { canonicalRequest } from '../../../src/client/javascript/lib/core/request.js';
import { formatStatement, parseStatement } from '../../../src/client/javascript/lib/core/statement.js';
import { identity, lifeText, Node } from '../../../src/client/javascript/lib/index.js';

const say = (...words) => process.stdout.write(`${words.join(' ')}\n`);
const hex = (octets) => Buffer.from(octets).toString('hex');
const services = new Map();
const conversions = new Map();

const node = new Node({ name: process.argv[2] });
node.on('connected', () => say('connected'));
node.on('disconnected', () => say('disconnected'));
node.on('problem', (error) => say('problem', '-', error.message));

/** Options of `mode=oto text=x port=5 rate=30`. */
function optionsOf(command, text) {
  const options = { attributes: {} };
  for (const [key, value] of parseStatement(`1 ${command} create ${text}`).parameters) {
    const name = key === 'for' ? undefined : shownAttribute(key);
    if (name !== undefined) options.attributes[name] = value ?? '';
    else if (key === 'port') options.port = Number(value);
    else if (key === 'protocol' && command === 'sub') options.protocol = value.split(',');
    else options[key] = value;
  }
  return options;
}

/** Shows messages until it is closed; while it is deaf it takes none. */
async function read(label, service) {
  for (;;) {
    await service.gate;
    let message;
    try {
      service.pause = new AbortController();
      message = await service.subscriber.receive({ signal: service.pause.signal });
    } catch (error) {
      if (error.name === 'AbortError') continue;
      return;
    }
    if (!message) return;
    if (service.isQuiet) continue;
    const { payload, life, sequence, missed } = message;
    say('message', label, lifeText(life), sequence, missed, payload.length, hex(payload.subarray(0, 32)));
  }
}

function watch(label, service, event) {
  service.on(event, ({ change, life, reason }) => say(event, label, change, lifeText(life), reason || '-'));
  service.on('problem', (error) => say('problem', label, error.message));
}

async function stream(label, count, size, milliseconds) {
  const { publisher } = services.get(label);
  const begin = performance.now();
  for (let i = 1; i <= count; ++i) {
    const payload = Buffer.alloc(Math.max(size, 8));
    payload.writeBigUInt64BE(BigInt(i));
    const isPrompt = publisher.send(payload.subarray(0, size));
    const due = begin + i * milliseconds - performance.now();
    if (!isPrompt) await publisher.drained();
    if (milliseconds > 0 && due > 0) await wait(due);
    else if (milliseconds === 0 && i % 64 === 0) await wait(0);
  }
  say('streamed', label);
}

function words(text) {
  return [...text.matchAll(/"((?:[^"\\]|\\.)*)"|([^ ]+)/g)].map(([, quoted, bare]) =>
    quoted === undefined ? bare : parseStatement(`1 a b c="${quoted}"`).parameters[0][1]);
}

function lineAgain(text) {
  try {
    const statement = parseStatement(text);
    if (statement.code !== undefined || statement.command === 'msg') return formatStatement(statement);
    return formatStatement(isEvent(statement) ? eventStatement(readEvent(statement)) : canonicalRequest(statement));
  } catch {
    return 'refused';
  }
}

const doings = {
  async pub(label, text) {
    try {
      const publisher = await node.publish(optionsOf('pub', text));
      services.set(label, { publisher });
      say('ok', label);
      watch(label, publisher, 'consumer');
    } catch (error) {
      say('error', label, error.message);
    }
  },
  async sub(label, text) {
    try {
      const subscriber = node.subscribe({ ...optionsOf('sub', text), conversions: conversions.get(label) });
      const service = { subscriber, gate: undefined, isQuiet: false };
      services.set(label, service);
      watch(label, subscriber, 'provider');
      read(label, service);
      await subscriber.ready();
      say('ok', label);
    } catch (error) {
      say('error', label, error.message);
    }
  },
  convert(label, text) {
    const [from, to, octets] = text.split(' ');
    if (!conversions.has(label)) conversions.set(label, new Map());
    const head = Buffer.from(octets ?? '', 'hex');
    conversions.get(label).set(`${from}>${to}`, (payload) => Buffer.concat([head, payload]));
  },
  async modify(label, text) {
    const { publisher, subscriber } = services.get(label);
    const { attributes, ...options } = optionsOf(publisher ? 'pub' : 'sub', text);
    try {
      await (publisher ?? subscriber).modify({ ...options, attributes });
    } catch (error) {
      say('error', label, error.message);
    }
  },
  send(label, text = '') {
    try {
      services.get(label).publisher.send(Buffer.from(text, 'hex'));
    } catch (error) {
      say('error', label, error.message);
    }
  },
  stream: (label, text) => stream(label, ...text.split(' ').map(Number)),
  count(label) {
    const { publisher, subscriber } = services.get(label);
    const counts = (publisher ?? subscriber).statistics;
    if (publisher) say('count', label, `sent=${counts.sent}`, `left_out=${counts.leftOut}`, `dropped=${counts.dropped}`);
    else say('count', label, `received=${counts.received}`, `missed=${counts.missed}`, `dropped=${counts.dropped}`);
  },
  quiet(label) {
    services.get(label).isQuiet = true;
  },
  deaf(label) {
    const service = services.get(label);
    if (service.gate) return;
    service.gate = new Promise((resolve) => {
      service.open = resolve;
    });
    service.pause?.abort();
  },
  reading(label) {
    const service = services.get(label);
    service.gate = undefined;
    service.open?.();
  },
  async close(label) {
    const service = services.get(label);
    await (service.publisher ?? service.subscriber).close();
    services.delete(label);
    say('closed', label);
  },
  identity(kind, text) {
    const [value, representation] = words(text);
    const key = kind === 'number' ? 'id' : kind;
    say('identity', identity({ [key]: kind === 'number' ? Number(value) : value, representation }));
  },
  frame(octets = '') {
    const frame = frameOfDatagram(Buffer.from(octets, 'hex'));
    if (!frame) {
      say('frame refused');
      return;
    }
    const kind = Object.keys(kinds).find((name) => kinds[name] === frame.kind);
    say('frame', kind, lifeText(frame.life), frame.sequence, hex(frame.payload));
  },
  line: (first = '', rest) => say('line', lineAgain(rest === undefined ? first : `${first} ${rest}`)),
};

async function quit() {
  await node.close();
  process.exit(0);
}

const input = createInterface({ input: process.stdin });
input.on('line', async (line) => {
  const [, word, label, rest] = /^([^ ]*)(?: ([^ ]*)(?: (.*))?)?$/.exec(line) ?? [];
  if (word === 'quit') {
    quit();
    return;
  }
  if (!Object.hasOwn(doings, word)) return;
  try {
    await doings[word](label, rest);
  } catch (error) {
    say('problem', label, error.message);
  }
});
input.once('close', quit);
