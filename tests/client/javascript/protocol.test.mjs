// The parts without sockets: hostile lines and frames, limits at their edges, inbox, back-off, conversions, sequences.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { isSlip, shownAttribute, statedKey } from '../../../src/client/javascript/lib/protocol/attribute.js';
import { canonicalAddress, isMulticast, isOfSomeLink } from '../../../src/client/javascript/lib/protocol/address.js';
import { Backoff } from '../../../src/client/javascript/lib/protocol/backoff.js';
import { Converter } from '../../../src/client/javascript/lib/protocol/converter.js';
import { FrameReader } from '../../../src/client/javascript/lib/protocol/frame_reader.js';
import { Sequence } from '../../../src/client/javascript/lib/protocol/sequence.js';
import { EarlyFrames } from '../../../src/client/javascript/lib/protocol/early_frames.js';
import { readEvent } from '../../../src/client/javascript/lib/protocol/event.js';
import { encodeFrame, frameOfDatagram, kinds } from '../../../src/client/javascript/lib/protocol/frame.js';
import { lifeOf, newLife } from '../../../src/client/javascript/lib/protocol/life.js';
import * as limits from '../../../src/client/javascript/lib/protocol/limits.js';
import { Senders } from '../../../src/client/javascript/lib/protocol/senders.js';
import { Inbox } from '../../../src/client/javascript/lib/protocol/inbox.js';
import { canonicalRequest, parametersOf } from '../../../src/client/javascript/lib/protocol/request.js';
import { decodeLine, formatValue, parseStatement } from '../../../src/client/javascript/lib/protocol/statement.js';
import { endpointOf } from '../../../src/client/javascript/lib/channels/endpoint.js';
import { Listeners } from '../../../src/client/javascript/lib/protocol/listeners.js';

const refused = (line, status = 400) =>
  assert.throws(() => parseStatement(line), (error) => error.code === 'GEMINGA_STATEMENT' && error.status === status, line);

test('hostile lines are refused, with the octet where they stop making sense', () => {
  for (const line of ['', ' ', 'GET / HTTP/1.1', '5', '5 pub', '5 pub add\u0001', '5 pub add \u007f', '5 pub add =x',
    '5 pub add a="x', '5 pub add a="x"y', '5 pub add a=x"y', '5 pub add a="\\x"', '5 pub add a="\\', '99999999999 pub add',
    '5 pub add a="\\__proto__"', '+5 pub add', '5\tpub add']) refused(line);
  assert.throws(() => parseStatement('5 pub add a=1 b=2 a=1'), /octet 19: a is given twice/);
  assert.throws(() => parseStatement('5 pub add Ö=1'), /octet 11:/);
  assert.throws(() => parseStatement('5 pub add a=Ö b"=1'), /octet 17:/);
  assert.throws(() => decodeLine(Buffer.from([0x35, 0xff])), /not UTF-8/);
});

test('a line has 65536 octets and 256 parameters at most', () => {
  const line = (octets) => `5 pub add a=${'x'.repeat(octets - 12)}`;
  for (const octets of [limits.maxLine - 1, limits.maxLine]) assert.equal(parseStatement(line(octets)).id, 5);
  refused(line(limits.maxLine + 1), 413);
  refused(`5 pub add a=${'Ö'.repeat(limits.maxLine / 2)}`, 413);
  const many = (count) => `5 pub add ${Array.from({ length: count }, (_, i) => `k${i}`).join(' ')}`;
  for (const count of [limits.maxParameters - 1, limits.maxParameters]) {
    assert.equal(parseStatement(many(count)).parameters.length, count);
  }
  refused(many(limits.maxParameters + 1), 413);
});

test('values are written so that they are read again', () => {
  for (const value of ['', 'x', 'a b', 'a"b\\c', '\n\r\t', 'Ölstand \u{1f916}', '\\', '\ufffd']) {
    assert.equal(parseStatement(`1 a b c=${formatValue(value)}`).parameters[0][1], value);
  }
  assert.equal(formatValue('a\u0000b'), '"a?b"');
  assert.equal(formatValue('a\ud800'), 'a\ufffd');
});

test('hostile events are refused and no attribute reaches a prototype', () => {
  const of = (line) => readEvent(parseStatement(line));
  const good = '5 pub add service=a provider=b id=1 degree=exact mode=oto port=1 protocol=udp';
  assert.equal(of(`${good} __proto__=1 constructor=2`).attributes['__proto__'], '1');
  assert.equal({}.x, undefined);
  for (const bad of ['5 pub add', '5 pub add service=a', good.replace('mode=oto', 'mode=x'), good.replace('port=1', 'port=65536'),
    good.replace('degree=exact', 'degree=best'), `${good} service=c`, good.replace('id=1', 'id=-1')]) {
    assert.throws(() => of(bad), { code: 'GEMINGA_STATEMENT' }, bad);
  }
  assert.equal(shownAttribute('attr.port'), 'port');
  assert.equal(statedKey('prot'), 'attr.prot');
  assert.equal(isSlip('wehre', 'where') && isSlip('Port', 'port') && isSlip('limits', 'limit') && isSlip('od', 'id'), true);
  assert.equal(isSlip('rate', 'where') || isSlip('port', 'port'), false);
});

test('who converts is a key behind a conversion, and else an attribute', () => {
  const of = (rest) => readEvent(parseStatement(`5 pub add service=a provider=b degree=converted mode=oto port=1 protocol=udp ${rest}`));
  const served = of('convert=a:A>a:B cost=2 via=udp://10.0.0.7:6000/b/1/1 attr.via=x');
  assert.equal(served.via, 'udp://10.0.0.7:6000/b/1/1');
  assert.equal(served.attributes.via, 'x');
  const far = of('attr.path=/left hops=2 path=base/tower reachable=no');
  assert.deepEqual([far.hops, far.path, far.reachable, far.attributes.path], [2, 'base/tower', false, '/left']);
  const near = of('path=/left attr.reachable=no');
  assert.deepEqual([near.hops, near.path, near.reachable, near.attributes.path], [0, undefined, true, '/left']);
  assert.equal(of('via=x').via, undefined);
  assert.equal(of('via=x').attributes.via, 'x');
});

test('options become parameters, and a word that is none is told', () => {
  assert.deepEqual(parametersOf({ mode: 'oto', text: 'x', protocol: ['udp', 'tcp'], attributes: { rate: 30, port: 1 } }, 'sub'),
    [['mode', 'oto'], ['text', 'x'], ['protocol', 'udp,tcp'], ['rate', '30'], ['attr.port', '1']]);
  assert.deepEqual(parametersOf({ mode: 'oto', id: 1, on: 'a:Robot', attributes: { on: 1, in: 2 } }, 'sub'),
    [['mode', 'oto'], ['id', '1'], ['on', 'a:Robot'], ['attr.on', '1'], ['attr.in', '2']]);
  assert.throws(() => parametersOf({ mode: 'oto', prority: 3 }, 'pub'), /prority is no option/);
});

test('limits of a request hold at their edges', () => {
  const request = (rest) => () => canonicalRequest(parseStatement(`5 sub create mode=oto id=1 ${rest}`));
  const edge = (limit, of) => {
    for (const count of [limit - 1, limit]) request(of(count))();
    assert.throws(request(of(limit + 1)), { status: 413 });
  };
  edge(limits.maxCondition, (n) => `where=${'x'.repeat(n)}`);
  edge(limits.maxScope, (n) => `scope=${'x'.repeat(n)}`);
  edge(limits.maxConcept, (n) => `on=${'x'.repeat(n)}`);
  edge(limits.maxPrefer, (n) => `prefer=${'x'.repeat(n)}`);
  edge(limits.maxRank, (n) => `rank=${'x'.repeat(n)}`);
  edge(limits.maxProviders, (n) => `provider=${Array(n).fill('a').join(',')}`);
  edge(limits.maxName, (n) => `favour=${'x'.repeat(n)}`);
  edge(limits.maxProtocols, (n) => `protocol=${Array(n).fill('a').join(',')}`);
  edge(limits.maxProtocol, (n) => `protocol=${'x'.repeat(n)}`);
  edge(limits.maxAttributes, (n) => Array.from({ length: n }, (_, i) => `attr.a${i}=1`).join(' '));
  edge(limits.maxAttributeName, (n) => `attr.${'x'.repeat(n)}=1`);
  edge(limits.maxAttributeValue, (n) => `attr.x=${'x'.repeat(n)}`);
  const text = (n) => () => canonicalRequest(parseStatement(`5 sub create mode=oto text=${'x'.repeat(n)}`));
  text(limits.maxText)();
  assert.throws(text(limits.maxText + 1), { status: 413 });
});

test('a datagram has 65000 octets of message at most', () => {
  const size = (octets) => frameOfDatagram(encodeFrame(kinds.message, 1n, 1n, Buffer.alloc(octets)))?.payload.length;
  assert.equal(size(limits.maxDatagramMessage - 1), limits.maxDatagramMessage - 1);
  assert.equal(size(limits.maxDatagramMessage), limits.maxDatagramMessage);
  assert.equal(size(limits.maxDatagramMessage + 1), undefined);
});

test('a stream of frames is read however it is cut', () => {
  const frames = [encodeFrame(kinds.message, 7n, 1n, Buffer.from('one')), encodeFrame(kinds.message, 7n, 2n, Buffer.alloc(300, 2)),
    encodeFrame(kinds.end, 7n, 2n)];
  const octets = Buffer.concat(frames);
  for (const step of [1, 2, 23, 24, 25, 100, octets.length]) {
    const decoder = new FrameReader(300);
    const read = [];
    for (let at = 0; at < octets.length; at += step) {
      decoder.push(octets.subarray(at, at + step));
      for (let frame = decoder.next(); frame; frame = decoder.next()) read.push(frame);
    }
    assert.deepEqual(read.map(({ sequence, kind }) => [kind, sequence]), [[1, 1n], [1, 2n], [3, 2n]]);
    assert.equal(read[1].payload.length, 300);
    assert.equal(decoder.isBroken, false);
  }
});

test('a stream ends at what is no frame, before its payload is waited for', () => {
  for (const limit of [299, 300, 301]) {
    const decoder = new FrameReader(limit);
    decoder.push(encodeFrame(kinds.message, 7n, 1n, Buffer.alloc(300)).subarray(0, 24));
    assert.equal(decoder.next(), undefined);
    assert.equal(decoder.isBroken, limit < 300);
  }
  const decoder = new FrameReader(300);
  decoder.push(Buffer.concat([encodeFrame(kinds.message, 7n, 1n), Buffer.from('GET / HTTP/1.1\r\nHost: x\r\n\r\n')]));
  assert.equal(decoder.next().sequence, 1n);
  assert.equal(decoder.next(), undefined);
  assert.ok(decoder.isBroken);
  decoder.push(encodeFrame(kinds.message, 7n, 2n));
  assert.equal(decoder.next(), undefined);
});

test('lives are 16 digits and never 0', () => {
  assert.equal(lifeOf('0123456789abcdef'), 0x0123456789abcdefn);
  for (const bad of ['', undefined, '0123456789ABCDEF', '0123456789abcde', '0000000000000000', '0x23456789abcdef', '0123456789abcdef0']) {
    assert.equal(lifeOf(bad), 0n);
  }
  const drawn = [Buffer.alloc(8), Buffer.alloc(8, 1)];
  assert.equal(newLife(() => drawn.shift()), 0x0101010101010101n);
});

test('the next try waits .1, .2, .4, .8, 1, 1 s, up to a quarter longer', () => {
  for (const [chance, factor] of [[0, 1], [0.5, 1.125], [0.999999, 1.25]]) {
    const backoff = new Backoff(() => chance);
    const waits = Array.from({ length: 7 }, () => Math.round(backoff.next()));
    assert.deepEqual(waits, [100, 200, 400, 800, 1000, 1000, 1000].map((wait) => Math.round(wait * factor)));
    backoff.reset();
    assert.ok(backoff.next() <= 125);
  }
});

test('over TCP or sealed a message is new if it is greater than the last, and what is missing is counted', () => {
  const sequence = new Sequence();
  assert.equal(sequence.takeSurely(1n, 5n), 0n);
  assert.equal(sequence.takeSurely(1n, 5n), undefined);
  assert.equal(sequence.takeSurely(1n, 4n), undefined);
  assert.equal(sequence.takeSurely(1n, 6n), 0n);
  assert.equal(sequence.takeSurely(1n, 9n), 2n);
  assert.equal(sequence.takeSurely(2n, 8n), 0n);
  assert.deepEqual([9n, 12n, 3n].map((last) => sequence.missedAtEnd(1n, last)), [0n, 3n, 0n]);
  assert.equal(sequence.missedAtEnd(3n, 5n), 0n);
  assert.equal(sequence.takeSurely(1n, 0xffffffffffffffffn), 0xffffffffffffffffn - 10n);
  assert.equal(sequence.takeSurely(4n, 0n), undefined);
});

test('an end without a key counts messages up to a step', () => {
  const sequence = new Sequence();
  sequence.take(1n, 1n, 0);
  const step = BigInt(limits.maxStep);
  assert.deepEqual([step, step + 1n, step + 2n].map((last) => sequence.missedAtEnd(1n, last, false)), [step - 1n, step, 0n]);
});

test('a life that is back delivers nothing twice and misses nothing that was not for it', () => {
  const sequence = new Sequence();
  assert.equal(sequence.take(1n, 9n, 0), 0n);
  sequence.interrupt(1n);
  assert.equal(sequence.missedAtEnd(1n, 50n), 0n);
  assert.equal(sequence.take(1n, 9n, 0), undefined);
  assert.equal(sequence.take(1n, 20n, 0), 0n);
  assert.equal(sequence.take(1n, 22n, 0), 1n);
  for (let life = 2n; life <= BigInt(limits.maxRemembered); ++life) sequence.take(life, 1n, 0);
  assert.equal(sequence.take(1n, 22n, 0), undefined);
  sequence.take(5000n, 1n, 0);
  assert.equal(sequence.take(1n, 22n, 0), 0n);
});

test('256 runs of delivered sequences are remembered, and the shortest is forgotten', () => {
  for (const [count, isRemembered] of [[limits.maxRanges - 1, true], [limits.maxRanges, true], [limits.maxRanges + 1, false]]) {
    const sequence = new Sequence();
    for (let i = 0; i < count; ++i) sequence.take(1n, BigInt(i * 2 + 1), 0);
    sequence.take(1n, 1n, 0);
    // A straggler behind a lower one is delivered after 2 s, unless it is known to have been.
    assert.equal(sequence.take(1n, 0n, 3000), undefined);
    sequence.take(1n, 0xffff_ffff_0000n, 3000);
    const got = [sequence.take(1n, 1n, 3000), sequence.take(1n, 2n, 3001)];
    assert.equal(got[1] === undefined, isRemembered, `${count}`);
  }
});

test('an inbox loses the eldest datagrams, and asks streams to wait', () => {
  const message = (sequence) => ({ life: 0n, sequence, missed: 0n, payload: Buffer.alloc(1) });
  const inbox = new Inbox(3, 100);
  for (const name of ['s', 't', 'u']) inbox.putStreamed(message(name));
  assert.equal(inbox.putDatagram(message('lost')), 1);
  assert.deepEqual([inbox.size, inbox.hasRoom, inbox.isHalfEmpty], [3, false, false]);
  assert.equal(inbox.take().sequence, 's');
  assert.deepEqual([inbox.hasRoom, inbox.isHalfEmpty], [true, false]);
  assert.equal(inbox.take().sequence, 't');
  assert.deepEqual([inbox.hasRoom, inbox.isHalfEmpty], [true, true]);
  assert.deepEqual([inbox.take().sequence, inbox.take()], ['u', undefined]);
});

test('1024 messages and 16 MiB wait, but always one', () => {
  const message = (size) => ({ life: 0n, sequence: 0n, missed: 0n, payload: { length: size } });
  assert.deepEqual([limits.queueLength, limits.maxQueuedOctets], [1024, 16_777_216]);
  const inbox = new Inbox(limits.queueLength, limits.maxQueuedOctets);
  for (let count = 0; count < limits.queueLength; ++count) assert.equal(inbox.putDatagram(message(0)), 0);
  assert.equal(inbox.putDatagram(message(0)), 1);
  assert.equal(inbox.size, limits.queueLength);
  const octets = new Inbox(limits.queueLength, limits.maxQueuedOctets);
  octets.putDatagram(message(limits.maxQueuedOctets - 1));
  assert.ok(octets.hasRoom);
  octets.putDatagram(message(1));
  assert.equal(octets.hasRoom, false);
  assert.equal(octets.putDatagram(message(0)), 1);
  assert.equal(octets.size, 2);
  const one = new Inbox(1, limits.maxQueuedOctets);
  one.putStreamed(message(limits.maxQueuedOctets + 1));
  assert.deepEqual([one.size, one.hasRoom], [1, false]);
});

test('early frames are kept by place and life, 64 of them and 256 KiB, each for a second', () => {
  const frame = (sequence, size = 0, life = 7n) => ({ kind: kinds.message, life, sequence, payload: Buffer.alloc(size) });
  const sequences = (frames) => frames.map(({ sequence }) => sequence);
  const early = new EarlyFrames();
  for (const [i, [where, life]] of [['a', 7n], ['b', 7n], ['a', 8n], ['a', 7n]].entries()) early.put(where, frame(i, 1, life), 0);
  assert.deepEqual(sequences(early.take('a', 7n, 0)), [0, 3]);
  assert.deepEqual(sequences(early.take('a', 7n, 0)), []);
  assert.deepEqual(sequences(early.take('b', 7n, 0)), [1]);
  assert.deepEqual(sequences(early.take('a', 8n, 0)), [2]);
  for (const [count, first] of [[limits.maxEarlyFrames - 1, 0], [limits.maxEarlyFrames, 0], [limits.maxEarlyFrames + 1, 1]]) {
    for (let i = 0; i < count; ++i) early.put('a', frame(i), 0);
    const kept = sequences(early.take('a', 7n, 0));
    assert.deepEqual([kept.length, kept[0]], [count - first, first]);
  }
  const eighth = limits.maxEarlyOctets / 8;
  for (const [size, kept] of [[eighth - 1, 8], [eighth, 8], [eighth + 1, 7]]) {
    for (let i = 0; i < 8; ++i) early.put('a', frame(i, size), 0);
    assert.equal(early.take('a', 7n, 0).length, kept);
  }
  for (const [later, kept] of [[limits.earlyPatience - 1, [1, 2]], [limits.earlyPatience, [2]], [2 * limits.earlyPatience, []]]) {
    early.put('a', frame(1), 0);
    early.put('a', frame(2), 1);
    assert.deepEqual(sequences(early.take('a', 7n, later)), kept);
  }
});

test('conversions follow the chain, or the one function that does it all', () => {
  const add = (word) => (octets) => Buffer.concat([octets, Buffer.from(word)]);
  const conversions = new Converter({ 'A>B': add('1'), 'B>C': add('2') });
  assert.equal(String(conversions.along('A>B>C')(Buffer.from('x'))), 'x12');
  conversions.set('A>C', add('3'));
  assert.equal(String(conversions.along('A>B>C')(Buffer.from('x'))), 'x3');
  assert.throws(() => conversions.along('A>B>D')(Buffer.alloc(0)), /no function for the conversion B>D$/);
  const served = conversions.along('A>B>D', '-,udp://10.0.0.7:6000/9c0d1e2f/1/1');
  assert.throws(() => served(Buffer.alloc(0)), /B>D, which the service udp:\/\/10.0.0.7:6000\/9c0d1e2f\/1\/1 does$/);
  conversions.set('<http://e/#A>>B', add('4'));
  assert.equal(String(conversions.along('<http://e/#A>>B>C')(Buffer.from('x'))), 'x42');
  conversions.set('B>D', () => 'text');
  assert.throws(() => conversions.along('A>B>D')(Buffer.alloc(0)), /B>D gave no Uint8Array/);
  conversions.set('B>D', () => JSON.parse('{'));
  assert.throws(() => conversions.along('A>B>D')(Buffer.alloc(0)), /B>D failed/);
  assert.throws(() => conversions.set('AB', add('')), TypeError);
  assert.throws(() => conversions.set('A>B', 1), TypeError);
});

test('addresses are compared in one spelling, with their zone', () => {
  assert.equal(canonicalAddress('::ffff:10.0.0.1'), '10.0.0.1');
  assert.equal(canonicalAddress('2001:DB8:0:0::1'), '2001:db8::1');
  assert.equal(canonicalAddress('fe80::1%eth0'), 'fe80::1%eth0');
  assert.notEqual(canonicalAddress('fe80::1%eth0'), canonicalAddress('fe80::1%eth1'));
  for (const bad of ['robot2', '', undefined, '1.2.3', '1.2.3.4%eth0']) assert.equal(canonicalAddress(bad), undefined);
  assert.deepEqual(['ff02::1', 'ff11::1', 'FF12::1', 'ff02::1%eth0', 'ff05::1', 'fe80::1', '224.0.0.1'].map(isOfSomeLink),
    [true, true, true, false, false, false, false]);
  assert.deepEqual(['239.0.0.1', '224.0.0.1', 'ff02::1', '10.0.0.1', '240.0.0.1', 'fe80::1'].map(isMulticast),
    [true, true, true, false, false, false]);
});

test('only the life of this place is believed', () => {
  const places = new Senders();
  const channel = { life: 7n };
  places.set('10.0.0.1 5000', channel);
  const message = encodeFrame(kinds.message, 7n, 1n, Buffer.from('x'));
  assert.equal(places.take('10.0.0.1 5000', message).channel, channel);
  assert.equal(places.take('10.0.0.1 5001', message), undefined);
  assert.equal(places.take('10.0.0.2 5000', message), undefined);
  assert.equal(places.take('10.0.0.1 5000', encodeFrame(kinds.message, 8n, 1n)), undefined);
  assert.equal(places.take('10.0.0.1 5000', Buffer.from('anything')), undefined);
  assert.equal(places.take('10.0.0.1 5000', encodeFrame(kinds.hello, 7n, 0n)), undefined);
  const plain = { life: 0n };
  places.set('10.0.0.1 5000', plain);
  assert.equal(places.take('10.0.0.1 5000', message).channel, channel);
  const taken = places.take('10.0.0.1 5000', Buffer.from('anything'));
  assert.equal(taken.channel, plain);
  assert.equal(String(taken.frame.payload), 'anything');
  places.delete('10.0.0.1 5000', channel);
  places.delete('10.0.0.1 5000', plain);
  assert.equal(places.take('10.0.0.1 5000', message), undefined);
});

test('listeners are 1024 at most, shared by address, and are forgotten after 3 s', () => {
  const listeners = new Listeners();
  const of = (address, port, heard = 0, counter = 0n) => ({ address, port, life: BigInt(port), challenge: 1n, heard, counter });
  for (let port = 1; port <= limits.maxListeners - 1; ++port) assert.ok(listeners.add(of('10.0.0.1', port)).isTaken);
  assert.deepEqual(listeners.add(of('10.0.0.1', limits.maxListeners)), { isTaken: true, loser: undefined });
  assert.equal(listeners.add(of('10.0.0.1', limits.maxListeners + 1)).isTaken, false);
  assert.equal(listeners.size, limits.maxListeners);
  const { isTaken, loser } = listeners.add(of('10.0.0.2', 7, 2000));
  assert.deepEqual([isTaken, loser.port, listeners.get('10.0.0.1', limits.maxListeners)], [true, limits.maxListeners, undefined]);
  listeners.expire(limits.listenerPatience - 1);
  assert.equal(listeners.size, limits.maxListeners);
  listeners.expire(limits.listenerPatience);
  assert.deepEqual([...listeners.values()].map(({ address }) => address), ['10.0.0.2']);
  assert.ok(listeners.places.hasRoomAgain);
  listeners.end({ address: '10.0.0.2', port: 7 });
  listeners.add(of('10.0.0.3', 1, 2000, 5n));
  listeners.end({ address: '10.0.0.3', port: 1 });
  assert.equal(listeners.size, 0);
});

test('endpoints are read as the other clients read them', () => {
  assert.deepEqual(endpointOf('127.0.0.1:4717'), { host: '127.0.0.1', port: 4717 });
  assert.deepEqual(endpointOf('[::1]:4717'), { host: '::1', port: 4717 });
  assert.deepEqual(endpointOf('/run/geminga'), { path: '/run/geminga' });
  assert.deepEqual(endpointOf('unix:x'), { path: 'x' });
  for (const bad of ['', 'x', '127.0.0.1', '127.0.0.1:0', '127.0.0.1:65536', '::1:4717', '[::1]', 'unix:']) {
    assert.throws(() => endpointOf(bad), TypeError, bad);
  }
});
