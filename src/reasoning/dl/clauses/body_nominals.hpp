// Nominals that only bodies ask for are no nominals.
//
// Lemma. Let a nominal {a} be in no head, in no filler of an at-least, in no fact and in no question. Let N be a new
// class, let N stand for {a} everywhere, and let N(a) be a fact. Then the same clauses, facts and concepts that do not
// speak of {a} or N hold, and the same questions have a model.
//
// A model of the clauses with {a} is one of the clauses with N, if N has the one instance a. In a model of the clauses
// with N, take all instances but a from N. N is asked for in bodies, where fewer instances make fewer bodies true, and
// is counted by at-mosts, which then count fewer neighbours. So all clauses still hold, and N(a), too.
//
// Facts about what an individual is or is not related to are such: {a}(x), R(x,y), {b}(y) -> false. Without nominals a
// question about classes needs no model of the facts, and models of questions are kept (hypertableau/README.md).
#ifndef GEMINGA_REASONING_DL_CLAUSES_BODY_NOMINALS_HPP
#define GEMINGA_REASONING_DL_CLAUSES_BODY_NOMINALS_HPP

#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::clauses {

/// Replaces these nominals by concepts of the kind `mark` with a fact each. Requires all else of the set to be there.
void replace_body_nominals(ClauseSet& set);

}  // namespace geminga::clauses

#endif
