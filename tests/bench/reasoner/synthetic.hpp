// A made-up ontology of OWL 2 EL that is shaped like SNOMED CT: a few axes, definitions by role groups of fillers from
// other axes, a deep hierarchy of properties and a few chains.
//
// SNOMED CT may not be redistributed, and free ontologies are smaller or of another shape. This one is made anew from
// its size and seed. At 350 000 classes it has about 722 000 axioms without declarations.
#ifndef GEMINGA_TESTS_BENCH_REASONER_SYNTHETIC_HPP
#define GEMINGA_TESTS_BENCH_REASONER_SYNTHETIC_HPP

#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace geminga::bench {

/// `property some filler`
struct Attribute {
  std::uint32_t property = 0;
  std::uint32_t filler = 0;
  friend auto operator<=>(const Attribute&, const Attribute&) = default;
};

struct SyntheticClass {
  std::vector<std::uint32_t> parents;
  /// Role groups of attributes that belong together. A class that is not defined may have none.
  std::vector<std::vector<Attribute>> groups;
  bool is_defined = false;    ///< equivalent to its parents and groups, not only below them
  std::uint32_t part_of = 0;  ///< another class that this is part of; 0: none
};

struct Chain {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::uint32_t result = 0;
};

struct Synthetic {
  std::vector<SyntheticClass> classes;                                  ///< parents and fillers have smaller numbers
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sub_properties;  ///< sub, super
  std::vector<Chain> chains;
  std::uint32_t property_count = 0;
  std::uint32_t role_group = 0;  ///< the property that binds a group to its class
  std::uint32_t part_of = 0;     ///< transitive and reflexive
};

/// Makes the ontology; the same for the same arguments, on every machine. Requires at least 50 `classes`.
[[nodiscard]] Synthetic make_synthetic(std::uint32_t classes, std::uint64_t seed);

/// Axioms without declarations.
[[nodiscard]] std::size_t axiom_count(const Synthetic& ontology);

/// Writers of the same axioms, with a label of every class, as a stream to the file.
void write_functional(const Synthetic& ontology, std::FILE* out);
void write_rdf_xml(const Synthetic& ontology, std::FILE* out);

}  // namespace geminga::bench

#endif
