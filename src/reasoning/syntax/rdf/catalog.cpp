// Walks through the elements with libxml2's reader, which the scan has made safe to use.
#include "reasoning/syntax/rdf/catalog.hpp"

#include <libxml/parser.h>
#include <libxml/xmlreader.h>

#include <limits>
#include <memory>

#include "base/text.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"

namespace geminga::rdf {
namespace {

std::string attribute(xmlTextReaderPtr reader, const char* name) {
  const std::unique_ptr<xmlChar, decltype(xmlFree)> value(
      xmlTextReaderGetAttribute(reader, reinterpret_cast<const xmlChar*>(name)), xmlFree);
  return value ? std::string(reinterpret_cast<const char*>(value.get())) : std::string();
}

bool is_uri_element(xmlTextReaderPtr reader) {
  if (xmlTextReaderNodeType(reader) != XML_READER_TYPE_ELEMENT) return false;
  const auto* name = reinterpret_cast<const char*>(xmlTextReaderConstLocalName(reader));
  return name != nullptr && std::string_view(name) == "uri";
}

}  // namespace

std::expected<std::vector<CatalogEntry>, syntax::LoadError> read_catalog(const std::string& path,
                                                                         std::string_view bytes,
                                                                         const syntax::FileLimits& limits) {
  const auto refuse = [&](std::uint32_t line, std::string text) {
    return std::unexpected(syntax::LoadError{base::printable(path, 4096), line, std::move(text)});
  };
  if (auto layout = scan_xml(bytes, limits); !layout)
    return refuse(layout.error().line, std::move(layout.error().text));
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return refuse(0, "is too large");
  const std::unique_ptr<xmlTextReader, decltype(&xmlFreeTextReader)> reader(
      xmlReaderForMemory(bytes.data(), static_cast<int>(bytes.size()), nullptr, nullptr,
                         XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING),
      xmlFreeTextReader);
  if (!reader) return refuse(0, "cannot be read: memory is short");
  std::vector<CatalogEntry> entries;
  int state = 1;
  while (entries.size() < limits.files && (state = xmlTextReaderRead(reader.get())) == 1) {
    if (!is_uri_element(reader.get())) continue;
    CatalogEntry entry{attribute(reader.get(), "name"), attribute(reader.get(), "uri")};
    if (!entry.iri.empty() && !entry.file.empty()) entries.push_back(std::move(entry));
  }
  if (state < 0) {
    const int line = xmlTextReaderGetParserLineNumber(reader.get());
    return refuse(line > 0 ? static_cast<std::uint32_t>(line) : 0, "is no well-formed XML");
  }
  return entries;
}

}  // namespace geminga::rdf
