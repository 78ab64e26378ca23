// The reasoner as its users see it: classifies, decides and completes with whichever engine the question needs.
//
// el saturates what is EL (and functional properties) and is the fastest; consequence derives what follows with
// inverses, universals, unions and cardinalities; tableau builds models, which shows what does not follow. Every answer
// is sound. It is complete where el used all, or where consequence has no gap, or where a model was found for every
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
  /// Conclusions by cases that are derived for one class before it is left to models. Deriving wins where there are
  /// few, as in SOMA; beyond, a model settles in a few steps what takes every combination to derive.
  std::uint32_t alternatives = 200;
  /// What all engines may cost together; nothing: only each engine's own limits hold. Borrowed. Where it is spent, what
  /// is certain by then is the result.
  base::Budget* budget = nullptr;
  /// Called now and then with what is being done and how far it is, in [0, 1]; on the caller's thread.
  std::function<void(std::string_view phase, double done)> progress{};
};

/// What the searches of a classification leave open. What may be missing because axioms were not used is not in it.
struct Undecided {
  /// Classes above which something may be missing, their being empty included: ascending.
  std::vector<taxonomy::ClassNumber> classes;
  bool consistency = false;  ///< whether the ontology has a model; where it has none, everything follows
  /// The class that the engines worked on when their limit came, or the first that was too hard for them.
  std::optional<taxonomy::ClassNumber> held_up_by;
};

/// The taxonomy as the engines together know it. It is cut off where the budget was spent.
struct Classified : taxonomy::Classification {
  /// Why something may be missing although its axioms were used, one line each: sorted, without doubles. Where this and
  /// `unused` are empty, the taxonomy is proven complete.
  std::vector<std::string> gaps;
  Undecided undecided;  ///< nothing where `gaps` is empty
};

/// Classifies with all engines. `unused` of the result lists what may have more to say than was understood, axiom by
/// axiom; it is empty where the taxonomy is proven complete. An ontology that is EL costs what el::classify() costs.
[[nodiscard]] std::expected<Classified, el::ClassifyError> classify(const owl::Ontology& source,
                                                                    const Options& options = {});

/// Whether the axioms of the source have a model. What the reader left out is not looked at.
/// Work is taken from the budget, if there is one; where that is spent the answer may be unknown.
[[nodiscard]] Answer is_consistent(const owl::Ontology& source, base::Budget* budget = nullptr);

/// Whether these axioms (numbers in the source; nothing: all) entail that every instance of class expression `sub` is
/// one of `super`. Both are terms of the source.
[[nodiscard]] Answer entails(const owl::Ontology& source, std::optional<std::span<const std::uint32_t>> axioms,
                             owl::TermId sub, owl::TermId super, base::Budget* budget = nullptr);

/// Of each of the axioms `conclusion`, whether it follows from the axioms `premise`; both are numbers in the source.
/// Every kind of axiom may stand on either side. Anonymous individuals of the conclusion mean "something"; facts that
/// share one stand or fall together. Everything follows from a contradiction.
[[nodiscard]] std::vector<Answer> entails_each(const owl::Ontology& source, std::span<const std::uint32_t> premise,
                                               std::span<const std::uint32_t> conclusion,
                                               base::Budget* budget = nullptr);

}  // namespace geminga::reasoner

#endif
