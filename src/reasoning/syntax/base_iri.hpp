// The base of the relative IRIs of a file.
#ifndef GEMINGA_REASONING_SYNTAX_BASE_IRI_HPP
#define GEMINGA_REASONING_SYNTAX_BASE_IRI_HPP

#include <string>

namespace geminga::syntax {

/// `file:///NAME`, where NAME is the file's name without its folder and without .gz. It is the same on every host.
[[nodiscard]] std::string base_iri(const std::string& path);

}  // namespace geminga::syntax

#endif
