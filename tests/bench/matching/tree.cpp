#include "bench/matching/tree.hpp"

#include <utility>

#include "bench/rows.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::matching {
namespace {

vocabulary::Vocabulary classified(std::uint32_t class_count) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("tree.ttl");
  for (std::uint32_t number = 1; number < class_count; ++number) {
    source.add(owl::AxiomKind::sub_class_of,
               {source.named_class(class_iri(number)), source.named_class(class_iri(class_above(number)))}, file,
               number);
  }
  auto classification = el::classify(source);
  return vocabulary::Vocabulary(
      std::move(compiled::Ontology::from_bytes(compiled::compile(source, classification.value()))).value());
}

}  // namespace

std::string class_iri(std::uint32_t number) { return "http://example.org/team#Concept" + std::to_string(number); }

std::uint32_t tree_size() {
  constexpr std::uint32_t of_a_team = 1365;
  constexpr std::uint32_t large = 349'525;
  constexpr long many_services = 100'000;
  return bench::sizes().back() < many_services ? of_a_team : large;
}

const vocabulary::Vocabulary& tree() {
  static const vocabulary::Vocabulary whole = classified(tree_size());
  return whole;
}

std::uint32_t rare_class() { return tree_size() - 1; }

std::uint32_t common_class(base::Random& random) {
  const std::uint32_t first_at_the_bottom = class_above(rare_class()) + 1;
  return first_at_the_bottom + static_cast<std::uint32_t>(random.below(tree_size() - first_at_the_bottom - branching));
}

}  // namespace geminga::matching
