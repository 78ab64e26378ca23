// Writes entries with fields to systemd's journal without waiting.
#ifndef GEMINGA_DAEMON_LOG_JOURNAL_WRITER_HPP
#define GEMINGA_DAEMON_LOG_JOURNAL_WRITER_HPP

#include <optional>
#include <string>
#include <string_view>

#include "base/log.hpp"

namespace geminga::daemon {

/// Whether a descriptor is the stream that `variable`, the value of $JOURNAL_STREAM, names by device and inode.
[[nodiscard]] bool is_journal_stream(int descriptor, std::string_view variable);

/// The journal's own protocol (systemd.io/JOURNAL_NATIVE_PROTOCOL): one datagram an entry, sent through a socket that
/// is connected before the daemon closes its cage. libsystemd would open one for each entry.
class JournalWriter {
 public:
  static constexpr const char* default_path = "/run/systemd/journal/socket";

  /// Connects to the journal's socket. Nothing where no process listens there.
  [[nodiscard]] static std::optional<JournalWriter> open(const std::string& path);
  ~JournalWriter();
  JournalWriter(JournalWriter&& other) noexcept;
  JournalWriter& operator=(JournalWriter&& other) noexcept;

  /// Writes MESSAGE, PRIORITY and SYSLOG_IDENTIFIER, and GEMINGA_PARTICIPANT, GEMINGA_PEER and GEMINGA_CODE where they
  /// are not empty. False: the journal has no room, or is gone, and the entry is dropped.
  [[nodiscard]] bool write(base::LogLevel level, std::string_view text, const base::LogFields& fields) const;

 private:
  explicit JournalWriter(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace geminga::daemon

#endif
