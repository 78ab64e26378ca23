// The command line of geminga-simulate.
#ifndef GEMINGA_TESTS_SCENARIOS_COMMAND_LINE_HPP
#define GEMINGA_TESTS_SCENARIOS_COMMAND_LINE_HPP

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "scenarios/conditions.hpp"
#include "scenarios/random_faults.hpp"
#include "scenarios/seeds.hpp"

namespace geminga::scenarios {

/// The flags, as they were given.
struct Flags {
  std::string scenario;
  std::optional<std::size_t> participants;
  std::optional<double> minutes;
  std::optional<std::size_t> sites;
  std::uint64_t seed = 1;
  std::string seeds;
  std::size_t threads = 0;
  std::string loss;
  std::string burst;
  std::string duplicate;
  std::string late;
  std::string flip;
  std::string delay;
  std::optional<double> interval;
  double spread = 0;
  std::size_t services = 0;
  std::optional<unsigned> changes;
  double drift = 0;
  Counts counts;
  bool has_random_faults = false;
  bool is_start = false;
  bool is_list = false;
  bool is_json = false;
  bool is_quiet = false;

  /// Borrows this for the life of `app`.
  void add_to(CLI::App& app);
  /// The runs that are asked for. Throws CLI::ValidationError where a value cannot be read.
  [[nodiscard]] Conditions conditions() const;
  /// Nothing: one run.
  [[nodiscard]] std::optional<Seeds> range() const;
  /// The command that runs one seed again.
  [[nodiscard]] std::string replay(std::uint64_t one) const;
};

}  // namespace geminga::scenarios

#endif
