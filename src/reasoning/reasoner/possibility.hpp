// Decides which situations are possible: first with the engine that is fast, then with those that know all of OWL.
#ifndef GEMINGA_REASONING_REASONER_POSSIBILITY_HPP
#define GEMINGA_REASONING_REASONER_POSSIBILITY_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/reasoner/challenge.hpp"

namespace geminga::reasoner {

/// Of each challenge, whether it is possible: no and yes are certain. All of them are asked about at once, which costs
/// little more than asking about one; those without a class cost a question to the whole ontology each. Work is
/// taken from the budget, if there is one.
[[nodiscard]] std::vector<hypertableau::Answer> are_possible(const Excerpt& excerpt,
                                                             std::span<const Challenge> challenges,
                                                             base::Budget* budget = nullptr);

}  // namespace geminga::reasoner

#endif
