// Near misses: what a candidate lacks to be what is asked for, and what of the request contradicts it.
#ifndef GEMINGA_REASONING_EXPLANATION_ABDUCTION_NEAR_MISSES_HPP
#define GEMINGA_REASONING_EXPLANATION_ABDUCTION_NEAR_MISSES_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "reasoning/explanation/abduction/conjuncts.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::abduction {

enum class Answer : std::uint8_t { no, yes, unknown };

/// The reasoner's face. A yes and a no are certain. The functions may not add to the source.
struct Reasoner {
  std::function<Answer(const owl::Ontology& source, owl::TermId sub, owl::TermId super)> is_subsumed;
  std::function<Answer(const owl::Ontology& source, owl::TermId expression)> is_satisfiable;
};

struct Limits {
  std::size_t questions = 512;  ///< to the reasoner, for one candidate
  std::size_t answers = 4;      ///< that are given; at most max_answers
};
inline constexpr std::size_t max_answers = 16;

/// One way to make the candidate match.
struct NearMiss {
  Members retracted = 0;  ///< of the request, because they contradict the candidate and the rest; with nested ones
  Members known = 0;      ///< of what is left: these hold of the candidate
  Members lacking = 0;    ///< to be added to the candidate; with these, all that is left of the request follows
  /// Whether the candidate with what is left of the request has a model; otherwise no contradiction is known.
  bool is_possible = false;
};

/// All ways that were found, the smallest first: by the number of retracted conjuncts, then of lacking ones.
struct NearMisses {
  std::vector<NearMiss> ranked;
  /// Why there may be smaller or other ways, one line; empty: the first is as small as any, and all others are there up
  /// to the limit of answers.
  std::string reservation{};
};

/// Concept contraction and abduction over the conjuncts of a request (Colucci and others, A Uniform Tableaux-Based
/// Method for Concept Abduction and Contraction, 2004; Di Noia, Di Sciascio, Donini: Computing Information Minimal
/// Match Explanations for Logic-Based Matchmaking, 2009).
///
/// For each way, with what is left of the request R and the candidate C:
/// - sound: C with R.term(known | lacking) is subsumed by R.term(all without retracted), and no contradiction of the
///   two is known;
/// - minimal, if there is no reservation: with one outermost retracted conjunct more there is a contradiction, and
///   with one lacking conjunct less (and those that are nested in it) it is not subsumed.
///
/// If the candidate can have no instance, there is no way. Cost: at most limits.questions questions.
[[nodiscard]] NearMisses find_near_misses(owl::Ontology& source, const Conjuncts& request, owl::TermId candidate,
                                          const Reasoner& reasoner, const Limits& limits = {});

/// Everything that is to be added to the candidate, as one expression; owl::Thing if nothing is.
[[nodiscard]] owl::TermId added(owl::Ontology& source, const Conjuncts& request, const NearMiss& near_miss);

}  // namespace geminga::abduction

#endif
