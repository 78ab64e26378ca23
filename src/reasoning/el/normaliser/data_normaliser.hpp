// Literals and datatypes as atoms. Legend as in expressions.hpp; u v are literals.
#ifndef GEMINGA_REASONING_EL_NORMALISER_DATA_NORMALISER_HPP
#define GEMINGA_REASONING_EL_NORMALISER_DATA_NORMALISER_HPP

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/normaliser/pending_uses.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// Makes the atoms of literals and datatypes. In the end it adds which atoms are within others and which exclude
/// others.
class DataNormaliser {
 public:
  DataNormaliser(const owl::Ontology& source, IndexBuilder& index, PendingUses& pending)
      : source_(source), index_(index), pending_(pending) {}

  ExprId make_datatype(const owl::Term& term);
  /// The atom of a literal; literals with the same value share one. To be called once for each literal.
  ExprId make_literal(owl::TermId id, const owl::Term& term);

  /// Notes that the literal, which has its atom, stands in the current axiom.
  void note_literal(owl::TermId id);
  /// Notes that the current axiom asks for elements with the literal as a value.
  void note_wanted_literal(owl::TermId id);
  /// Notes that the current axiom says that values are in the datatype.
  void note_datatype(const owl::Term& term);

  /// Notes that the current axiom asks for values in the datatype, or says that values are not in it.
  void note_wanted_datatype(const owl::Term& term);

  /// Adds how literals and datatypes relate. To be called once, after the last literal and datatype.
  void relate();
  /// Adds the axioms of which literals or datatypes are not used in full.
  void find_unused(UnusedAxioms& unused) const;

 private:
  struct Literal {
    owl::DataFamily family{};
    bool is_exact = true;
  };
  using FamilyAtoms = std::array<ExprId, owl::data_family_count>;

  void relate_datatypes(FamilyAtoms& families);
  void relate_values(FamilyAtoms& families);
  void put_under_family(ExprId expr, owl::DataFamily family, FamilyAtoms& families);
  void exclude(ExprId one, ExprId other);

  const owl::Ontology& source_;
  IndexBuilder& index_;
  PendingUses& pending_;
  std::vector<std::pair<owl::Datatype, ExprId>> datatypes_;  ///< known datatypes
  std::vector<std::pair<owl::DataValue, ExprId>> values_;
  std::map<std::pair<owl::DataFamily, std::string>, ExprId> expr_of_value_;
  std::map<owl::TermId, Literal> literals_;  ///< literals of known datatypes
  std::array<bool, owl::data_family_count> is_wanted_{};
  std::set<owl::NameId> wanted_opaque_;  ///< datatypes of which nothing is known
  bool has_opaque_literals_ = false;     ///< of such datatypes
};

}  // namespace geminga::el

#endif
