// A recording of geminga-query record as the history that the page goes back and forth in.
#ifndef GEMINGA_WEB_RECORDING_HPP
#define GEMINGA_WEB_RECORDING_HPP

#include <expected>
#include <string>

#include "web/site/history.hpp"

namespace geminga::web {

/// Reads the whole recording, a moment a second. Where it has more than is kept, its last part is; that, and lines that
/// cannot be read, are told on standard error. The error is one line.
[[nodiscard]] std::expected<void, std::string> read_recording(const std::string& file, History& history);

}  // namespace geminga::web

#endif
