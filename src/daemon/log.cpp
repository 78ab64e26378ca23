#include "daemon/log.hpp"

#include <spdlog/logger.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>

#include "base/text.hpp"

namespace geminga::daemon {
namespace {

/// The longest line; a longer one is cut.
constexpr std::size_t max_line_bytes = 4096;

spdlog::level::level_enum severity(base::LogLevel level) {
  switch (level) {
    case base::LogLevel::debug:
      return spdlog::level::debug;
    case base::LogLevel::info:
      return spdlog::level::info;
    case base::LogLevel::warning:
      return spdlog::level::warn;
    case base::LogLevel::error:
      return spdlog::level::err;
  }
  return spdlog::level::err;
}

}  // namespace

class Log::State {
 public:
  State() : logger("gemingad", std::make_shared<spdlog::sinks::stderr_sink_st>()) {
    logger.set_error_handler([](const std::string&) {});
    logger.flush_on(spdlog::level::debug);
  }

  spdlog::logger logger;
  LogFormat format = LogFormat::text;
};

Log::Log(base::LogLevel level, LogFormat format) : state_(std::make_unique<State>()) { set(level, format); }
Log::~Log() = default;

void Log::set(base::LogLevel level, LogFormat format) {
  state_->format = format;
  state_->logger.set_level(severity(level));
  state_->logger.set_pattern(format == LogFormat::json ? R"({"time":"%Y-%m-%dT%H:%M:%S.%e%z","level":"%l","text":%v})"
                                                       : "%Y-%m-%dT%H:%M:%S.%e %-7l %v");
}

void Log::write(base::LogLevel level, std::string_view line) {
  const auto severe = severity(level);
  if (!state_->logger.should_log(severe)) return;
  const std::string text = base::printable(line, max_line_bytes);
  if (state_->format == LogFormat::text) {
    state_->logger.log(severe, spdlog::string_view_t(text));
    return;
  }
  const std::string quoted = boost::json::serialize(boost::json::string(text));
  state_->logger.log(severe, spdlog::string_view_t(quoted));
}

}  // namespace geminga::daemon
