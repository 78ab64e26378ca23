// The daemon's log: lines on standard error, as text or as one JSON object each, or entries of systemd's journal.
#ifndef GEMINGA_DAEMON_LOG_LOG_HPP
#define GEMINGA_DAEMON_LOG_LOG_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/log.hpp"
#include "daemon/configuration/configuration.hpp"
#include "daemon/log/journal_writer.hpp"

namespace spdlog {
class logger;
}

namespace geminga::daemon {

class Log final : public base::LogSink {
 public:
  /// Writes to the journal at this path if standard error is a stream to the journal (environment variable
  /// JOURNAL_STREAM, systemd.exec(5)), so that an entry keeps its level and fields; to standard error otherwise.
  Log(base::LogLevel level, LogFormat format, const std::string& journal = JournalWriter::default_path);
  ~Log() override;
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  /// Drops lines that are less severe than `level` from now on.
  void set(base::LogLevel level, LogFormat format);
  /// Writes a line and never waits. A line that cannot be written (a reader that does not read, a full disk, a closed
  /// terminal) is dropped and counted.
  void write(base::LogLevel level, std::string_view line, const base::LogFields& fields) override;
  using base::LogSink::write;
  /// Writes why configuration or ontologies could not be read again, and what is kept instead.
  void write_failed_reading(const std::vector<std::string>& errors, const std::string& kept);
  /// Writes how many lines were dropped since this was said last, as soon as there is room for it. Costs nothing where
  /// none was.
  void catch_up() { (void)has_caught_up(); }
  /// Lines dropped since the start.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

 private:
  class Sink;

  bool has_caught_up();
  bool put(base::LogLevel level, const std::string& text, const base::LogFields& fields);

  std::optional<JournalWriter> journal_;
  std::shared_ptr<Sink> sink_;  ///< shared with the logger
  std::unique_ptr<spdlog::logger> logger_;
  base::LogLevel level_ = base::LogLevel::info;
  LogFormat format_ = LogFormat::text;
  std::uint64_t dropped_ = 0;
  std::uint64_t told_ = 0;  ///< dropped lines that the log tells of
};

}  // namespace geminga::daemon

#endif
