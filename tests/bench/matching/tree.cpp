// Builds the tree as an ontology and classifies it.
#include "bench/matching/tree.hpp"

#include <map>
#include <utility>

#include "reasoning/compiled/compile.hpp"
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

const vocabulary::Vocabulary& tree(std::uint32_t class_count) {
  static std::map<std::uint32_t, vocabulary::Vocabulary> trees;
  const auto known = trees.find(class_count);
  return known != trees.end() ? known->second : trees.emplace(class_count, classified(class_count)).first->second;
}

std::uint32_t common_class(std::uint32_t class_count, base::Random& random) {
  const std::uint32_t first_at_the_bottom = class_above(class_count - 1) + 1;
  return first_at_the_bottom + static_cast<std::uint32_t>(random.below(class_count - first_at_the_bottom - branching));
}

}  // namespace geminga::matching
