// The catalogue that Protégé writes beside ontologies. It maps imports to files.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_CATALOG_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_CATALOG_HPP

#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/limits.hpp"

namespace geminga::rdf {

/// The name of a catalogue in a folder.
inline constexpr std::string_view catalog_name = "catalog-v001.xml";

/// One `<uri name="IRI" uri="FILE"/>` (OASIS XML Catalogs 1.1, section 6.5.6).
struct CatalogEntry {
  std::string iri;
  std::string file;  ///< as it is written: relative to the catalogue, or a file: URL
};

/// The entries of a catalogue in their order, at most `limits.files`. Other elements are ignored, and no file that it
/// names is opened.
[[nodiscard]] std::expected<std::vector<CatalogEntry>, syntax::LoadError> read_catalog(
    const std::string& path, std::string_view bytes, const syntax::FileLimits& limits);

}  // namespace geminga::rdf

#endif
