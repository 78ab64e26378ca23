// Reads the MCAP file that geminga-query makes of a recording with @mcap/core: node mcap.test.mjs RECORDING MCAP
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const [recording, file] = process.argv.slice(2);
const library = "@mcap/core"; // in the folder beside which read_mcap puts this file, not in this project
const { McapIndexedReader, McapStreamReader } = await import(library);
const lines = readFileSync(recording, "utf8").trimEnd().split("\n");
const octets = readFileSync(file);
const decode = (data) => new TextDecoder().decode(data);

// As a stream: every record, with the checksums of chunks and summary.
const stream = new McapStreamReader({ validateCrcs: true });
stream.append(octets);
const records = [];
for (let record; (record = stream.nextRecord()); ) records.push(record);
assert.ok(stream.done());
const channels = new Map(records.filter((r) => r.type === "Channel").map((r) => [r.id, r]));
const schemas = new Map(records.filter((r) => r.type === "Schema").map((r) => [r.id, r]));
const messages = records.filter((r) => r.type === "Message");
assert.deepEqual(messages.map((m) => decode(m.data)), lines, "each line is a message, in its order");
assert.equal(records.find((r) => r.type === "Statistics").messageCount, BigInt(lines.length));

const topicOf = (event) =>
  event.event === "heard" ? "heard" : event.kind ?? "recording";
let before = 0n;
for (const message of messages) {
  const event = JSON.parse(decode(message.data));
  const channel = channels.get(message.channelId);
  assert.equal(channel.topic, `/geminga/${topicOf(event)}`);
  assert.equal(channel.messageEncoding, "json");
  const schema = schemas.get(channel.schemaId);
  assert.equal(schema.encoding, "jsonschema");
  const { properties, required } = JSON.parse(decode(schema.data));
  for (const key of required) assert.ok(key in event);
  for (const key of Object.keys(event)) {
    if (!["records", "format", "version"].includes(key)) assert.ok(key in properties, `${channel.topic}: ${key}`);
  }
  assert.ok(message.logTime >= before, "time never runs backwards");
  before = message.logTime;
  assert.equal(message.publishTime, BigInt(Date.parse(event.time)) * 1_000_000n);
}

// By the index, as Foxglove does it, and one channel alone.
const indexed = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt(octets.length),
    read: async (offset, length) => octets.subarray(Number(offset), Number(offset + length)),
  },
});
const all = [];
for await (const message of indexed.readMessages()) all.push(decode(message.data));
assert.deepEqual([...all].sort(), [...lines].sort());
const services = [];
for await (const message of indexed.readMessages({ topics: ["/geminga/services"] })) services.push(decode(message.data));
assert.deepEqual(services, lines.filter((line) => JSON.parse(line).kind === "services"));
assert.ok(services.length > 0);
console.log(`${lines.length} messages read`);
