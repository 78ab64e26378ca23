#include "reasoning/dl/clauses/class_clauses.hpp"

#include <algorithm>
#include <utility>

namespace geminga::clauses {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

namespace {

constexpr Atom atom_of(ConceptId id) { return {AtomKind::concept_of, centre, centre, number(id)}; }

/// Up to so many disjoint classes have a clause for each pair. If there are more, so many make a group each, because
/// the number of pairs grows with the square.
constexpr std::size_t max_paired = 64;
constexpr std::size_t members_a_group = 16;

}  // namespace

std::string_view ClassClauses::problem(const OrderedAxiom& axiom) {
  const auto& arguments = axiom.arguments;
  const auto first_of = [&](auto&&... literals) {
    std::string_view found;
    ((found = found.empty() ? allowed_.problem(literals) : found), ...);
    return found;
  };
  std::string_view found;
  switch (axiom.kind) {
    case AxiomKind::sub_class_of:
      return first_of(negative(arguments[0]), positive(arguments[1]));
    case AxiomKind::equivalent_classes:
    case AxiomKind::disjoint_union:
      for (const TermId member : arguments)
        found = found.empty() ? first_of(negative(member), positive(member)) : found;
      return found;
    case AxiomKind::disjoint_classes:
      for (const TermId member : arguments) found = found.empty() ? first_of(negative(member)) : found;
      return found;
    case AxiomKind::class_assertion:
      return first_of(positive(arguments[0]));
    case AxiomKind::has_key:
      return first_of(negative(arguments[0]));
    case AxiomKind::data_property_domain:
      return first_of(positive(arguments[1]));
    default:
      return {};
  }
}

void ClassClauses::add_inclusion(TermId sub, TermId super) { add_disjunction({negative(sub), positive(super)}); }

void ClassClauses::add_disjunction(std::vector<Literal> disjunction) {
  const bool is_allowed =
      std::ranges::all_of(disjunction, [&](Literal literal) { return allowed_.problem(literal).empty(); });
  if (is_allowed) translator_.add(std::move(disjunction));
}

void ClassClauses::add(const OrderedAxiom& axiom) {
  const auto& arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::sub_class_of:
      add_inclusion(arguments[0], arguments[1]);
      return;
    case AxiomKind::equivalent_classes:
      // The first argument is a name, if one of them is.
      for (const TermId other : std::span(arguments).subspan(1)) {
        add_inclusion(arguments[0], other);
        add_inclusion(other, arguments[0]);
      }
      return;
    case AxiomKind::disjoint_classes:
      add_disjoint(arguments);
      return;
    case AxiomKind::disjoint_union: {
      const auto parts = std::span(arguments).subspan(1);
      std::vector<Literal> whole = {negative(arguments[0])};
      for (const TermId part : parts) {
        add_inclusion(part, arguments[0]);
        whole.push_back(positive(part));
      }
      add_disjunction(std::move(whole));
      add_disjoint(parts);
      return;
    }
    case AxiomKind::has_key:
      return add_key(axiom);
    default:
      return;
  }
}

//  A(x) -> G(x) for each A of a group G    A(x), B(x) -> false for A, B of one group    G(x), H(x) -> false
// instead of a clause for each pair, if there are many. Many groups are grouped again.
void ClassClauses::add_disjoint(std::span<const TermId> members) {
  if (members.size() <= max_paired) return add_disjoint_pairs(members);
  std::vector<ConceptId> groups;
  for (std::size_t at = 0; at < members.size(); at += members_a_group) {
    const auto group = members.subspan(at, std::min(members_a_group, members.size() - at));
    add_disjoint_pairs(group);
    groups.push_back(vocabulary_.auxiliary(group.front()));
    for (const TermId member : group) {
      if (!allowed_.problem(negative(member)).empty()) continue;
      Draft draft;
      draft.waiting.push_back({negative(member), centre});
      draft.clause.head.push_back(atom_of(groups.back()));
      translator_.add(std::move(draft));
    }
  }
  add_disjoint_groups(std::move(groups));
}

void ClassClauses::add_disjoint_groups(std::vector<ConceptId> groups) {
  while (groups.size() > 1) {
    std::vector<ConceptId> above;
    const std::size_t size = groups.size() <= max_paired ? groups.size() : members_a_group;
    for (std::size_t at = 0; at < groups.size(); at += size) {
      const auto group = std::span(groups).subspan(at, std::min(size, groups.size() - at));
      above.push_back(vocabulary_.auxiliary(set_.concepts[number(group.front())].term));
      for (std::size_t first = 0; first < group.size(); ++first) {
        for (std::size_t second = first + 1; second < group.size(); ++second) {
          translator_.add_clause({{atom_of(group[first]), atom_of(group[second])}, {}});
        }
        if (size < groups.size()) translator_.add_clause({{atom_of(group[first])}, {atom_of(above.back())}});
      }
    }
    groups = std::move(above);
  }
}

void ClassClauses::add_disjoint_pairs(std::span<const TermId> members) {
  for (std::size_t first = 0; first < members.size(); ++first) {
    for (std::size_t second = first + 1; second < members.size() && !translator_.is_full(); ++second) {
      add_disjunction({negative(members[first]), negative(members[second])});
    }
  }
}

void ClassClauses::add_key(const OrderedAxiom& axiom) {
  Key key{translator_.above(positive(axiom.arguments[0])), {}, {}};
  for (const TermId property : std::span(axiom.arguments).subspan(1)) {
    if (vocabulary_.source().kind(property) == TermKind::data_property) {
      key.data_properties.push_back(vocabulary_.data_property(property));
    } else {
      key.roles.push_back(translator_.role(property));
    }
  }
  std::ranges::sort(key.roles);
  std::ranges::sort(key.data_properties);
  set_.keys.push_back(std::move(key));
}

}  // namespace geminga::clauses
