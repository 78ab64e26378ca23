// Axioms about classes, facts, and the axioms that have no clauses.
#include <algorithm>

#include "reasoning/dl/clauses/clausifier.hpp"

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

std::string_view Clausifier::problem_of(const Ordered& axiom) {
  const auto& arguments = axiom.arguments;
  if (axiom.kind == AxiomKind::declaration) return {};
  const bool is_trivial = axiom.kind == AxiomKind::sub_data_property_of;  // owl:topDataProperty may be the super
  for (const TermId argument : std::span(arguments).first(is_trivial ? 1 : arguments.size())) {
    if (source_.kind(argument) == TermKind::data_property && allowed_->is_top_data(argument)) {
      return "owl:topDataProperty";
    }
  }
  const std::string_view found = problem_of_classes(axiom);
  return found.empty() ? problem_of_properties(axiom) : found;
}

std::string_view Clausifier::problem_of_classes(const Ordered& axiom) {
  const auto& arguments = axiom.arguments;
  const auto first_of = [&](auto&&... literals) {
    std::string_view found;
    ((found = found.empty() ? allowed_->problem(literals) : found), ...);
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

void Clausifier::add(const Ordered& axiom) {
  switch (axiom.kind) {
    case AxiomKind::declaration:
      if (source_.kind(axiom.arguments[0]) == TermKind::named_class) vocabulary_.concept_of(axiom.arguments[0]);
      if (source_.kind(axiom.arguments[0]) == TermKind::individual) vocabulary_.individual(axiom.arguments[0]);
      return;
    case AxiomKind::datatype_definition:
      set_.datatype_definitions.push_back({axiom.arguments[0], axiom.arguments[1]});
      return;
    case AxiomKind::has_key:
      add_key(axiom);
      return;
    default:
      add_class_axiom(axiom);
      add_property_axiom(axiom);
      add_data_property_axiom(axiom);
      add_fact(axiom);
  }
}

void Clausifier::add_inclusion(TermId sub, TermId super) { add_disjunction({negative(sub), positive(super)}); }

void Clausifier::add_disjunction(std::vector<Literal> disjunction) {
  const bool is_allowed =
      std::ranges::all_of(disjunction, [&](Literal literal) { return allowed_->problem(literal).empty(); });
  if (is_allowed) translator_->add(std::move(disjunction));
}

void Clausifier::add_class_axiom(const Ordered& axiom) {
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
    default:
      return;
  }
}

//  A(x) -> G(x) for each A of a group G    A(x), B(x) -> false for A, B of one group    G(x), H(x) -> false
// instead of a clause for each pair, if there are many. Many groups are grouped again.
void Clausifier::add_disjoint(std::span<const TermId> members) {
  if (members.size() <= max_paired) return add_disjoint_pairs(members);
  std::vector<ConceptId> groups;
  for (std::size_t at = 0; at < members.size(); at += members_a_group) {
    const auto group = members.subspan(at, std::min(members_a_group, members.size() - at));
    add_disjoint_pairs(group);
    groups.push_back(vocabulary_.auxiliary(group.front()));
    for (const TermId member : group) {
      if (!allowed_->problem(negative(member)).empty()) continue;
      Draft draft;
      draft.waiting.push_back({negative(member), centre});
      draft.clause.head.push_back(atom_of(groups.back()));
      translator_->add(std::move(draft));
    }
  }
  add_disjoint_groups(std::move(groups));
}

void Clausifier::add_disjoint_groups(std::vector<ConceptId> groups) {
  while (groups.size() > 1) {
    std::vector<ConceptId> above;
    const std::size_t size = groups.size() <= max_paired ? groups.size() : members_a_group;
    for (std::size_t at = 0; at < groups.size(); at += size) {
      const auto group = std::span(groups).subspan(at, std::min(size, groups.size() - at));
      above.push_back(vocabulary_.auxiliary(set_.concepts[number(group.front())].term));
      for (std::size_t first = 0; first < group.size(); ++first) {
        for (std::size_t second = first + 1; second < group.size(); ++second) {
          translator_->add_clause({{atom_of(group[first]), atom_of(group[second])}, {}});
        }
        if (size < groups.size()) translator_->add_clause({{atom_of(group[first])}, {atom_of(above.back())}});
      }
    }
    groups = std::move(above);
  }
}

void Clausifier::add_disjoint_pairs(std::span<const TermId> members) {
  for (std::size_t first = 0; first < members.size(); ++first) {
    for (std::size_t second = first + 1; second < members.size() && !translator_->is_full(); ++second) {
      add_disjunction({negative(members[first]), negative(members[second])});
    }
  }
}

void Clausifier::add_key(const Ordered& axiom) {
  Key key{translator_->above(positive(axiom.arguments[0])), {}, {}};
  for (const TermId property : std::span(axiom.arguments).subspan(1)) {
    if (source_.kind(property) == TermKind::data_property) {
      key.data_properties.push_back(vocabulary_.data_property(property));
    } else {
      key.roles.push_back(translator_->role(property));
    }
  }
  std::ranges::sort(key.roles);
  std::ranges::sort(key.data_properties);
  set_.keys.push_back(std::move(key));
}

void Clausifier::assert_fact(Literal literal, IndividualId individual) {
  const Shape shape = shape_of(source_, literal);
  if (shape.kind == ShapeKind::all_of) {
    for (const Literal operand : shape.operands) assert_fact(operand, individual);
    return;
  }
  const ConceptId id = translator_->below(literal);
  if (id != thing) set_.concept_facts.push_back({id, individual});
}

void Clausifier::add_fact(const Ordered& axiom) {
  const auto& arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::class_assertion:
      assert_fact(positive(arguments[0]), vocabulary_.individual(arguments[1]));
      return;
    case AxiomKind::object_property_assertion: {
      const Role role = translator_->role(arguments[0]);
      RoleFact fact{role.property, vocabulary_.individual(arguments[1]), vocabulary_.individual(arguments[2])};
      if (role.is_inverse) std::swap(fact.first, fact.second);
      set_.role_facts.push_back(fact);
      return;
    }
    case AxiomKind::negative_object_property_assertion:  // a is not in  some R.{b}
      translator_->add_every(vocabulary_.role(arguments[0]), negative(arguments[2]), negative(arguments[1]));
      return;
    case AxiomKind::data_property_assertion:
      set_.data_facts.push_back(
          {vocabulary_.data_property(arguments[0]), vocabulary_.individual(arguments[1]), arguments[2]});
      return;
    case AxiomKind::negative_data_property_assertion: {  // {a}(x), U(x,v) -> (not {value})(v)
      const DataRangeId others = vocabulary_.data_range({arguments[2], true});
      const std::uint32_t nominal = number(vocabulary_.concept_of(arguments[1]));
      translator_->add_clause({{{AtomKind::concept_of, centre, centre, nominal},
                                {AtomKind::data_role, centre, 1, number(vocabulary_.data_property(arguments[0]))}},
                               {{AtomKind::data_range, 1, centre, number(others)}}});
      return;
    }
    case AxiomKind::same_individual:
      for (const TermId other : std::span(arguments).subspan(1)) {
        set_.equalities.push_back({vocabulary_.individual(arguments[0]), vocabulary_.individual(other), false});
      }
      return;
    case AxiomKind::different_individuals:
      for (std::size_t first = 0; first < arguments.size(); ++first) {
        for (std::size_t second = first + 1; second < arguments.size(); ++second) {
          if (set_.equalities.size() > limits_.clauses) return;
          set_.equalities.push_back(
              {vocabulary_.individual(arguments[first]), vocabulary_.individual(arguments[second]), true});
        }
      }
      return;
    default:
      return;
  }
}

}  // namespace geminga::clauses
