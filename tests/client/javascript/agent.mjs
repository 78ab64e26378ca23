// The agent of JavaScript: does what it is told on standard input and says what happened (tests/client/conformance/AGENT.md).
import { createInterface } from 'node:readline';
import { setTimeout as wait } from 'node:timers/promises';

import { shownAttribute } from '../../../src/client/javascript/lib/protocol/attribute.js';
import { frameOfDatagram, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { formatStatement, parseStatement } from '../../../src/client/javascript/lib/protocol/statement.js';
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

/** Reports what happens to a service, but only after its ok. Returns the function that says this ok. */
function watch(label, service, event) {
  let early = [];
  const tell = (...words) => (early ? early.push(words) : say(...words));
  service.on(event, ({ change, life, reason }) => tell(event, label, change, lifeText(life), reason || '-'));
  service.on('problem', (error) => tell('problem', label, error.message));
  return () => {
    say('ok', label);
    for (const words of early) say(...words);
    early = undefined;
  };
}

async function stream(label, count, size, milliseconds) {
  const { publisher } = services.get(label);
  const begin = performance.now();
  for (let i = 1; i <= count; ++i) {
    const payload = Buffer.alloc(Math.max(size, 8));
    payload.writeBigUInt64BE(BigInt(i));
    const isPrompt = publisher.send(payload.subarray(0, size));
    const due = begin + i * milliseconds - performance.now();
    if (milliseconds > 0) await wait(Math.max(due, 0));
    else if (!isPrompt) await publisher.drained();
    else if (i % 64 === 0) await wait(0);
  }
  say('streamed', label);
}

function lineAgain(text) {
  try {
    return formatStatement(parseStatement(text));
  } catch {
    return 'refused';
  }
}

const doings = {
  async pub(label, text) {
    try {
      const publisher = await node.publish(optionsOf('pub', text));
      services.set(label, { publisher });
      watch(label, publisher, 'consumer')();
    } catch (error) {
      say('error', label, error.message);
    }
  },
  async sub(label, text) {
    try {
      const subscriber = node.subscribe({ ...optionsOf('sub', text), conversions: conversions.get(label) });
      const service = { subscriber, gate: undefined, isQuiet: false };
      services.set(label, service);
      const sayOk = watch(label, subscriber, 'provider');
      await subscriber.ready();
      sayOk();
      read(label, service);
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
    await (publisher ?? subscriber).modify({ ...options, attributes });
  },
  send(label, text = '') {
    services.get(label).publisher.send(Buffer.from(text, 'hex'));
  },
  async stream(label, text) {
    try {
      await stream(label, ...text.split(' ').map(Number));
    } catch (error) {
      say('error', label, error.message);
    }
  },
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
    // An expression has spaces of its own and ends with a bracket; an IRI has none.
    const hasTwo = (kind === 'concept' || kind === 'expression') && text.includes(' ') && !text.endsWith(')');
    const end = hasTwo ? text.lastIndexOf(' ') : text.length;
    const value = text.slice(0, end);
    const representation = hasTwo ? text.slice(end + 1) : undefined;
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

const besides = new Set(['pub', 'sub', 'stream']);
for await (const line of createInterface({ input: process.stdin })) {
  const [, word, label, rest] = /^([^ ]*)(?: ([^ ]*)(?: (.*))?)?$/.exec(line) ?? [];
  if (word === 'quit') break;
  if (!Object.hasOwn(doings, word)) continue;
  try {
    const done = doings[word](label, rest);
    if (!besides.has(word)) await done;
  } catch (error) {
    say('error', label, error.message);
  }
}
await node.close();
process.exit(0);
