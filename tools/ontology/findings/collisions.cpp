#include "ontology/findings/collisions.hpp"

#include <algorithm>
#include <cstdint>

namespace geminga::ontology {
namespace {

/// The most pairs that are compared. More would collide by the hundreds (the birthday paradox), and no team publishes
/// so many services.
constexpr std::size_t max_pairs = 4'000'000;

constexpr std::string_view concept_root = "https://geminga.example/core#Concept";
constexpr std::string_view representation_root = "https://geminga.example/core#Representation";

struct Entry {
  Id32 id;
  std::uint32_t concept_index;
  std::uint32_t representation_index;  ///< 0: none
};

/// The IRIs of the satisfiable classes below a root, or of all where the ontology knows no such root.
std::vector<std::string> names_below(const compiled::Ontology& ontology, std::string_view root, bool all_without_root) {
  const auto top = ontology.find_iri(root);
  const auto thing = ontology.find_iri(owl::owl_thing);
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  std::vector<std::string> names;
  for (std::uint32_t number = 0; number < ontology.class_count(); ++number) {
    const taxonomy::ClassNumber named{number};
    if (named == thing || named == nothing) continue;
    if (top ? ontology.is_subsumed(named, *top) && ontology.is_satisfiable(named) : all_without_root)
      names.emplace_back(ontology.iri(named));
  }
  return names;
}

}  // namespace

Collisions find_collisions(const std::vector<std::string>& concept_iris,
                           const std::vector<std::string>& representation_iris) {
  Collisions collisions;
  const bool with_pairs = concept_iris.size() * representation_iris.size() <= max_pairs;
  collisions.is_whole = with_pairs;
  const auto identity = [&](const Entry& entry) {
    SemanticIdentity named{concept_iris[entry.concept_index], {}};
    if (entry.representation_index != 0) named.representation_iri = representation_iris[entry.representation_index - 1];
    return named;
  };
  std::vector<Entry> entries;
  for (std::uint32_t c = 0; c < concept_iris.size(); ++c) {
    for (std::uint32_t r = 0; r <= (with_pairs ? representation_iris.size() : 0); ++r) {
      Entry entry{0, c, r};
      entry.id = id32(identity(entry));
      entries.push_back(entry);
    }
  }
  std::ranges::sort(entries, {}, &Entry::id);
  for (std::size_t begin = 0; begin < entries.size();) {
    std::size_t end = begin + 1;
    while (end < entries.size() && entries[end].id == entries[begin].id) ++end;
    if (end - begin > 1) {
      Collision collision{entries[begin].id, {}};
      for (std::size_t place = begin; place < end; ++place)
        collision.names.push_back(canonical_form(identity(entries[place])));
      std::ranges::sort(collision.names);
      collisions.found.push_back(std::move(collision));
    }
    begin = end;
  }
  return collisions;
}

Collisions find_collisions(const compiled::Ontology& ontology) {
  return find_collisions(names_below(ontology, concept_root, true), names_below(ontology, representation_root, false));
}

}  // namespace geminga::ontology
