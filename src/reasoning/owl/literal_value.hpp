// The value of a literal of an ontology.
#ifndef GEMINGA_REASONING_OWL_LITERAL_VALUE_HPP
#define GEMINGA_REASONING_OWL_LITERAL_VALUE_HPP

#include <optional>

#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// Nothing if the datatype is not known. Every literal of an axiom is of its datatype (Ontology::literal()).
[[nodiscard]] std::optional<DataValue> value_of(const Ontology& source, const Term& literal);

}  // namespace geminga::owl

#endif
