#include "ontology/command/words.hpp"

#include <boost/json.hpp>
#include <cstdio>

namespace geminga::ontology {

Exit say_error(std::string_view words, Exit exit) {
  const std::string line = "geminga-ontology: " + std::string(words) + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
  return exit;
}

Exit say_failure(std::string_view words, bool as_json, Exit exit) {
  // Standard error has the words as well, so that nothing is lost where this cannot be written.
  if (as_json) (void)print(boost::json::serialize(boost::json::object{{"error", words}}) + '\n');
  return say_error(words, exit);
}

bool print(std::string_view text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
}

Exit print_or_say(std::string_view text, Exit exit) { return print(text) ? exit : say_unwritten(); }

Exit say_unwritten() { return say_error("standard output cannot be written"); }

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

}  // namespace geminga::ontology
