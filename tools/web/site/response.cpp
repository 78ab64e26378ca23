#include "web/site/response.hpp"

#include <boost/json/object.hpp>
#include <sstream>

#include "shell/json.hpp"
#include "shell/terminal.hpp"

namespace geminga::web {

const std::vector<std::pair<std::string, std::string>>& common_fields() {
  static const std::vector<std::pair<std::string, std::string>> fields{
      {"Cache-Control", "no-store"},
      {"Content-Security-Policy", "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Referrer-Policy", "no-referrer"},
      {"X-Content-Type-Options", "nosniff"},
      {"X-Frame-Options", "DENY"}};
  return fields;
}

Response plain(unsigned status, std::string_view line) {
  return {.status = status, .type = "text/plain; charset=utf-8", .body = shell::printable(line) + '\n'};
}

Response document(const boost::json::value& value) {
  std::ostringstream text;
  shell::print(text, value);
  return {.status = 200, .type = "application/json", .body = std::move(text).str()};
}

Response failure(unsigned status, std::string_view text) {
  Response response = document(boost::json::object{{"error", text}});
  response.status = status;
  return response;
}

}  // namespace geminga::web
