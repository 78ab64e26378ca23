// One place for standard error and standard output.
#include "words.hpp"

#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <cstdio>

#include "base/text.hpp"

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

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + ' ' + std::string(count == 1 ? one : many);
}

CLI::Option* add_files(CLI::App& command, std::vector<std::string>& files) {
  return command.add_option("FILES", files, "ontology files, or folders of them")->required()->type_name("");
}

CLI::Option* add_number(CLI::App& command, const std::string& flag, unsigned& number, unsigned low, unsigned high,
                        const std::string& description) {
  const auto read = [&number, low, high, flag](const std::string& text) {
    const auto value = base::parse_number<unsigned>(text);
    if (!value || *value < low || *value > high)
      throw CLI::ValidationError(flag, base::printable(text) + " is not a whole number from " + std::to_string(low) +
                                           " to " + std::to_string(high));
    number = *value;
  };
  return command.add_option_function<std::string>(flag, read, description)->type_name("N");
}

bool print(std::string_view text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
}

}  // namespace geminga::ontology
