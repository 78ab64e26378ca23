// Clauses as a person reads them.
#ifndef GEMINGA_TESTS_REASONING_DL_CLAUSES_PRINT_HPP
#define GEMINGA_TESTS_REASONING_DL_CLAUSES_PRINT_HPP

#include <string>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::clauses {

/// `A`, `{a}`, or `Q7` for a name of a part, by its number.
[[nodiscard]] std::string print(const owl::Ontology& source, const ClauseSet& set, ConceptId id,
                                const owl::ShortName& short_name);
/// "A(x), R(x,y1) -> B(y1) or >=2 S.C(x)"; false where the head is empty, true where the body is.
[[nodiscard]] std::string print(const owl::Ontology& source, const ClauseSet& set, const Clause& clause,
                                const owl::ShortName& short_name);

}  // namespace geminga::clauses

#endif
