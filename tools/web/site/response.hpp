// One response: a document, or a stream of events.
#ifndef GEMINGA_WEB_SITE_RESPONSE_HPP
#define GEMINGA_WEB_SITE_RESPONSE_HPP

#include <boost/json/value.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geminga::web {

class EventStream;

struct Response {
  unsigned status = 200;
  std::string type{};  ///< of the body
  std::string body{};
  std::vector<std::pair<std::string, std::string>> fields{};  ///< beside those that every response has
  /// Where it is not null, the body is what this gives until the reader goes.
  std::shared_ptr<EventStream> stream{};
};

/// The fields that every response has: no other site may show, frame or read it, nobody keeps it, and a browser takes
/// it for what its type says.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& common_fields();

/// One line of plain text.
[[nodiscard]] Response plain(unsigned status, std::string_view line);
/// A document as geminga-query prints it.
[[nodiscard]] Response document(const boost::json::value& value);
/// `{"error":"..."}`, one line that says what is wrong and what to do.
[[nodiscard]] Response failure(unsigned status, std::string_view text);

}  // namespace geminga::web

#endif
