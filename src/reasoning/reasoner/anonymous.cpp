// Builds a tree of anonymous individuals from facts, then one expression, from the leaves up.
#include "reasoning/reasoner/anonymous.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/sorted.hpp"

namespace geminga::reasoner {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

namespace {

constexpr std::size_t max_levels = 400;  // SourceLimits::nesting has room for these and what they hold

bool is_anonymous(const owl::Ontology& source, TermId term) {
  return source.kind(term) == TermKind::anonymous_individual;
}

/// The anonymous individuals in some terms, each once.
std::vector<TermId> anonymous_in(const owl::Ontology& source, std::span<const TermId> terms) {
  std::vector<TermId> found = owl::terms_in(source, terms);
  std::erase_if(found, [&](TermId term) { return !is_anonymous(source, term); });
  return found;
}

/// One group of facts, and the steps that make one expression of it.
class Group {
 public:
  explicit Group(Excerpt& excerpt) : source_(excerpt.source) {}

  std::expected<RolledUp, std::string> roll_up(std::vector<Statement> facts) {
    if (!identify(facts)) return std::unexpected(problem_);
    for (const Statement& fact : facts) {
      if (!take(fact)) return std::unexpected(problem_);
    }
    if (variables_.empty()) return std::move(result_);
    base::sort_unique(edges_);
    if (edges_.size() + 1 != variables_.size()) return std::unexpected("anonymous individuals form a cycle");
    return finish();
  }

 private:
  struct Edge {
    TermId from;
    TermId property;
    TermId to;
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  bool fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  /// Replaces individuals that facts say are the same by one of them.
  bool identify(std::vector<Statement>& facts) {
    std::map<TermId, TermId> is_same;
    const auto find = [&](TermId individual) {
      for (auto known = is_same.find(individual); known != is_same.end(); known = is_same.find(individual))
        individual = known->second;
      return individual;
    };
    for (const Statement& fact : facts) {
      if (fact.kind != AxiomKind::same_individual) continue;
      for (const TermId argument : fact.arguments) {
        TermId one = find(fact.arguments.front());
        TermId other = find(argument);
        if (one == other) continue;
        if (!is_anonymous(source_, one)) std::swap(one, other);
        if (is_anonymous(source_, one)) {
          is_same.emplace(one, other);
        } else {
          result_.plain.push_back({AxiomKind::same_individual, {one, other}});
        }
      }
    }
    std::erase_if(facts, [](const Statement& fact) { return fact.kind == AxiomKind::same_individual; });
    for (Statement& fact : facts) {
      for (TermId& argument : fact.arguments) argument = find(argument);
    }
    return true;
  }

  void describe(TermId variable, TermId expression) { classes_[variable].push_back(expression); }

  bool take(const Statement& fact) {
    const auto& terms = fact.arguments;
    if (anonymous_in(source_, terms).empty()) {
      result_.plain.push_back(fact);
      return true;
    }
    for (const TermId term : terms) {
      if (is_anonymous(source_, term)) variables_.insert(term);
    }
    switch (fact.kind) {
      case AxiomKind::class_assertion:
        if (!anonymous_in(source_, std::span(&terms[0], 1)).empty())
          return fail("a class expression holds an anonymous individual");
        describe(terms[1], terms[0]);
        return true;
      case AxiomKind::object_property_assertion:
        return take_edge(terms[0], terms[1], terms[2]);
      case AxiomKind::data_property_assertion:
        describe(terms[1], source_.term(TermKind::data_has_value, {terms[0], terms[2]}));
        return true;
      case AxiomKind::negative_data_property_assertion:
        describe(terms[1], complement(source_.term(TermKind::data_has_value, {terms[0], terms[2]})));
        return true;
      case AxiomKind::negative_object_property_assertion:
        return take_negative_edge(terms[0], terms[1], terms[2]);
      case AxiomKind::different_individuals:
        return take_difference(terms);
      default:
        return fail(std::string(owl::to_string(fact.kind)) + " holds an anonymous individual");
    }
  }

  bool take_edge(TermId property, TermId from, TermId to) {
    if (from == to) {
      describe(from, source_.term(TermKind::object_has_self, {property}));
    } else if (!is_anonymous(source_, to)) {
      describe(from, source_.term(TermKind::object_has_value, {property, to}));
    } else if (is_anonymous(source_, from)) {
      edges_.push_back({from, property, to});
    } else if (!result_.individual) {
      result_.individual = from;  // the tree hangs from this one
      root_property_ = property;
      root_ = to;
    } else {
      describe(to, source_.term(TermKind::object_has_value, {inverse(property), from}));
    }
    return true;
  }

  bool take_negative_edge(TermId property, TermId from, TermId to) {
    if (is_anonymous(source_, from) && is_anonymous(source_, to))
      return fail("two anonymous individuals are said not to be related");
    const bool is_forward = is_anonymous(source_, from);
    describe(is_forward ? from : to,
             complement(source_.term(TermKind::object_has_value,
                                     {is_forward ? property : inverse(property), is_forward ? to : from})));
    return true;
  }

  bool take_difference(const std::vector<TermId>& members) {
    for (std::size_t first = 0; first < members.size(); ++first) {
      for (std::size_t second = first + 1; second < members.size(); ++second) {
        TermId one = members[first];
        TermId other = members[second];
        if (!is_anonymous(source_, one)) std::swap(one, other);
        if (!is_anonymous(source_, one)) {
          result_.plain.push_back({AxiomKind::different_individuals, {one, other}});
        } else if (is_anonymous(source_, other)) {
          return fail("two anonymous individuals are said to differ");
        } else {
          describe(one, complement(source_.term(TermKind::object_one_of, {other})));
        }
      }
    }
    return true;
  }

  TermId complement(TermId expression) { return source_.term(TermKind::object_complement_of, {expression}); }
  TermId inverse(TermId property) {
    if (source_.kind(property) == TermKind::object_inverse_of) return source_.term(property).arguments.front();
    return source_.term(TermKind::object_inverse_of, {property});
  }

  /// Goes down level by level from the root, then back, so that children become expressions before their parents do.
  std::expected<RolledUp, std::string> finish() {
    struct Visit {
      TermId variable;
      std::optional<Edge> edge;  ///< to the parent, seen from it
      std::size_t parent = 0;
      std::size_t level = 0;
    };
    std::map<TermId, std::vector<Edge>> around;
    for (const Edge& edge : edges_) {
      around[edge.from].push_back(edge);
      around[edge.to].push_back({edge.to, inverse(edge.property), edge.from});
    }
    std::vector<Visit> visits{{root_ ? *root_ : *variables_.begin(), std::nullopt, 0, 0}};
    for (std::size_t at = 0; at < visits.size(); ++at) {
      const Visit here = visits[at];
      if (here.level > max_levels) return std::unexpected("anonymous individuals form a tree of too many levels");
      for (const Edge& edge : around[here.variable]) {
        if (here.edge && edge.to == here.edge->from) continue;
        visits.push_back({edge.to, edge, at, here.level + 1});
        if (visits.size() > variables_.size()) return std::unexpected("anonymous individuals form a cycle");
      }
    }
    if (visits.size() != variables_.size()) return std::unexpected("anonymous individuals do not hang together");
    TermId expression{};
    for (std::size_t at = visits.size(); at-- > 0;) {
      expression = together(classes_[visits[at].variable]);
      if (const auto& edge = visits[at].edge) {
        describe(visits[visits[at].parent].variable,
                 source_.term(TermKind::object_some_values_from, {edge->property, expression}));
      }
    }
    result_.has_expression = true;
    result_.expression =
        root_ ? source_.term(TermKind::object_some_values_from, {root_property_, expression}) : expression;
    return std::move(result_);
  }

  TermId together(const std::vector<TermId>& parts) {
    if (parts.empty()) return owl::thing_term;
    if (parts.size() == 1) return parts.front();
    return source_.term(TermKind::object_intersection_of, parts);
  }

  owl::Ontology& source_;
  std::string problem_;
  RolledUp result_;
  std::set<TermId> variables_;
  std::map<TermId, std::vector<TermId>> classes_;
  std::vector<Edge> edges_;
  std::optional<TermId> root_;
  TermId root_property_{};
};

}  // namespace

std::expected<RolledUp, std::string> roll_up(Excerpt& excerpt, std::vector<Statement> facts) {
  return Group(excerpt).roll_up(std::move(facts));
}

std::vector<std::vector<std::uint32_t>> find_groups(const owl::Ontology& source,
                                                    std::span<const std::uint32_t> axioms) {
  std::vector<std::uint32_t> members;
  std::vector<std::size_t> leader;  // of each member, a member
  std::map<TermId, std::size_t> first_with;
  const auto find = [&](std::size_t member) {
    while (leader[member] != member) member = leader[member] = leader[leader[member]];
    return member;
  };
  for (const std::uint32_t axiom : axioms) {
    const std::vector<TermId> found = anonymous_in(source, source.axiom(axiom).arguments);
    if (found.empty()) continue;
    const std::size_t member = members.size();
    members.push_back(axiom);
    leader.push_back(member);
    for (const TermId individual : found) {
      const auto [known, is_new] = first_with.emplace(individual, member);
      if (is_new) continue;
      const std::size_t one = find(known->second);
      const std::size_t other = find(member);
      leader[std::max(one, other)] = std::min(one, other);
    }
  }
  std::map<std::size_t, std::vector<std::uint32_t>> groups;
  for (std::size_t member = 0; member < members.size(); ++member) groups[find(member)].push_back(members[member]);
  std::vector<std::vector<std::uint32_t>> result;
  for (auto& [first, group] : groups) result.push_back(std::move(group));
  return result;
}

}  // namespace geminga::reasoner
