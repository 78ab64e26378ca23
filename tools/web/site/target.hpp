// The target of a request: a path and parameters.
#ifndef GEMINGA_WEB_SITE_TARGET_HPP
#define GEMINGA_WEB_SITE_TARGET_HPP

#include <expected>
#include <string>
#include <string_view>

#include "web/asking/asker.hpp"

namespace geminga::web {

/// `/PATH?KEY=VALUE&...` (RFC 9112, 3.2.1), decoded.
struct Target {
  std::string path;
  Parameters parameters{};
};

/// Reads a target. `+` and %20 of a value are blanks, as forms and URLSearchParams write them. The error is one line:
/// another form than that of a path, a text that is no UTF-8 or has control characters, or too many parameters.
[[nodiscard]] std::expected<Target, std::string> read_target(std::string_view text);

}  // namespace geminga::web

#endif
