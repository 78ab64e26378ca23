// A small constraint problem: every value in its ranges, some pairs different.
//
// A node whose ranges have more values than it has nodes to differ from can always be given one, and is put aside. If
// all others must differ from each other, a matching with values decides. Otherwise they are few, and assignments are
// tried. If a range is not fully known, a clash must follow from its upper
// bound, and a model from its lower bound.
//
// A model chooses its opaque sets (value_ranges.hpp). The values in one must differ from those outside of it, and that
// is all: let each node have a value so that this holds; then the set of the values of the nodes inside is a choice. If
// one of two nodes has infinitely many values to choose from, they can differ without more ado, as the model has fewer
// nodes with different values than there are values.
#include "reasoning/dl/hypertableau/facts/value_check.hpp"

#include <algorithm>
#include <utility>

namespace geminga::hypertableau {

using clauses::DataRangeId;

namespace {

/// As many values are looked at to give different ones to nodes that must all differ.
constexpr std::size_t max_matching_steps = 20'000'000;

/// Whether each of these can have a value of its own: a matching of all with values, by augmenting paths (Kuhn, 1955).
/// Nothing after too many steps.
std::optional<bool> can_all_differ(const std::vector<std::vector<Value>>& values) {
  std::map<Value, std::uint32_t> numbers;
  std::vector<std::vector<std::uint32_t>> choices;
  for (const std::vector<Value>& own : values) {
    auto& of_one = choices.emplace_back();
    for (const Value& value : own)
      of_one.push_back(numbers.try_emplace(value, static_cast<std::uint32_t>(numbers.size())).first->second);
  }
  std::vector<std::uint32_t> taken_by(numbers.size(), none);
  std::vector<std::uint32_t> has(choices.size(), none);
  std::size_t steps = 0;
  for (std::uint32_t start = 0; start < choices.size(); ++start) {
    // For whom each value was reached; breadth first, so that no recursion is as deep as there are values.
    std::vector<std::uint32_t> reached_for(numbers.size(), none);
    std::vector<std::uint32_t> open{start};
    std::uint32_t next = none;
    for (std::size_t at = 0; at < open.size() && next == none; ++at) {
      const std::uint32_t one = open[at];
      for (const std::uint32_t value : choices[one]) {
        if (++steps > max_matching_steps) return std::nullopt;
        if (reached_for[value] != none) continue;
        reached_for[value] = one;
        if (taken_by[value] == none) {
          next = value;
          break;
        }
        open.push_back(taken_by[value]);
      }
    }
    if (next == none) return false;
    while (next != none) {  // each on the way takes the value that it reached, and leaves its own
      const std::uint32_t one = reached_for[next];
      taken_by[next] = one;
      next = std::exchange(has[one], next);
    }
  }
  return true;
}

}  // namespace

bool ValueCheck::are_different(owl::TermId first, owl::TermId second) {
  const std::optional<Value> a = ranges_.value(first);
  const std::optional<Value>& b = ranges_.value(second);
  return a && b && !(*a == *b);
}

std::optional<bool> ValueCheck::is_in(owl::TermId literal, std::uint32_t range) {
  const auto& value = ranges_.value(literal);
  if (!value) return std::nullopt;
  const KnownSet& set = ranges_.known_set(DataRangeId{range});
  if (!set.most.contains(*value)) return false;
  if (set.opaque.empty() && set.least.contains(*value)) return true;
  return std::nullopt;
}

owl::TermId ValueCheck::representative(owl::TermId literal) {
  const auto& value = ranges_.value(literal);
  return value ? representative_.try_emplace(*value, literal).first->second : literal;
}

std::optional<owl::TermId> ValueCheck::made(const Value& value) {
  const auto found = representative_.find(value);
  if (found != representative_.end()) return found->second;
  if (made_ >= max_made_values) return std::nullopt;
  const owl::TermId literal{first_made_value + made_++};
  ranges_.set_value(literal, value);
  representative_.emplace(value, literal);
  return literal;
}

std::optional<owl::TermId> ValueCheck::only_value(const Graph& graph, NodeId node, DependencySet& dependency,
                                                  bool& is_free) {
  std::vector<std::uint32_t> ranges;
  DependencySet because = no_dependency;
  for (FactId id = graph.node(node).others; id != none; id = graph.next_other(id, node)) {
    const Fact& fact = graph.fact(id);
    if (fact.kind != FactKind::data_range) continue;
    ranges.push_back(fact.predicate);
    because = graph.unite(because, fact.dependency);
  }
  std::ranges::sort(ranges);
  const Counted& counted = sets_[known_set(ranges, none)];
  is_free = counted.least >= many_values;
  if (counted.most != 1) return std::nullopt;
  const std::vector<Value> values = counted.set.most.list(1);
  if (values.empty()) return std::nullopt;
  dependency = graph.unite(dependency, because);
  return made(values.front());
}

std::uint32_t ValueCheck::known_set(const std::vector<std::uint32_t>& ranges, std::uint32_t literal) {
  const auto [found, is_new] = set_of_ranges_.try_emplace({ranges, literal}, static_cast<std::uint32_t>(sets_.size()));
  if (!is_new) return found->second;
  Counted counted{literal == none ? KnownSet::exactly(ValueSet::everything())
                                  : ranges_.set_of_literal(owl::TermId{literal})};
  KnownSet& set = counted.set;
  for (const std::uint32_t range : ranges) set.restrict_to(ranges_.known_set(DataRangeId{range}));
  counted.least = set.least.count();
  counted.most = set.most.count();
  sets_.push_back(std::move(counted));
  return found->second;
}

bool ValueCheck::can_be_alone(const Counted& counted) const {
  const std::vector<OpaqueSet>& opaque = counted.set.opaque;
  if (opaque.empty()) return counted.least > 0;
  // separate_opaque() asks for nothing of values of which there are many, unless equality is asked for.
  return counted.least >= many_values &&
         std::ranges::none_of(opaque, [&](const OpaqueSet& set) { return ranges_.is_literal(set.term); });
}

bool ValueCheck::is_unchanged(const Graph& graph, NodeId node) const {
  const Look& last = last_looks_[node];
  return last.version == graph.node(node).version && last.surroundings == graph.node(node).surroundings;
}

bool ValueCheck::needs_look(const Graph& graph, NodeId node) const {
  const bool is_there = node < graph.node_count() && is_value(graph.node(node).kind) && graph.is_active(node);
  if (is_there && node < settled_ && graph.node(node).kind != NodeKind::constant) return false;
  return is_there && !(last_looks_[node].is_free && is_unchanged(graph, node));
}

bool ValueCheck::knows_all_ranges() {
  if (!knows_all_ranges_) knows_all_ranges_ = ranges_.are_all_known();
  return *knows_all_ranges_;
}

void ValueCheck::settle(const Graph& graph, NodeId first) {
  // Values that are not settled any more are looked at again.
  if (first < settled_) looked_at_.insert(graph.values().begin(), graph.values().end());
  settled_ = first;
}

std::vector<ValueCheck::Variable> ValueCheck::variables_of(Graph& graph) {
  std::vector<Variable> variables;
  std::vector<std::uint32_t> ranges;
  last_looks_.resize(graph.node_count());
  number_of_.resize(graph.node_count(), none);
  // Values that were free at the last look and have not changed are most of a large model. They are not looked at.
  for (const NodeId node : graph.take_changed_values()) looked_at_.insert(node);
  std::erase_if(looked_at_, [&](NodeId node) { return !needs_look(graph, node); });
  for (const NodeId node : looked_at_) {
    ++looked_;
    Look& last = last_looks_[node];
    if (!is_unchanged(graph, node)) last = {graph.node(node).version, graph.node(node).surroundings, no_set, false};
    Variable variable;
    variable.node = node;
    ranges.clear();
    const bool has_siblings = graph.node(node).siblings != none;
    bool is_free = !has_siblings;
    bool is_alone = !has_siblings;
    for (FactId id = graph.node(node).others; id != none; id = graph.next_other(id, node)) {
      const Fact& fact = graph.fact(id);
      is_free = false;
      if (fact.kind == FactKind::data_range) {
        ranges.push_back(fact.predicate);
        variable.dependency = graph.unite(variable.dependency, fact.dependency);
      } else if (fact.kind == FactKind::unequal) {
        is_alone = false;
        const NodeId other = fact.a == node ? fact.b : fact.a;
        if (other > node || number_of_[other] == none) continue;
        variable.differs.push_back(number_of_[other]);
        variable.because.push_back(fact.dependency);
      }
    }
    if (!is_free && last.known == no_set) {
      std::ranges::sort(ranges);
      last.known = known_set(ranges, graph.node(node).literal);
    }
    last.is_free = is_free || (is_alone && can_be_alone(sets_[last.known]));
    if (last.is_free) continue;
    variable.known = last.known;
    // With more values than there are nodes, one is left for it whatever the others take.
    if (sets_[variable.known].least > graph.values().size()) continue;
    if (has_siblings) {
      const Siblings& siblings = graph.siblings_of(node);
      for (NodeId other = siblings.first; other < node; ++other) {
        if (number_of_[other] == none) continue;
        variable.differs.push_back(number_of_[other]);
        variable.because.push_back(siblings.dependency);
      }
    }
    number_of_[node] = static_cast<std::uint32_t>(variables.size());
    for (std::size_t at = 0; at < variable.differs.size(); ++at) {
      variables[variable.differs[at]].differs.push_back(number_of_[node]);
      variables[variable.differs[at]].because.push_back(variable.because[at]);
    }
    variables.push_back(std::move(variable));
  }
  for (const Variable& variable : variables) number_of_[variable.node] = none;
  return variables;
}

std::string ValueCheck::separate_opaque(std::vector<Variable>& variables, bool has_all_facts) const {
  struct Sides {
    std::vector<std::uint32_t> inside;
    std::vector<std::uint32_t> outside;
  };
  std::map<owl::TermId, Sides> sides;
  for (std::uint32_t at = 0; at < variables.size(); ++at) {
    const Counted& counted = sets_[variables[at].known];
    if (!has_all_facts && !counted.set.opaque.empty() && counted.least < many_values)
      return "values of a datatype that is not known, of which facts may say something else";
    for (const OpaqueSet& opaque : counted.set.opaque) {
      Sides& its = sides[opaque.term];
      (opaque.is_complement ? its.outside : its.inside).push_back(at);
    }
  }
  std::size_t pairs = 0;
  for (const auto& [term, its] : sides) {
    // Two nodes with the value of one literal are equal, which is more than that they differ from others.
    if (ranges_.is_literal(term) && its.inside.size() > 1) return "values whose equality is not known";
    for (const std::uint32_t one : its.inside) {
      if (sets_[variables[one].known].least >= many_values) continue;
      for (const std::uint32_t other : its.outside) {
        if (sets_[variables[other].known].least >= many_values) continue;
        if (++pairs > max_opaque_pairs) return "values that must differ are too many to try out";
        // The ranges of both are the reason, and clash() has these already.
        for (const auto& [from, to] : {std::pair{one, other}, std::pair{other, one}}) {
          variables[from].differs.push_back(to);
          variables[from].because.push_back(no_dependency);
        }
      }
    }
  }
  return {};
}

std::optional<DependencySet> ValueCheck::clash(Graph& graph, std::string& unknown, bool has_all_facts) {
  std::vector<Variable> variables = variables_of(graph);
  const std::string unsaid = separate_opaque(variables, has_all_facts);
  if (!unsaid.empty()) unknown = unsaid;
  std::vector<bool> is_seen(variables.size(), false);
  for (std::uint32_t start = 0; start < variables.size(); ++start) {
    if (is_seen[start]) continue;
    // The values that must differ from each other and are connected with `start`.
    std::vector<std::uint32_t> group = {start};
    is_seen[start] = true;
    for (std::size_t at = 0; at < group.size(); ++at) {
      for (const std::uint32_t other : variables[group[at]].differs) {
        if (!is_seen[other]) group.push_back(other);
        is_seen[other] = true;
      }
    }
    const auto can_with_most = can_differ(variables, group, true);
    if (can_with_most == false) {
      DependencySet dependency = no_dependency;
      for (const std::uint32_t at : group) {
        // An empty range is enough of a reason.
        if (sets_[variables[at].known].most == 0) return variables[at].dependency;
        dependency = graph.unite(dependency, variables[at].dependency);
        for (const DependencySet because : variables[at].because) dependency = graph.unite(dependency, because);
      }
      return dependency;
    }
    if (!can_with_most) unknown = "values that must differ are too many to try out";
    if (can_with_most && can_differ(variables, group, false) != true) {
      for (const std::uint32_t at : group) {
        if (unknown.empty()) unknown = sets_[variables[at].known].set.reason;
      }
      if (unknown.empty()) unknown = "values that must differ are too many to try out";
    }
  }
  return std::nullopt;
}

std::optional<bool> ValueCheck::can_differ(const std::vector<Variable>& variables,
                                           const std::vector<std::uint32_t>& group, bool uses_most) {
  const auto count = [&](std::uint32_t at) {
    const Counted& one = sets_[variables[at].known];
    return uses_most ? one.most : one.least;
  };
  if (group.size() == 1 && variables[group.front()].differs.empty()) return count(group.front()) > 0;
  std::map<std::uint32_t, std::size_t> open;  // with how many open ones each must differ from
  for (const std::uint32_t at : group) open.emplace(at, variables[at].differs.size());
  for (bool changed = true; changed;) {
    changed = false;
    for (auto one = open.begin(); one != open.end();) {
      if (count(one->first) == 0) return false;
      if (count(one->first) <= one->second) {
        ++one;
        continue;
      }
      for (const std::uint32_t other : variables[one->first].differs) {
        if (const auto found = open.find(other); found != open.end()) --found->second;
      }
      one = open.erase(one);
      changed = true;
    }
  }
  if (open.empty()) return true;
  std::vector<std::uint32_t> order;
  for (const auto& [at, degree] : open) order.push_back(at);
  std::ranges::stable_sort(order, {}, count);
  std::vector<std::vector<Value>> values;
  for (const std::uint32_t at : order) {
    const Counted& one = sets_[variables[at].known];
    values.push_back((uses_most ? one.set.most : one.set.least).list(count(at)));
    if (values.back().size() < count(at)) return std::nullopt;  // not all of them can be listed
  }
  const bool all_differ = std::ranges::all_of(order, [&](std::uint32_t one) {
    std::set<std::uint32_t> others;
    for (const std::uint32_t other : variables[one].differs) {
      if (open.contains(other)) others.insert(other);
    }
    return others.size() + 1 == order.size();
  });
  if (all_differ) return can_all_differ(values);
  // Depth first, with an index into the values of each.
  std::vector<std::size_t> chosen = {0};
  for (std::size_t attempts = 0; attempts < max_value_attempts; ++attempts) {
    const std::size_t last = chosen.size() - 1;
    if (chosen[last] == values[last].size()) {
      if (last == 0) return false;
      chosen.pop_back();
      ++chosen.back();
      continue;
    }
    bool is_free = true;
    for (std::size_t before = 0; before < last && is_free; ++before) {
      const bool must_differ =
          std::ranges::find(variables[order[last]].differs, order[before]) != variables[order[last]].differs.end();
      is_free = !must_differ || !(values[before][chosen[before]] == values[last][chosen[last]]);
    }
    if (!is_free) {
      ++chosen[last];
    } else if (chosen.size() == order.size()) {
      return true;
    } else {
      chosen.push_back(0);
    }
  }
  return std::nullopt;
}

}  // namespace geminga::hypertableau
