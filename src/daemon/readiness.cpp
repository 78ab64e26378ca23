#include "daemon/readiness.hpp"

#include <utility>

namespace geminga::daemon {

Readiness::Readiness(const Supervisor& supervisor, base::LogSink& log, std::function<std::string()> line)
    : supervisor_(supervisor), log_(log), line_(std::move(line)) {}

void Readiness::begin_reload(base::Instant now) {
  supervisor_.say_reloading(now);
  is_reloading_ = true;
}

void Readiness::update(bool is_ready, bool is_loading) {
  const bool is_new = !is_told_ && is_ready;
  is_told_ = is_told_ || is_new;
  const bool has_reloaded = is_reloading_ && is_told_ && !is_loading;
  if (!is_new && !has_reloaded) return;
  is_reloading_ = is_reloading_ && !has_reloaded;
  const std::string line = line_();
  if (is_new) log_.write(base::LogLevel::info, line);
  supervisor_.say_ready(line);
}

}  // namespace geminga::daemon
