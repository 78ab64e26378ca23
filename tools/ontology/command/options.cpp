#include "ontology/command/options.hpp"

#include <CLI/CLI.hpp>

#include "base/text.hpp"

namespace geminga::ontology {
namespace {

constexpr unsigned max_seconds = 1'000'000;
constexpr std::uint64_t max_steps = 1'000'000'000'000'000;

}  // namespace

CLI::Option* add_files(CLI::App& command, std::vector<std::string>& files) {
  return command.add_option("FILES", files, "ontology files, or folders of them")->required()->type_name("");
}

void add_connect(CLI::App& command, std::string& connect) {
  command
      .add_option("--connect", connect,
                  "where the daemon listens, or the path of its socket; $GEMINGA_CONNECT, else 127.0.0.1:4717 and "
                  "[::1]:4717")
      ->type_name("ADDRESS:PORT");
}

void add_lenient(CLI::App& command, bool& is_lenient) {
  command.add_flag("--lenient", is_lenient,
                   "read a bound or literal of another numeric datatype as the number that it writes, such as "
                   "xsd:double[<= \"1\"^^xsd:integer], instead of leaving its axiom out");
}

void add_output(CLI::App& command, std::string& out) {
  command.add_option("-o,--output", out, "the file to write, replaced as a whole or not at all; - is standard output")
      ->required()
      ->type_name("OUT");
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

void add_strict(CLI::App& command, bool& is_strict) {
  command.add_flag("--strict", is_strict,
                   "refuse everything, with exit status 2, where a file cannot be read; without it a folder costs that "
                   "file only");
}

void add_memory_limit(CLI::App& command, Choice& choice) {
  add_number(command, "--memory-limit", choice.memory_limit_mib, min_memory_limit_mib, 1'000'000,
             "most address space to use, in MiB");
}

void add_graph_limit(CLI::App& command, WorkLimits& limits) {
  add_number(command, "--graph-limit", limits.graph_mib, 1, 1'000'000,
             "most memory for the triples, in MiB (default: " + std::to_string(WorkLimits::default_graph_mib) +
                 ", or half of --memory-limit); beyond it exit 4")
      ->type_name("MIB");
}

void add_work_limits(CLI::App& command, WorkLimits& limits) {
  add_number(command, "--time-limit", limits.seconds, 1, max_seconds,
             "search for so many seconds at most; then answer from what is decided, and exit 4")
      ->type_name("SECONDS");
  const auto read = [&limits](const std::string& text) {
    const auto value = base::parse_number<std::uint64_t>(text);
    if (!value || *value == 0 || *value > max_steps)
      throw CLI::ValidationError(
          "--steps", base::printable(text) + " is not a whole number from 1 to " + std::to_string(max_steps));
    limits.steps = *value;
  };
  command
      .add_option_function<std::string>(
          "--steps", read,
          "search for so many counted steps at most (default: " + std::to_string(WorkLimits::default_steps) +
              "): as --time-limit, but the same on every machine")
      ->type_name("N");
}

void add_run_limits(CLI::App& command, Choice& choice) {
  add_memory_limit(command, choice);
  add_number(command, "--time-limit", choice.limits.seconds, 1, max_seconds,
             "most time to take, in seconds; then exit 4");
}

}  // namespace geminga::ontology
