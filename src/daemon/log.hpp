// The daemon's log: lines on standard error, as text or as one JSON object each.
#ifndef GEMINGA_DAEMON_LOG_HPP
#define GEMINGA_DAEMON_LOG_HPP

#include <cstdint>
#include <memory>
#include <string_view>

#include "base/log.hpp"
#include "daemon/configuration.hpp"

namespace geminga::daemon {

class Log final : public base::LogSink {
 public:
  Log(base::LogLevel level, LogFormat format);
  ~Log() override;
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  /// What is less severe than `level` is dropped from now on.
  void set(base::LogLevel level, LogFormat format);
  /// Never waits. A line that cannot be written (a reader that does not read, a full disk, a closed terminal) is
  /// dropped and counted; nobody else is to suffer from it.
  void write(base::LogLevel level, std::string_view line) override;
  /// Says how many lines were dropped since this was said last, as soon as there is room for it. Costs nothing where
  /// none was.
  void catch_up();
  /// Lines dropped since the start.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::daemon

#endif
