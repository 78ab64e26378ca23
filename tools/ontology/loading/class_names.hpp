// Classes by the names that users write.
#ifndef GEMINGA_ONTOLOGY_LOADING_CLASS_NAMES_HPP
#define GEMINGA_ONTOLOGY_LOADING_CLASS_NAMES_HPP

#include <expected>
#include <optional>
#include <string>

#include "reasoning/compiled/ontology.hpp"

namespace geminga::ontology {

/// Finds a class by its name, or by the end of its IRI (behind the last `#` or `/`) where one class alone has that end.
/// The error says what is wrong, with the candidates or with similar names.
[[nodiscard]] std::expected<taxonomy::ClassNumber, std::string> find_class(const compiled::Ontology& ontology,
                                                                           const std::string& name);
/// Finds a class; nothing after saying what is wrong.
[[nodiscard]] std::optional<taxonomy::ClassNumber> find_or_say(const compiled::Ontology& ontology,
                                                               const std::string& name, bool as_json = false);

}  // namespace geminga::ontology

#endif
