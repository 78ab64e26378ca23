// Writes OWL-S services in the form of the public collections.
#ifndef GEMINGA_TESTS_TOOLS_ONTOLOGY_COLLECTION_HPP
#define GEMINGA_TESTS_TOOLS_ONTOLOGY_COLLECTION_HPP

#include <string>
#include <vector>

namespace geminga::ontology {

/// A profile whose parameters have these types, as the text of a file.
[[nodiscard]] std::string owls(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace geminga::ontology

#endif
