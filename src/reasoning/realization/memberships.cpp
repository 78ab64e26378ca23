#include "reasoning/realization/memberships.hpp"

#include <algorithm>
#include <string>

namespace geminga::realization {
namespace {

using clauses::IndividualId;
using hypertableau::Supposition;
using hypertableau::Verdict;
using IndividualIds = std::vector<IndividualId>;

/// The most questions about one ontology, and the most of them that are too hard.
constexpr std::size_t max_questions = 100'000;
constexpr std::size_t max_unanswered = 20;

bool contains(const IndividualIds& sorted, IndividualId wanted) { return std::ranges::binary_search(sorted, wanted); }

class Deciding {
 public:
  Deciding(hypertableau::FactModel& model, OpenQuestions& open, const Options& options, Gaps& gaps)
      : model_(model), open_(open), options_(options), gaps_(gaps) {}

  void run() {
    learn();
    for (Pair& pair : open_.pairs) {
      if (pair.are_same == Verdict::unknown)
        pair.are_same = opposite(ask({.facts = {}, .different = {{pair.first, pair.second}}}));
    }
    decide_columns();
    for (OpenLink& link : open_.links) {
      if (link.holds == Verdict::unknown)
        link.holds =
            opposite(ask({.facts = {{link.of_first, link.first}, {link.of_second, link.second}}, .different = {}}));
    }
  }

 private:
  static Verdict opposite(Verdict verdict) {
    if (verdict == Verdict::unknown) return verdict;
    return verdict == Verdict::yes ? Verdict::no : Verdict::yes;
  }

  /// Whether this is possible. Learns from the model that shows it.
  Verdict ask(const Supposition& supposed) {
    if (!may_ask()) return Verdict::unknown;
    ++questions_;
    const hypertableau::Answer answer = model_.is_possible(supposed);
    if (answer.verdict == Verdict::unknown) {
      ++unanswered_;
      gaps_.insert(answer.reason);
    }
    if (answer.verdict == Verdict::yes) learn();
    return answer.verdict;
  }

  bool may_ask() {
    if (options_.budget != nullptr && options_.budget->is_spent()) {
      gaps_.insert(options_.budget->reason().value_or(""));
      return false;
    }
    if (questions_ >= max_questions) {
      gaps_.insert("more than " + std::to_string(max_questions) + " questions to the tableau");
      return false;
    }
    if (unanswered_ >= max_unanswered) {
      gaps_.insert(std::to_string(max_unanswered) + " questions were too hard for the tableau");
      return false;
    }
    return true;
  }

  /// Drops the candidates that do not hold in the model, because they do not follow.
  void learn() {
    const hypertableau::Individuals individuals = model_.individuals();
    for (Column& column : open_.columns) {
      std::erase_if(column.open, [&](IndividualId individual) {
        return !individuals.is_in(individuals.node(individual), column.of);
      });
    }
    for (Pair& pair : open_.pairs) {
      if (pair.are_same == Verdict::unknown && individuals.node(pair.first) != individuals.node(pair.second))
        pair.are_same = Verdict::no;
    }
    for (OpenLink& link : open_.links) {
      if (link.holds == Verdict::unknown &&
          !individuals.has_link(link.property, individuals.node(link.first), individuals.node(link.second)))
        link.holds = Verdict::no;
    }
  }

  /// An individual that may be in the concept of a column.
  struct Candidate {
    std::size_t column = 0;
    IndividualId individual{};
  };

  /// Asks about all candidates at once, and in halves where the answer is no.
  void decide_columns() {
    std::vector<Candidate> all;
    for (std::size_t at = 0; at < open_.columns.size(); ++at) {
      for (const IndividualId individual : open_.columns[at].open) all.push_back({at, individual});
    }
    const auto count = static_cast<double>(all.size());
    std::size_t done = 0;
    std::vector<std::vector<Candidate>> batches{std::move(all)};
    while (!batches.empty()) {
      if (options_.progress) options_.progress("asking about individuals", static_cast<double>(done) / count);
      std::vector<Candidate> batch = std::move(batches.back());
      batches.pop_back();
      const std::size_t size = batch.size();
      std::erase_if(batch, [&](const Candidate& candidate) {
        return !contains(open_.columns[candidate.column].open, candidate.individual);
      });
      const Verdict verdict = batch.empty() ? Verdict::yes : ask(none_of(batch));
      if (verdict == Verdict::unknown && !may_ask()) return;
      if (verdict == Verdict::yes || batch.size() == 1) {
        if (verdict == Verdict::no) note_found(batch.front().column, batch.front().individual);
        // A model may have the complement and the concept of a column, where the one does not exclude the other.
        for (const Candidate& candidate : batch) {
          if (verdict == Verdict::yes) std::erase(open_.columns[candidate.column].open, candidate.individual);
        }
        done += size;
        continue;
      }
      done += size - batch.size();
      const auto half = batch.begin() + static_cast<std::ptrdiff_t>(batch.size() / 2);
      batches.emplace_back(half, batch.end());
      batches.emplace_back(batch.begin(), half);
    }
  }

  [[nodiscard]] Supposition none_of(const std::vector<Candidate>& candidates) const {
    Supposition supposed;
    for (const Candidate& candidate : candidates)
      supposed.facts.push_back({open_.columns[candidate.column].complement, candidate.individual});
    return supposed;
  }

  void note_found(std::size_t at, IndividualId individual) {
    Column& column = open_.columns[at];
    if (std::erase(column.open, individual) == 0) return;
    column.found.push_back(individual);
    for (const std::size_t above : column.above) note_found(above, individual);
  }

  hypertableau::FactModel& model_;
  OpenQuestions& open_;
  const Options& options_;
  Gaps& gaps_;
  std::size_t questions_ = 0;
  std::size_t unanswered_ = 0;
};

}  // namespace

void decide(hypertableau::FactModel& model, OpenQuestions& open, const Options& options, Gaps& gaps) {
  Deciding(model, open, options, gaps).run();
}

}  // namespace geminga::realization
