// The reasoner as its users see it: it classifies, decides and completes with the engine that a question needs.
//
// el saturates OWL 2 EL with functional properties and is the fastest. consequence derives what follows with inverses,
// universals, unions and cardinalities. hypertableau builds models, which show what does not follow. Every answer is
// sound. It is complete if el used every axiom in full, if consequence has no gap, or if a model was found for every
// subsumption that was not derived.
#ifndef GEMINGA_REASONING_REASONER_REASONER_HPP
#define GEMINGA_REASONING_REASONER_REASONER_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

using hypertableau::Answer;
using hypertableau::Verdict;

struct Options {
  unsigned threads = 1;
  /// How many conclusions by cases are derived for one class before models are built. Deriving is faster if there are
  /// few, as in SOMA. With more, a model takes few steps, and deriving takes every combination.
  std::uint32_t alternatives = 200;
  /// A budget for all engines together. When it is spent, the result is what is certain by then. Without it each engine
  /// has its own limits only. Borrowed.
  base::Budget* budget = nullptr;
  /// Called from time to time on the caller's thread, with what is being done and how far it is, in [0, 1].
  std::function<void(std::string_view phase, double done)> progress{};
};

/// Questions that the searches of a classification leave open. Consequences of unused axioms are not among them.
struct Undecided {
  /// Classes that may have further subsumers or be unsatisfiable, ascending.
  std::vector<taxonomy::ClassNumber> classes;
  bool consistency = false;  ///< whether the ontology has a model; where it has none, everything follows
  /// The class that the engines worked on when a limit was reached, or the first that was too hard.
  std::optional<taxonomy::ClassNumber> held_up_by;
};

/// The taxonomy that the engines together derive. It is cut off if the budget was spent.
struct Classified : taxonomy::Classification {
  /// Why something may be missing although its axioms were used, one line each: sorted, without doubles. If this and
  /// `unused` are empty, the taxonomy is proven complete.
  std::vector<std::string> gaps;
  Undecided undecided;  ///< nothing where `gaps` is empty
  /// Why it is not known whether the axioms have a model, in one line: no model was found, or an axiom is in no clause.
  /// Empty: they have one, or `is_consistent` is false.
  std::string consistency_gap;
};

/// Classifies with all engines. `unused` of the result lists the axioms that no engine uses in full. Where a limit or
/// memory ended the work before the engines beyond EL, it lists those that el does not use. An EL ontology costs what
/// el::classify() costs.
[[nodiscard]] std::expected<Classified, el::ClassifyError> classify(const owl::Ontology& source,
                                                                    const Options& options = {});

/// Whether the axioms of the source have a model. What the reader left out does not count. Work is taken from the
/// budget, if there is one; when it is spent the answer may be unknown.
[[nodiscard]] Answer is_consistent(const owl::Ontology& source, base::Budget* budget = nullptr);

/// Whether these axioms (numbers in the source; nothing: all) entail that every instance of the class expression `sub`
/// is one of `super`. Both are terms of the source.
[[nodiscard]] Answer entails(const owl::Ontology& source, std::optional<std::span<const std::uint32_t>> axioms,
                             owl::TermId sub, owl::TermId super, base::Budget* budget = nullptr);

/// Whether each of the axioms `conclusion` follows from the axioms `premise`. Both are numbers in the source. Every
/// kind of axiom may stand on either side. Anonymous individuals of the conclusion mean "something", and facts that
/// share one have one answer. Everything follows from a contradiction.
[[nodiscard]] std::vector<Answer> entails_each(const owl::Ontology& source, std::span<const std::uint32_t> premise,
                                               std::span<const std::uint32_t> conclusion,
                                               base::Budget* budget = nullptr);

}  // namespace geminga::reasoner

#endif
