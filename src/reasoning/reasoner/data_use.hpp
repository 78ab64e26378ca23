// The ranges, literals and cardinalities that the values of each data property are compared with.
#ifndef GEMINGA_REASONING_REASONER_DATA_USE_HPP
#define GEMINGA_REASONING_REASONER_DATA_USE_HPP

#include <map>
#include <set>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// The uses of one property, or of several that axioms relate: everything that can distinguish their values.
struct DataUse {
  std::set<owl::TermId> datatypes;  ///< named ones that are ranges or parts of ranges
  std::set<owl::TermId> literals;   ///< in enumerations, hasValue, facts that are denied or asked for
  std::set<owl::TermId> facets;
  /// Literals in facts of the premise, by property.
  std::map<owl::TermId, std::set<owl::TermId>> facts;
  bool is_counted = false;  ///< numbers, functionality, disjointness or a key: whether values are equal matters
  bool is_key = false;
};

/// Collects the uses of all data properties, axiom by axiom, and then answers.
class DataUses {
 public:
  explicit DataUses(const owl::Ontology& source) : source_(source) {}

  /// `is_told`: facts in it hold. Otherwise they are asked for.
  void add(const owl::Axiom& axiom, bool is_told);

  /// The use of the properties in an axiom, of all properties that axioms relate to them, and of those that share a
  /// user's datatype with them. Requires that every axiom was added.
  [[nodiscard]] DataUse use_in(const owl::Axiom& axiom) const;

 private:
  [[nodiscard]] std::vector<owl::TermId> properties_in(const owl::Axiom& axiom) const;
  void add_range(owl::TermId range, DataUse& use);
  void relate(const std::vector<owl::TermId>& properties);

  const owl::Ontology& source_;
  std::map<owl::TermId, DataUse> uses_;  ///< by property
  std::map<owl::TermId, std::set<owl::TermId>> related_;
  std::map<owl::TermId, DataUse> definitions_;  ///< by datatype: what is in its definitions
};

}  // namespace geminga::reasoner

#endif
