// Atoms that can be looked up come first, then atoms that lead from what is bound to more, then enumerations.
#include "reasoning/dl/hypertableau/rules/rule_plans.hpp"

#include <algorithm>

#include "reasoning/dl/clauses/built_in.hpp"

namespace geminga::hypertableau {
namespace {

using clauses::Rule;
using clauses::RuleAtom;
using clauses::RuleAtomKind;
using clauses::RuleTerm;
using clauses::RuleTermKind;

constexpr std::uint32_t no_trigger = 0xffffffffU;

/// Orders the atoms of one rule, which has clauses::max_rule_atoms at most: the square of that is its cost.
class Ordering {
 public:
  explicit Ordering(const Rule& rule) : rule_(rule), is_bound_(rule.is_value.size(), false) {}

  std::vector<RuleStep> run(std::uint32_t trigger) {
    for (std::uint32_t at = 0; at < rule_.body.size(); ++at) {
      if (at != trigger) open_.push_back(at);
    }
    if (trigger != no_trigger) bind(rule_.body[trigger]);
    while (!open_.empty()) {
      auto next = std::ranges::find_if(open_, [&](std::uint32_t at) { return is_check(rule_.body[at]); });
      if (next == open_.end())
        next = std::ranges::find_if(open_, [&](std::uint32_t at) { return is_reachable(rule_.body[at]); });
      if (next == open_.end()) {
        if (enumerate_one()) continue;
        next = open_.begin();  // a built-in whose arguments nothing binds
      }
      const std::uint32_t at = *next;
      open_.erase(next);
      bind(rule_.body[at]);
      steps_.push_back({false, static_cast<std::uint16_t>(at)});
    }
    for (std::uint32_t variable = 0; variable < is_bound_.size(); ++variable) {
      if (!is_bound_[variable] && !rule_.is_value[variable])
        steps_.push_back({true, static_cast<std::uint16_t>(variable)});
    }
    return std::move(steps_);
  }

 private:
  [[nodiscard]] bool is_known(const RuleTerm& term) const {
    return term.kind != RuleTermKind::variable || is_bound_[term.number];
  }
  void bind(const RuleAtom& atom) {
    if (atom.kind == RuleAtomKind::unknown) return;
    for (const RuleTerm& term : atom.terms) {
      if (term.kind == RuleTermKind::variable) is_bound_[term.number] = true;
    }
  }
  [[nodiscard]] bool is_check(const RuleAtom& atom) const {
    if (atom.kind == RuleAtomKind::unknown || std::ranges::all_of(atom.terms, [&](auto& one) { return is_known(one); }))
      return true;
    if (atom.kind == RuleAtomKind::equal) return is_known(atom.terms[0]) || is_known(atom.terms[1]);
    if (atom.kind != RuleAtomKind::built_in) return false;
    const auto built_in = static_cast<clauses::BuiltIn>(atom.predicate);
    if (built_in == clauses::BuiltIn::equal)
      return (is_known(atom.terms[0]) && is_left_to_bind(atom.terms[1])) ||
             (is_known(atom.terms[1]) && is_left_to_bind(atom.terms[0]));
    return clauses::form_of(built_in).binds_first && is_left_to_bind(atom.terms[0]) &&
           std::ranges::all_of(std::span(atom.terms).subspan(1), [&](auto& one) { return is_known(one); });
  }
  /// Whether no fact binds the value, so that a built-in may: 1 and "1"^^xsd:double are equal, and are two values.
  [[nodiscard]] bool is_left_to_bind(const RuleTerm& term) const {
    return is_known(term) || std::ranges::none_of(open_, [&](std::uint32_t at) {
             const RuleAtom& atom = rule_.body[at];
             return atom.kind == RuleAtomKind::data_role && atom.terms[1].kind == RuleTermKind::variable &&
                    atom.terms[1].number == term.number;
           });
  }
  [[nodiscard]] bool is_reachable(const RuleAtom& atom) const {
    if (atom.kind == RuleAtomKind::role) return is_known(atom.terms[0]) || is_known(atom.terms[1]);
    return (atom.kind == RuleAtomKind::path || atom.kind == RuleAtomKind::data_role) && is_known(atom.terms[0]);
  }
  /// Lets a variable of an individual be each named individual.
  bool enumerate_one() {
    for (const std::uint32_t at : open_) {
      for (const RuleTerm& term : rule_.body[at].terms) {
        if (is_known(term) || rule_.is_value[term.number]) continue;
        is_bound_[term.number] = true;
        steps_.push_back({true, static_cast<std::uint16_t>(term.number)});
        return true;
      }
    }
    return false;
  }

  const Rule& rule_;
  std::vector<bool> is_bound_;
  std::vector<std::uint32_t> open_;
  std::vector<RuleStep> steps_;
};

}  // namespace

RulePlans::RulePlans(const clauses::ClauseSet& set) {
  by_concept_.resize(set.rules.empty() ? 0 : set.concepts.size());
  by_role_.resize(set.rules.empty() ? 0 : set.properties.size());
  by_data_role_.resize(set.rules.empty() ? 0 : set.data_properties.size());
  for (std::uint32_t number = 0; number < set.rules.size(); ++number) {
    const Rule& rule = set.rules[number];
    whole_.push_back({number, no_trigger, Ordering(rule).run(no_trigger)});
    const auto has = [&](RuleAtomKind kind) {
      return std::ranges::any_of(rule.body, [&](const RuleAtom& atom) { return atom.kind == kind; });
    };
    is_known_.push_back(!has(RuleAtomKind::unknown));
    if (has(RuleAtomKind::path)) {
      about_paths_.push_back(number);
      continue;
    }
    bool is_triggered = false;
    for (std::uint32_t at = 0; at < rule.body.size(); ++at) {
      const RuleAtom& atom = rule.body[at];
      Table* const table = atom.kind == RuleAtomKind::concept_of  ? &by_concept_
                           : atom.kind == RuleAtomKind::role      ? &by_role_
                           : atom.kind == RuleAtomKind::data_role ? &by_data_role_
                                                                  : nullptr;
      if (table == nullptr) continue;
      (*table)[atom.predicate].push_back({number, at, Ordering(rule).run(at)});
      is_triggered = true;
    }
    if (!is_triggered) untriggered_.push_back(number);
  }
}

}  // namespace geminga::hypertableau
