#include "daemon/log/log.hpp"

#include <spdlog/details/null_mutex.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>
#include <unistd.h>

#include <boost/json/serialize.hpp>
#include <boost/json/string.hpp>
#include <cstdlib>

#include "base/text.hpp"
#include "daemon/log/log_writer.hpp"

namespace geminga::daemon {
namespace {

/// The most octets of a line; a longer one is cut.
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

/// Hands formatted lines to the writer.
class Log::Sink final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 public:
  [[nodiscard]] bool is_written() const { return is_written_; }
  /// Writes the rest of a line whose beginning is written already.
  bool write_rest() { return writer_.finish_begun(); }

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    is_written_ = writer_.write({line.data(), line.size()});
  }
  void flush_() override {}

  LogWriter writer_{STDERR_FILENO};
  bool is_written_ = true;  ///< the last line is written
};

Log::Log(base::LogLevel level, LogFormat format, const std::string& journal)
    : sink_(std::make_shared<Sink>()), logger_(std::make_unique<spdlog::logger>("gemingad", sink_)) {
  if (const char* stream = std::getenv("JOURNAL_STREAM"); stream != nullptr && is_journal_stream(STDERR_FILENO, stream))
    journal_ = JournalWriter::open(journal);
  logger_->set_error_handler([](const std::string&) {});
  logger_->set_level(spdlog::level::trace);  // write() has the level
  set(level, format);
}
Log::~Log() = default;

void Log::set(base::LogLevel level, LogFormat format) {
  level_ = level;
  format_ = format;
  logger_->set_pattern(format == LogFormat::json ? R"({"time":"%Y-%m-%dT%H:%M:%S.%e%z","level":"%l","text":%v})"
                                                 : "%Y-%m-%dT%H:%M:%S.%e %-7l %v");
}

void Log::write(base::LogLevel level, std::string_view line, const base::LogFields& fields) {
  if (level < level_) return;
  if (!has_caught_up() || !put(level, base::printable(line, max_line_bytes), fields)) ++dropped_;
}

void Log::write_failed_reading(const std::vector<std::string>& errors, const std::string& kept) {
  for (const std::string& error : errors) write(base::LogLevel::error, error);
  write(base::LogLevel::error, "reading failed: " + kept);
}

/// True where no dropped line is left to be told of.
bool Log::has_caught_up() {
  if (!sink_->write_rest()) return false;
  const std::uint64_t missing = dropped_ - told_;
  if (missing == 0) return true;
  // Written whatever the level is: a reader of errors alone has to know that some are missing.
  if (!put(
          base::LogLevel::warning,
          std::to_string(missing) + (missing == 1 ? " line" : " lines") + " of this log dropped: nobody was reading it",
          {.code = "log_dropped"})) {
    return false;
  }
  told_ = dropped_;
  return true;
}

bool Log::put(base::LogLevel level, const std::string& text, const base::LogFields& fields) {
  if (journal_) return journal_->write(level, text, fields);
  const std::string words = format_ == LogFormat::text ? text : boost::json::serialize(boost::json::string(text));
  logger_->log(severity(level), spdlog::string_view_t(words));
  return sink_->is_written();
}

}  // namespace geminga::daemon
