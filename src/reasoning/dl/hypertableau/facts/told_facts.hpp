// The facts of a clause set, written into the model under construction.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_TOLD_FACTS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_TOLD_FACTS_HPP

#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Makes a node for each individual of the set, and asserts its facts. Without individuals it makes one node, because
/// there is at least one thing.
void assert_told_facts(const clauses::ClauseSet& set, const Program& program, Assertions& facts);

}  // namespace geminga::hypertableau

#endif
