// Derives what follows from clauses: for each concept that is asked for, everything that subsumes it.
//
// The consequence-based calculus of Bate, Motik, Cuenca Grau, Tena Cucala, Simancik, Horrocks: Consequence-Based
// Reasoning for Description Logics with Disjunctions and Number Restrictions (JAIR 2018). On Horn clauses every head
// has at most one literal, and it is the Horn-SHIQ calculus of Kazakov (IJCAI 2009).
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CLOSURE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CLOSURE_HPP

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::consequence {

struct Options {
  unsigned threads = 1;
  /// Whether to look at facts, too. Without them is_consistent is about the rest, and fact_gap and key_gap never stand.
  bool facts = true;
  /// Derived clauses of all contexts together (long ones count several times, vain attempts a little): beyond it the
  /// closure is incomplete. A million takes at most some hundred megabytes.
  std::size_t clauses = 5'000'000;
  /// Conclusions with alternatives (more than one literal in the head) in one context: beyond it the context keeps what
  /// it has without alternatives, and the closure has alternative_gap. Horn clauses are not bounded by it.
  std::uint32_t alternatives = std::numeric_limits<std::uint32_t>::max();
  /// What this work is taken from, beside other work; nothing: only the limit of clauses holds. Where it is spent the
  /// closure is incomplete. Borrowed.
  base::Budget* budget = nullptr;
};

/// Gaps. The first two are about facts alone: where there is no other, the subsumers of named classes are complete as
/// long as the facts are consistent, which is then undecided unless is_consistent is false.
inline constexpr std::string_view fact_gap = "facts about properties, together with alternatives";
inline constexpr std::string_view key_gap = "owl:hasKey";
inline constexpr std::string_view nominal_gap = "owl:oneOf, owl:hasValue";
inline constexpr std::string_view range_gap = "data ranges that are more than datatypes and single values";
inline constexpr std::string_view alternative_gap = "classes with many alternatives";
inline constexpr std::string_view value_gap = "numbers of values of finite data ranges";

/// What follows. Always sound; complete where `gaps` is empty.
struct Closure {
  bool is_consistent = true;  ///< false: an individual of the facts cannot exist
  /// Of each concept that was asked for, in that order: the named classes and nominals above it, ascending, itself
  /// included; {nothing} where it can have no instance.
  std::vector<std::vector<clauses::ConceptId>> subsumers;
  /// Why something may be missing, one line each, e.g. "values with owl:oneOf"; sorted, without doubles.
  std::vector<std::string> gaps;
  /// Of each concept that was asked for, whether no gap matters to it: all its subsumers are there, if the ontology is
  /// consistent.
  std::vector<bool> is_settled;
  /// Of each concept that was asked for, whether it is settled without alternatives: if the ontology is consistent, it
  /// has a model with an instance of which its subsumers hold and no other named class.
  std::vector<bool> is_plain;
  std::size_t contexts = 0;
  std::size_t derived = 0;  ///< clauses
};

/// The result depends neither on the order of clauses nor on the number of threads, save for the counts, and save for a
/// closure that was cut off. Builds only what the concepts asked for lead to (and, with `facts`, the individuals).
[[nodiscard]] Closure saturate(const owl::Ontology& source, const clauses::ClauseSet& clauses,
                               std::span<const clauses::ConceptId> wanted, const Options& options = {});

/// Whether `super` follows for the one concept that the clauses have a query of, which it also does where that can have
/// no instance. A yes is certain; a no is none where the closure has gaps.
[[nodiscard]] bool derives(const owl::Ontology& source, const clauses::ClauseSet& clauses, owl::TermId super,
                           const Options& options);

}  // namespace geminga::consequence

#endif
