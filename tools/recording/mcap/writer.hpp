// Writes an MCAP file (https://mcap.dev/spec): channels of messages with schemas, in chunks with an index.
#ifndef GEMINGA_RECORDING_MCAP_WRITER_HPP
#define GEMINGA_RECORDING_MCAP_WRITER_HPP

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geminga::recording::mcap {

/// The octets of messages after which a chunk ends. Larger: fewer entries in the index. Smaller: a reader that seeks
/// reads less.
inline constexpr std::size_t chunk_bytes = std::size_t{1} * 1024 * 1024;

/// Nanoseconds since 1970.
using Timestamp = std::uint64_t;

/// Writes the parts in the order in which they are called. Chunks are not compressed: tools that read MCAP, and zstd,
/// do that afterwards. Whether the stream could be written, its state says. Not thread-safe.
class Writer {
 public:
  /// Begins the file. Borrows the stream for its life. `library` names the program.
  Writer(std::ostream& out, std::string_view library);

  /// Adds a channel of messages in JSON. Returns its number.
  std::uint16_t add_channel(std::string_view topic, std::string_view schema_name, std::string_view json_schema);
  /// Adds a message. Requires a channel that add_channel() gave.
  void write(std::uint16_t channel, Timestamp log_time, Timestamp publish_time, std::string_view message);
  /// Writes the last chunk, the summary and the end. To be called once, last.
  void finish();

 private:
  using Index = std::map<std::uint16_t, std::vector<std::pair<Timestamp, std::uint64_t>>>;
  struct Chunk {
    Timestamp begin = 0;
    Timestamp end = 0;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
    std::uint64_t index_length = 0;
    std::uint64_t records_length = 0;
  };

  void put(std::string_view octets);
  void end_chunk();
  void put_summary();
  [[nodiscard]] std::string statistics() const;

  std::ostream& out_;
  std::uint64_t offset_ = 0;
  std::string schemas_;
  std::string channels_;
  std::uint16_t count_ = 0;
  std::string records_;  ///< of the present chunk
  Index index_;          ///< of the present chunk
  Timestamp chunk_begin_ = 0;
  Timestamp chunk_end_ = 0;
  std::vector<Chunk> chunks_;
  std::map<std::uint16_t, std::uint64_t> messages_;  ///< of each channel
};

}  // namespace geminga::recording::mcap

#endif
