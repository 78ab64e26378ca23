// What the values of data properties are compared with: the ranges, literals and numbers that stand beside them.
#ifndef GEMINGA_REASONING_REASONER_DATA_USE_HPP
#define GEMINGA_REASONING_REASONER_DATA_USE_HPP

#include <map>
#include <set>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// Of one property, or of several that axioms relate: what could tell one of their values from another.
struct DataUse {
  std::set<el::TermId> datatypes;  ///< named ones that are ranges or parts of ranges
  std::set<el::TermId> literals;   ///< in enumerations, hasValue, facts that are denied or asked for
  std::set<el::TermId> facets;
  /// Literals of the facts of the premise, by property.
  std::map<el::TermId, std::set<el::TermId>> facts;
  bool is_counted = false;  ///< numbers, functionality, disjointness or a key: whether values are equal matters
  bool is_key = false;
};

/// Gathers the uses of all data properties, axiom by axiom; then answers.
class DataUses {
 public:
  explicit DataUses(const el::OntologySource& source) : source_(source) {}

  /// `is_told`: a fact in it holds; otherwise it is asked for.
  void add(const el::Axiom& axiom, bool is_told);

  /// The use of the properties that an axiom speaks of, of all that axioms relate to them, and of those that share a
  /// user's datatype with them. Requires that every axiom was added.
  [[nodiscard]] DataUse of(const el::Axiom& axiom) const;

 private:
  [[nodiscard]] std::vector<el::TermId> properties_in(const el::Axiom& axiom) const;
  void add_range(el::TermId range, DataUse& use);
  void relate(const std::vector<el::TermId>& properties);

  const el::OntologySource& source_;
  std::map<el::TermId, DataUse> uses_;  ///< by property
  std::map<el::TermId, std::set<el::TermId>> related_;
  std::map<el::TermId, DataUse> definitions_;  ///< by datatype: what is in its definitions
};

}  // namespace geminga::reasoner

#endif
