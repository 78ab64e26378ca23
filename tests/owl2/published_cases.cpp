// Reads the file as XML: every case is one element, its documents are text in it.
#include "owl2/published_cases.hpp"

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace geminga::owl2 {
namespace {

constexpr std::string_view rdf = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
constexpr std::string_view test = "http://www.w3.org/2007/OWL/testOntology#";

struct FreeDocument {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};

std::string_view view(const xmlChar* text) {
  return text == nullptr ? std::string_view() : reinterpret_cast<const char*>(text);
}

bool is_element(const xmlNode* node, std::string_view space, std::string_view name) {
  return node->type == XML_ELEMENT_NODE && node->ns != nullptr && view(node->ns->href) == space &&
         view(node->name) == name;
}

std::string owned(xmlChar* text) {
  std::string copy(view(text));
  xmlFree(text);
  return copy;
}

std::string resource_of(const xmlNode* node) {
  return owned(xmlGetNsProp(node, reinterpret_cast<const xmlChar*>("resource"),
                            reinterpret_cast<const xmlChar*>(std::string(rdf).c_str())));
}

std::string text_of(const xmlNode* node) { return owned(xmlNodeGetContent(node)); }

/// Every child of that name, as the part of its rdf:resource behind the test vocabulary's name.
std::vector<std::string> words(const xmlNode* of, std::string_view space, std::string_view name) {
  std::vector<std::string> found;
  for (const xmlNode* child = of->children; child != nullptr; child = child->next) {
    if (!is_element(child, space, name)) continue;
    const std::string resource = resource_of(child);
    if (resource.starts_with(test)) found.push_back(resource.substr(test.size()));
  }
  return found;
}

/// The text of the child of that name; empty where there is none.
std::string text(const xmlNode* of, std::string_view name) {
  for (const xmlNode* child = of->children; child != nullptr; child = child->next) {
    if (is_element(child, test, name)) return text_of(child);
  }
  return {};
}

/// An imported ontology is described by an element of its own, which the case names by its IRI.
std::vector<ImportedDocument> imports_of(const xmlNode* one, const xmlNode* root) {
  std::vector<ImportedDocument> found;
  for (const xmlNode* child = one->children; child != nullptr; child = child->next) {
    if (!is_element(child, test, "importedOntology")) continue;
    const std::string about = resource_of(child);
    for (const xmlNode* other = root->children; other != nullptr; other = other->next) {
      if (other->type != XML_ELEMENT_NODE) continue;
      const std::string name = owned(xmlGetNsProp(other, reinterpret_cast<const xmlChar*>("about"),
                                                  reinterpret_cast<const xmlChar*>(std::string(rdf).c_str())));
      if (name != about || text(other, "rdfXmlInputOntology").empty()) continue;
      ImportedDocument document;
      for (const xmlNode* part = other->children; part != nullptr; part = part->next) {
        if (is_element(part, test, "importedOntologyIRI")) document.iri = resource_of(part);
      }
      document.rdf_xml = text(other, "rdfXmlInputOntology");
      found.push_back(std::move(document));
    }
  }
  return found;
}

bool has(const std::vector<std::string>& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

}  // namespace

std::expected<std::vector<PublishedCase>, std::string> read_published_cases(const std::filesystem::path& all_rdf) {
  // The file declares four short entities, and its largest text is below libxml2's limit of 10 MB.
  const std::unique_ptr<xmlDoc, FreeDocument> document(
      xmlReadFile(all_rdf.c_str(), nullptr, XML_PARSE_NOENT | XML_PARSE_NONET));
  const xmlNode* root = document == nullptr ? nullptr : xmlDocGetRootElement(document.get());
  if (root == nullptr) return std::unexpected(all_rdf.string() + " is no XML");
  std::vector<PublishedCase> cases;
  for (const xmlNode* node = root->children; node != nullptr; node = node->next) {
    if (!is_element(node, test, "TestCase")) continue;
    if (!has(words(node, test, "status"), "Approved") || !has(words(node, test, "semantics"), "DIRECT")) continue;
    const auto types = words(node, rdf, "type");
    PublishedCase one;
    one.identifier = text(node, "identifier");
    one.is_consistent = has(types, "ConsistencyTest");
    one.is_inconsistent = has(types, "InconsistencyTest");
    one.is_dl = has(words(node, test, "species"), "DL");
    one.premise = {text(node, "rdfXmlPremiseOntology"), text(node, "fsPremiseOntology")};
    if (has(types, "PositiveEntailmentTest"))
      one.conclusion = {text(node, "rdfXmlConclusionOntology"), text(node, "fsConclusionOntology")};
    if (has(types, "NegativeEntailmentTest"))
      one.non_conclusion = {text(node, "rdfXmlNonConclusionOntology"), text(node, "fsNonConclusionOntology")};
    one.imports = imports_of(node, root);
    cases.push_back(std::move(one));
  }
  if (cases.empty()) return std::unexpected(all_rdf.string() + " holds no approved case");
  return cases;
}

std::optional<std::filesystem::path> find_published_cases() {
  const char* named = std::getenv("GEMINGA_TEST_DATA");
  for (const std::filesystem::path& folder : {std::filesystem::path(named == nullptr ? "" : named),
                                              std::filesystem::path(GEMINGA_SOURCE_DIR) / ".." / "shared" / "data"}) {
    if (folder.empty()) continue;
    std::filesystem::path found = folder / "owl2-testcases" / "all.rdf";
    if (std::filesystem::exists(found)) return found;
  }
  return std::nullopt;
}

}  // namespace geminga::owl2
