// Decides which situations are possible: by the fastest engine first, then by those that know all of OWL.
#ifndef GEMINGA_REASONING_REASONER_POSSIBILITY_HPP
#define GEMINGA_REASONING_REASONER_POSSIBILITY_HPP

#include <span>
#include <vector>

#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/reasoner/challenge.hpp"

namespace geminga::reasoner {

/// Whether each challenge is possible. No and yes are certain. Asking about all at once costs little more than asking
/// about one, except that each challenge without a class is a question about the whole ontology. Work is taken from the
/// budget, if there is one.
[[nodiscard]] std::vector<hypertableau::Answer> are_possible(const Excerpt& excerpt,
                                                             std::span<const Challenge> challenges,
                                                             base::Budget* budget = nullptr);

}  // namespace geminga::reasoner

#endif
