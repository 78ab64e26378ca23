#include "limits.hpp"

#include <CLI/CLI.hpp>

#include "base/text.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

constexpr unsigned max_seconds = 1'000'000;
constexpr std::uint64_t max_steps = 1'000'000'000'000'000;

}  // namespace

void add_work_limits(CLI::App& command, WorkLimits& limits) {
  add_number(command, "--time-limit", limits.seconds, 1, max_seconds,
             "search for so many seconds at most; then what is settled counts, and exit 4")
      ->type_name("SECONDS");
  const auto read = [&limits](const std::string& text) {
    const auto value = base::parse_number<std::uint64_t>(text);
    if (!value || *value == 0 || *value > max_steps)
      throw CLI::ValidationError(
          "--steps", base::printable(text) + " is not a whole number from 1 to " + std::to_string(max_steps));
    limits.steps = *value;
  };
  command
      .add_option_function<std::string>("--steps", read,
                                        "search for so many counted steps at most (" +
                                            std::to_string(WorkLimits::default_steps) +
                                            " unless told): as --time-limit, but the same on every machine")
      ->type_name("N");
}

base::Budget budget_of(const WorkLimits& limits) {
  if (limits.seconds == 0) return base::Budget(limits.steps);
  const auto end = limits.start + std::chrono::seconds(limits.seconds);
  return base::Budget(limits.steps, [end] { return std::chrono::steady_clock::now() >= end; });
}

}  // namespace geminga::ontology
