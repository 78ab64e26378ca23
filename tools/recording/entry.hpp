// The lines of a recording, as values and as JSON (tools/recording/RECORDING.md).
#ifndef GEMINGA_RECORDING_ENTRY_HPP
#define GEMINGA_RECORDING_ENTRY_HPP

#include <chrono>
#include <cstddef>
#include <expected>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::recording {

inline constexpr std::string_view format_name = "geminga-recording";
/// The version that is written, and the only one that is read.
inline constexpr int format_version = 1;
/// The longest line, its end not counted. A longer one is not written, and skipped when it is read.
inline constexpr std::size_t max_line_bytes = std::size_t{1} * 1024 * 1024;

/// A time since the beginning of the recording, by a clock that never jumps.
using At = std::chrono::milliseconds;
/// A time by the clock of the recording host, in UTC.
using Time = std::chrono::sys_time<std::chrono::milliseconds>;

/// All that is known begins anew with the next `records` lines, each of which is a Present::Change::there.
struct Snapshot {
  std::string participant;  ///< the daemon that was asked
  std::string name;         ///< of its host
  std::string ontology;     ///< its digest, or `-`
  std::size_t records = 0;
};

/// A participant, a service or a request is there, came, or changed. The whole of it is told each time.
struct Present {
  enum class Change { there, add, modify };
  Change change = Change::there;
  Record record;  ///< of the kind participants, services or requests
};

struct Gone {
  std::string kind;
  std::string key;
  std::string reason;  ///< withdrawn, or gone with its participant
};

/// When each participant was last heard, and its loss.
struct Heard {
  std::vector<Record> records;
};

/// The daemon's answer to a query about itself, or to `why` about one request. It replaces the former one.
struct Answered {
  std::string kind;
  std::string subscription;  ///< of `why`
  Answer answer;
};

/// So many rounds of questions were not written, because of the limit.
struct Skipped {
  std::size_t rounds = 0;
};

/// The daemon could not be asked any more. The next line is a snapshot, or the end.
struct Lost {
  std::string text;
};

struct End {
  std::string reason;
};

/// An event that this version does not know, which means nothing to it.
struct Unknown {};

using Event = std::variant<Snapshot, Present, Gone, Heard, Answered, Skipped, Lost, End, Unknown>;

struct Entry {
  At at{};
  Time time{};
  Event event;
};

/// The field that names a record of this kind for its whole life; empty for another kind.
[[nodiscard]] std::string_view key_field(std::string_view kind);

/// The entry as one line of JSON with its end. Requires an event that is not Unknown.
[[nodiscard]] std::string line_of(const Entry& entry);

/// A line of a recording that cannot be used.
struct BadLine {
  std::string text;               ///< one half sentence: what is wrong
  bool is_other_version = false;  ///< nothing behind it can be read, either
};

/// Reads a line without its end. What it gives can be told in GCNP: keys are words, and no record is over a line there.
[[nodiscard]] std::expected<Entry, BadLine> read_line(std::string_view line);

}  // namespace geminga::recording

#endif
