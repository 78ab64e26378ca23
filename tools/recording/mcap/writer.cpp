#include "recording/mcap/writer.hpp"

#include <zlib.h>

#include <algorithm>
#include <concepts>

namespace geminga::recording::mcap {
namespace {

constexpr std::string_view magic("\x89MCAP0\r\n", 8);

/// The kinds of records (https://mcap.dev/spec, "Opcodes").
enum class Opcode : unsigned char {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0b,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

/// Appends a number, the least octet first.
template <std::unsigned_integral Number>
void append(std::string& out, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i) {
    out += static_cast<char>(static_cast<unsigned char>(static_cast<std::uint64_t>(number) >> (8 * i)));
  }
}

/// Appends a text, or an array that is written already, with its length in octets.
void append_text(std::string& out, std::string_view text) {
  append(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

std::string record(Opcode opcode, std::string_view content) {
  std::string out(1, static_cast<char>(opcode));
  append(out, static_cast<std::uint64_t>(content.size()));
  out += content;
  return out;
}

std::uint32_t crc(std::string_view octets) {
  return static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const unsigned char*>(octets.data()), octets.size()));
}

std::string map_of(const std::map<std::uint16_t, std::uint64_t>& numbers) {
  std::string out;
  for (const auto& [key, number] : numbers) {
    append(out, key);
    append(out, number);
  }
  return out;
}

}  // namespace

Writer::Writer(std::ostream& out, std::string_view library) : out_(out) {
  std::string header;
  append_text(header, "");  // no profile: messages are in JSON
  append_text(header, library);
  put(magic);
  put(record(Opcode::header, header));
}

void Writer::put(std::string_view octets) {
  out_.write(octets.data(), static_cast<std::streamsize>(octets.size()));
  offset_ += octets.size();
}

std::uint16_t Writer::add_channel(std::string_view topic, std::string_view schema_name, std::string_view json_schema) {
  const std::uint16_t number = ++count_;  // of the schema, too; 0 would be no schema
  std::string schema;
  append(schema, number);
  append_text(schema, schema_name);
  append_text(schema, "jsonschema");
  append_text(schema, json_schema);
  std::string channel;
  append(channel, number);
  append(channel, number);
  append_text(channel, topic);
  append_text(channel, "json");
  append_text(channel, "");  // no metadata
  const std::string schema_record = record(Opcode::schema, schema);
  const std::string channel_record = record(Opcode::channel, channel);
  schemas_ += schema_record;
  channels_ += channel_record;
  records_ += schema_record + channel_record;  // a chunk tells of the channels that begin with it
  return number;
}

void Writer::write(std::uint16_t channel, Timestamp log_time, Timestamp publish_time, std::string_view message) {
  const bool is_first = index_.empty();
  chunk_begin_ = is_first ? log_time : std::min(chunk_begin_, log_time);
  chunk_end_ = is_first ? log_time : std::max(chunk_end_, log_time);
  index_[channel].emplace_back(log_time, records_.size());
  std::string content;
  append(content, channel);
  append(content, static_cast<std::uint32_t>(++messages_[channel]));
  append(content, log_time);
  append(content, publish_time);
  content += message;
  records_ += record(Opcode::message, content);
  if (records_.size() >= chunk_bytes) end_chunk();
}

void Writer::end_chunk() {
  if (records_.empty()) return;
  Chunk chunk;
  chunk.begin = chunk_begin_;
  chunk.end = chunk_end_;
  chunk.offset = offset_;
  chunk.records_length = records_.size();
  std::string content;
  append(content, chunk.begin);
  append(content, chunk.end);
  append(content, chunk.records_length);
  append(content, crc(records_));
  append_text(content, "");  // no compression
  append(content, chunk.records_length);
  content += records_;
  put(record(Opcode::chunk, content));
  chunk.length = offset_ - chunk.offset;
  for (const auto& [channel, messages] : index_) {
    std::string entries;
    for (const auto& [time, offset] : messages) {
      append(entries, time);
      append(entries, offset);
    }
    std::string index;
    append(index, channel);
    append_text(index, entries);
    chunk.index_offsets.emplace(channel, offset_);
    put(record(Opcode::message_index, index));
  }
  chunk.index_length = offset_ - chunk.offset - chunk.length;
  chunks_.push_back(std::move(chunk));
  records_.clear();
  index_.clear();
}

std::string Writer::statistics() const {
  std::uint64_t messages = 0;
  for (const auto& [channel, count] : messages_) messages += count;
  Timestamp begin = 0;
  Timestamp end = 0;
  for (const Chunk& chunk : chunks_) {
    begin = &chunk == &chunks_.front() ? chunk.begin : std::min(begin, chunk.begin);
    end = std::max(end, chunk.end);
  }
  std::string content;
  append(content, messages);
  append(content, count_);                              // schemas
  append(content, static_cast<std::uint32_t>(count_));  // channels
  append(content, std::uint32_t{0});                    // attachments
  append(content, std::uint32_t{0});                    // metadata
  append(content, static_cast<std::uint32_t>(chunks_.size()));
  append(content, begin);
  append(content, end);
  append_text(content, map_of(messages_));
  return record(Opcode::statistics, content);
}

void Writer::put_summary() {
  const std::uint64_t summary_begin = offset_;
  std::string indices;
  for (const Chunk& chunk : chunks_) {
    std::string content;
    append(content, chunk.begin);
    append(content, chunk.end);
    append(content, chunk.offset);
    append(content, chunk.length);
    append_text(content, map_of(chunk.index_offsets));
    append(content, chunk.index_length);
    append_text(content, "");  // no compression
    append(content, chunk.records_length);
    append(content, chunk.records_length);
    indices += record(Opcode::chunk_index, content);
  }
  std::string summary;
  std::string offsets;
  const auto add_group = [&](Opcode opcode, std::string_view group) {
    if (group.empty()) return;
    std::string content(1, static_cast<char>(opcode));
    append(content, summary_begin + summary.size());
    append(content, static_cast<std::uint64_t>(group.size()));
    offsets += record(Opcode::summary_offset, content);
    summary += group;
  };
  add_group(Opcode::schema, schemas_);
  add_group(Opcode::channel, channels_);
  add_group(Opcode::statistics, statistics());
  add_group(Opcode::chunk_index, indices);
  const std::uint64_t offsets_begin = summary_begin + summary.size();
  // The checksum covers the summary and the footer up to the checksum itself.
  std::string footer(1, static_cast<char>(Opcode::footer));
  append(footer, std::uint64_t{20});
  append(footer, summary_begin);
  append(footer, offsets_begin);
  const std::uint32_t checksum = crc(summary + offsets + footer);
  append(footer, checksum);
  put(summary);
  put(offsets);
  put(footer);
}

void Writer::finish() {
  end_chunk();
  std::string data_end;
  append(data_end, std::uint32_t{0});  // no checksum of the data section: each chunk has its own
  put(record(Opcode::data_end, data_end));
  put_summary();
  put(magic);
  out_.flush();
}

}  // namespace geminga::recording::mcap
