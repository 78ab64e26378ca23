// Prints what hello-publishers of any language say: node hello-subscriber.mjs [COUNT]
import { connect } from 'geminga';

let left = Number(process.argv[2] ?? Infinity);
const node = await connect({ name: 'hello-subscriber' });
const subscriber = node.subscribe({ mode: 'otm/pubsub', text: 'hello' });
subscriber.on('provider', ({ change, name, participantName }) => console.log(`${change}: ${name} on ${participantName}`));
process.once('SIGINT', () => node.close());

for await (const { payload, missed } of subscriber) {
  console.log(Buffer.from(payload).toString() + (missed > 0 ? ` (${missed} missed)` : ''));
  if (--left === 0) break;
}
await node.close();
