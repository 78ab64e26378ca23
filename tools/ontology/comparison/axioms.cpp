#include "ontology/comparison/axioms.hpp"

#include <algorithm>
#include <array>

namespace geminga::ontology {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

Contents::Contents(const owl::Ontology& source)
    : source_(source), hashes_(source, owl::BlankNodes::all_alike), holds_blank_(source.term_count()) {
  for (std::uint32_t number = 0; number < source.term_count(); ++number) {
    const owl::Term term = source.term(TermId{number});
    holds_blank_[number] =
        term.kind == TermKind::anonymous_individual ||
        std::ranges::any_of(term.arguments, [&](TermId id) { return holds_blank_[static_cast<std::size_t>(id)]; });
  }
}

Contents::Hash Contents::hash_of(const owl::Axiom& axiom) const {
  const auto property = [&](TermId id) {
    return source_.kind(id) == TermKind::object_inverse_of ? source_.term(id).arguments[0] : id;
  };
  const auto arguments = axiom.arguments;
  if (axiom.kind == AxiomKind::object_property_assertion && property(arguments[0]) != arguments[0]) {
    const std::array reverse{property(arguments[0]), arguments[2], arguments[1]};
    return hashes_.hash_of({.kind = axiom.kind, .arguments = reverse});
  }
  if (axiom.kind == AxiomKind::inverse_object_properties && property(arguments[0]) != arguments[0] &&
      property(arguments[1]) != arguments[1]) {
    const std::array properties{property(arguments[0]), property(arguments[1])};
    return hashes_.hash_of({.kind = axiom.kind, .arguments = properties});
  }
  return hashes_.hash_of(axiom);
}

std::vector<Contents::Hash> Contents::same_things(const owl::Axiom& axiom) const {
  const bool is_sameness =
      axiom.kind == AxiomKind::equivalent_classes || axiom.kind == AxiomKind::equivalent_object_properties ||
      axiom.kind == AxiomKind::equivalent_data_properties || axiom.kind == AxiomKind::same_individual;
  std::vector<Hash> members;
  if (!is_sameness) return members;
  for (const TermId id : axiom.arguments) {
    if (holds_blank_[static_cast<std::size_t>(id)]) return {};
    members.push_back(hashes_.hash_of(id));
  }
  return members;
}

Axioms::Axioms(const owl::Ontology& source) {
  const Contents contents(source);
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    known_.insert(contents.hash_of(axiom));
    const auto members = contents.same_things(axiom);
    all_.join(members);
    if (members.size() > 2) of_more_than_two_.join(members);
  }
  all_.settle();
  of_more_than_two_.settle();
}

bool Axioms::has(const Contents& contents, const owl::Axiom& axiom) const {
  if (known_.contains(contents.hash_of(axiom))) return true;
  const auto members = contents.same_things(axiom);
  if (members.empty()) return false;
  return members.size() > 2 ? all_.have_together(members) : of_more_than_two_.have_together(members);
}

void Axioms::Groups::join(const std::vector<Contents::Hash>& members) {
  for (const Contents::Hash& member : members) {
    above_.try_emplace(member, member);
    above_[root(member)] = root(members.front());
  }
}

Contents::Hash Axioms::Groups::root(Contents::Hash member) {
  for (;;) {
    Contents::Hash& above = above_.at(member);
    if (above == member) return member;
    above = above_.at(above);
    member = above;
  }
}

void Axioms::Groups::settle() {
  for (auto& [member, above] : above_) above = root(member);
}

bool Axioms::Groups::have_together(const std::vector<Contents::Hash>& members) const {
  const auto first = above_.find(members.front());
  return first != above_.end() && std::ranges::all_of(members, [&](const Contents::Hash& member) {
           const auto found = above_.find(member);
           return found != above_.end() && found->second == first->second;
         });
}

}  // namespace geminga::ontology
