// Says hello to whoever asks, ten times a second: node hello-publisher.mjs [COUNT]
import { setTimeout } from 'node:timers/promises';

import { connect } from 'geminga';

const count = Number(process.argv[2] ?? Infinity);
const node = await connect({ name: 'hello-publisher' });
const publisher = await node.publish({ mode: 'otm/pubsub', text: 'hello', attributes: { language: 'javascript' } });
console.log(`offers hello at port ${publisher.port}`);
publisher.on('consumer', ({ change, name }) => console.log(`${change}: ${name ?? 'somebody'}`));
process.once('SIGINT', () => node.close());

for (let i = 1; i <= count && node.isConnected; await setTimeout(100)) {
  if (publisher.hasConsumer) publisher.send(Buffer.from(`hello ${i++}`));
}
await node.close();
