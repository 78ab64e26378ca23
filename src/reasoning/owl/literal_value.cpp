#include "reasoning/owl/literal_value.hpp"

#include <algorithm>
#include <array>

#include "reasoning/owl/datatypes.hpp"

namespace geminga::owl {
namespace {

bool is_one_of(std::string_view iri, std::span<const std::string_view> words) {
  return iri.starts_with(xsd_namespace) && std::ranges::find(words, iri.substr(xsd_namespace.size())) != words.end();
}

bool is_bound(std::string_view facet) {
  static constexpr std::array<std::string_view, 4> words{"minInclusive", "maxInclusive", "minExclusive",
                                                         "maxExclusive"};
  return is_one_of(facet, words);
}

bool is_length(std::string_view facet) {
  static constexpr std::array<std::string_view, 3> words{"length", "minLength", "maxLength"};
  return is_one_of(facet, words);
}

bool is_number_or_float(DataFamily family) {
  return family == DataFamily::number || family == DataFamily::double_ || family == DataFamily::float_;
}

/// Whether the pair of a facet and a value is in the facet space of a datatype.
bool has_facet(std::string_view datatype, DataFamily family, std::string_view facet, const DataValue& value) {
  static const Datatype count = Datatype::find(std::string(xsd_namespace) + "nonNegativeInteger").value();
  switch (family) {
    case DataFamily::number:
    case DataFamily::double_:
    case DataFamily::float_:
    case DataFamily::time:
      return is_bound(facet) && value.family == family;
    case DataFamily::text:
      if (facet.starts_with(rdf_namespace) && facet.substr(rdf_namespace.size()) == "langRange")
        return datatype.starts_with(rdf_namespace) && value.family == DataFamily::text;
      [[fallthrough]];
    case DataFamily::uri:
      if (facet.starts_with(xsd_namespace) && facet.substr(xsd_namespace.size()) == "pattern")
        return value.family == DataFamily::text;
      [[fallthrough]];
    case DataFamily::hex:
    case DataFamily::base64:
      return is_length(facet) && value.is_in(count);
    case DataFamily::boolean:
    case DataFamily::xml:
      return false;
  }
  return false;
}

}  // namespace

std::optional<DataValue> value_of(const Ontology& source, const Term& literal) {
  const std::string_view language =
      literal.arguments.size() > 1 ? source.name_of(literal.arguments[1]) : std::string_view();
  bool is_ill_formed = false;
  return DataValue::read(source.name(literal.name), source.name_of(literal.arguments[0]), language, is_ill_formed);
}

bool has_its_facets(const Ontology& source, std::span<const TermId> restriction) {
  const std::string_view datatype = source.name_of(restriction[0]);
  const auto type = Datatype::find(datatype);
  if (!type) return datatype != rdfs_literal;
  return std::ranges::all_of(restriction.subspan(1), [&](TermId id) {
    const Term facet = source.term(id);
    const auto value = value_of(source, source.term(facet.arguments[0]));
    return !value || has_facet(datatype, type->family(), source.name(facet.name), *value);
  });
}

std::optional<std::vector<TermId>> with_numeric_bounds(Ontology& source, std::span<const TermId> restriction) {
  const std::string datatype(source.name_of(restriction[0]));
  const auto type = Datatype::find(datatype);
  if (!type || !is_number_or_float(type->family())) return std::nullopt;
  std::vector<TermId> read{restriction[0]};
  bool is_other = false;
  for (const TermId id : restriction.subspan(1)) {
    const Term facet = source.term(id);
    const std::string iri(source.name(facet.name));
    const TermId bound = facet.arguments[0];
    const auto value = value_of(source, source.term(bound));
    const bool is_own = value ? has_facet(datatype, type->family(), iri, *value) : source.is_well_typed(bound);
    const TermId meant = is_own ? bound : source.literal(std::string(source.name_of(bound)), datatype);
    if (!is_bound(iri) || !source.is_well_typed(meant)) return std::nullopt;
    read.push_back(is_own ? id : source.facet(iri, meant));
    is_other = is_other || !is_own;
  }
  return is_other ? std::optional(std::move(read)) : std::nullopt;
}

bool is_decimal_instead(std::string_view lexical, std::string_view datatype_iri) {
  const auto type = Datatype::find(datatype_iri);
  if (!type || type->family() != DataFamily::number) return false;
  bool is_ill_formed = false;
  if (DataValue::read(lexical, datatype_iri, {}, is_ill_formed) || !is_ill_formed) return false;
  const auto number = DataValue::read(lexical, xsd_decimal, {}, is_ill_formed);
  return number && number->is_in(*type);
}

}  // namespace geminga::owl
