// Any octets as a GCNP stream, from either side: each line is refused with an error, or is the same when it is written
// and read again.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>

#include "base/text.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/gcnp/line_reader.hpp"
#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"

namespace {

using namespace geminga;
using namespace geminga::gcnp;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_error(const Error& error) {
  require(!error.text.empty() && base::is_valid_utf8(error.text) && !base::has_control_character(error.text));
  const std::string line = to_line(7, error);
  require(line.size() <= max_error_text_bytes + 32 && line.ends_with("\r\n"));
}

std::string_view without_end(const std::string& line) { return std::string_view(line).substr(0, line.size() - 2); }

/// Whether a written line keeps the limits of one that is read; defaults that are written out may take it over them.
bool keeps_limits(const Statement& statement, const std::string& line) {
  return line.size() - 2 <= max_line_bytes && statement.parameters.size() <= max_parameters;
}

void check_statement(std::string_view line) {
  const auto statement = parse(line);
  if (!statement) return check_error(statement.error().error);
  const std::string written = to_line(*statement);
  if (keeps_limits(*statement, written)) {
    const auto again = parse(without_end(written));
    require(again && *again == *statement);
  }
  const auto request = read_request(*statement);
  if (!request) return check_error(request.error());
  const Statement restated = to_statement(statement->id, *request);
  const auto request_again = read_request(restated);
  require(request_again && *request_again == *request);
}

void check_reply(std::string_view line) {
  const auto reply = read_reply(line);
  if (!reply) return check_error(reply.error());
  const auto* event = std::get_if<Event>(&*reply);
  if (event == nullptr || std::holds_alternative<Error>(event->what)) return;
  const auto* service = std::get_if<ServiceEvent>(&event->what);
  const Statement statement = service != nullptr ? to_statement(event->request, *service)
                                                 : to_statement(event->request, std::get<ConsumerEvent>(event->what));
  const std::string written = to_line(statement);
  if (!keeps_limits(statement, written)) return;
  const auto again = read_reply(without_end(written));
  require(again && std::get<Event>(*again) == *event);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  // A small limit, so that lines over it are common.
  LineReader reader(512);
  std::string_view stream(reinterpret_cast<const char*>(octets), size);
  while (!stream.empty()) {
    const std::size_t piece = std::min<std::size_t>(stream.size(), 1 + static_cast<unsigned char>(stream.front()));
    reader.feed(stream.substr(0, piece));
    stream.remove_prefix(piece);
    while (const auto line = reader.next()) {
      require(line->text.size() <= (line->is_too_long ? LineReader::beginning_bytes : 512));
      check_statement(line->text);
      check_reply(line->text);
    }
  }
  return 0;
}
