// Class expressions written so that parse() reads them again.
#ifndef GEMINGA_MANCHESTER_PRINT_HPP
#define GEMINGA_MANCHESTER_PRINT_HPP

#include <functional>
#include <string>
#include <string_view>

#include "el/source.hpp"

namespace geminga::manchester {

/// How an IRI is written: `soccer:BallInfo` or `<https://...>`.
using ShortName = std::function<std::string(std::string_view iri)>;

/// "soccer:Camera and (core:observes some soccer:Ball)". The term is a class expression or data range; its depth is
/// that of terms.
[[nodiscard]] std::string print(const el::OntologySource& source, el::TermId term, const ShortName& short_name);

/// The canonical form (MANCHESTER.md): full IRIs, the members of `and`, `or` and braces sorted and each once. Equal for
/// expressions that differ in nothing else.
[[nodiscard]] std::string canonical(const el::OntologySource& source, el::TermId term);

}  // namespace geminga::manchester

#endif
