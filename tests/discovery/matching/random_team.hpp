// Random lives of a team: every step, every event, every seed, told by a matcher and worked out by a model.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_RANDOM_TEAM_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_RANDOM_TEAM_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "discovery/matching/event.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Changes what the matcher tells, to try whether the model notices it.
using Sabotage = std::function<void(std::vector<Event>&)>;

/// One life: what kind of team it is, and the seed of each step. A step can be left out without changing what the seeds
/// of the others mean.
struct Life {
  std::uint64_t team = 0;
  std::vector<std::uint64_t> steps;
};
[[nodiscard]] Life random_life(std::uint64_t seed, std::size_t steps);

/// What is wrong first; empty where nothing is.
struct Outcome {
  std::string wrong;
  std::size_t steps = 0;  ///< that were lived, the wrong one included
};
[[nodiscard]] Outcome live(const Life& life, const std::vector<vocabulary::Vocabulary>& ontologies,
                           const Sabotage& sabotage = {});

/// The shortest life found that goes wrong, too. Requires that this one does.
[[nodiscard]] Life shortest(const Life& life, const std::vector<vocabulary::Vocabulary>& ontologies,
                            const Sabotage& sabotage = {});

}  // namespace geminga::matching

#endif
