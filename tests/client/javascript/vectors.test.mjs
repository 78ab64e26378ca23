// The tables that every language passes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inspect } from 'node:util';

import { isEvent, readEvent } from '../../../src/client/javascript/lib/protocol/event.js';
import { reservedKeys } from '../../../src/client/javascript/lib/protocol/attribute.js';
import { ChannelKeys, plainKeys, readChannelKeys } from '../../../src/client/javascript/lib/protocol/channel_keys.js';
import { encodeFrame, forms, frameOfDatagram, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { PublisherFrames } from '../../../src/client/javascript/lib/protocol/frame_writer.js';
import { lifeText } from '../../../src/client/javascript/lib/protocol/life.js';
import { Inbox } from '../../../src/client/javascript/lib/protocol/inbox.js';
import { identity } from '../../../src/client/javascript/lib/protocol/identity.js';
import { Places } from '../../../src/client/javascript/lib/protocol/places.js';
import { canonicalRequest } from '../../../src/client/javascript/lib/protocol/request.js';
import { anyFrameOfDatagram } from '../../../src/client/javascript/lib/protocol/sealed_frame.js';
import { Sequence } from '../../../src/client/javascript/lib/protocol/sequence.js';
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
    if (kind !== 'message' || sequence !== '1') continue;
    for (const isReused of [false, true]) {
      const writer = new PublisherFrames(BigInt(`0x${life}`), isReused);
      writer.keys = plainKeys;
      assert.equal(writer.message(Buffer.from(payload, 'hex')).toString('hex'), frame);
    }
  }
});

test('sealed frames are those of the table', () => {
  const [, forward] = /forward ([0-9a-f]{64})/.exec(text('tests/client/vectors/sealed.tsv'));
  const [, back] = /back ([0-9a-f]{64})/.exec(text('tests/client/vectors/sealed.tsv'));
  const ring = [[0x6208, Buffer.from(forward, 'hex'), Buffer.from(back, 'hex')]];
  const of = { 2: new ChannelKeys('encrypted', ring), 3: new ChannelKeys('authenticated', ring) };
  for (const row of rows('tests/client/vectors/sealed.tsv')) {
    if (row[0] === 'refused') {
      const read = anyFrameOfDatagram(Buffer.from(row[2], 'hex'));
      const keys = of[2];
      assert.equal(read && (row[1] === 'forward' ? keys.takeForward(read) : keys.takeBack(read)), undefined, row[3]);
      continue;
    }
    const [direction, form, kind, life, sequence, id, port, counter, payload, frame] = row;
    const keys = of[form];
    const octets = Buffer.from(frame, 'hex');
    const head = { kind: kinds[kind], life: BigInt(`0x${life}`), sequence: BigInt(sequence), counter: BigInt(counter), port: Number(port) };
    const written = Buffer.alloc(octets.length);
    keys[direction === 'forward' ? 'sealForward' : 'sealBack'](written, head, Buffer.from(payload, 'hex'));
    assert.equal(written.toString('hex'), frame);
    const read = anyFrameOfDatagram(octets);
    assert.deepEqual([read.form, read.key], [Number(form), parseInt(id, 16)]);
    const opened = direction === 'forward' ? keys.takeForward(read) : keys.takeBack(read);
    assert.deepEqual({ ...opened, payload: opened.payload.toString('hex') }, { ...head, payload, isSealed: true });
    assert.equal(direction === 'forward' ? keys.takeBack(read) : keys.takeForward(read), undefined);
  }
  assert.equal(forms.plain, 1);
});

test('a line of keys is read, and shows nothing of them when it is wrong', () => {
  const key = '0123456789abcdef'.repeat(4);
  const line = (rest) => parseStatement(`5 pub keys life=00000000000000aa ${rest}`);
  const { life, keys } = readChannelKeys(line(`mode=mixed ring=6208:${key}:${key},beef:${key}:${key}`));
  assert.deepEqual([life, keys.mode, keys.hasRing, keys.seals, keys.takesPlain], [0xaan, 'mixed', true, true, true]);
  for (const shown of [inspect(keys, { showHidden: true, depth: 9 }), JSON.stringify(keys), String(keys)]) {
    assert.equal(shown.includes('0123'), false, shown);
    assert.equal(/[0-9a-f]{2} [0-9a-f]{2}|[0-9]+, [0-9]+/.test(shown), false, shown);
  }
  assert.equal(readChannelKeys(line('mode=plain')).keys.hasRing, false);
  for (const bad of ['mode=new', `mode=new ring=6208:${key}:${key}`, 'mode=encrypted', 'mode=encrypted ring=', `mode=mixed ring=6208:${key}:${key}0`,
    `mode=mixed ring=6208:${key}`, `mode=encrypted ring=${Array(65).fill(`6208:${key}:${key}`).join(',')}`]) {
    assert.throws(() => readChannelKeys(line(bad)), (error) => error.code === 'GEMINGA_KEYS' && !error.stack.includes('0123'), bad);
  }
  assert.throws(() => readChannelKeys(parseStatement(`5 pub keys life=x mode=mixed ring=6208:${key}:${key}`)), { code: 'GEMINGA_KEYS' });
  for (const count of [63, 64]) {
    const ring = Array.from({ length: count }, (_, i) => `${i.toString(16).padStart(4, '0')}:${key}:${key}`).join(',');
    assert.ok(readChannelKeys(line(`mode=encrypted ring=${ring}`)).keys.hasRing);
  }
});

test('which message is new is as the table says', () => {
  for (const [words, wanted] of rows('tests/client/vectors/sequence.tsv')) {
    const sequence = new Sequence();
    const got = [];
    for (const word of words.split(' ')) {
      if (word === 'again') {
        sequence.interrupt(7n);
        continue;
      }
      const [now, number] = word.split(':');
      got.push(sequence.take(7n, BigInt(number), Number(now)) ?? '-');
    }
    assert.equal(got.join(' '), wanted, words);
  }
});

test('places are shared as the table says', () => {
  for (const [count, words, wanted] of rows('tests/client/vectors/places.tsv')) {
    const places = new Places(Number(count));
    const got = [];
    let last = 0;
    for (const word of words.split(' ')) {
      if (word[0] === '!') places.serve(Number(word.slice(1)));
      else if (word[0] === '-') places.leave(Number(word.slice(1)));
      else {
        const { isTaken, loser } = places.take(++last, word);
        got.push(isTaken ? `taken${loser === undefined ? '' : `-${loser}`}` : 'refused');
      }
    }
    assert.equal(got.join(' '), wanted, words);
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

/** Whether a line states or changes a service, as all requests of the library do; a participant has no channel. */
const isStated = (line) => /^[0-9]+ (pub|sub) (create|modify)\b/.test(line) && !line.includes('mode=participant');

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
