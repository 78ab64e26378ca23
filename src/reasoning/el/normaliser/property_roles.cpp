// A role for each property; the top and bottom properties have a fixed meaning.
#include "reasoning/el/normaliser/property_roles.hpp"

#include <string_view>

#include "base/interner.hpp"

namespace geminga::el {
namespace {

constexpr std::uint32_t no_role = base::NumberTable::none;
constexpr std::string_view owl_prefix = "http://www.w3.org/2002/07/owl#";

bool is_in_owl(std::string_view iri, std::string_view local) {
  return iri.size() == owl_prefix.size() + local.size() && iri.starts_with(owl_prefix) && iri.ends_with(local);
}

}  // namespace

PropertyRoles::PropertyRoles(const owl::Ontology& source, IndexBuilder& index)
    : source_(source), index_(index), roles_(source.term_count(), no_role) {}

Property PropertyRoles::find(owl::TermId id) {
  const owl::Term term = source_.term(id);
  if (term.kind == owl::TermKind::object_inverse_of) {
    Property inverse = find(term.arguments[0]);
    inverse.is_inverse = !inverse.is_top;  // the inverse of the top property is itself
    return inverse;
  }
  Property result;
  result.is_data = term.kind == owl::TermKind::data_property;
  const std::string_view iri = source_.name(term.name);
  result.is_top = is_in_owl(iri, result.is_data ? "topDataProperty" : "topObjectProperty");
  std::uint32_t& role = roles_[static_cast<std::size_t>(id)];
  if (role == no_role) {
    role = static_cast<std::uint32_t>(index_.roles().add());
    if (result.is_data) index_.mark_data(RoleId{role});
    if (is_in_owl(iri, result.is_data ? "bottomDataProperty" : "bottomObjectProperty")) {
      const ExprId some = index_.existential(RoleId{role}, top_expr);
      index_.mark_negative(some);
      index_.add_told(some, bottom_expr);
    }
  }
  result.role = RoleId{role};
  return result;
}

}  // namespace geminga::el
