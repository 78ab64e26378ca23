// From OWL axioms to the index: what EL can say exactly is said, what it cannot is weakened soundly and named.
#ifndef GEMINGA_REASONING_EL_RULE_NORMALISER_HPP
#define GEMINGA_REASONING_EL_RULE_NORMALISER_HPP

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reasoning/el/indexed_ontology.hpp"
#include "reasoning/el/open_parts.hpp"
#include "reasoning/owl/construct.hpp"
#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/role_box.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// The most combinations of values that one key is written out for; over it the key is left out and named.
inline constexpr std::size_t max_key_tuples = std::size_t{1} << 16;

/// Rewrites axioms one by one into an index. Everything it adds follows from the axioms (over names of its own), so
/// that whatever is derived is sound; where it returns Construct::none, nothing of the axiom is lost.
///
/// An expression that EL has no rules for becomes an atom of its own, so that it is at least equal to itself.
class RuleNormaliser {
 public:
  RuleNormaliser(const owl::Ontology& source, IndexedOntology& index);

  /// Adds one axiom of the source; the first construct in it that is not used in full.
  owl::Construct add(std::uint32_t axiom);
  using Unused = std::vector<std::pair<std::uint32_t, owl::Construct>>;
  /// Whether the index may hold universals, for whoever has rules for them.
  enum class Universals : std::uint8_t { left_out, used };
  /// To be called once after the last axiom: says how literals and datatypes relate, what universals and the ranges of
  /// chains say, and which axioms turn out only now not to be used in full.
  [[nodiscard]] Unused finish(Universals universals = Universals::left_out);

  /// After finish(): the axioms of which a part is used by a universal rule, ascending.
  [[nodiscard]] const Unused& uses_of_universals() const { return uses_of_universals_; }

  /// What the rules do not use of the added axioms.
  [[nodiscard]] const OpenParts& open() const { return open_; }

  /// The expression of a class, whether an axiom uses it or not.
  ExprId expression(owl::TermId term);
  /// All individuals that the added axioms name.
  [[nodiscard]] const std::vector<ExprId>& individuals() const { return individuals_; }

 private:
  /// A property expression: a role, or the inverse of one.
  struct Property {
    RoleId role{};
    bool is_inverse = false;
    bool is_top = false;
    bool is_data = false;
  };

  // Both polarities.
  ExprId make_expression(owl::TermId term);
  ExprId make_restriction(owl::TermId id, const owl::Term& term);
  ExprId make_some(const Property& property, ExprId filler, owl::TermId id);
  ExprId opaque(owl::TermKind kind, std::uint32_t number, std::vector<std::uint32_t> key);
  ExprId opaque_restriction(owl::TermKind kind, std::uint32_t number, const Property& property, ExprId filler);
  ExprId make_union(const std::vector<ExprId>& parts);
  Property property(owl::TermId term);
  ExprId filler_of(const owl::Term& term);

  // Data (rule_normaliser_data.cpp).
  ExprId make_literal(owl::TermId id, const owl::Term& term);
  ExprId make_datatype(const owl::Term& term);
  void use_negative_literal(owl::TermId id);
  void note_literal(owl::TermId id);
  owl::Construct use_positive_datatype(const owl::Term& term);
  void relate_data();

  // Keys (rule_normaliser_keys.cpp).
  struct Key {
    std::uint32_t axiom = 0;
    ExprId of{};
    std::vector<Property> properties;
  };
  owl::Construct add_key(const owl::Axiom& axiom);
  void use_keys(Unused& unused);
  void use_key(const Key& key, ExprId is_named, std::size_t tuple, const std::vector<ExprId>& named,
               const std::vector<ExprId>& literals);

  // Uses that are judged when all axioms are known (rule_normaliser_finish.cpp).
  struct SimpleUse {
    RoleId role{};
    owl::Construct construct = owl::Construct::none;  ///< what it is unless the role is simple
  };
  /// An index of universals_.
  struct UniversalUse {
    std::size_t universal = 0;
  };
  struct PendingUse {
    std::uint32_t axiom = 0;
    /// A datatype that values are said to be in, the family of a literal whose value is not exact, a property that must
    /// be simple, or a universal.
    std::variant<owl::Datatype, owl::DataFamily, SimpleUse, UniversalUse> use;
  };
  [[nodiscard]] static owl::Role role_of(RoleId role) {
    return {owl::PropertyId{static_cast<std::uint32_t>(role)}, false};
  }
  void note_use(const std::variant<owl::Datatype, owl::DataFamily, SimpleUse, UniversalUse>& use) {
    pending_uses_.push_back({current_axiom_, use});
  }
  void repeat_uses(owl::TermId term, bool is_positive);
  void find_unused_data(Unused& unused) const;
  void find_not_simple(const Roles& closed, Unused& unused) const;

  // Universals, and ranges that chains would escape (rule_normaliser_universals.cpp).
  void add_universals(Universals universals, Unused& unused);
  [[nodiscard]] std::vector<std::size_t> find_ranges_over_chains(const Roles& closed) const;
  void add_universal(ExprId restricting, const Property& property, ExprId filler, const owl::RoleBox& box);
  void add_range_over_chains(RoleId role, std::span<const ExprId> ranges, const owl::RoleBox& box);

  // What no rule uses (rule_normaliser_open_parts.cpp).
  owl::Construct beyond(owl::Construct construct);
  void open_union(ExprId whole, std::span<const ExprId> parts);
  void open_count(std::vector<OpenCount>& counts, const OpenCount& count);
  owl::Construct open_inverse(const Property& sub, const Property& super, owl::Construct construct);

  // Inverses (rule_normaliser_inverses.cpp).
  void mirror_roles();

  // One polarity: `use` adds the rules, once, and returns the first construct that has none.
  owl::Construct use_negative(owl::TermId term);
  owl::Construct use_positive(owl::TermId term);
  owl::Construct use_once(owl::TermId term, bool is_positive);
  owl::Construct make_negative(owl::TermId term);
  owl::Construct make_positive(owl::TermId term);
  owl::Construct make_negative_restriction(const owl::Term& term, ExprId expr);
  owl::Construct make_positive_restriction(const owl::Term& term, ExprId expr);
  owl::Construct use_all_values(const Property& property, owl::TermId filler, ExprId expr);
  owl::Construct use_at_least(std::uint32_t count, const Property& property, const owl::Term& term);
  owl::Construct use_at_most(std::uint32_t limit, const Property& property, const owl::Term& term, ExprId expr);
  /// min R C is given as min R T where it is not qualified.
  [[nodiscard]] static bool is_qualified(const owl::Term& term) { return term.arguments.size() == 2; }
  owl::Construct use_negative_filler(const owl::Term& term);
  owl::Construct use_positive_filler(const owl::Term& term);
  ExprId negative_some(const Property& property, ExprId filler);

  // Axioms.
  owl::Construct add_class_axiom(const owl::Axiom& axiom);
  owl::Construct add_object_property_axiom(const owl::Axiom& axiom);
  owl::Construct add_data_property_axiom(const owl::Axiom& axiom);
  owl::Construct add_assertion(const owl::Axiom& axiom);
  owl::Construct include(owl::TermId sub, owl::TermId super);
  std::optional<owl::Construct> include_as_range(owl::TermId sub, owl::TermId super);
  owl::Construct add_disjoint(std::span<const owl::TermId> members);
  owl::Construct add_chain(const owl::Term& chain, owl::TermId super);
  void add_chain(std::span<const RoleId> roles, RoleId super);
  owl::Construct add_inverse(const Property& one, const Property& other);
  owl::Construct add_domain(const Property& property, owl::TermId domain);
  owl::Construct add_range(const Property& property, owl::TermId range, std::uint32_t axiom);
  owl::Construct add_property_assertion(const owl::Axiom& axiom, bool is_negative);

  const owl::Ontology& source_;
  IndexedOntology& index_;
  std::vector<std::uint32_t> exprs_;    ///< by term
  std::vector<std::uint8_t> negative_;  ///< by term: 0 not used yet, else 1 + construct
  std::vector<std::uint8_t> positive_;
  std::vector<std::uint32_t> roles_;        ///< by term
  std::vector<std::uint32_t> opaque_keys_;  ///< all keys in a row
  std::vector<std::pair<std::uint32_t, std::uint32_t>> opaque_spans_;
  std::vector<ExprId> opaque_exprs_;
  base::NumberTable opaque_table_;
  std::vector<ExprId> individuals_;
  std::uint32_t current_axiom_ = 0;
  std::vector<std::pair<owl::Datatype, ExprId>> datatypes_;
  std::vector<std::pair<owl::DataValue, ExprId>> values_;
  std::map<std::pair<owl::DataFamily, std::string>, ExprId> expr_of_value_;
  std::map<owl::TermId, owl::DataFamily> family_of_literal_;
  std::vector<Key> keys_;
  std::vector<PendingUse> pending_uses_;
  /// The later uses of a term with rules: of the axiom that used it first, and for whom they were repeated last.
  struct TermUses {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::uint32_t axiom = 0;
  };
  std::map<std::pair<owl::TermId, bool>, TermUses> uses_of_term_;  ///< by term, and whether it is asserted
  std::map<owl::TermId, bool> is_exact_literal_;
  std::array<bool, owl::data_family_count> has_negative_literal_{};
  struct Range {
    std::uint32_t axiom = 0;
    RoleId role{};
    ExprId range{};
  };
  std::vector<Range> ranges_;
  struct Universal {
    ExprId restricting{};
    Property property;
    ExprId filler{};
  };
  std::vector<Universal> universals_;
  Unused uses_of_universals_;
  OpenParts open_;
  std::vector<owl::RoleChain> chains_;  ///< as they were written; each has its number instead of its axiom's
};

}  // namespace geminga::el

#endif
