// An ontology that is saturated once and then only read, to classify any number of expressions.
//
// The taxonomy of the compiled form is added to the axioms. It may come from an engine that derives more than the rules
// of saturation.hpp, and its subsumptions of named classes must hold for expressions over them, too.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_BASE_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_BASE_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::placement {

/// The limits of a base and of one expression. Beyond those of the base there is an error and no base, because others
/// wait while it is built.
struct ExpressionLimits {
  std::size_t axioms = 200'000;
  std::size_t conclusions = 20'000'000;  ///< of the base
  std::size_t work = 200'000;            ///< conclusions for one expression; beyond it the answer has a gap
  /// Axioms that are classified again for one expression if individuals matter; beyond it the answer has a gap.
  std::size_t scratch_axioms = 20'000;
  std::size_t parts = 64;  ///< alternatives that one expression is taken apart into at its unions
};

/// The reason why no expression can be classified. `text` is one line for a user.
struct ExpressionError {
  std::string text;
};

/// The saturated contexts, and tables that lead downwards. Neither copied nor moved.
class ExpressionBase {
  /// A span of a list or set of a context.
  template <typename Members>
  [[nodiscard]] static auto as_span(const Members& members) {
    if constexpr (requires { members.items(); }) {
      return std::span(members.items());
    } else if constexpr (requires { members.get(); }) {
      return std::span(members.get());
    } else {
      return std::span(members.data(), members.size());
    }
  }

 public:
  [[nodiscard]] static std::expected<std::unique_ptr<const ExpressionBase>, ExpressionError> build(
      const compiled::Ontology& ontology, const ExpressionLimits& limits);
  ExpressionBase(const ExpressionBase&) = delete;
  ExpressionBase& operator=(const ExpressionBase&) = delete;

  [[nodiscard]] const ExpressionLimits& limits() const { return limits_; }
  [[nodiscard]] const taxonomy::ClassifiedView& view() const { return view_; }
  [[nodiscard]] const el::IndexedOntology& index() const { return index_; }
  /// The axioms, and an axiom for each edge of the taxonomy.
  [[nodiscard]] const owl::Ontology& source() const { return source_; }
  [[nodiscard]] std::size_t context_count() const { return saturation_->contexts().size(); }
  [[nodiscard]] const el::Context& context(std::uint32_t number) const { return saturation_->contexts()[number]; }
  /// The subsumers of a context. Spans live as long as the base.
  [[nodiscard]] auto subsumers_of(std::uint32_t number) const { return as_span(context(number).subsumers); }
  [[nodiscard]] auto backward_of(std::uint32_t number) const { return as_span(context(number).backward); }
  [[nodiscard]] auto forward_of(std::uint32_t number) const { return as_span(context(number).forward); }
  /// Subsumers with existential rules.
  [[nodiscard]] auto propagating_of(std::uint32_t number) const { return as_span(context(number).propagating); }
  [[nodiscard]] auto derived_of(std::uint32_t number) const { return as_span(context(number).derived); }
  [[nodiscard]] auto selfs_of(std::uint32_t number) const { return as_span(context(number).selfs); }
  /// The atoms whose conjunction the context stands for. Empty if it stands for its root alone.
  [[nodiscard]] auto together_of(std::uint32_t number) const { return as_span(context(number).together); }
  [[nodiscard]] const el::Context* find(el::ExprId root) const { return saturation_->find(root); }
  [[nodiscard]] std::uint32_t number_of(el::ExprId root) const { return saturation_->number_of(root); }
  /// The constructs of axioms that the rules do not use in full.
  [[nodiscard]] const std::vector<std::string>& gaps() const { return gaps_; }

  /// The term of the base that is equal to one of the query. Nothing if no axiom of the ontology uses it.
  [[nodiscard]] std::optional<owl::TermId> find_term(owl::TermKind kind, std::string_view name, std::uint32_t number,
                                                     std::span<const owl::TermId> arguments) const;
  /// The representative of a term of source(): a class expression, individual, literal or data range.
  [[nodiscard]] el::ExprId expr(owl::TermId term) const { return exprs_[static_cast<std::size_t>(term)]; }
  /// The role of a property of source().
  [[nodiscard]] el::RoleId role(owl::TermId property) const { return el::RoleId{number(expr(property))}; }
  /// The atom of a value, in whichever literal it was written.
  [[nodiscard]] std::optional<el::ExprId> find_value(const owl::DataValue& value) const;
  /// The datatypes of OWL 2 that the ontology names, and its literals.
  [[nodiscard]] std::span<const std::pair<owl::Datatype, el::ExprId>> datatypes() const { return datatypes_; }
  [[nodiscard]] std::span<const std::pair<owl::DataValue, el::ExprId>> values() const { return values_; }

  /// The classes of an atom: representatives of nodes, ascending.
  [[nodiscard]] std::span<const taxonomy::ClassNumber> classes_of(el::ExprId atom) const {
    return classes_of_[number(atom)];
  }
  /// The contexts below an atom, ascending, including those without instances.
  [[nodiscard]] std::vector<std::uint32_t> contexts_below(el::ExprId atom) const;
  /// Contexts without instances, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& unsatisfiable() const { return unsatisfiable_; }
  /// True if the context leads to an individual, so that more may follow if it has an instance.
  [[nodiscard]] bool is_conditional(std::uint32_t context) const { return is_conditional_[context]; }
  [[nodiscard]] bool has_conditional() const { return has_conditional_; }

 private:
  ExpressionBase(const taxonomy::ClassifiedView& view, const ExpressionLimits& limits) : view_(view), limits_(limits) {}
  void copy_axioms();
  void add_taxonomy();
  void name_properties();
  void index_terms();
  [[nodiscard]] std::optional<ExpressionError> saturate();
  void find_classes();
  void find_edges_down();
  void find_conditional();
  void find_data();
  [[nodiscard]] std::uint64_t hash_of(owl::TermKind kind, owl::NameId name, std::uint32_t number_of_term,
                                      std::span<const owl::TermId> arguments) const;

  taxonomy::ClassifiedView view_;
  ExpressionLimits limits_;
  owl::Ontology source_;
  el::IndexedOntology index_;
  std::unique_ptr<el::Saturation> saturation_;
  std::vector<std::string> gaps_;
  base::NumberTable term_table_;
  std::vector<std::pair<owl::TermId, owl::TermId>> properties_;  ///< a property, and `property some everything`
  std::vector<el::ExprId> exprs_;                                ///< by term; of a property its role
  base::Rows<taxonomy::ClassNumber> classes_of_;                 ///< by atom
  base::Rows<std::uint32_t> down_;  ///< by atom: atoms right below, and contexts behind the number of expressions
  std::vector<std::uint32_t> unsatisfiable_;
  std::vector<bool> is_conditional_;
  bool has_conditional_ = false;
  std::vector<std::pair<owl::Datatype, el::ExprId>> datatypes_;
  std::vector<std::pair<owl::DataValue, el::ExprId>> values_;
  std::map<std::pair<owl::DataFamily, std::string>, el::ExprId> expr_of_value_;
};

}  // namespace geminga::placement

#endif
