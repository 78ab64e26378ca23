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
#include "reasoning/reasoner/subsumers.hpp"

namespace geminga::reasoner {
namespace {

/// The most steps for a fact in the one model of all facts, and for one of the many inequalities of individuals.
constexpr std::size_t steps_a_fact = 500;
constexpr std::size_t steps_an_inequality = 4;

/// Whether questions about several pairs at once are worth their steps.
class JointQuestions {
 public:
  /// A question about one class or one pair was answered.
  void note_single(std::size_t steps) {
    ++singles_;
    single_steps_ += steps;
  }
  void note_refuted(std::size_t pairs, std::size_t steps) { balance_ += as_signed(pairs * usual_steps(), steps); }
  void note_vain(std::size_t steps) { balance_ += as_signed(0, steps); }

  /// Whether they have saved steps, or lost few beside those of single questions.
  [[nodiscard]] bool are_worth_it() const {
    return balance_ > -static_cast<std::int64_t>(patience + single_steps_ / 4);
  }
  /// The most steps that a question about so many pairs may take.
  [[nodiscard]] std::size_t most_steps(std::size_t pairs) const { return times * pairs * usual_steps(); }

 private:
  static constexpr std::size_t patience = 50'000;  ///< steps that may be lost
  static constexpr std::size_t times = 8;          ///< the steps of the pairs, at most

  /// Of a question about one class or pair.
  [[nodiscard]] std::size_t usual_steps() const {
    constexpr std::size_t least = 500;
    return singles_ == 0 ? least : std::max(least, single_steps_ / singles_);
  }
  [[nodiscard]] static std::int64_t as_signed(std::size_t saved, std::size_t taken) {
    return static_cast<std::int64_t>(saved) - static_cast<std::int64_t>(taken);
  }

  std::size_t singles_ = 0;
  std::size_t single_steps_ = 0;
  std::int64_t balance_ = 0;  ///< steps saved, less those taken
};

class Completing {
 public:
  Completing(const owl::Ontology& source, const Incomplete& given, const Options& options,
             const CompletionLimits& limits)
      : source_(source),
        given_(given),
        options_(options),
        limits_(limits),
        question_(limits.question),
        subsumers_(given.classification),
        has_model_(given.classification.class_count(), false) {
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
    for (std::uint32_t of = 0; of < class_count(); ++of) {
      if (given_.is_settled[of]) subsumers_.close(subsumers_.representative(of));
    }
    const NamedConcepts concepts(source_, given_.classification, given_.clauses);
    hypertableau::Tableau tableau(source_, given_.clauses, question_);
    find_models(tableau, concepts);
    if (result_.is_consistent) ask_pairs(tableau, concepts);
    return finish();
  }

 private:
  [[nodiscard]] std::size_t class_count() const { return given_.classification.class_count(); }

  Completion finish() {
    for (std::uint32_t of = 0; of < class_count() && !gaps_.empty(); ++of) {
      const bool is_open = !subsumers_.has_bound(of) || !subsumers_.open_above(of).empty();
      const bool is_asked = subsumers_.is_asked(of) || of == subsumers_.top();
      if (is_asked && !subsumers_.is_empty(of) && is_open) result_.open.push_back(of);
    }
    // A question that was too hard may have been answered by the model of another one.
    if (result_.open.empty() && !result_.is_consistency_open) {
      gaps_.clear();
      result_.held_up_by.reset();
    }
    result_.gaps.assign(gaps_.begin(), gaps_.end());
    result_.found = subsumers_.found();
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
              const std::vector<clauses::ConceptId>& outside = {}) {
    const std::size_t before = tableau.steps();
    const Verdict verdict = note(tableau.is_satisfiable({inside}, outside), of);
    if (verdict != Verdict::unknown) {
      joint_.note_single(tableau.steps() - before);
      return verdict;
    }
    put_off_ = of;
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
    std::vector<ClassNumbers> labels;
    for (const auto& label : model.labels) labels.push_back(classes_of(label, concepts));
    base::sort_unique(labels);
    for (const ClassNumbers& label : labels) subsumers_.learn(label);
  }

  /// For each of these classes derivation has shown the label of an instance in a model.
  void learn_plain() {
    for (std::uint32_t of = 0; of < class_count(); ++of) {
      if (given_.is_plain[of] && subsumers_.is_asked(of)) subsumers_.learn_plain(of);
    }
  }

  [[nodiscard]] ClassNumbers classes_of(const std::vector<clauses::ConceptId>& label,
                                        const NamedConcepts& concepts) const {
    ClassNumbers classes;
    for (const clauses::ConceptId concept_id : label) {
      const auto named = concepts.class_of(concept_id);
      if (named && subsumers_.representative(*named) != subsumers_.top())
        classes.push_back(subsumers_.representative(*named));
    }
    base::sort_unique(classes);
    return classes;
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
    const ClassNumbers order = subsumers_.lowest_first();
    find_models_of(order, tableau, concepts);
    // Questions that were too hard may be answered with more steps, beside models that were found since.
    if (unanswered_ == 0) return;
    for (const std::uint32_t of : order) has_model_[of] = subsumers_.has_bound(of);
    find_models_of(order, tableau, concepts);
  }

  /// Looks for models of these classes in turn, until no more may be asked.
  void find_models_of(const ClassNumbers& order, hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    for (std::size_t at = 0; at < order.size(); ++at) {
      const double done = 0.5 * static_cast<double>(at) / static_cast<double>(order.size());
      if (!find_model(order[at], tableau, concepts, done)) return;
      if (!subsumers_.is_empty(order[at])) continue;
      // A class is often empty because a subsumer is. Then its siblings are empty, too, so the highest class is asked
      // first.
      ClassNumbers above = subsumers_.known(order[at]);
      std::ranges::stable_sort(above, {}, [&](std::uint32_t of) { return subsumers_.known(of).size(); });
      for (std::size_t next = 0; next < above.size() && (next == 0 || !subsumers_.is_empty(above[next - 1])); ++next) {
        if (!find_model(above[next], tableau, concepts, done)) return;
      }
    }
  }

  /// Looks for a model with an instance of the class, unless other models have answered everything. False: no more may
  /// be asked.
  bool find_model(std::uint32_t of, hypertableau::Tableau& tableau, const NamedConcepts& concepts, double done) {
    if (!subsumers_.is_asked(of) || subsumers_.is_closed(of) || has_model_[of]) return true;
    if (std::ranges::any_of(subsumers_.known(of), [&](std::uint32_t above) { return subsumers_.is_empty(above); })) {
      subsumers_.set_empty(of);
      return true;
    }
    const auto asked = concepts.concept_of(of);
    // A class that no clause mentions has no other subsumers.
    if (!asked) subsumers_.close(of);
    if (!asked) return true;
    if (!may_ask(of, tableau, done)) return false;
    has_model_[of] = true;
    const Verdict verdict = ask(of, *asked, tableau);
    if (verdict == Verdict::no) subsumers_.set_empty(of);
    if (verdict != Verdict::yes) return true;
    for (const std::uint32_t above : classes_of(tableau.model().certain, concepts)) {
      if (above != of && !std::ranges::binary_search(subsumers_.known(of), above)) subsumers_.add(of, above);
    }
    learn(tableau.model(), concepts);
    return true;
  }

  void ask_pairs(hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    // The subsumers of a class need not be asked again for the classes below it.
    ClassNumbers order = subsumers_.lowest_first();
    order.push_back(subsumers_.top());
    std::ranges::reverse(order);
    tableau.begin_anew();
    // Pairs may take as many steps as models may.
    former_steps_ = tableau.steps();
    const std::size_t unanswered = unanswered_;
    ask_pairs_of(order, tableau, concepts, true);
    if (unanswered_ > unanswered) ask_pairs_of(order, tableau, concepts, false);
  }

  /// The concept of a class, or of one that is known to be equivalent: an axiom that only el uses may name the class.
  [[nodiscard]] std::optional<clauses::ConceptId> concept_of_any(std::uint32_t representative_of,
                                                                 const NamedConcepts& concepts) const {
    auto found = concepts.concept_of(representative_of);
    for (std::uint32_t of = 0; of < class_count() && !found; ++of) {
      if (subsumers_.representative(of) == representative_of) found = concepts.concept_of(of);
    }
    return found;
  }

  /// Asks about the pairs of these classes that are open, until no more may be asked. `may_put_off`: where one pair is
  /// too hard, the others of its class are left for another time.
  void ask_pairs_of(const ClassNumbers& order, hypertableau::Tableau& tableau, const NamedConcepts& concepts,
                    bool may_put_off) {
    for (std::size_t at = 0; at < order.size(); ++at) {
      const std::uint32_t of = order[at];
      subsumers_.inherit(of);
      if (!concepts.concept_of(of)) continue;
      std::vector<ClassNumbers> parts{subsumers_.open_above(of)};
      put_off_.reset();
      while (!parts.empty() && !(may_put_off && put_off_ == of)) {
        ClassNumbers part = std::move(parts.back());
        parts.pop_back();
        std::erase_if(part, [&](std::uint32_t above) { return !subsumers_.is_open(of, above); });
        if (part.empty()) continue;
        if (!may_ask(of, tableau, 0.5 + 0.5 * static_cast<double>(at) / static_cast<double>(order.size()))) return;
        if (part.size() == 1) {
          ask_pair(of, part.front(), tableau, concepts);
        } else if (!joint_.are_worth_it() || !refute_together(of, part, tableau, concepts)) {
          // The most specific first.
          const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
          parts.emplace_back(middle, part.end());
          parts.emplace_back(part.begin(), middle);
        }
      }
    }
  }

  void ask_pair(std::uint32_t of, std::uint32_t above, hypertableau::Tableau& tableau, const NamedConcepts& concepts) {
    const auto super = concept_of_any(above, concepts);
    const Verdict verdict =
        ask(of, *concepts.concept_of(of), tableau, super ? std::vector{*super} : std::vector<clauses::ConceptId>());
    if (verdict == Verdict::no) subsumers_.add(of, above);
    if (verdict == Verdict::yes) learn(tableau.model(), concepts);
  }

  /// Looks for an instance of the class that is in none of these: most of what models leave open does not follow, and
  /// then this is one question instead of one for each pair. False: some may follow.
  bool refute_together(std::uint32_t of, const ClassNumbers& above, hypertableau::Tableau& tableau,
                       const NamedConcepts& concepts) {
    std::vector<clauses::ConceptId> outside;
    for (const std::uint32_t one : above) {
      if (const auto super = concept_of_any(one, concepts)) outside.push_back(*super);
    }
    ++questions_;
    const std::size_t before = tableau.steps();
    tableau.limit_steps(std::min(question_.steps, joint_.most_steps(above.size())));
    const Verdict verdict = tableau.is_satisfiable({*concepts.concept_of(of)}, outside).verdict;
    tableau.limit_steps(question_.steps);
    if (verdict != Verdict::yes) {
      joint_.note_vain(tableau.steps() - before);
      return false;
    }
    joint_.note_refuted(above.size(), tableau.steps() - before);
    learn(tableau.model(), concepts);
    return true;
  }

  const owl::Ontology& source_;
  const Incomplete& given_;
  const Options& options_;
  const CompletionLimits& limits_;
  hypertableau::QuestionLimits question_;
  Subsumers subsumers_;
  JointQuestions joint_;
  std::optional<std::uint32_t> put_off_;  ///< the class of the last question without an answer
  Completion result_;
  std::set<std::string> gaps_;
  std::size_t questions_ = 0;
  std::size_t unanswered_ = 0;
  std::size_t vain_steps_ = 0;    ///< of questions about classes without an answer
  std::size_t former_steps_ = 0;  ///< before the models of classes, and before the pairs
  std::vector<bool> has_model_;   ///< by representative: a model of it was looked for
};

/// No question is asked, so each class that is not settled stays open.
Completion leave_open(const Incomplete& known, const CompletionLimits& limits) {
  const taxonomy::Classification& classification = known.classification;
  Completion left;
  left.gaps.push_back("more than " + std::to_string(limits.classes) + " classes are too many to look for models");
  left.is_consistency_open = true;
  const auto is_node_of = [&](std::uint32_t of, taxonomy::ClassNumber named) {
    return classification.representative[of] == classification.representative[static_cast<std::uint32_t>(named)];
  };
  for (std::uint32_t of = 0; of < classification.class_count(); ++of) {
    if (static_cast<std::uint32_t>(classification.representative[of]) != of || known.is_settled[of]) continue;
    if (!is_node_of(of, classification.thing) && !is_node_of(of, classification.nothing)) left.open.push_back(of);
  }
  return left;
}

}  // namespace

Completion complete(const owl::Ontology& source, const Incomplete& known, const Options& options,
                    const CompletionLimits& limits) {
  if (known.classification.class_count() > limits.classes) return leave_open(known, limits);
  return Completing(source, known, options, limits).run();
}

}  // namespace geminga::reasoner
