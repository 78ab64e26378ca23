// The gate: the checks that a request passes before anything is answered.
#ifndef GEMINGA_WEB_SITE_GATE_HPP
#define GEMINGA_WEB_SITE_GATE_HPP

#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "web/site/request.hpp"
#include "web/site/response.hpp"

namespace geminga::web {

/// The path that is answered without a token: it tells nothing but that the program lives.
inline constexpr std::string_view open_path = "/livez";

/// The conditions for a request.
struct Rules {
  /// Names under which the program may be addressed, beside `localhost` and IP addresses in numbers. A page of another
  /// site can have its name lead to this host (DNS rebinding), and then asks by that name.
  std::vector<std::string> names{};
  /// The secret of `Authorization: Bearer TOKEN` (RFC 6750, 2.1); empty: none is asked for.
  std::string token{};
};

/// The host of a `Host` field without its port, in lower case and without the brackets of IPv6; nothing where the field
/// is none (RFC 9110, 7.2).
[[nodiscard]] std::optional<std::string> host_of(std::string_view field);

/// The refusal of a request; nothing: it may be answered. 405 for another method than GET and HEAD, 414 for a long
/// target, 400 and 421 for the `Host`, 401 for the token, which is compared in constant time.
[[nodiscard]] std::optional<Response> refuse(const Request& request, const Rules& rules);

/// The error of a token, without the token; empty: none. At least min_token_octets of what RFC 6750 allows.
[[nodiscard]] std::string complaint_about_token(std::string_view token);

}  // namespace geminga::web

#endif
