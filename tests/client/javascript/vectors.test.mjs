// The tables that every language passes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { isEvent, readEvent } from '../../../src/client/javascript/lib/protocol/event.js';
import { reservedKeys } from '../../../src/client/javascript/lib/protocol/attribute.js';
import { encodeFrame, frameOfDatagram, kinds, MessageWriter } from '../../../src/client/javascript/lib/protocol/frame.js';
import { lifeText } from '../../../src/client/javascript/lib/protocol/life.js';
import { Inbox } from '../../../src/client/javascript/lib/protocol/inbox.js';
import { identity } from '../../../src/client/javascript/lib/protocol/identity.js';
import { canonicalRequest } from '../../../src/client/javascript/lib/protocol/request.js';
import { formatStatement, parseStatement } from '../../../src/client/javascript/lib/protocol/statement.js';
import { xxh32 } from '../../../src/client/javascript/lib/protocol/xxh32.js';
import { root } from './support.mjs';

const text = (path) => readFileSync(new URL(path, root), 'utf8');
const rows = (path) => text(path).split('\n').filter((line) => line && !line.startsWith('#')).map((line) => line.split('\t'));
const gcnp = text('src/discovery/gcnp/GCNP.md');

/** Lines of a block, each with the line behind `=`, or itself. */
function pairs(block) {
  const lines = new RegExp(`\`\`\`${block}\\n([^]*?)\`\`\``).exec(gcnp)[1].split('\n').filter(Boolean);
  const found = [];
  for (const line of lines) {
    if (line.startsWith('= ')) found.at(-1)[1] = line.slice(2);
    else found.push([line, line]);
  }
  assert.ok(found.length > 4);
  return found;
}

test('identities are those of the table', () => {
  for (const [kind, value, representation, number] of rows('tests/client/vectors/identities.tsv')) {
    const key = kind === 'number' ? 'id' : kind;
    const asked = { [key]: kind === 'number' ? Number(value) : value, representation: representation || undefined };
    assert.equal(identity(asked), Number(number), `${kind} ${value}`);
  }
});

test('XXH32 agrees with the xxHash project for all lengths of its branches', () => {
  const octets = (count) => Buffer.from(Array.from({ length: count }, (_, i) => (i * 7) & 255));
  assert.equal(xxh32(Buffer.alloc(0)), 0x02cc5d05);
  assert.equal(xxh32(Buffer.from('a')), 0x550d7456);
  assert.equal(xxh32(Buffer.from('abc')), 0x32d153ff);
  assert.equal(xxh32(Buffer.from('Nobody inspects the spammish repetition')), 0xe2293b2f);
  assert.notEqual(xxh32(octets(15)), xxh32(octets(16)));
});

test('frames are those of the table', () => {
  for (const [kind, life, sequence, payload, frame] of rows('tests/client/vectors/frames.tsv')) {
    const read = frameOfDatagram(Buffer.from(frame ?? '', 'hex'));
    if (kind === 'refused') {
      assert.equal(read, undefined, frame);
      continue;
    }
    assert.equal(read.kind, kinds[kind], frame);
    assert.equal(lifeText(read.life), life);
    assert.equal(read.sequence, BigInt(sequence));
    assert.equal(read.payload.toString('hex'), payload);
    const again = encodeFrame(kinds[kind], BigInt(`0x${life}`), BigInt(sequence), Buffer.from(payload, 'hex'));
    assert.equal(again.toString('hex'), frame);
    if (kind !== 'message' || BigInt(sequence) > BigInt(Number.MAX_SAFE_INTEGER)) continue;
    for (const isReused of [false, true]) {
      const quick = new MessageWriter(BigInt(`0x${life}`), isReused).write(Number(sequence), Buffer.from(payload, 'hex'));
      assert.equal(quick.toString('hex'), frame);
    }
  }
});

test('a full inbox loses what the table says', () => {
  const message = (word) => {
    const [life, sequence, missed] = word.split(':').map(BigInt);
    return { life, sequence, missed, payload: Buffer.alloc(0) };
  };
  for (const [room, words, wanted, count] of rows('tests/client/vectors/inbox.tsv')) {
    const inbox = new Inbox(Number(room), 1000);
    const got = [];
    const take = () => {
      const { life, sequence, missed } = inbox.take();
      got.push(`${life}:${sequence}:${missed}`);
    };
    let lost = 0;
    for (const word of words.split(' ')) {
      if (word === '-') take();
      else if (word[0] === 's') inbox.putStreamed(message(word.slice(1)));
      else lost += inbox.putDatagram(message(word.slice(1)));
    }
    while (inbox.size > 0) take();
    assert.deepEqual([got.join(' '), lost], [wanted, Number(count)], words);
  }
});

/** Whether a line states or changes a publication or subscription, which are all requests that the library makes. */
const isStated = (line) => /^[0-9]+ (pub|sub) (create|modify)\b/.test(line);

test('requests are read and written as in GCNP.md', () => {
  const requests = pairs('requests').filter(([line]) => isStated(line));
  assert.ok(requests.length > 10);
  for (const [line, written] of requests) assert.equal(formatStatement(canonicalRequest(parseStatement(line))), written, line);
});

test('what GCNP.md refuses is refused, with its id and code', () => {
  for (const [line, answer] of pairs('refused')) {
    if (/^[0-9]+ (query|sys)\b/.test(line)) continue; // the library makes no queries
    assert.throws(() => canonicalRequest(parseStatement(line)), (error) => `${error.id} ${error.status}` === answer, line);
  }
});

test('lines of the daemon are read and written as in GCNP.md', () => {
  for (const [line] of pairs('events')) {
    const statement = parseStatement(line);
    assert.equal(formatStatement(statement), line);
    if (statement.code !== undefined) continue;
    assert.ok(isEvent(statement), line);
    const values = new Map(statement.parameters);
    const event = readEvent(statement);
    assert.equal(event.service, values.get('service') ?? values.get('subscription'), line);
    for (const [name, value] of Object.entries(event.attributes ?? {})) {
      assert.equal(values.get(`attr.${name}`) ?? values.get(name), value, line);
    }
  }
});

test('the reserved keys are those of GCNP.md', () => {
  assert.deepEqual(reservedKeys, /```reserved\n([^]*?)```/.exec(gcnp)[1].trim().split(/\s+/));
});
