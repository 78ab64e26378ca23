// Compiled, never run: how the package is used from TypeScript.
import {
  AbortError, ClosedError, connect, GemingaError, identity, lifeText, limits, Message, MessageTooLargeError, Mode, Node, Peer,
  PortError, Publisher, RefusedError, StatementError, Subscriber,
} from 'geminga';

export async function use(signal: AbortSignal): Promise<number> {
  const node: Node = await connect({ name: 'vision', daemon: '127.0.0.1:4717', log: (line) => line.length, signal });
  const mode: Mode = 'otm/pubsub';
  const publisher: Publisher = await node.publish({
    mode, concept: 'soccer:BallInfo', representation: 'soccer:Pixels', protocol: 'tcp', for: 'rate > 3', scope: 'any',
    attributes: { rate: 30, calibrated: true }, signal,
  });
  publisher.on('consumer', ({ change, reason, life, name }) => lifeText(life) + change + (reason ?? '') + (name ?? ''));
  if (!publisher.send(new Uint8Array(8))) await publisher.drained({ signal });
  await publisher.modify({ attributes: { rate: 15 } });
  const subscriber: Subscriber = node.subscribe({
    mode: 'oto', id: 7, provider: ['robot2', 'robot3'], convert: true, on: 'a:Robot', limit: 2, queue: 16, signal,
    conversions: { 'a:A>a:B': (payload) => payload.subarray(1) },
  });
  subscriber.convert('a:B>a:C', (payload) => payload);
  node.once('disconnected', () => undefined).on('connected', (hello) => hello.participant.length);
  subscriber.once('problem', (error: Error) => error.message);
  await (await subscriber.ready({ signal })).modify({ where: 'rate > 5', prefer: 'rate desc' });
  const one: Message | undefined = await subscriber.receive({ signal });
  let octets = one?.payload.length ?? 0;
  for await (const { payload, missed, sequence, provider } of subscriber) {
    const from: Peer = provider;
    octets += payload.length + missed + Number(sequence) + from.distance + limits.maxDatagramMessage;
  }
  await node.unref().ref().close();
  return octets + identity({ text: 'x' }) + identity({ expression: 'x' }) + new Node().hello!.peer.length;
}

export function explain(error: unknown): string {
  if (error instanceof RefusedError || error instanceof StatementError) return String(error.status);
  if (error instanceof PortError) return String(error.port);
  if (error instanceof MessageTooLargeError) return String(error.limit);
  if (error instanceof ClosedError || error instanceof AbortError || error instanceof GemingaError) return error.code;
  return '';
}

export async function misuse(node: Node): Promise<void> {
  // @ts-expect-error: there is no such mode
  await node.publish({ mode: 'otm', text: 'x' });
  // @ts-expect-error: one identity
  await node.publish({ mode: 'oto', text: 'x', id: 7 });
  // @ts-expect-error: attributes stand in attributes
  node.subscribe({ mode: 'oto', text: 'x', rate: 3 });
  // @ts-expect-error: octets
  (await node.publish({ mode: 'oto', text: 'x' })).send('text');
  // @ts-expect-error: no such option
  new Node({ nmae: 'x' });
  // @ts-expect-error: no such event
  node.on('connect', () => undefined);
}
