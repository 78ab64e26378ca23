#include "reasoning/syntax/functional/reading.hpp"

#include "reasoning/syntax/rdf/functional.hpp"

namespace geminga::functional {

std::vector<std::string> Reading::axioms() const { return rdf::functional_with_left_out(source); }

std::vector<std::string> Reading::labels() const { return rdf::labels(source); }

}  // namespace geminga::functional
