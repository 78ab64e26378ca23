#include "reasoning/owl/literal_value.hpp"

namespace geminga::owl {

std::optional<DataValue> value_of(const Ontology& source, const Term& literal) {
  const std::string_view language =
      literal.arguments.size() > 1 ? source.name_of(literal.arguments[1]) : std::string_view();
  bool is_ill_formed = false;
  return DataValue::read(source.name(literal.name), source.name_of(literal.arguments[0]), language, is_ill_formed);
}

}  // namespace geminga::owl
