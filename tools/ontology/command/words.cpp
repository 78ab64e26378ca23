#include "ontology/command/words.hpp"

#include <unistd.h>

#include <boost/json.hpp>
#include <cstdio>

#include "base/harmless.hpp"

namespace geminga::ontology {
namespace {

bool write(std::string_view text) { return std::fwrite(text.data(), 1, text.size(), stdout) == text.size(); }

}  // namespace

Exit say_error(std::string_view words, Exit exit) {
  const std::string line = "geminga-ontology: " + base::harmless_lines(words) + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
  return exit;
}

Exit say_failure(std::string_view words, bool as_json, Exit exit) {
  // Standard error has the words as well, so that nothing is lost where this cannot be written.
  if (as_json) (void)print(json_text(boost::json::object{{"error", words}}) + '\n');
  return say_error(words, exit);
}

bool print(std::string_view lines) { return print_more(lines) && std::fflush(stdout) == 0; }

bool print_more(std::string_view lines) { return write(base::harmless_lines(lines)); }

bool print_data(std::string_view data) {
  if (isatty(STDOUT_FILENO) == 1) return print(data);
  return write(data) && std::fflush(stdout) == 0;
}

std::string json_text(const boost::json::value& document) {
  return base::harmless_json(boost::json::serialize(document));
}

Exit print_or_say(std::string_view text, Exit exit) { return print(text) ? exit : say_unwritten(); }

Exit say_unwritten() { return say_error("standard output cannot be written"); }

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

}  // namespace geminga::ontology
