// A second, slow reasoner that shares only the axioms with the first: the rules of EL over sets of terms, applied
// everywhere until nothing changes.
#ifndef GEMINGA_TESTS_SUPPORT_REFERENCE_HPP
#define GEMINGA_TESTS_SUPPORT_REFERENCE_HPP

#include <string>
#include <vector>

#include "base/random.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// The closure, as closure() of written.hpp. Without individuals, data and constructs beyond EL.
std::vector<std::string> reference_closure(const Ontology& source);

/// Whether a range of a property does not hold for the last property of a chain below it. The naive reasoner does not
/// know what follows from that.
bool has_range_over_chain(const Ontology& source);

/// A random ontology in the syntax of written.hpp. `size` is about the number of axioms.
std::string random_ontology(base::Random& random, std::size_t size);

}  // namespace geminga::owl

#endif
