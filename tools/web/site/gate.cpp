#include "web/site/gate.hpp"

#include <algorithm>
#include <boost/url/authority_view.hpp>
#include <boost/url/host_type.hpp>
#include <boost/url/parse.hpp>

#include "base/text.hpp"
#include "web/site/limits.hpp"

namespace geminga::web {
namespace {

bool is_of_tokens(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~+/=").contains(c);
}

/// Compares in a time that depends on the lengths alone.
bool is_same_secret(std::string_view secret, std::string_view given) {
  unsigned difference = secret.size() == given.size() ? 0 : 1;
  for (std::size_t at = 0; at < given.size(); ++at) {
    difference |= static_cast<unsigned char>(given[at]) ^ static_cast<unsigned char>(secret[at % secret.size()]);
  }
  return difference == 0;
}

bool has_token(const Request& request, const std::string& token) {
  constexpr std::string_view scheme = "bearer ";
  if (request.authorizations.size() != 1) return false;
  const std::string_view field = request.authorizations.front();
  return field.size() > scheme.size() && base::in_lower_case(std::string(field.substr(0, scheme.size()))) == scheme &&
         is_same_secret(token, field.substr(scheme.size()));
}

std::optional<Response> refuse_host(const Request& request, const Rules& rules) {
  if (request.hosts.size() != 1) return failure(400, "a request has one Host: say it");
  const auto authority = boost::urls::parse_authority(request.hosts.front());
  const auto host = host_of(request.hosts.front());
  if (!authority || !host) return failure(400, "the Host cannot be read: write NAME or NAME:PORT");
  const bool is_address = authority->host_type() != boost::urls::host_type::name;
  if (is_address || *host == "localhost" || std::ranges::find(rules.names, *host) != rules.names.end()) {
    return std::nullopt;
  }
  return failure(421, "nobody has this name here: use an address in numbers, or start geminga-web with --host NAME");
}

}  // namespace

std::optional<std::string> host_of(std::string_view field) {
  const auto authority = boost::urls::parse_authority(field);
  if (!authority || authority->has_userinfo() || authority->host_type() == boost::urls::host_type::none) {
    return std::nullopt;
  }
  std::string host = base::in_lower_case(authority->host_address());
  if (host.empty()) return std::nullopt;
  if (host.ends_with('.')) host.pop_back();  // the root of the DNS
  return host;
}

std::optional<Response> refuse(const Request& request, const Rules& rules) {
  if (request.method != "GET" && request.method != "HEAD") {
    Response refusal = failure(405, "nothing can be changed here: use GET or HEAD");
    refusal.fields.emplace_back("Allow", "GET, HEAD");
    return refusal;
  }
  if (request.target.size() > max_target_octets) {
    return failure(414, "the target has over " + std::to_string(max_target_octets) + " octets");
  }
  if (auto refusal = refuse_host(request, rules)) return refusal;
  if (rules.token.empty() || request.target == open_path || has_token(request, rules.token)) return std::nullopt;
  Response refusal = failure(401, "a token is asked for: send Authorization: Bearer TOKEN");
  refusal.fields.emplace_back("WWW-Authenticate", "Bearer");
  return refusal;
}

std::string complaint_about_token(std::string_view token) {
  if (token.size() < min_token_octets) return "has under " + std::to_string(min_token_octets) + " octets";
  if (token.size() > max_token_octets) return "has over " + std::to_string(max_token_octets) + " octets";
  if (!std::ranges::all_of(token, is_of_tokens)) return "has other characters than A-Z a-z 0-9 - . _ ~ + / =";
  return {};
}

}  // namespace geminga::web
