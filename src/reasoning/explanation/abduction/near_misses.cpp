#include "reasoning/explanation/abduction/near_misses.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace geminga::abduction {
namespace {

using owl::TermId;

/// Sets of what is known of one restriction, where its fillers can be found in several ways.
constexpr std::size_t max_known_of_conjunct = 4;
/// The same for all conjuncts together.
constexpr std::size_t max_known = 8;

class NearMissSearch {
 public:
  NearMissSearch(owl::Ontology& source, const Conjuncts& request, TermId candidate, const Reasoner& reasoner,
                 const Limits& limits)
      : source_(source), request_(request), candidate_(candidate), reasoner_(reasoner), limits_(limits) {
    limits_.answers = std::min(limits_.answers, max_answers);
    for (std::size_t at = 0; at < request_.size(); ++at) inside_.push_back(request_.inside(at));
  }

  NearMisses run() {
    NearMisses result;
    if (is_possible(owl::thing_term) == Answer::no) {
      result.reservation = "the candidate can have no instance";
      return result;
    }
    for (const Members retracted : contractions()) abduce(retracted, result.ranked);
    std::ranges::sort(result.ranked, {}, [&](const NearMiss& one) {
      return std::tuple(request_.count(one.retracted), request_.count(one.lacking), one.retracted, one.lacking);
    });
    if (result.ranked.size() > limits_.answers) result.ranked.resize(limits_.answers);
    result.reservation = reservation();
    return result;
  }

 private:
  /// The smallest sets to retract so that no contradiction is known.
  std::vector<Members> contractions() {
    const SearchSpace space{
        .all = request_.all(), .with = inside_, .size = [&](Members retracted) { return request_.count(retracted); }};
    return minimal_sets(
        space,
        [&](Members retracted) {
          return is_possible(request_.term(source_, request_.all() & ~retracted)) != Answer::no;
        },
        limits_.answers);
  }

  /// The ways with this set retracted.
  void abduce(Members retracted, std::vector<NearMiss>& ways) {
    const Members left = request_.all() & ~retracted;
    const TermId goal = request_.term(source_, left);
    const bool is_proven = is_possible(goal) == Answer::yes;
    std::set<Members> told;
    for (const Members known : known_of(left)) {
      for (const Members lacking : lacking_of(left, known, goal)) {
        if (told.insert(lacking).second) ways.push_back({retracted, known, lacking, is_proven});
      }
    }
  }

  /// The largest sets of conjuncts that hold of the candidate.
  std::vector<Members> known_of(Members left) {
    std::vector<Members> all = {0};
    for (const std::size_t top : numbers_of(request_.top() & left)) {
      std::vector<Members> longer;
      for (const Members own : known_of_one(left & request_.inside(top))) {
        for (const Members others : all) longer.push_back(others | own);
      }
      is_cut_short_ = is_cut_short_ || longer.size() > max_known;
      longer.resize(std::min(longer.size(), max_known));
      all = std::move(longer);
    }
    return all;
  }

  std::vector<Members> known_of_one(Members own) {
    const auto holds = [&](Members without) {
      const Members kept = own & ~without;
      return kept == 0 || is_below(candidate_, request_.term(source_, kept));
    };
    if (holds(0)) return {own};
    if (request_.outermost(own) == own) return {0};  // nothing is nested
    std::vector<Members> with = inside_;
    for (Members& members : with) members &= own;
    const SearchSpace space{.all = own, .with = with, .size = [&](Members without) { return request_.count(without); }};
    auto sets = minimal_sets(space, holds, max_known_of_conjunct);
    is_cut_short_ = is_cut_short_ || sets.size() == max_known_of_conjunct;
    for (Members& members : sets) members = own & ~members;
    return sets.empty() ? std::vector<Members>{0} : sets;
  }

  /// The smallest sets that are to be added to what is known.
  std::vector<Members> lacking_of(Members left, Members known, TermId goal) {
    const Members open = left & ~known;
    if (open == 0) return {0};
    std::vector<Members> with(request_.size());
    for (const std::size_t at : numbers_of(open)) with[at] = request_.around(at) & open;
    const auto holds = [&](Members lacking) {
      if (lacking == open) return true;
      return lacking != 0 && is_below(together(candidate_, request_.term(source_, known | lacking)), goal);
    };
    Members needed = 0;
    for (const std::size_t at : numbers_of(open)) {
      if (!holds(open & ~request_.inside(at))) needed |= with[at];
    }
    const SearchSpace space{
        .all = open, .begin = needed, .with = with, .size = [&](Members lacking) { return request_.count(lacking); }};
    return minimal_sets(space, holds, limits_.answers);
  }

  TermId together(TermId one, TermId other) {
    if (other == owl::thing_term || one == other) return one;
    if (one == owl::thing_term) return other;
    return source_.term(owl::TermKind::object_intersection_of, {one, other});
  }

  bool take_question() {
    if (asked_ < limits_.questions) {
      ++asked_;
      return true;
    }
    is_cut_short_ = true;
    return false;
  }

  /// Whether something can be the candidate and this. Unknown once the questions are used up.
  Answer is_possible(TermId expression) {
    const TermId both = together(candidate_, expression);
    const auto known = possible_.find(both);
    if (known != possible_.end()) return known->second;
    const Answer answer = take_question() ? reasoner_.is_satisfiable(source_, both) : Answer::unknown;
    is_undecided_ = is_undecided_ || answer == Answer::unknown;
    return possible_.emplace(both, answer).first->second;
  }

  bool is_below(TermId sub, TermId super) {
    if (!take_question()) return false;
    const Answer answer = reasoner_.is_subsumed(source_, sub, super);
    is_undecided_ = is_undecided_ || answer == Answer::unknown;
    return answer == Answer::yes;
  }

  [[nodiscard]] std::string reservation() const {
    if (is_cut_short_) return "the search was ended early: there may be smaller ways";
    if (!request_.is_whole()) {
      return "of the request no more than " + std::to_string(max_conjuncts) + " conjuncts are told apart";
    }
    if (is_undecided_) return "the reasoner could not decide all of it: there may be smaller ways";
    return "";
  }

  owl::Ontology& source_;
  const Conjuncts& request_;
  TermId candidate_;
  const Reasoner& reasoner_;
  Limits limits_;
  std::vector<Members> inside_;
  std::map<TermId, Answer> possible_;
  std::size_t asked_ = 0;
  bool is_cut_short_ = false;
  bool is_undecided_ = false;
};

}  // namespace

NearMisses find_near_misses(owl::Ontology& source, const Conjuncts& request, TermId candidate, const Reasoner& reasoner,
                            const Limits& limits) {
  return NearMissSearch(source, request, candidate, reasoner, limits).run();
}

TermId added(owl::Ontology& source, const Conjuncts& request, const NearMiss& near_miss) {
  const Members enriched = near_miss.known | near_miss.lacking;
  Members whole = 0;
  for (const std::size_t at : numbers_of(near_miss.lacking)) {
    whole |= request.inside(request.top_of(at)) & enriched;
  }
  return request.term(source, whole);
}

}  // namespace geminga::abduction
