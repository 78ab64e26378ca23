// Classification: first the fastest engine, then the one that derives more, then models for what both leave open.
#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "base/sorted.hpp"
#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/reasoner/completion.hpp"
#include "reasoning/reasoner/named_concepts.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/taxonomy.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::reasoner {
namespace {

/// How many clauses may be derived. The limit grows with the number of clauses that are written, so that a small file
/// that means much takes the memory of a small file (a clause takes about 150 octets), and has a bound that no known
/// ontology comes near.
constexpr std::size_t always_derived = 400'000;
constexpr std::size_t derived_per_axiom = 100;
constexpr std::size_t max_clauses_of_classes = 5'000'000;
/// The most steps of the budget that a clause may take, vain attempts included. Half of the budget is kept for models.
constexpr std::size_t steps_per_clause = 100;

/// For a result whose last gap says why.
void leave_all_undecided(Classified& result) {
  result.consistency_gap = result.gaps.back();
  result.undecided.consistency = true;
  result.undecided.classes.clear();
  const auto empty = result.representative[static_cast<std::size_t>(result.nothing)];
  for (std::uint32_t of = 0; of < result.class_count(); ++of) {
    const bool is_settled = of < result.is_settled.size() && result.is_settled[of];
    if (result.representative[of] != empty && !is_settled)
      result.undecided.classes.push_back(taxonomy::ClassNumber{of});
  }
}

/// Where there are alternatives or nominals, models may be found in less time than deriving takes, or deriving may end
/// soon after a limit where models take long. Neither is known before. So both get a first limit, in turn, and after
/// each turn one that is several times as large. What a turn settles is not asked again. Together they take a few
/// times as long as the faster of the two alone.
constexpr std::size_t first_derived = 20'000;
constexpr std::size_t first_derived_per_axiom = 15;
constexpr std::size_t growth_a_turn = 4;
constexpr std::size_t quick_unanswered = 3;
/// A search may take as many steps as take the time of the derivation before it.
constexpr std::size_t steps_a_derived_clause = 8;

/// Most classes have a model within these limits. If some have none, more is derived by cases before the search goes
/// on. The limits grow with the ontology, because a model does.
hypertableau::QuestionLimits quick_question(const owl::Ontology& source) {
  constexpr std::size_t steps = 50'000;
  constexpr std::size_t steps_per_axiom = 10;
  return {.nodes = 20'000, .steps = steps + steps_per_axiom * source.axiom_count()};
}

bool has_branches(const clauses::ClauseSet& clauses) {
  const auto is_nominal = [](const clauses::Concept& one) { return one.kind == clauses::ConceptKind::nominal; };
  return std::ranges::any_of(clauses.concepts, is_nominal) ||
         std::ranges::any_of(clauses.clauses, [](const clauses::Clause& clause) { return clause.head.size() > 1; });
}

constexpr std::uint64_t more_alternatives = 25;
constexpr std::uint64_t most_alternatives = 1'000'000;

/// Adds what follows from the clauses.
class Deepening {
 public:
  Deepening(const owl::Ontology& source, const Options& options, Classified& result)
      : source_(source), options_(options), result_(result) {}

  void run() {
    report("translating to clauses", 0);
    auto clauses = clauses::clausify(source_, std::nullopt, {}, {}, {.budget = options_.budget});
    if (!clauses) {
      result_.gaps.push_back(clauses.error().text);
      leave_all_undecided(result_);
      return;
    }
    is_settled_ = result_.is_settled;
    is_settled_.resize(result_.class_count(), false);
    is_plain_.assign(result_.class_count(), false);
    if (!derive_first(*clauses)) derive(*clauses, options_.alternatives);
    bool is_open = !is_finished();
    if (is_open && std::ranges::find(result_.gaps, consequence::alternative_gap) != result_.gaps.end()) {
      search(*clauses, {.unanswered = quick_unanswered, .question = quick_question(source_)});
      is_open = !is_finished() && !is_spent();
      // Some questions are hard for a search and easy by cases.
      if (is_open) {
        derive(*clauses,
               static_cast<std::uint32_t>(std::min(options_.alternatives * more_alternatives, most_alternatives)));
      }
    }
    if (is_open && !is_finished()) search(*clauses, {});
    std::vector<clauses::Unused> unused = clauses->unused;
    unused.insert(unused.end(), clauses->open_rules.begin(), clauses->open_rules.end());
    note_unused(unused);
    note_consistency(*clauses);
  }

 private:
  void report(std::string_view phase, double done) const {
    if (options_.progress) options_.progress(phase, done);
  }

  [[nodiscard]] bool is_finished() const { return !result_.is_consistent || result_.gaps.empty(); }

  [[nodiscard]] bool is_spent() const { return options_.budget != nullptr && options_.budget->is_spent(); }

  /// How many clauses a derivation may have.
  [[nodiscard]] std::size_t most_derived() const {
    const std::size_t most =
        std::min(max_clauses_of_classes, always_derived + derived_per_axiom * source_.axiom_count());
    if (options_.budget == nullptr) return most;
    return std::min<std::size_t>(most, options_.budget->left() / 2 / steps_per_clause);
  }

  /// False: the limits were reached, and models have not decided what is open.
  bool derive_first(const clauses::ClauseSet& clauses) {
    if (!has_branches(clauses)) return false;
    const std::size_t most = most_derived();
    for (std::size_t limit = first_derived + first_derived_per_axiom * source_.axiom_count(); limit < most;
         limit *= growth_a_turn) {
      if (derive(clauses, options_.alternatives, limit)) return true;
      search(clauses, {.unanswered = quick_unanswered,
                       .steps = steps_a_derived_clause * limit,
                       .question = quick_question(source_)});
      if (is_finished() || is_spent()) return true;
    }
    return false;
  }

  /// False: a limit was reached.
  bool derive(const clauses::ClauseSet& clauses, std::uint32_t alternatives,
              std::size_t limit = max_clauses_of_classes) {
    result_.undecided = {};
    report("deriving consequences", 0.1);
    const NamedConcepts concepts(source_, result_, clauses);
    std::vector<clauses::ConceptId> wanted;
    std::vector<std::uint32_t> classes;
    for (std::uint32_t of = 0; of < result_.class_count(); ++of) {
      if (is_settled_[of]) continue;
      const auto found = concepts.concept_of(of);
      if (!found || result_.representative[of] == result_.representative[static_cast<std::size_t>(result_.nothing)])
        continue;
      wanted.push_back(*found);
      classes.push_back(of);
    }
    const std::size_t most = std::min(limit, most_derived());
    const consequence::Closure closure = consequence::saturate(
        source_, clauses, wanted,
        {.threads = options_.threads, .clauses = most, .alternatives = alternatives, .budget = options_.budget});
    if (!closure.is_consistent) {
      contradict(result_, source_);
      return true;
    }
    Subsumptions more;
    for (std::size_t at = 0; at < classes.size(); ++at) {
      for (const clauses::ConceptId above : closure.subsumers[at]) {
        const auto super = concepts.class_of(above);
        if (super && *super != classes[at]) more.emplace_back(classes[at], *super);
      }
    }
    extend(result_, more);
    result_.gaps = closure.gaps;
    for (std::size_t at = 0; at < classes.size(); ++at) {
      is_settled_[classes[at]] = closure.is_settled[at];
      is_plain_[classes[at]] = closure.is_plain[at];
    }
    return !closure.is_cut_off;
  }

  void search(const clauses::ClauseSet& clauses, const CompletionLimits& limits) {
    Completion completion = complete(source_, {result_, clauses, is_settled_, is_plain_}, options_, limits);
    if (!completion.is_consistent) return contradict(result_, source_);
    if (!completion.gaps.empty()) {
      note_undecided(completion);
      if (!completion.is_consistency_open) settle_all_but(result_.undecided.classes);
    }
    extend(result_, completion.found);
    if (completion.gaps.empty()) {
      result_.gaps.clear();
    } else {
      std::ranges::move(completion.gaps, std::back_inserter(result_.gaps));
      base::sort_unique(result_.gaps);
    }
  }

  /// The classes are representatives of the taxonomy that was completed.
  void note_undecided(const Completion& completion) {
    std::vector<bool> is_open(result_.class_count(), false);
    for (const std::uint32_t of : completion.open) is_open[of] = true;
    result_.undecided = {.classes = {}, .consistency = completion.is_consistency_open, .held_up_by = std::nullopt};
    if (completion.held_up_by) result_.undecided.held_up_by = taxonomy::ClassNumber{*completion.held_up_by};
    for (std::uint32_t of = 0; of < result_.class_count(); ++of) {
      if (is_open[static_cast<std::size_t>(result_.representative[of])])
        result_.undecided.classes.push_back(taxonomy::ClassNumber{of});
    }
  }

  /// Classes that models have completed need not be derived again.
  void settle_all_but(const std::vector<taxonomy::ClassNumber>& open) {
    is_settled_.assign(result_.class_count(), true);
    for (const taxonomy::ClassNumber of : open) is_settled_[static_cast<std::size_t>(of)] = false;
  }

  /// Only axioms without clauses are unused. Where a limit ended a search, the gaps say so.
  void note_unused(const std::vector<clauses::Unused>& unused) {
    result_.unused.clear();
    if (!result_.is_consistent) {
      result_.gaps.clear();
      result_.undecided = {};
    } else {
      for (const clauses::Unused& entry : unused) result_.unused.push_back({entry.axiom, entry.construct});
      std::ranges::stable_sort(result_.unused, {}, &taxonomy::UnusedAxiom::axiom);
      result_.unused.erase(std::ranges::unique(result_.unused, {}, &taxonomy::UnusedAxiom::axiom).begin(),
                           result_.unused.end());
    }
    const auto is_declared = [&](const taxonomy::UnusedAxiom& entry) {
      return source_.axiom(entry.axiom).kind == owl::AxiomKind::declaration;
    };
    result_.counts.used_axioms =
        result_.counts.axioms -
        (result_.unused.size() - static_cast<std::size_t>(std::ranges::count_if(result_.unused, is_declared)));
  }

  /// A model of the clauses is one of the axioms if each axiom is in them.
  void note_consistency(const clauses::ClauseSet& clauses) {
    if (!result_.is_consistent) return;
    if (result_.undecided.consistency) {
      result_.consistency_gap = result_.gaps.front();
    } else if (!clauses.unused.empty()) {
      const clauses::Unused& first = clauses.unused.front();
      result_.consistency_gap = describe_unused(source_, first.axiom, first.construct);
    }
  }

  const owl::Ontology& source_;
  const Options& options_;
  Classified& result_;
  std::vector<bool> is_settled_;  ///< by class: that no gap matters to it
  std::vector<bool> is_plain_;    ///< by class: see Closure::is_plain
};

}  // namespace

std::expected<Classified, el::ClassifyError> classify(const owl::Ontology& source, const Options& options) {
  if (options.progress) options.progress("classifying", 0);
  auto found = el::classify(source, {.threads = options.threads, .budget = options.budget});
  if (!found) return std::unexpected(std::move(found.error()));
  Classified result{std::move(*found), {}, {}, {}};
  if (!result.is_consistent) {
    result.unused.clear();  // nothing can be missing where everything follows
    return result;
  }
  if (result.is_cut_off) {
    result.gaps.push_back(*options.budget->reason());
    leave_all_undecided(result);
    return result;
  }
  if (result.unused.empty()) return result;
  // If memory does not suffice for the engines beyond EL, the result is that of EL.
  Classified deepened = result;
  try {
    Deepening(source, options, deepened).run();
  } catch (const std::bad_alloc&) {
    result.gaps.emplace_back("there is not enough memory for more than the EL part");
    leave_all_undecided(result);
    return result;
  }
  deepened.is_cut_off = options.budget != nullptr && options.budget->is_spent();
  return deepened;
}

}  // namespace geminga::reasoner
