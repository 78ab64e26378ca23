// Looks for a model of every class first, then asks about the pairs that all models leave open.
#include "reasoning/reasoner/completion.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "base/sorted.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/reasoner/named_concepts.hpp"

namespace geminga::reasoner {
namespace {

using Numbers = std::vector<std::uint32_t>;

bool contains(const Numbers& sorted, std::uint32_t wanted) { return std::ranges::binary_search(sorted, wanted); }

void insert(Numbers& sorted, std::uint32_t added) {
  const auto place = std::ranges::lower_bound(sorted, added);
  if (place == sorted.end() || *place != added) sorted.insert(place, added);
}

/// The most steps for a fact in the one model of all facts, and for one of the many inequalities of individuals.
constexpr std::size_t steps_a_fact = 500;
constexpr std::size_t steps_an_inequality = 4;

class Completing {
 public:
  Completing(const owl::Ontology& source, const Incomplete& given, const Options& options,
             const CompletionLimits& limits)
      : source_(source),
        given_(given),
        classification_(given.classification),
        options_(options),
        limits_(limits),
        question_(limits.question),
        top_(representative(static_cast<std::uint32_t>(classification_.thing))),
        bottom_(representative(static_cast<std::uint32_t>(classification_.nothing))) {
    question_.budget = options.budget;
    const clauses::ClauseSet& set = given.clauses;
    const std::size_t facts =
        set.individuals.size() + set.concept_facts.size() + set.role_facts.size() + set.data_facts.size();
    // Without an answer to the first question all others have none, so it may take the steps of all.
    question_.world_steps = steps_a_fact * facts + steps_an_inequality * set.equalities.size() + most_vain_steps();
    if (has_limit()) question_.world_steps = std::max(question_.world_steps, limits.steps / 2);
    question_.nodes += set.individuals.size() + set.data_facts.size();
  }

  Completion run() {
    if (classification_.class_count() > limits_.classes) {
      gaps_.insert("more than " + std::to_string(limits_.classes) + " classes are too many to look for models");
      result_.is_consistency_open = true;
      for (std::uint32_t of = 0; of < classification_.class_count(); ++of) {
        if (is_asked(of) && !given_.is_settled[of]) result_.open.push_back(of);
      }
      return finish();
    }
    known_ = find_ancestors(classification_);
    possible_.resize(known_.size());
    is_empty_.assign(known_.size(), false);
    has_model_.assign(known_.size(), false);
    for (std::uint32_t of = 0; of < known_.size(); ++of) {
      if (given_.is_settled[of]) possible_[representative(of)] = known_[representative(of)];
    }
    const NamedConcepts concepts(source_, classification_, given_.clauses);
    hypertableau::Tableau tableau(source_, given_.clauses, question_);
    find_models(tableau, concepts);
    if (result_.is_consistent) ask_pairs(tableau, concepts);
    return finish();
  }

 private:
  [[nodiscard]] std::uint32_t representative(std::uint32_t of) const {
    return static_cast<std::uint32_t>(classification_.representative[of]);
  }
  [[nodiscard]] bool is_asked(std::uint32_t of) const {
    return representative(of) == of && of != top_ && of != bottom_;
  }

  Completion finish() {
    for (std::uint32_t of = 0; of < possible_.size() && !gaps_.empty(); ++of) {
      const bool is_open = !possible_[of] || !open_above(of).empty();
      if ((is_asked(of) || of == top_) && !is_empty_[of] && is_open) result_.open.push_back(of);
    }
    // A question that was too hard may have been answered by the model of another one.
    if (result_.open.empty() && !result_.is_consistency_open) {
      gaps_.clear();
      result_.held_up_by.reset();
    }
    result_.gaps.assign(gaps_.begin(), gaps_.end());
    return std::move(result_);
  }

  /// False if no more questions may be asked, or none about this class.
  bool may_ask(std::uint32_t of, const hypertableau::Tableau& tableau, double done) {
    if (options_.progress) options_.progress("looking for models", done);
    const auto spent = options_.budget == nullptr ? std::nullopt : options_.budget->reason();
    const bool has_steps = tableau.steps() - former_steps_ < limits_.steps;
    const bool is_too_hard = unanswered_ >= limits_.unanswered || vain_steps_ >= most_vain_steps();
    if (!spent && has_steps && questions_ < limits_.questions && !is_too_hard) return true;
    if (!result_.held_up_by) result_.held_up_by = of;
    if (spent) {
      gaps_.insert(*spent);
    } else if (is_too_hard) {
      gaps_.insert(std::to_string(unanswered_) + " questions were too hard for the tableau");
    } else if (!has_steps) {
      gaps_.insert("more than " + std::to_string(limits_.steps) + " steps of the tableau");
    } else {
      gaps_.insert("more than " + std::to_string(limits_.questions) + " questions to the tableau");
    }
    return false;
  }

  /// The steps that questions without an answer may take together. They may have a good part of those of the search,
  /// because the search saves more if it succeeds.
  [[nodiscard]] std::size_t most_vain_steps() const {
    constexpr std::size_t vain_part = 8;
    return std::max(limits_.unanswered * limits_.question.steps, has_limit() ? limits_.steps / vain_part : 0);
  }
  /// Whether the steps of the search are bounded, not only those of each question.
  [[nodiscard]] bool has_limit() const { return limits_.steps != std::numeric_limits<std::size_t>::max(); }

  /// Asks about a class. Where there is no answer, later questions may take twice as many steps: the first model may be
  /// large, and when it is kept the others take few.
  Verdict ask(std::uint32_t of, clauses::ConceptId inside, hypertableau::Tableau& tableau,
              std::optional<clauses::ConceptId> outside = std::nullopt) {
    const std::size_t before = tableau.steps();
    const Verdict verdict = note(tableau.is_satisfiable({inside}, outside), of);
    if (verdict != Verdict::unknown) return verdict;
    vain_steps_ += tableau.steps() - before;
    const std::size_t left = most_vain_steps() - std::min(most_vain_steps(), vain_steps_);
    question_.steps = std::min(2 * question_.steps, std::max(left, limits_.question.steps));
    tableau.limit_steps(question_.steps);
    return verdict;
  }

  /// Notes the answer to a question about a class, or about the whole ontology.
  Verdict note(const Answer& answer, std::optional<std::uint32_t> of) {
    ++questions_;
    if (answer.verdict == Verdict::unknown) {
      ++unanswered_;
      gaps_.insert(answer.reason);
      if (of && !result_.held_up_by) result_.held_up_by = of;
    }
    return answer.verdict;
  }

  /// Every instance in a model bounds the subsumers of the classes that it is in.
  void learn(const hypertableau::Model& model, const NamedConcepts& concepts) {
    std::vector<Numbers> labels;
    for (const auto& label : model.labels) labels.push_back(classes_of(label, concepts));
    base::sort_unique(labels);
    for (const Numbers& label : labels) learn(label);
  }
  void learn(const Numbers& label) {
    narrow(top_, label, known_[top_].size());
    for (const std::uint32_t of : label) narrow(of, label, known_[of].size() + 1);
  }

  /// For each of these classes derivation has shown the label of an instance in a model.
  void learn_plain() {
    for (std::uint32_t of = 0; of < known_.size(); ++of) {
      if (!given_.is_plain[of] || !is_asked(of)) continue;
      Numbers label = known_[of];
      insert(label, of);
      learn(label);
    }
  }

  /// Bounds the possible subsumers of a class by a label, unless no more than the `closed` known ones, itself included,
  /// are possible.
  void narrow(std::uint32_t of, const Numbers& label, std::size_t closed) {
    if (!possible_[of]) {
      possible_[of] = label;
    } else if (possible_[of]->size() > closed) {
      std::erase_if(*possible_[of], [&](std::uint32_t above) { return !contains(label, above); });
    }
  }

  [[nodiscard]] Numbers classes_of(const std::vector<clauses::ConceptId>& label, const NamedConcepts& concepts) const {
    Numbers classes;
    for (const clauses::ConceptId concept_id : label) {
      const auto named = concepts.class_of(concept_id);
      if (named && representative(*named) != top_) classes.push_back(representative(*named));
    }
    base::sort_unique(classes);
    return classes;
  }

  void add(std::uint32_t sub, std::uint32_t super) {
    result_.found.emplace_back(sub, super);
    insert(known_[sub], super);
    const Numbers above = known_[super];
    for (const std::uint32_t higher : above) {
      if (higher != sub) insert(known_[sub], higher);
    }
  }

  void inherit(std::uint32_t of) {
    if (result_.found.empty()) return;
    const Numbers direct = known_[of];
    for (const std::uint32_t above : direct) {
      for (const std::uint32_t higher : known_[above]) {
        if (higher != of) insert(known_[of], higher);
      }
    }
  }

  void set_empty(std::uint32_t of) {
    is_empty_[of] = true;
    result_.found.emplace_back(of, static_cast<std::uint32_t>(classification_.nothing));
  }

  /// The classes with the most subsumers first: their models are models of all their subsumers, too.
  [[nodiscard]] Numbers lowest_first() const {
    Numbers order;
    for (std::uint32_t of = 0; of < known_.size(); ++of) {
      if (is_asked(of)) order.push_back(of);
    }
    std::ranges::stable_sort(order,
                             [&](std::uint32_t a, std::uint32_t b) { return known_[a].size() > known_[b].size(); });
    return order;
  }

  void find_models(hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    const Verdict world = note(tableau.is_consistent(), std::nullopt);
    former_steps_ = tableau.steps();
    result_.is_consistency_open = world == Verdict::unknown;
    if (world == Verdict::no) result_.is_consistent = false;
    if (world == Verdict::no) return;
    if (world == Verdict::yes) {
      // An instance of a class needs neighbours as the individuals do, and so a good part of the steps that these took.
      const std::size_t most = std::max(limits_.question.steps, 2 * most_vain_steps());
      question_.steps = std::clamp(former_steps_ / 2, limits_.question.steps, most);
      tableau.limit_steps(question_.steps);
      learn(tableau.model(), concepts);
      learn_plain();
    }
    const Numbers order = lowest_first();
    find_models_of(order, tableau, concepts);
    // Questions that were too hard may be answered with more steps, beside models that were found since.
    if (unanswered_ == 0) return;
    for (const std::uint32_t of : order) has_model_[of] = possible_[of].has_value();
    find_models_of(order, tableau, concepts);
  }

  /// Looks for models of these classes in turn, until no more may be asked.
  void find_models_of(const Numbers& order, hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    for (std::size_t at = 0; at < order.size(); ++at) {
      const double done = 0.5 * static_cast<double>(at) / static_cast<double>(order.size());
      if (!find_model(order[at], tableau, concepts, done)) return;
      if (!is_empty_[order[at]]) continue;
      // A class is often empty because a subsumer is. Then its siblings are empty, too, so the highest class is asked
      // first.
      Numbers above = known_[order[at]];
      std::ranges::stable_sort(above, {}, [&](std::uint32_t of) { return known_[of].size(); });
      for (std::size_t next = 0; next < above.size() && (next == 0 || !is_empty_[above[next - 1]]); ++next) {
        if (!find_model(above[next], tableau, concepts, done)) return;
      }
    }
  }

  /// Whether all subsumers of the class are known, or that it is empty.
  [[nodiscard]] bool is_closed(std::uint32_t of) const {
    return is_empty_[of] || (possible_[of] && possible_[of]->size() <= known_[of].size() + 1);
  }

  /// Looks for a model with an instance of the class, unless other models have answered everything. False: no more may
  /// be asked.
  bool find_model(std::uint32_t of, hypertableau::Tableau& tableau, const NamedConcepts& concepts, double done) {
    if (!is_asked(of) || is_closed(of) || has_model_[of]) return true;
    if (std::ranges::any_of(known_[of], [&](std::uint32_t above) { return is_empty_[above]; })) {
      set_empty(of);
      return true;
    }
    const auto asked = concepts.concept_of(of);
    // A class that no clause mentions has no other subsumers.
    if (!asked) possible_[of] = known_[of];
    if (!asked) return true;
    if (!may_ask(of, tableau, done)) return false;
    has_model_[of] = true;
    const Verdict verdict = ask(of, *asked, tableau);
    if (verdict == Verdict::no) set_empty(of);
    if (verdict != Verdict::yes) return true;
    for (const std::uint32_t above : classes_of(tableau.model().certain, concepts)) {
      if (above != of && !contains(known_[of], above)) add(of, above);
    }
    learn(tableau.model(), concepts);
    return true;
  }

  [[nodiscard]] Numbers open_above(std::uint32_t of) const {
    Numbers open;
    if (!possible_[of] || is_empty_[of]) return open;
    for (const std::uint32_t above : *possible_[of]) {
      if (above == of || is_empty_[above] || contains(known_[of], above)) continue;
      if (!contains(known_[top_], above)) open.push_back(above);
    }
    // The most specific first: a yes answers all of its subsumers.
    std::ranges::stable_sort(open,
                             [&](std::uint32_t a, std::uint32_t b) { return known_[a].size() > known_[b].size(); });
    return open;
  }

  void ask_pairs(hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    // The subsumers of a class need not be asked again for the classes below it.
    Numbers order = lowest_first();
    order.push_back(top_);
    std::ranges::reverse(order);
    tableau.begin_anew();
    // Pairs may take as many steps as models may.
    former_steps_ = tableau.steps();
    const std::size_t unanswered = unanswered_;
    ask_pairs_of(order, tableau, concepts);
    if (unanswered_ > unanswered) ask_pairs_of(order, tableau, concepts);
  }

  /// The concept of a class, or of one that is known to be equivalent: an axiom that only el uses may name the class.
  [[nodiscard]] std::optional<clauses::ConceptId> concept_of_any(std::uint32_t representative_of,
                                                                 const NamedConcepts& concepts) const {
    auto found = concepts.concept_of(representative_of);
    for (std::uint32_t of = 0; of < known_.size() && !found; ++of) {
      if (representative(of) == representative_of) found = concepts.concept_of(of);
    }
    return found;
  }

  /// Asks about the pairs of these classes that are open, until no more may be asked.
  void ask_pairs_of(const Numbers& order, hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    for (std::size_t at = 0; at < order.size(); ++at) {
      const std::uint32_t of = order[at];
      const auto sub = concepts.concept_of(of);
      inherit(of);
      for (const std::uint32_t above : open_above(of)) {
        if (!sub || contains(known_[of], above) || contains(known_[top_], above)) continue;
        if (!contains(*possible_[of], above)) continue;
        if (!may_ask(of, tableau, 0.5 + 0.5 * static_cast<double>(at) / static_cast<double>(order.size()))) return;
        const Verdict verdict = ask(of, *sub, tableau, concept_of_any(above, concepts));
        if (verdict == Verdict::no) add(of, above);
        if (verdict == Verdict::yes) learn(tableau.model(), concepts);
      }
    }
  }

  const owl::Ontology& source_;
  const Incomplete& given_;
  const taxonomy::Classification& classification_;
  const Options& options_;
  const CompletionLimits& limits_;
  hypertableau::QuestionLimits question_;
  std::uint32_t top_;
  std::uint32_t bottom_;
  Completion result_;
  std::set<std::string> gaps_;
  std::size_t questions_ = 0;
  std::size_t unanswered_ = 0;
  std::size_t vain_steps_ = 0;                    ///< of questions about classes without an answer
  std::size_t former_steps_ = 0;                  ///< before the models of classes, and before the pairs
  std::vector<Numbers> known_;                    ///< by representative: what is strictly above it, ascending
  std::vector<std::optional<Numbers>> possible_;  ///< by representative: what may be above it, itself (but T) included
  std::vector<bool> has_model_;                   ///< by representative: a model of it was looked for
  std::vector<bool> is_empty_;                    ///< by representative: found to be below owl:Nothing
};

}  // namespace

Completion complete(const owl::Ontology& source, const Incomplete& known, const Options& options,
                    const CompletionLimits& limits) {
  return Completing(source, known, options, limits).run();
}

}  // namespace geminga::reasoner
