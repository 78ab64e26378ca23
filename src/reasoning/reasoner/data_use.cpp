#include "reasoning/reasoner/data_use.hpp"

namespace geminga::reasoner {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

void merge(const DataUse& from, DataUse& into) {
  into.datatypes.insert(from.datatypes.begin(), from.datatypes.end());
  into.literals.insert(from.literals.begin(), from.literals.end());
  into.facets.insert(from.facets.begin(), from.facets.end());
  for (const auto& [property, literals] : from.facts) into.facts[property].insert(literals.begin(), literals.end());
  into.is_counted = into.is_counted || from.is_counted;
  into.is_key = into.is_key || from.is_key;
}

bool is_counting(TermKind kind) {
  return kind == TermKind::data_min_cardinality || kind == TermKind::data_max_cardinality ||
         kind == TermKind::data_exact_cardinality;
}

}  // namespace

std::vector<TermId> DataUses::properties_in(const owl::Axiom& axiom) const {
  std::vector<TermId> properties;
  for (const TermId id : owl::terms_in(source_, axiom.arguments)) {
    if (source_.kind(id) == TermKind::data_property) properties.push_back(id);
  }
  return properties;
}

void DataUses::relate(const std::vector<TermId>& properties) {
  for (std::size_t at = 1; at < properties.size(); ++at) {
    related_[properties[0]].insert(properties[at]);
    related_[properties[at]].insert(properties[0]);
  }
}

/// A literal in a facet belongs to the facet, and the datatype of a literal is not a range.
void DataUses::add_range(TermId range, DataUse& use) {
  std::vector<TermId> open{range};
  std::set<TermId> seen;
  while (!open.empty()) {
    const TermId id = open.back();
    open.pop_back();
    if (!seen.insert(id).second) continue;
    switch (source_.kind(id)) {
      case TermKind::datatype:
        use.datatypes.insert(id);
        break;
      case TermKind::literal:
        use.literals.insert(id);
        break;
      case TermKind::facet:
        use.facets.insert(id);
        break;
      default:
        for (const TermId part : source_.term(id).arguments) open.push_back(part);
    }
  }
}

void DataUses::add(const owl::Axiom& axiom, bool is_told) {
  const auto arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::sub_data_property_of:
    case AxiomKind::equivalent_data_properties:
      return relate({arguments.begin(), arguments.end()});
    case AxiomKind::disjoint_data_properties:
      for (const TermId property : arguments) uses_[property].is_counted = true;
      return relate({arguments.begin(), arguments.end()});
    case AxiomKind::functional_data_property:
      uses_[arguments[0]].is_counted = true;
      return;
    case AxiomKind::data_property_range:
      return add_range(arguments[1], uses_[arguments[0]]);
    case AxiomKind::datatype_definition:
      return add_range(arguments[1], definitions_[arguments[0]]);
    case AxiomKind::data_property_assertion:
      if (is_told) {
        uses_[arguments[0]].facts[arguments[0]].insert(arguments[2]);
        return;
      }
      [[fallthrough]];
    case AxiomKind::negative_data_property_assertion:
      uses_[arguments[0]].literals.insert(arguments[2]);
      uses_[arguments[0]].is_counted = true;
      return;
    case AxiomKind::has_key:
      for (const TermId property : arguments) {
        if (source_.kind(property) != TermKind::data_property) continue;
        uses_[property].is_counted = true;
        uses_[property].is_key = true;
      }
      break;
    default:
      break;
  }
  for (const TermId id : owl::terms_in(source_, arguments)) {
    const owl::Term term = source_.term(id);
    if (term.kind < TermKind::data_some_values_from || term.kind > TermKind::data_exact_cardinality) continue;
    DataUse& use = uses_[term.arguments[0]];
    use.is_counted = use.is_counted || is_counting(term.kind);
    if (term.arguments.size() > 1) add_range(term.arguments[1], use);
  }
}

DataUse DataUses::use_in(const owl::Axiom& axiom) const {
  DataUse use;
  std::vector<TermId> open = properties_in(axiom);
  std::set<TermId> seen(open.begin(), open.end());
  while (!open.empty()) {
    const TermId property = open.back();
    open.pop_back();
    if (const auto found = uses_.find(property); found != uses_.end()) merge(found->second, use);
    const auto related = related_.find(property);
    if (related == related_.end()) continue;
    for (const TermId next : related->second) {
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  // A datatype of the user is what its definition says, and its parts may be other such datatypes.
  std::set<TermId> defined;
  for (bool is_growing = true; is_growing;) {
    is_growing = false;
    for (const auto& [datatype, definition] : definitions_) {
      if (!use.datatypes.contains(datatype) || !defined.insert(datatype).second) continue;
      merge(definition, use);
      is_growing = true;
    }
  }
  for (const TermId datatype : defined) use.datatypes.erase(datatype);
  return use;
}

}  // namespace geminga::reasoner
