// The log as every part of the daemon sees it, which does not know who writes it down.
#ifndef GEMINGA_BASE_LOG_HPP
#define GEMINGA_BASE_LOG_HPP

#include <string_view>

namespace geminga::base {

enum class LogLevel { debug, info, warning, error };

/// The subject of a line, for logs that keep fields beside the text. Each is empty where it does not apply.
struct LogFields {
  std::string_view participant = {};  ///< the identifier of a participant, as the tools print it
  std::string_view peer = {};         ///< the name of a local client
  std::string_view code = {};         ///< a word for the kind of event, the same in every version: `clash`
};

/// Takes one line at a time. The daemon writes the lines with spdlog; the simulator keeps or drops them.
class LogSink {
 public:
  virtual ~LogSink() = default;
  /// `line` is one line without its end, made printable by the caller. The fields are borrowed for the call.
  virtual void write(LogLevel level, std::string_view line, const LogFields& fields) = 0;
  void write(LogLevel level, std::string_view line) { write(level, line, {}); }
};

}  // namespace geminga::base

#endif
