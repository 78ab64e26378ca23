#include "functional/reading.hpp"

#include "rdf/functional.hpp"

namespace geminga::functional {

std::vector<std::string> Reading::axioms() const { return rdf::functional_with_left_out(source); }

std::vector<std::string> Reading::labels() const { return rdf::labels(source); }

}  // namespace geminga::functional
