// Ontologies as they are written in tests: axioms in functional syntax, and what follows from them as sorted lines.
#ifndef GEMINGA_TESTS_REASONING_DL_CONSEQUENCE_WRITTEN_HPP
#define GEMINGA_TESTS_REASONING_DL_CONSEQUENCE_WRITTEN_HPP

#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::consequence {

/// Names in `:` are of https://t.example/#. What cannot be read fails the test that asks, and is an empty ontology.
[[nodiscard]] owl::Ontology written(std::string_view axioms);
/// Of all axioms, and of the class expressions given as terms.
[[nodiscard]] clauses::ClauseSet clauses_of(const owl::Ontology& source, std::span<const owl::TermId> queries = {});
/// All named classes, owl:Thing and owl:Nothing included.
[[nodiscard]] std::vector<clauses::ConceptId> named_classes(const clauses::ClauseSet& clauses);
/// Lines "A B" for A below B, both named classes and not the same, B not owl:Thing; an unsatisfiable A has one line,
/// "A Nothing". "inconsistent" where it is.
[[nodiscard]] std::vector<std::string> lines_of(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                                                const Closure& closure);
/// The same from axioms to lines.
[[nodiscard]] std::vector<std::string> closure_of(std::string_view axioms);
[[nodiscard]] std::vector<std::string> gaps_of(std::string_view axioms);

/// The constructs that a random ontology may use.
struct Vocabulary {
  bool facts = false;
  bool disjunctions = true;
};
/// Axioms, one a line, of ALCHIQ with transitive properties and ObjectHasSelf, over at most nine classes.
[[nodiscard]] std::vector<std::string> random_axioms(base::Random& random, const Vocabulary& vocabulary);
[[nodiscard]] std::string joined(const std::vector<std::string>& lines);

}  // namespace geminga::consequence

#endif
