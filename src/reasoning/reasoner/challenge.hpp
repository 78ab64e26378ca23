// Challenges of an axiom: situations of which none is possible exactly if the axiom follows.
//
// Every kind of axiom becomes the question whether something can exist. `C SubClassOf D` follows if nothing can be in C
// and not in D. Classes and properties that no other axiom mentions stand for any class or property: `r SubPropertyOf
// s` follows if nothing can be in (r some N) and not in (s some N) for a new N (Horrocks, Patel-Schneider: Reducing OWL
// entailment to description logic satisfiability, 2004).
#ifndef GEMINGA_REASONING_REASONER_CHALLENGE_HPP
#define GEMINGA_REASONING_REASONER_CHALLENGE_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/reasoner/excerpt.hpp"

namespace geminga::reasoner {

/// One situation. If it has a class, it is possible if the class can have an instance. Otherwise it is possible if the
/// axioms of the excerpt and the statements together have a model.
struct Challenge {
  std::optional<owl::TermId> of;
  std::vector<Statement> statements;
  /// The axioms of the excerpt that describe the class: [first_axiom, last_axiom).
  std::size_t first_axiom = 0;
  std::size_t last_axiom = 0;
};

/// The axiom follows if no situation of `all` is possible, and does not follow if one is.
struct Refutation {
  std::vector<Challenge> all;
  /// If not empty: why `all` decides nothing, in one line. Then only witnesses can decide: the axiom does not follow if
  /// one of them is possible.
  std::string undecided;
  std::vector<Challenge> witnesses;
};

/// The most pairs of members of one axiom, such as DisjointClasses. An axiom with more is undecided.
inline constexpr std::size_t max_pairs_of_members = 100'000;

/// Turns axioms into challenges, and adds the axioms that describe them to the excerpt. These entail nothing new about
/// the other terms of the excerpt.
class Challenger {
 public:
  using Terms = std::vector<owl::TermId>;

  explicit Challenger(Excerpt& excerpt);

  /// The arguments are terms of the excerpt. Anonymous individuals count as names; reasoner/anonymous.hpp treats those
  /// that stand for "some".
  [[nodiscard]] Refutation refute(owl::AxiomKind kind, const Terms& terms);
  /// The refutation of "this class expression has no instance in any model".
  [[nodiscard]] Refutation refute_emptiness_everywhere(owl::TermId expression);

 private:
  void refute_class_axiom(Refutation& into, owl::AxiomKind kind, const Terms& terms);
  void refute_object_property_axiom(Refutation& into, owl::AxiomKind kind, const Terms& terms);
  void refute_data_property_axiom(Refutation& into, owl::AxiomKind kind, const Terms& terms);
  void refute_fact(Refutation& into, owl::AxiomKind kind, const Terms& terms);

  void subsume(Refutation& into, owl::TermId sub, owl::TermId super);
  void include(Refutation& into, const Terms& chain, owl::TermId super);
  void share_pair(Refutation& into, owl::TermId first, owl::TermId second);
  void reach_outside(Refutation& into, owl::TermId property, owl::TermId range);
  void reach_two(Refutation& into, owl::TermId property);
  void reach_itself(Refutation& into, owl::TermId property);
  void include_data(Refutation& into, owl::TermId sub, owl::TermId super);
  void share_value(Refutation& into, owl::TermId first, owl::TermId second);
  void define_datatype(Refutation& into, owl::TermId datatype, owl::TermId range);
  void identify_by_key(Refutation& into, const Terms& terms);
  /// Calls `use` with every two members.
  static void for_pairs(Refutation& into, const Terms& members,
                        const std::function<void(owl::TermId, owl::TermId)>& use);

  /// Something that is in all of `in` and in none of `not_in`. `first` is the first axiom that describes it.
  [[nodiscard]] Challenge challenge(const Terms& in, const Terms& not_in, std::size_t first);
  [[nodiscard]] Challenge challenge(const Terms& in, const Terms& not_in = {}) { return challenge(in, not_in, next()); }
  [[nodiscard]] std::size_t next() const { return excerpt_.source.axiom_count(); }
  [[nodiscard]] owl::TermId some(owl::TermId property, owl::TermId filler);
  [[nodiscard]] owl::TermId one_of(owl::TermId individual);
  [[nodiscard]] owl::TermId inverse(owl::TermId property);
  [[nodiscard]] bool is_named(owl::TermId property, std::string_view iri) const;

  Excerpt& excerpt_;
  owl::TermId any_value_{};
};

}  // namespace geminga::reasoner

#endif
