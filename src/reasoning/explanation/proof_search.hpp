// The search for a proof: derives a subsumption from few axioms by rules that a reader can follow.
//
// The rules are those of EL and the simplest ones beyond it: universal restrictions, inverses, functional properties,
// unions by cases. They need not be complete, because lemmas bridge what they do not reach (proof.hpp). Each conclusion
// is an inclusion of class expressions in the form of ProofTerms. The axioms are a minimal set, so nothing here needs
// to be fast for many axioms.
//
// Legend: C D E F class expressions, R S T property expressions, a an individual, R <* S "R is S or below it by told
// inclusions"; premises stand above the line, the conclusion below, side conditions in brackets.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_SEARCH_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_SEARCH_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/explanation/explain_minimal.hpp"
#include "reasoning/explanation/proof_roles.hpp"
#include "reasoning/explanation/proof_terms.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// The rule by which a step follows from its premises.
enum class ProofRule : std::uint8_t {
  trivial,      ///< C SubClassOf C, C SubClassOf owl:Thing: no step at all
  subclass,     ///< C < D, D < E: C < E
  conjunct,     ///< C < D and E: C < D
  conjunction,  ///< C < D, C < E: C < D and E
  alternative,  ///< C < D: C < D or E
  existential,  ///< C < R some D, D < E, R < S: C < S some E
  empty,        ///< C < R some owl:Nothing: C < owl:Nothing
  domain,
  range,
  universal,
  chain,
  inverse,
  functional,
  cardinality,
  self,
  disjointness,   ///< C < D, C < E, D and E disjoint: C < owl:Nothing
  negation,       ///< C < D, C < not D: C < owl:Nothing; C and D < owl:Nothing: C < not D
  cases,          ///< C < D or E, C and D < F, C and E < F: C < F
  contradiction,  ///< C < owl:Nothing: C < D; a is in owl:Nothing: C < D
  together,       ///< the axioms entail it together, by an engine that shows no steps
};
/// The words behind "by": "the existential rule", "the domain", "cases".
[[nodiscard]] std::string_view to_string(ProofRule rule);

/// A conclusion and its premises: earlier conclusions by number, and axioms.
struct Conclusion {
  owl::TermId sub{};
  owl::TermId super{};
  ProofRule rule = ProofRule::trivial;
  std::vector<std::uint32_t> steps;
  AxiomSet axioms;
};

/// Searches forward from the goal's subclass until the goal is derived, nothing is left to derive, or a limit is
/// reached.
class ProofSearch {
 public:
  /// Adds terms to the source. Only the given axioms are used.
  ProofSearch(owl::Ontology& source, const AxiomSet& axioms, owl::TermId sub, owl::TermId super);

  /// The number of the goal's conclusion, if it was reached. May be called again after assume().
  [[nodiscard]] std::optional<std::uint32_t> run();
  /// Adds a conclusion that these axioms entail together.
  void assume(owl::TermId sub, owl::TermId super, AxiomSet axioms);

  [[nodiscard]] const std::vector<Conclusion>& conclusions() const { return conclusions_; }
  /// The class expressions that the search draws conclusions about: the goal's subclass, fillers, individuals and
  /// cases; and all class expressions of the axioms.
  [[nodiscard]] const std::vector<owl::TermId>& contexts() const { return contexts_; }
  [[nodiscard]] const std::vector<owl::TermId>& expressions() const { return expressions_; }
  [[nodiscard]] bool is_known(owl::TermId sub, owl::TermId super) const { return find(sub, super) != nullptr; }
  [[nodiscard]] ProofTerms& terms() { return terms_; }

 private:
  struct Told {
    owl::TermId sub{};
    owl::TermId super{};
    std::uint32_t axiom = 0;
  };
  /// C < R some D, as a conclusion.
  struct Link {
    std::uint32_t step = 0;
    owl::TermId role{};
    owl::TermId filler{};
  };

  // proof_search.cpp: the axioms, and the conclusions.
  void use(std::uint32_t axiom);
  void use_fact(owl::AxiomKind kind, const std::vector<owl::TermId>& given, std::uint32_t axiom);
  void tell(owl::TermId sub, owl::TermId super, std::uint32_t axiom);
  void tell_all(const std::vector<owl::TermId>& equal, std::uint32_t axiom);
  void tell_disjoint(const std::vector<owl::TermId>& members, std::uint32_t axiom);
  void look_into(owl::TermId expression);
  void open(owl::TermId context);
  void add(owl::TermId sub, owl::TermId super, ProofRule rule, std::vector<std::uint32_t> steps, AxiomSet axioms = {});
  [[nodiscard]] const std::uint32_t* find(owl::TermId sub, owl::TermId super) const;
  /// The conclusions about a context, by number. A copy, because the list grows.
  [[nodiscard]] std::vector<std::uint32_t> about(owl::TermId context) const;
  [[nodiscard]] std::vector<owl::TermId> arguments(owl::TermId term) const;
  [[nodiscard]] owl::TermKind kind(owl::TermId term) const { return source_.kind(term); }
  [[nodiscard]] bool is_open(owl::TermId context) const { return about_.contains(context); }
  [[nodiscard]] std::vector<Link> links(owl::TermId context);
  void conclude_goal();

  // proof_rules.cpp: rules without successors.
  void apply(owl::TermId context);
  void apply_told(owl::TermId context);
  void apply_parts(owl::TermId context);
  void apply_clashes(owl::TermId context);
  void apply_cases(owl::TermId context);
  void apply_selfs(owl::TermId context);

  // proof_rules_links.cpp: rules along links.
  void apply_links(owl::TermId context);
  void apply_existentials(owl::TermId context, const Link& link);
  void apply_ranges(owl::TermId context, const Link& link);
  void apply_universals(owl::TermId context, const Link& link);
  void apply_inverses(owl::TermId context, const Link& link);
  void apply_functional(owl::TermId context, const std::vector<Link>& links);
  void apply_numbers(owl::TermId context, const std::vector<Link>& links);
  void apply_chains(owl::TermId context);
  void follow_chain(const RoleChain& chain, std::size_t at, owl::TermId from, owl::TermId to,
                    std::vector<std::uint32_t>& steps, AxiomSet& axioms);
  void refine(owl::TermId context, const Link& link, owl::TermId more, ProofRule rule, std::vector<std::uint32_t> steps,
              AxiomSet axioms);

  owl::Ontology& source_;
  ProofTerms terms_;
  ProofRoles roles_;
  owl::TermId sub_;
  owl::TermId super_;
  std::vector<Told> told_;
  std::vector<Told> disjoint_;
  std::vector<owl::TermId> data_domains_;  ///< property, class, ... of data properties, in pairs
  std::vector<std::uint32_t> data_domain_axioms_;
  std::vector<owl::TermId> expressions_;
  std::vector<owl::TermId> contexts_;
  std::map<owl::TermId, std::vector<std::uint32_t>> about_;
  std::map<std::pair<owl::TermId, owl::TermId>, std::uint32_t> known_;
  std::vector<Conclusion> conclusions_;
  std::optional<std::uint32_t> goal_;
};

}  // namespace geminga::explanation

#endif
