// A value as a literal.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_WRITTEN_VALUE_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_WRITTEN_VALUE_HPP

#include <optional>
#include <string>

#include "reasoning/dl/hypertableau/values/value.hpp"

namespace geminga::hypertableau {

/// The parts of a literal.
struct WrittenValue {
  std::string lexical;
  std::string datatype;  ///< an IRI; empty for a text with a language
  std::string language;
};

/// A literal with this value: xsd:integer, xsd:decimal or owl:rational for numbers, xsd:string for texts. Nothing for
/// times and the contents of hexBinary, base64Binary, anyURI and XMLLiteral.
[[nodiscard]] std::optional<WrittenValue> written(const Value& value);

/// The number of a value of xsd:double or xsd:float, by its rank. NaN is in a layer of its own.
[[nodiscard]] double float_of(const Value& value);

}  // namespace geminga::hypertableau

#endif
