// The answers of our engines about one ontology, each asked by itself, so that they can be compared.
#ifndef GEMINGA_TESTS_COMPARE_OPINIONS_HPP
#define GEMINGA_TESTS_COMPARE_OPINIONS_HPP

#include <string>
#include <vector>

#include "cases/taxonomy.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// Closures have whole IRIs, as cases::closure_of() gives them.
struct Opinion {
  cases::Closure closure;
  bool is_complete = true;           ///< the engine says that nothing else follows
  std::vector<std::string> unknown;  ///< pairs that it could not decide
};

/// The face of the reasoner.
[[nodiscard]] Opinion of_the_reasoner(const owl::Ontology& source);
/// The same where nothing is derived by cases: what EL and Horn clauses leave open is settled by models.
[[nodiscard]] Opinion of_models(const owl::Ontology& source);
/// The fast engine alone.
[[nodiscard]] Opinion of_el(const owl::Ontology& source);
/// The consequence-based engine alone.
[[nodiscard]] Opinion of_consequence(const owl::Ontology& source);
/// The tableau alone, asked for each pair of named classes whether there can be something in the one and not in the
/// other.
[[nodiscard]] Opinion of_the_tableau(const owl::Ontology& source);
/// The same, with every neighbour that an at-least asks for, within few steps.
[[nodiscard]] Opinion of_the_tableau_without_counting(const owl::Ontology& source);

/// How two opinions contradict each other, one line each: a pair that the first has and the second, being complete,
/// has not, or the other way round.
[[nodiscard]] std::vector<std::string> contradictions(const Opinion& first, const Opinion& second);

}  // namespace geminga::compare

#endif
