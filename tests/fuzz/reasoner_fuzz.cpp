// Any bytes as a small ontology in functional-style syntax: both engines beyond EL work on it within small limits, and
// do not contradict each other.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/assert.hpp"
#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/syntax/functional/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  using namespace geminga;
  functional::FunctionalLimits limits;
  limits.nesting = 10;
  limits.operands = 10;
  limits.iri_bytes = 100;
  limits.literal_bytes = 100;
  owl::Ontology source;
  const std::string_view bytes(reinterpret_cast<const char*>(octets), size);
  if (!functional::read(bytes, source.add_file("fuzz.ofn"), source, limits) || source.axiom_count() > 40) return 0;
  clauses::ClausifyLimits few;
  few.clauses = 5'000;
  few.automaton_states = 1'000;
  few.cardinality = 5;
  const auto set = clauses::clausify(source, {}, {}, {}, few);
  if (!set) {
    GEMINGA_ASSERT(!set.error().text.empty());
    return 0;
  }
  std::vector<clauses::ConceptId> wanted;
  for (std::uint32_t id = 0; id < set->concepts.size() && wanted.size() < 8; ++id) {
    if (set->concepts[id].kind == clauses::ConceptKind::named && clauses::ConceptId{id} != clauses::nothing)
      wanted.push_back(clauses::ConceptId{id});
  }
  const consequence::Closure closure = consequence::saturate(source, *set, wanted, {.clauses = 5'000});
  hypertableau::Tableau tableau(source, *set, {.nodes = 300, .steps = 30'000});
  const auto consistent = tableau.is_consistent();
  GEMINGA_ASSERT(closure.is_consistent || consistent.verdict != hypertableau::Verdict::yes);
  if (consistent.verdict != hypertableau::Verdict::yes || !closure.is_consistent) return 0;
  for (std::size_t at = 0; at < wanted.size(); ++at) {
    const bool is_empty = closure.subsumers[at] == std::vector{clauses::nothing};
    const auto answer = tableau.is_satisfiable({wanted[at]});
    GEMINGA_ASSERT(!is_empty || answer.verdict != hypertableau::Verdict::yes);
    const bool is_whole = closure.gaps.empty();
    GEMINGA_ASSERT(!is_whole || is_empty || answer.verdict != hypertableau::Verdict::no);
  }
  return 0;
}
