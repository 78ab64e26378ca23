// What classifying an ontology gives: the taxonomy of its named classes, and what was not used.
#ifndef GEMINGA_REASONING_TAXONOMY_CLASSIFICATION_HPP
#define GEMINGA_REASONING_TAXONOMY_CLASSIFICATION_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/class_number.hpp"
#include "reasoning/taxonomy/property_taxonomy.hpp"

namespace geminga::owl {
struct LeftOut;
}

namespace geminga::taxonomy {

/// What the reasoner could not use of one axiom.
struct UnusedAxiom {
  std::uint32_t axiom = 0;     ///< its index in the source
  std::string_view construct;  ///< why: the first construct in it that is not supported, e.g. "owl:unionOf"
};

/// Numbers for `--stats`.
struct ClassifyCounts {
  std::size_t axioms = 0;       ///< without declarations, each counted once
  std::size_t used_axioms = 0;  ///< those of them that are used in full
  std::size_t expressions = 0;  ///< indexed ones
  std::size_t contexts = 0;
  std::size_t subsumptions = 0;  ///< derived conclusions
  std::size_t links = 0;
};

/// The taxonomy of all named classes of an ontology. Classes are numbered in ascending order of their IRIs (octet by
/// octet); owl:Thing and owl:Nothing are always among them.
struct Classification {
  std::vector<owl::NameId> classes;  ///< the IRI of each class
  ClassNumber thing{};
  ClassNumber nothing{};
  /// The smallest class that each class is equivalent to; itself for most. Those of unsatisfiable classes are equal to
  /// that of owl:Nothing.
  std::vector<ClassNumber> representative;
  /// The direct superclasses of each representative, as representatives, ascending: parents[parent_begin[c] ..
  /// parent_begin[c + 1]). Empty for others, for owl:Thing, and for owl:Nothing's (which lies below every leaf).
  std::vector<std::uint32_t> parent_begin;
  std::vector<ClassNumber> parents;
  PropertyTaxonomy object_properties;
  PropertyTaxonomy data_properties;
  bool is_consistent = true;        ///< false: an individual must be in owl:Nothing, and everything follows
  bool is_cut_off = false;          ///< the budget was spent: more may follow, of classes and of consistency
  std::vector<UnusedAxiom> unused;  ///< ascending by axiom
  /// By class: every subsumer of the class is known, if the ontology is consistent. Empty if this is known of no class;
  /// then every class is complete if all axioms are used and nothing was cut off.
  std::vector<bool> is_settled;
  ClassifyCounts counts;

  [[nodiscard]] std::size_t class_count() const { return classes.size(); }
  [[nodiscard]] std::span<const ClassNumber> parents_of(ClassNumber number) const {
    const auto index = static_cast<std::size_t>(number);
    return std::span(parents).subspan(parent_begin[index], parent_begin[index + 1] - parent_begin[index]);
  }
};

/// What was left out, by the reader and by the reasoner together: sorted by construct, with counts and the first place.
[[nodiscard]] std::vector<owl::LeftOut> left_out(const owl::Ontology& source, const Classification& classification);

}  // namespace geminga::taxonomy

#endif
