// What would refute an axiom: situations of which none is possible exactly if the axiom follows.
//
// Every kind of axiom becomes the question whether something can be: `C SubClassOf D` follows if nothing can be in C
// and not in D. Classes and properties that nothing else speaks of stand for "any": `r SubPropertyOf s` follows if
// nothing can be in (r some N) and not in (s some N) for a new N (Horrocks, Patel-Schneider: Reducing OWL entailment to
// description logic satisfiability, 2004).
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

/// One situation. It is possible if the class can have an instance; or, where there is no class, if the axioms of the
/// excerpt together with the statements have a model.
struct Challenge {
  std::optional<el::TermId> of;
  std::vector<Statement> statements;
  /// The axioms of the excerpt that describe the class: [first_axiom, last_axiom).
  std::size_t first_axiom = 0;
  std::size_t last_axiom = 0;
};

/// The axiom follows if none of `all` is possible, and does not where one is.
struct Refutation {
  std::vector<Challenge> all;
  /// Not empty: why `all` says nothing, in one line. Then only a witness tells: the axiom does not follow where one of
  /// them is possible.
  std::string undecided;
  std::vector<Challenge> witnesses;
};

/// Pairs that the members of one axiom are taken in, as in DisjointClasses; an axiom with more is undecided.
inline constexpr std::size_t max_pairs_of_members = 100'000;

/// Turns axioms into challenges, and adds what describes them to the excerpt. What is added entails nothing about the
/// other terms of the excerpt that did not follow before.
class Challenger {
 public:
  using Terms = std::vector<el::TermId>;

  explicit Challenger(Excerpt& excerpt);

  /// The arguments are terms of the excerpt. Anonymous individuals are taken for names: see reasoner/anonymous.hpp for
  /// those that stand for "some".
  [[nodiscard]] Refutation refute(el::AxiomKind kind, const Terms& terms);
  /// That a class expression can have an instance at all, anywhere.
  [[nodiscard]] Refutation refute_emptiness_everywhere(el::TermId expression);

 private:
  void refute_class_axiom(Refutation& into, el::AxiomKind kind, const Terms& terms);
  void refute_object_property_axiom(Refutation& into, el::AxiomKind kind, const Terms& terms);
  void refute_data_property_axiom(Refutation& into, el::AxiomKind kind, const Terms& terms);
  void refute_fact(Refutation& into, el::AxiomKind kind, const Terms& terms);

  void subsume(Refutation& into, el::TermId sub, el::TermId super);
  void include(Refutation& into, const Terms& chain, el::TermId super);
  void share_pair(Refutation& into, el::TermId first, el::TermId second);
  void reach_outside(Refutation& into, el::TermId property, el::TermId range);
  void reach_two(Refutation& into, el::TermId property);
  void reach_itself(Refutation& into, el::TermId property);
  void include_data(Refutation& into, el::TermId sub, el::TermId super);
  void share_value(Refutation& into, el::TermId first, el::TermId second);
  void define_datatype(Refutation& into, el::TermId datatype, el::TermId range);
  void identify_by_key(Refutation& into, const Terms& terms);
  /// Calls `use` with every two members.
  static void for_pairs(Refutation& into, const Terms& members, const std::function<void(el::TermId, el::TermId)>& use);

  /// That something is in all of `in` and in none of `not_in`. `first` is the first axiom that describes it.
  [[nodiscard]] Challenge challenge(const Terms& in, const Terms& not_in, std::size_t first);
  [[nodiscard]] Challenge challenge(const Terms& in, const Terms& not_in = {}) { return challenge(in, not_in, next()); }
  [[nodiscard]] std::size_t next() const { return excerpt_.source.axiom_count(); }
  [[nodiscard]] el::TermId some(el::TermId property, el::TermId filler);
  [[nodiscard]] el::TermId one_of(el::TermId individual);
  [[nodiscard]] el::TermId inverse(el::TermId property);
  [[nodiscard]] bool is_named(el::TermId property, std::string_view iri) const;

  Excerpt& excerpt_;
  el::TermId any_value_{};
};

}  // namespace geminga::reasoner

#endif
