// Loads a text as if it were a file of its own.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_RDF_READING_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_RDF_READING_HPP

#include <string>
#include <string_view>

#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::rdf {

/// The result of loading a file of this name and content.
[[nodiscard]] std::expected<Loaded, syntax::LoadError> load_text(const std::string& name, std::string_view content,
                                                                 const syntax::FileLimits& limits = {});
/// "NAME:LINE: text" of why it was refused, or "accepted". The path is cut to its last part.
[[nodiscard]] std::string refusal(const std::string& name, std::string_view content,
                                  const syntax::FileLimits& limits = {});

/// An RDF/XML document with this DOCTYPE and content; the content begins on line 3 where the DOCTYPE is empty.
[[nodiscard]] std::string xml(std::string_view content, std::string_view doctype = "");

/// A text, repeated.
[[nodiscard]] std::string times(std::size_t count, std::string_view text);

inline constexpr std::string_view turtle_prefixes =
    "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n";

}  // namespace geminga::rdf

#endif
