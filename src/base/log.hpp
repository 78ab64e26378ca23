// The log as every part of the daemon sees it, which does not know who writes it down.
#ifndef GEMINGA_BASE_LOG_HPP
#define GEMINGA_BASE_LOG_HPP

#include <string_view>

namespace geminga::base {

enum class LogLevel { debug, info, warning, error };

/// Takes one line at a time. The daemon writes the lines with spdlog; the simulator keeps or drops them.
class LogSink {
 public:
  virtual ~LogSink() = default;
  /// `line` is one line without its end, made printable by the caller.
  virtual void write(LogLevel level, std::string_view line) = 0;
};

}  // namespace geminga::base

#endif
