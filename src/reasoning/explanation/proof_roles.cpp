// One kind of property axiom after the other.
#include "reasoning/explanation/proof_roles.hpp"

#include <algorithm>

namespace geminga::explanation {

using owl::Axiom;
using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

ProofRoles::ProofRoles(owl::Ontology& source, ProofTerms& terms, std::span<const std::uint32_t> axioms)
    : source_(source), terms_(terms) {
  for (const std::uint32_t axiom : axioms) add(axiom);
}

/// `inverse of inverse of r` is r.
TermId ProofRoles::role(TermId term) {
  if (source_.kind(term) != TermKind::object_inverse_of) return term;
  return inverse(inverse(term));
}

void ProofRoles::include(TermId sub, TermId super, std::uint32_t axiom) {
  inclusions_.push_back({sub, super, axiom});
  if (source_.kind(sub) != TermKind::data_property) inclusions_.push_back({inverse(sub), inverse(super), axiom});
}

void ProofRoles::add_chain(std::vector<TermId> links, TermId super, std::uint32_t axiom) {
  chains_.push_back({links, super, axiom});
  std::ranges::reverse(links);
  for (TermId& link : links) link = inverse(link);
  chains_.push_back({std::move(links), inverse(super), axiom});
}

void ProofRoles::add(std::uint32_t number) {
  const Axiom axiom = source_.axiom(number);
  std::vector<TermId> arguments(axiom.arguments.begin(), axiom.arguments.end());
  switch (axiom.kind) {
    case AxiomKind::sub_object_property_of:
      if (source_.kind(arguments[0]) == TermKind::object_property_chain) {
        const auto links = source_.term(arguments[0]).arguments;
        std::vector<TermId> copy(links.begin(), links.end());
        for (TermId& link : copy) link = role(link);
        return add_chain(std::move(copy), role(arguments[1]), number);
      }
      return include(role(arguments[0]), role(arguments[1]), number);
    case AxiomKind::sub_data_property_of:
      return include(arguments[0], arguments[1], number);
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::equivalent_data_properties:
      for (const TermId one : arguments) {
        for (const TermId other : arguments) {
          if (one != other) include(role(one), role(other), number);
        }
      }
      return;
    case AxiomKind::inverse_object_properties:
      include(role(arguments[0]), inverse(role(arguments[1])), number);
      return include(role(arguments[1]), inverse(role(arguments[0])), number);
    case AxiomKind::symmetric_object_property:
      return include(role(arguments[0]), inverse(role(arguments[0])), number);
    case AxiomKind::transitive_object_property:
      return add_chain({role(arguments[0]), role(arguments[0])}, role(arguments[0]), number);
    case AxiomKind::object_property_range:
      ranges_.push_back({role(arguments[0]), terms_.normal(arguments[1]), number});
      return;
    case AxiomKind::object_property_domain:
      ranges_.push_back({inverse(role(arguments[0])), terms_.normal(arguments[1]), number});
      return;
    case AxiomKind::functional_object_property:
      functional_.push_back({role(arguments[0]), owl::thing_term, number});
      return;
    case AxiomKind::functional_data_property:
      functional_.push_back({arguments[0], owl::thing_term, number});
      return;
    case AxiomKind::inverse_functional_object_property:
      functional_.push_back({inverse(role(arguments[0])), owl::thing_term, number});
      return;
    default:
      return;
  }
}

const std::vector<RoleAbove>& ProofRoles::above(TermId start) {
  auto [known, is_new] = above_.try_emplace(start);
  std::vector<RoleAbove>& found = known->second;
  if (!is_new) return found;
  found.push_back({start, {}});
  for (std::size_t at = 0; at < found.size(); ++at) {
    for (const Inclusion& inclusion : inclusions_) {
      if (inclusion.sub != found[at].role) continue;
      if (std::ranges::find(found, inclusion.super, &RoleAbove::role) != found.end()) continue;
      AxiomSet axioms = found[at].axioms;
      axioms.push_back(inclusion.axiom);
      found.push_back({inclusion.super, std::move(axioms)});
    }
  }
  return found;
}

const AxiomSet* ProofRoles::find(TermId sub, TermId super) {
  const std::vector<RoleAbove>& all = above(sub);
  const auto found = std::ranges::find(all, super, &RoleAbove::role);
  return found == all.end() ? nullptr : &found->axioms;
}

}  // namespace geminga::explanation
