// Random lives of a team, in which every event of the matcher is compared with a model.
#ifndef GEMINGA_TESTS_DISCOVERY_MATCHING_RANDOM_TEAM_HPP
#define GEMINGA_TESTS_DISCOVERY_MATCHING_RANDOM_TEAM_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "discovery/matching/event.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Changes events of the matcher, to test whether the model notices it.
using Sabotage = std::function<void(std::vector<Event>&)>;

/// One life: the kind of the team, and the seed of each step. A step can be left out without changing the others.
struct Life {
  std::uint64_t team = 0;
  std::vector<std::uint64_t> steps;
};
[[nodiscard]] Life random_life(std::uint64_t seed, std::size_t steps);

/// The first error of a life; empty where there is none.
struct Outcome {
  std::string wrong;
  std::size_t steps = 0;  ///< steps that were taken, the wrong one included
};
[[nodiscard]] Outcome live(const Life& life, const std::vector<vocabulary::Vocabulary>& ontologies,
                           const Sabotage& sabotage = {});

/// The shortest life found that goes wrong, too. Requires that this one goes wrong.
[[nodiscard]] Life shortest(const Life& life, const std::vector<vocabulary::Vocabulary>& ontologies,
                            const Sabotage& sabotage = {});

}  // namespace geminga::matching

#endif
