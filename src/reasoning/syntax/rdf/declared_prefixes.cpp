#include "reasoning/syntax/rdf/declared_prefixes.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> fixed_prefixes{{{"rdf", syntax::rdf_namespace},
                                                                                       {"rdfs", syntax::rdfs_namespace},
                                                                                       {"owl", syntax::owl_namespace},
                                                                                       {"xsd", syntax::xsd_namespace}}};

}  // namespace

void DeclaredPrefixes::add(std::span<const owl::DeclaredPrefix> prefixes) {
  for (const owl::DeclaredPrefix& declared : prefixes) {
    if (++files_[declared.prefix][declared.iri] == 1) ++size_;
  }
}

std::vector<PrefixConflict> DeclaredPrefixes::choose(owl::Ontology& source) const {
  auto files_of = files_;
  for (const auto& [prefix, iri] : fixed_prefixes) {
    auto& iris = files_of[std::string(prefix)];
    iris[std::string(iri)];
  }
  std::vector<PrefixConflict> conflicts;
  for (const auto& [prefix, iris] : files_of) {
    auto chosen = std::ranges::max_element(iris, {}, [](const auto& entry) { return entry.second; });
    for (const auto& [name, iri] : fixed_prefixes) {
      if (name == prefix) chosen = iris.find(std::string(iri));
    }
    if (prefix.empty() && iris.size() > 1) continue;
    source.add_prefix(prefix, chosen->first);
    if (iris.size() == 1) continue;
    PrefixConflict conflict{prefix, chosen->first, {}};
    for (const auto& [iri, files] : iris) {
      if (iri != chosen->first) conflict.others.push_back(iri);
    }
    conflicts.push_back(std::move(conflict));
  }
  return conflicts;
}

}  // namespace geminga::rdf
