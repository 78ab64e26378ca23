// The parts of handshakes and seals, without sockets: keys, counters, beliefs, cookies, and the frames that wait.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Belief } from '../../../src/client/javascript/lib/protocol/belief.js';
import { ChannelKeys, lastBack, plainKeys } from '../../../src/client/javascript/lib/protocol/channel_keys.js';
import { kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { ConsumerFrames, PublisherFrames } from '../../../src/client/javascript/lib/protocol/frame_writer.js';
import { Allowance, Cookies, readHandshake, writeHandshake } from '../../../src/client/javascript/lib/protocol/handshake.js';
import * as limits from '../../../src/client/javascript/lib/protocol/limits.js';
import { ProviderKeys } from '../../../src/client/javascript/lib/protocol/provider_keys.js';
import { anyFrameOfDatagram } from '../../../src/client/javascript/lib/protocol/sealed_frame.js';
import { Pool, SendQueue } from '../../../src/client/javascript/lib/protocol/send_queue.js';

test('a writer reuses the octets of large messages, unless they are still needed', () => {
  const large = Buffer.alloc(limits.maxDatagramMessage, 7);
  for (const keys of [plainKeys, ring('encrypted')]) {
    const of = (isReused) => Object.assign(new PublisherFrames(9n, isReused), { keys });
    const writer = of(true);
    const one = writer.message(large);
    assert.ok(writer.isLent);
    const two = writer.message(large);
    assert.equal(two.buffer, one.buffer);
    assert.equal(anyFrameOfDatagram(one).sequence, 2n);
    assert.deepEqual(keys.takeForward(anyFrameOfDatagram(one)).payload, large);
    writer.keep();
    assert.notEqual(writer.message(large).buffer, one.buffer);
    assert.equal(anyFrameOfDatagram(two).sequence, 2n);
    const fresh = of(false);
    assert.notEqual(fresh.message(large).buffer, fresh.message(large).buffer);
    const small = Buffer.alloc(8);
    assert.equal(fresh.message(small).buffer, fresh.message(small).buffer);
    assert.notEqual(fresh.message(small, true).buffer, fresh.message(small, true).buffer);
  }
});

/** Keys of a mode; another `seed` gives others under the same id. */
function ring(mode, seed = 1, id = 0x6208) {
  return new ChannelKeys(mode, [[id, Buffer.alloc(32, seed), Buffer.alloc(32, seed + 1)]]);
}

test('no nonce is used twice: each life counts all its frames, and ends when its counter is used up', () => {
  const writer = Object.assign(new PublisherFrames(9n), { keys: ring('encrypted') });
  const counters = [writer.message(Buffer.from('x')), writer.other(kinds.floor, writeHandshake(1n, 2n, 0n)), writer.other(kinds.full), writer.other(kinds.end),
    writer.message(Buffer.from('x'))].map((octets) => anyFrameOfDatagram(octets).counter);
  assert.deepEqual(counters, [1n, 2n, 3n, 4n, 5n]);
  const last = Object.assign(new PublisherFrames(9n, false, Number.MAX_SAFE_INTEGER - 1), { keys: ring('encrypted') });
  assert.equal(anyFrameOfDatagram(last.message(Buffer.from('x'))).counter, BigInt(Number.MAX_SAFE_INTEGER));
  assert.throws(() => last.message(Buffer.from('x')), { code: 'GEMINGA_CLOSED' });
  assert.throws(() => last.other(kinds.end), { code: 'GEMINGA_CLOSED' });
  const consumer = new ConsumerFrames(7n, lastBack - 1);
  const hello = writeHandshake(9n, 2n, 0n);
  assert.equal(anyFrameOfDatagram(consumer.write(ring('mixed'), kinds.hello, hello)).counter, BigInt(lastBack));
  assert.throws(() => consumer.write(ring('mixed'), kinds.hello, hello), /counter is used up/);
  assert.equal(consumer.write(plainKeys, kinds.hello, hello).length, 48);
});

test('each mode sends and takes what the table says', () => {
  const plain = { kind: kinds.message, life: 9n, sequence: 1n, payload: Buffer.from('x') };
  const sealed = (mode) => {
    const writer = Object.assign(new PublisherFrames(9n), { keys: ring(mode) });
    return anyFrameOfDatagram(writer.message(Buffer.from('x')));
  };
  for (const [mode, form, takesPlain, takesSealed] of [['plain', undefined, true, false], ['prepared', undefined, true, true],
    ['mixed', 2, true, true], ['authenticated', 3, false, true], ['encrypted', 2, false, true]]) {
    const keys = mode === 'plain' ? plainKeys : ring(mode);
    const writer = Object.assign(new PublisherFrames(9n), { keys });
    assert.equal(anyFrameOfDatagram(writer.message(Buffer.from('x'))).form, form, mode);
    assert.equal(keys.takeForward(plain) !== undefined, takesPlain, mode);
    for (const other of ['encrypted', 'authenticated']) assert.equal(keys.takeForward(sealed(other)) !== undefined, takesSealed, mode);
  }
  assert.equal(ring('encrypted', 3).takeForward(sealed('encrypted')), undefined);
  assert.equal(ring('encrypted', 1, 7).takeForward(sealed('encrypted')), undefined);
  const both = new ChannelKeys('encrypted', [[7, Buffer.alloc(32, 5), Buffer.alloc(32, 6)], [0x6208, Buffer.alloc(32, 1), Buffer.alloc(32, 2)]]);
  assert.ok(both.takeForward(sealed('encrypted')).isSealed);
});

test('a belief has the floor of its challenge, and takes nothing plain of a life of which it has taken something sealed', () => {
  const writer = Object.assign(new PublisherFrames(9n), { keys: ring('mixed') });
  const belief = new Belief(7n, 9n, ring('mixed'));
  const { life, challenge, cookie } = readHandshake(belief.hello());
  assert.deepEqual([life, cookie], [9n, 0n]);
  assert.notEqual(challenge, 0n);
  const floor = (to, back, given) => belief.take(anyFrameOfDatagram(writer.other(kinds.floor, writeHandshake(to, back, given))));
  const plain = { kind: kinds.message, life: 9n, sequence: 1n, payload: Buffer.from('x') };
  assert.ok(belief.take(plain));
  const message = belief.take(anyFrameOfDatagram(writer.message(Buffer.from('x'))));
  assert.equal(belief.isBehindFloor(message), undefined);
  assert.equal(belief.take(plain), undefined);
  assert.equal(belief.answered(floor(8n, challenge, 5n)), 'forged');
  assert.equal(belief.answered(floor(7n, challenge ^ 1n, 5n)), 'forged');
  assert.equal(belief.floor, undefined);
  assert.equal(belief.answered(floor(7n, challenge, 5n)), 'again');
  assert.equal(readHandshake(belief.hello()).cookie, 5n);
  assert.equal(belief.answered(floor(7n, challenge, 5n)), 'heard');
  assert.equal(belief.isAccepted, false);
  assert.equal(belief.isBehindFloor(message), false);
  assert.equal(belief.isBehindFloor(belief.take(anyFrameOfDatagram(writer.message(Buffer.from('x'))))), true);
  assert.equal(belief.answered(floor(7n, challenge, 0n)), 'heard');
  assert.deepEqual([belief.isAccepted, belief.floor], [true, 1n]);
  belief.greet();
  assert.deepEqual([belief.floor, belief.isAccepted], [undefined, false]);
  assert.deepEqual(Array.from({ length: 8 }, () => belief.wait()), [20, 40, 80, 160, 320, 640, 1000, 1000]);
});

test('a plain floor counts only while plain frames are taken', () => {
  const belief = new Belief(7n, 9n, ring('mixed'));
  const { challenge } = readHandshake(belief.hello());
  belief.answered({ kind: kinds.floor, sequence: 3n, payload: writeHandshake(7n, challenge, 0n) });
  assert.equal(belief.floor, 3n);
  belief.rekey(ring('encrypted'));
  assert.equal(belief.floor, undefined);
  belief.answered({ kind: kinds.floor, sequence: 5n, payload: writeHandshake(7n, challenge, 0n), isSealed: true });
  assert.equal(belief.floor, 5n);
});

test('a cookie is right for its address, port, life and challenge, for 8 to 16 s', () => {
  const cookies = new Cookies(Buffer.alloc(32, 1));
  const period = limits.cookiePatience;
  const cookie = cookies.cookie('10.0.0.1', 5, 7n, 9n, 10);
  const isRight = (address, port, life, challenge, now, given = cookie) => cookies.isRight(address, port, life, challenge, given, now);
  assert.ok(isRight('10.0.0.1', 5, 7n, 9n, 2 * period - 1));
  for (const bad of [['10.0.0.2', 5, 7n, 9n, 10], ['10.0.0.1', 6, 7n, 9n, 10], ['10.0.0.1', 5, 8n, 9n, 10], ['10.0.0.1', 5, 7n, 8n, 10],
    ['10.0.0.1', 5, 7n, 9n, 2 * period], ['10.0.0.1', 5, 7n, 9n, 10, 0n], ['10.0.0.1', 5, 7n, 9n, 10, cookie ^ 1n]]) assert.equal(isRight(...bad), false);
  assert.equal(new Cookies(Buffer.alloc(32, 2)).isRight('10.0.0.1', 5, 7n, 9n, cookie, 10), false);
});

test('512 answers at once and a second are allowed, and half of them are for newcomers', () => {
  const allowance = new Allowance(0);
  const count = (now, keepsHalf) => {
    let given = 0;
    while (allowance.take(now, keepsHalf)) ++given;
    return given;
  };
  assert.deepEqual([count(0, true), count(0), count(0)], [limits.maxAnswers / 2, limits.maxAnswers / 2, 0]);
  assert.deepEqual([count(500), count(100_000)], [limits.maxAnswers / 2, limits.maxAnswers]);
});

test('keys of 1024 lives are kept beside those of the providers', () => {
  const keys = new ProviderKeys();
  const isKept = (life) => life === 1n;
  const put = (life) => keys.put(life, plainKeys, isKept);
  for (let life = 1n; life <= BigInt(limits.maxKeptKeys) + 1n; ++life) put(life);
  assert.equal(keys.get(2n), plainKeys);
  put(5000n);
  assert.deepEqual([keys.get(1n), keys.get(2n), keys.get(3n), keys.get(2n, 'none')], [plainKeys, undefined, plainKeys, 'none']);
});

test('frames that wait are counted once whoever waits for them, and the rest of one that was begun is kept', () => {
  const pool = new Pool();
  const queues = [new SendQueue(pool), new SendQueue(pool)];
  const writer = Object.assign(new PublisherFrames(9n), { keys: plainKeys });
  const large = writer.message(Buffer.alloc(100_000));
  for (const queue of queues) queue.put(large);
  assert.equal(pool.octets, 100_024);
  for (let i = 0; i < 10; ++i) queues[0].put(writer.message(Buffer.alloc(100)));
  assert.equal(queues[0].octets, 100_024 + 1240);
  assert.equal(pool.octets, 100_024 + 65_536);
  assert.deepEqual([queues[0].next(70_000).length, queues[1].hasRoomFor(limits.maxWaiting), new SendQueue(pool).hasRoomFor(limits.maxStreamMessage)],
    [70_000, false, true]);
  queues[0].took(70_000);
  assert.equal(queues[0].next(70_000).length, 30_024);
  queues[0].took(30_024);
  assert.equal(queues[0].next(70_000).length, 1240); // frames that lie behind each other are one piece
  queues[0].took(130);
  queues[0].dismiss(10);
  assert.deepEqual([queues[0].octets, queues[0].next(1000).length], [118, 118]);
  queues[0].took(118);
  assert.equal(pool.octets, 100_024);
  queues[1].dismiss(0);
  assert.deepEqual([queues[0].isEmpty, queues[1].isEmpty, pool.octets], [true, true, 0]);
});

test('16384 frames wait for one consumer, whether they lie behind each other or not', () => {
  const frames = Object.assign(new PublisherFrames(9n), { keys: plainKeys });
  for (const isAlone of [true, false]) {
    const queue = new SendQueue(new Pool());
    const put = () => queue.put(frames.message(Buffer.alloc(1), isAlone));
    for (let i = 0; i < limits.maxWaitingFrames - 1; ++i) put();
    assert.equal(queue.hasRoomFor(25), true);
    put();
    assert.equal(queue.hasRoomFor(25), false);
    while (!queue.isEmpty) queue.took(queue.next(1 << 20).length);
    put();
    assert.equal(queue.hasRoomFor(25), true);
  }
});

test('4 MiB wait for one consumer', () => {
  for (const [octets, isRoom] of [[limits.maxWaiting - 1, true], [limits.maxWaiting, true], [limits.maxWaiting + 1, false]]) {
    const queue = new SendQueue(new Pool());
    queue.put(Buffer.alloc(24));
    assert.equal(queue.hasRoomFor(octets - 24), isRoom);
  }
});
