// Another project that finds the unpacked package and runs, without a daemon: node use.mjs VERSION
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';

import { AbortError, connect, identity, limits, Node } from 'geminga';

const described = createRequire(import.meta.url)('geminga/package.json');
assert.equal(described.version, process.argv[2]);
for (const file of ['LICENSE', 'README.md', described.types, described.exports['.'].default]) {
  assert.ok(existsSync(new URL(`node_modules/geminga/${file}`, import.meta.url)), file);
}
assert.equal(identity({ text: 'vision' }), 807676232);
assert.equal(limits.maxDatagramMessage, 65_000);

await assert.rejects(connect({ daemon: '127.0.0.1:1', signal: AbortSignal.timeout(1) }), AbortError);
const node = new Node({ daemon: '127.0.0.1:1' });
const subscriber = node.subscribe({ mode: 'otm/pubsub', text: 'ball' });
assert.ok(subscriber.port > 0 && subscriber.life !== 0n && !node.isConnected);
await assert.rejects(import('geminga/lib/core/session.js'), { code: 'ERR_PACKAGE_PATH_NOT_EXPORTED' });
await node.close();
