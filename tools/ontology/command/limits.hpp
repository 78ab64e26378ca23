// The limits of a run: of a search in time and counted steps, and of the whole process in memory and time.
#ifndef GEMINGA_ONTOLOGY_COMMAND_LIMITS_HPP
#define GEMINGA_ONTOLOGY_COMMAND_LIMITS_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "base/budget.hpp"

namespace geminga::ontology {

/// The limits of a search. Where one is reached, what is settled by then is printed and used, and the exit status is 4.
struct WorkLimits {
  /// More than published ontologies need; one engine takes 2 to 20 million steps in a second.
  static constexpr std::uint64_t default_steps = 2'000'000'000;
  /// Of asking a query, in processor time.
  static constexpr unsigned default_asking_seconds = 300;

  unsigned seconds = 0;  ///< from the start of the program; 0: no limit
  std::uint64_t steps = default_steps;
  /// Of the triples that infer writes and query asks, and as much again for the query. Some four million triples.
  static constexpr unsigned default_graph_mib = 1024;

  unsigned memory_mib = 0;  ///< of the whole process; 0: no limit
  unsigned graph_mib = 0;   ///< 0: default_graph_mib, or half of the memory where that is limited
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// The budget of a search within these limits. Reading asks no budget; limit_time() ends it.
[[nodiscard]] base::Budget budget_of(const WorkLimits& limits);
/// The same with a number of steps of its own.
[[nodiscard]] base::Budget budget_of(const WorkLimits& limits, std::uint64_t steps);

/// The limits of a first search after which another one follows: half of the time.
[[nodiscard]] WorkLimits first_half(const WorkLimits& limits);
/// The limits of searches whose results are used afterwards within the rest of the time.
[[nodiscard]] WorkLimits three_quarters(const WorkLimits& limits);

/// The limit of the triples that infer writes and query asks, in octets.
[[nodiscard]] std::size_t graph_octets(const WorkLimits& limits);
/// Ends this process with Exit::timed_out and a line on standard error when it has used so much processor time from now
/// on, unless there is a limit of time already: rasqal cannot be asked to end while it computes without triples.
void limit_asking(const WorkLimits& limits);

/// Limits the address space of this process; 0: no limit.
void limit_memory(unsigned mebibytes);
/// Ends this process with Exit::timed_out and a line on standard error when it still runs a quarter longer than this,
/// and a second; 0: never. Searches end in time by themselves and keep what they have found.
void limit_time(unsigned seconds);

}  // namespace geminga::ontology

#endif
