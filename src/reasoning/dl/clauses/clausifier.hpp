// The translation of one ontology, axiom by axiom.
#ifndef GEMINGA_REASONING_DL_CLAUSES_CLAUSIFIER_HPP
#define GEMINGA_REASONING_DL_CLAUSES_CLAUSIFIER_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/dl/clauses/allowed.hpp"
#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/clauses/translator.hpp"

namespace geminga::clauses {

constexpr Literal positive(owl::TermId term) { return {term, false, Part::whole}; }
constexpr Literal negative(owl::TermId term) { return {term, true, Part::whole}; }

/// The clauses depend on the contents of the axioms only: axioms are taken in the order of their hashes.
class Clausifier {
 public:
  Clausifier(const owl::Ontology& source, const ClausifyLimits& limits);

  void run(std::optional<std::span<const std::uint32_t>> axioms, std::span<const owl::TermId> queries,
           std::span<const owl::TermId> complements);
  /// A limit that was exceeded.
  [[nodiscard]] const std::optional<std::string>& problem() const { return problem_; }
  [[nodiscard]] ClauseSet take() { return std::move(set_); }

 private:
  struct Ordered {
    std::uint32_t axiom = 0;
    owl::AxiomKind kind{};
    std::vector<owl::TermId> arguments;  ///< sets sorted
  };

  void order(std::optional<std::span<const std::uint32_t>> axioms);
  void find_properties(std::span<const owl::TermId> terms);
  void find_property(owl::TermId term);
  void build_roles();
  void collect_roles(const Ordered& axiom, std::vector<owl::RoleInclusion>& inclusions,
                     std::vector<owl::RoleChain>& chains);
  void add_hierarchy(std::span<const owl::RoleInclusion> inclusions);
  void add(const Ordered& axiom);
  void add_class_axiom(const Ordered& axiom);
  void add_property_axiom(const Ordered& axiom);
  void add_data_property_axiom(const Ordered& axiom);
  void add_fact(const Ordered& axiom);
  void add_inclusion(owl::TermId sub, owl::TermId super);
  /// Adds the disjunction, unless a part of it is not allowed.
  void add_disjunction(std::vector<Literal> disjunction);
  void add_disjoint(std::span<const owl::TermId> members);
  void add_disjoint_pairs(std::span<const owl::TermId> members);
  void add_disjoint_groups(std::vector<ConceptId> groups);
  void add_key(const Ordered& axiom);
  void assert_fact(Literal literal, IndividualId individual);
  void ask(std::span<const owl::TermId> expressions, bool is_complement, std::vector<ConceptId>& answers);
  /// Why the axiom has no clauses.
  [[nodiscard]] std::string_view problem_of(const Ordered& axiom);
  [[nodiscard]] std::string_view problem_of_classes(const Ordered& axiom);
  [[nodiscard]] std::string_view problem_of_properties(const Ordered& axiom);

  const owl::Ontology& source_;
  ClausifyLimits limits_;
  owl::ContentHashes hashes_;
  ClauseSet set_;
  Vocabulary vocabulary_;
  std::vector<Ordered> axioms_;
  std::vector<bool> is_seen_;
  std::optional<Role> top_role_;
  std::optional<Role> bottom_role_;
  std::optional<DataPropertyId> bottom_data_;
  std::optional<owl::RoleBox> roles_;
  std::optional<Translator> translator_;
  std::optional<Allowed> allowed_;
  std::optional<std::string> problem_;
};

}  // namespace geminga::clauses

#endif
