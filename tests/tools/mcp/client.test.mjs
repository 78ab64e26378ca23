// geminga-query mcp with the client of @modelcontextprotocol/sdk and a real daemon: `client.test.mjs PROGRAMS ONTOLOGY PACKAGES`. Takes
// what package-lock.json names from the npm registry into PACKAGES; ends with 77 where that is not to be had.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const [programs, ontology, packages] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const patience = 20_000;

const lock = (folder) => join(folder, 'package-lock.json');
const kept = join(packages, 'node_modules/.lock');
mkdirSync(packages, { recursive: true });
for (const name of ['package.json', 'package-lock.json']) cpSync(join(here, name), join(packages, name));
if (!existsSync(kept) || readFileSync(kept, 'utf8') !== readFileSync(lock(packages), 'utf8')) {
  const words = ['ci', '--ignore-scripts', '--no-audit', '--no-fund', '--loglevel=error', '--fetch-retries=0'];
  if (spawnSync('npm', words, { cwd: packages, stdio: 'ignore' }).status !== 0) {
    console.log('NOT TESTED: @modelcontextprotocol/sdk cannot be had from the npm registry');
    process.exit(77);
  }
  cpSync(lock(packages), kept);
}
const sdk = (path) => import(pathToFileURL(join(packages, 'node_modules/@modelcontextprotocol/sdk/dist/esm', path)).href);
const { Client } = await sdk('client/index.js');
const { StdioClientTransport } = await sdk('client/stdio.js');

/** A port of 127.0.0.1 that nobody has. */
const freePort = () =>
  new Promise((found) => {
    const server = createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => found(port));
    });
  });

/** A connection, once somebody listens at the port. */
async function connection(port) {
  for (const end = Date.now() + patience; ; ) {
    const socket = await new Promise((done) => {
      const one = connect(port, '127.0.0.1', () => done(one)).on('error', () => done(undefined));
    });
    if (socket) return socket.on('error', () => {});
    assert.ok(Date.now() < end, `nobody listens at ${port}`);
    await new Promise((soon) => setTimeout(soon, 50));
  }
}

/** The lines of a peer until one that begins so. */
function until(socket, beginning) {
  return new Promise((found) => {
    let text = '';
    socket.on('data', (octets) => {
      text += octets;
      if (text.split('\n').some((line) => line.startsWith(beginning))) found();
    });
  });
}

const port = await freePort();
const flags = ['--name', 'robot', '--interface', 'lo', '--gcnp', `127.0.0.1:${port}`, '--port', String(await freePort()), '--group', `mcp-${process.pid}`];
const files = ['core.ttl', 'robot-soccer.ttl'].flatMap((file) => ['--ontology', join(ontology, file)]);
const daemon = spawn(join(programs, 'gemingad'), [...flags, ...files], { stdio: 'ignore' });
const client = new Client({ name: 'geminga-test', version: '1' });
try {
  const peer = await connection(port);
  peer.write(['0 sys hello name=vision', '1 pub create mode=otm/stream concept=soccer:BallInfo port=5000',
    '2 sub create mode=otm/stream concept=soccer:GoalInfo', '3 sub create mode=otm/stream concept=soccer:TrackedObject', ''].join('\r\n'));
  await until(peer, '3 pub add');
  await client.connect(new StdioClientTransport({ command: join(programs, 'geminga-query'), args: ['--connect', `127.0.0.1:${port}`, 'mcp'] }));
  assert.equal(client.getServerVersion().name, 'geminga-query');
  const { tools } = await client.listTools();
  for (const word of ['participants', 'services', 'requests', 'match', 'why', 'ontology']) {
    assert.ok(tools.some((tool) => tool.name === word && tool.annotations.readOnlyHint), word);
  }
  const ask = async (name, words = {}) => {
    const { content, isError } = await client.callTool({ name, arguments: words });
    return isError ? content[0].text : JSON.parse(content[0].text);
  };
  assert.equal((await ask('participants'))[0].name, 'robot');
  assert.equal((await ask('services'))[0].concept, 'soccer:BallInfo');
  assert.equal((await ask('ontology')).loaded, true);
  assert.equal((await ask('match', { concept: 'soccer:TrackedObject' }))[0].degree, 'narrower');
  const [unserved] = await ask('requests', { unmatched: true });
  assert.equal(unserved.concept, 'soccer:GoalInfo');
  assert.equal((await ask('why', { subscription: unserved.subscription })).served, false);
  assert.match(await ask('match', { concept: 'soccer:BalInfo' }), /soccer:BallInfo/);
  assert.match(await ask('match', { concpet: 'soccer:BallInfo' }), /no key 'concpet'/);
  await assert.rejects(client.callTool({ name: 'publish', arguments: {} }), /no such tool/);
  await client.ping();

  daemon.kill('SIGKILL');
  await new Promise((done) => daemon.once('exit', done));
  assert.match(await ask('status'), /gemingad/);
  console.log('geminga-query mcp answered the client of the protocol');
} finally {
  await client.close();
  daemon.kill('SIGKILL');
}
process.exit(0);
