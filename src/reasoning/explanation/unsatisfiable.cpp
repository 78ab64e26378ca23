// Axioms that lead from one class to another are followed first; minimal sets are compared where none does.
#include "reasoning/explanation/unsatisfiable.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

#include "reasoning/explanation/allowance.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/modules/module.hpp"

namespace geminga::explanation {
namespace {

using owl::AxiomKind;
using owl::TermKind;
using taxonomy::ClassifiedView;
using taxonomy::ClassNumber;

/// An axiom by which a class can have no instance because another can have none.
struct Edge {
  ClassNumber from{};
  ClassNumber to{};
  std::uint32_t axiom = 0;  ///< of the compiled form
};

/// Finds the edges that one axiom makes: C < D, C < D and E, C < r some D, C = D or E, and the like.
class Edges {
 public:
  Edges(const compiled::Ontology& ontology, const std::vector<ClassNumber>& empty) : view_(ontology.axioms()) {
    for (const ClassNumber number : empty) {
      if (const auto term = ontology.module_index().term_of(number)) class_of_.emplace(*term, number);
    }
  }

  [[nodiscard]] std::vector<Edge> find() const {
    std::vector<Edge> edges;
    const auto add = [&](std::uint32_t axiom, std::uint32_t sub, std::span<const std::uint32_t> supers) {
      const auto from = class_of_.find(sub);
      if (from == class_of_.end()) return;
      std::vector<ClassNumber> needed;
      for (const std::uint32_t super : supers) {
        if (super != sub) collect(super, needed);
      }
      for (const ClassNumber to : needed) {
        if (to != from->second) edges.push_back({from->second, to, axiom});
      }
    };
    for (std::uint32_t axiom = 0; axiom < view_.axiom_count(); ++axiom) {
      const auto arguments = view_.arguments_of_axiom(axiom);
      switch (view_.kind_of_axiom(axiom)) {
        case AxiomKind::sub_class_of:
          add(axiom, arguments[0], arguments.subspan(1));
          break;
        case AxiomKind::equivalent_classes:
          for (const std::uint32_t sub : arguments) add(axiom, sub, arguments);
          break;
        default:
          break;
      }
    }
    return edges;
  }

 private:
  /// Adds the unsatisfiable classes of which one or, in a union, all are why this expression can have no instance. Adds
  /// none where it can have one. Recursion is bounded by the nesting of terms.
  void collect(std::uint32_t term, std::vector<ClassNumber>& needed) const {
    if (const auto known = class_of_.find(term); known != class_of_.end()) {
      needed.push_back(known->second);
      return;
    }
    const auto arguments = view_.arguments_of_term(term);
    switch (view_.kind_of_term(term)) {
      case TermKind::object_intersection_of:
        for (const std::uint32_t part : arguments) collect(part, needed);
        break;
      case TermKind::object_union_of: {
        std::vector<ClassNumber> all;
        for (const std::uint32_t part : arguments) {
          const std::size_t known = all.size();
          collect(part, all);
          if (all.size() == known) return;
        }
        needed.insert(needed.end(), all.begin(), all.end());
        break;
      }
      case TermKind::object_some_values_from:
        collect(arguments[1], needed);
        break;
      case TermKind::object_min_cardinality:
      case TermKind::object_exact_cardinality:
        if (view_.number_of_term(term) > 0 && arguments.size() == 2) collect(arguments[1], needed);
        break;
      default:
        break;
    }
  }

  const ClassifiedView& view_;
  std::map<std::uint32_t, ClassNumber> class_of_;  ///< by term
};

/// The search over all unsatisfiable classes of one ontology.
class Search {
 public:
  Search(const compiled::Ontology& ontology, ClassNumber nothing, const std::vector<ClassNumber>& empty,
         base::Budget* budget, Patience patience)
      : ontology_(ontology),
        nothing_(nothing),
        allowance_(budget, steps_of_reasons(ontology.axiom_count())),
        patience_(patience) {
    for (const ClassNumber number : empty) found_[number].number = number;
    edges_ = Edges(ontology, empty).find();
  }

  std::vector<Unsatisfiable> run() {
    explain_candidates();
    derive();
    std::vector<Unsatisfiable> list;
    for (auto& [number, one] : found_) list.push_back(std::move(one));
    std::ranges::stable_sort(list, {}, [](const Unsatisfiable& one) { return one.root.has_value(); });
    return list;
  }

 private:
  /// A class whose minimal set is compared with those of others.
  struct Candidate {
    Candidate(const compiled::Ontology& ontology, ClassNumber of, ClassNumber nothing, Patience patience,
              base::Budget* budget)
        : number(of), explainer(ontology, of, nothing, patience, budget) {}
    ClassNumber number;
    Explainer explainer;
    AxiomSet set;
  };

  /// The classes that no path of edges leads to a class without an edge, and those without an edge: ascending.
  [[nodiscard]] std::vector<ClassNumber> candidates() const {
    std::map<ClassNumber, std::vector<ClassNumber>> before;
    std::map<ClassNumber, bool> has_edge;
    for (const Edge& edge : edges_) {
      before[edge.to].push_back(edge.from);
      has_edge[edge.from] = true;
    }
    std::map<ClassNumber, bool> is_led;
    std::deque<ClassNumber> open;
    for (const auto& [number, one] : found_) {
      if (!has_edge.contains(number)) open.push_back(number);
    }
    while (!open.empty()) {
      const ClassNumber to = open.front();
      open.pop_front();
      for (const ClassNumber from : before[to]) {
        if (std::exchange(is_led[from], true)) continue;
        open.push_back(from);
      }
    }
    std::vector<ClassNumber> list;
    for (const auto& [number, one] : found_) {
      if (!is_led.contains(number)) list.push_back(number);
    }
    return list;
  }

  void explain_candidates() {
    std::deque<Candidate> explained;
    bool was_hard = false;
    for (const ClassNumber number : candidates()) {
      candidates_.push_back(number);
      if (was_hard || explained.size() == max_explained_classes) continue;
      if (allowance_.budget().is_spent()) continue;
      Candidate& one = explained.emplace_back(ontology_, number, nothing_, patience_, &allowance_.budget());
      auto set = one.explainer.find_one();
      was_hard = one.explainer.oracle().undecided_count() > 0;
      if (!set || allowance_.budget().is_spent()) {  // a set that was not searched to the end need not be minimal
        explained.pop_back();
        continue;
      }
      one.set = std::move(*set);
      found_[number].reason = one.explainer.explained(one.set);
    }
    // A class is compared with those of smaller sets, so that none is derived from itself.
    std::vector<Candidate*> order;
    for (Candidate& one : explained) order.push_back(&one);
    std::ranges::stable_sort(order, {}, [](const Candidate* one) { return one->set.size(); });
    for (std::size_t at = 0; at < order.size(); ++at) {
      for (std::size_t less = 0; less < at && !found_[order[at]->number].root; ++less) {
        const ClassNumber other = order[less]->number;
        if (order[less]->set.size() < order[at]->set.size() && holds_set_of(*order[at], other))
          found_[order[at]->number].root = found_[other].root.value_or(other);
      }
    }
  }

  /// Whether fewer axioms of this class's set entail that the other class can have no instance.
  static bool holds_set_of(Candidate& one, ClassNumber other) {
    Module& module = one.explainer.module();
    const owl::TermId term = module.term(other);
    const bool is_named = std::ranges::any_of(one.set, [&](std::uint32_t axiom) {
      const auto terms = owl::terms_in(module.source(), module.source().axiom(axiom).arguments);
      return std::ranges::find(terms, term) != terms.end();
    });
    if (!is_named) return false;
    const auto set = find_justification(one.explainer.oracle(), one.set, term, owl::nothing_term);
    return set && set->size() < one.set.size();
  }

  /// Follows the edges backwards from the candidates, shortest paths first, and lower numbers first among those.
  void derive() {
    std::map<ClassNumber, std::vector<const Edge*>> before;
    for (const Edge& edge : edges_) before[edge.to].push_back(&edge);
    for (auto& [to, edges] : before)
      std::ranges::sort(edges, {}, [](const Edge* edge) { return std::tuple(edge->from, edge->axiom); });
    std::map<ClassNumber, bool> is_done;
    std::deque<ClassNumber> open(candidates_.begin(), candidates_.end());
    for (const ClassNumber number : candidates_) is_done[number] = true;
    std::ranges::stable_sort(open, {}, [&](ClassNumber number) { return found_[number].root.has_value(); });
    Module module(ontology_, {});
    while (!open.empty()) {
      const ClassNumber to = open.front();
      open.pop_front();
      for (const Edge* edge : before[to]) {
        if (std::exchange(is_done[edge->from], true)) continue;
        Unsatisfiable& one = found_[edge->from];
        one.root = found_[to].root.value_or(to);
        one.reason = {module.explained_original(edge->axiom)};
        open.push_back(edge->from);
      }
    }
  }

  const compiled::Ontology& ontology_;
  ClassNumber nothing_;
  Allowance allowance_;
  Patience patience_;
  std::map<ClassNumber, Unsatisfiable> found_;
  std::vector<Edge> edges_;
  std::vector<ClassNumber> candidates_;
};

}  // namespace

std::vector<Unsatisfiable> find_unsatisfiable(const compiled::Ontology& ontology, base::Budget* budget,
                                              Patience patience) {
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  std::vector<ClassNumber> empty;
  for (std::uint32_t number = 0; number < ontology.class_count() && nothing; ++number) {
    const ClassNumber named{number};
    if (named != *nothing && !ontology.is_satisfiable(named)) empty.push_back(named);
  }
  if (empty.empty()) return {};
  return Search(ontology, *nothing, empty, budget, patience).run();
}

}  // namespace geminga::explanation
