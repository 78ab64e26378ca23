// Class expressions that users write on the command line.
#ifndef GEMINGA_ONTOLOGY_LOADING_CLASS_EXPRESSIONS_HPP
#define GEMINGA_ONTOLOGY_LOADING_CLASS_EXPRESSIONS_HPP

#include <optional>
#include <string>
#include <string_view>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/owl/names.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/manchester/parse.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::ontology {

/// Reads a class expression in Manchester syntax, of which the name of a class is the simplest; nothing after saying
/// what is wrong. The names are those of the ontology.
[[nodiscard]] std::optional<manchester::Expression> read_expression_or_say(const compiled::Ontology& ontology,
                                                                           const owl::Names& names,
                                                                           const std::string& text, bool as_json);

/// The class that an expression is; nothing where it is more than a name.
[[nodiscard]] std::optional<taxonomy::ClassNumber> class_of(const compiled::Ontology& ontology,
                                                            const manchester::Expression& expression);

/// Adds a class that is equivalent to an expression of the source, with this name or one that begins with it. Returns
/// its IRI, which nothing else has.
std::string define_class(owl::Ontology& source, std::string_view name, owl::TermId expression, owl::FileId file);

/// The expression with short names.
[[nodiscard]] std::string words_of(const compiled::Ontology& ontology, const manchester::Expression& expression);

}  // namespace geminga::ontology

#endif
