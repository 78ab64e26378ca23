// The W3C's OWL 2 test cases as published in one RDF/XML file: what each asks, and the documents that it asks about.
#ifndef GEMINGA_TESTS_OWL2_PUBLISHED_CASES_HPP
#define GEMINGA_TESTS_OWL2_PUBLISHED_CASES_HPP

#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::owl2 {

/// A document in one or both of the syntaxes in which it was published; empty where it was not.
struct Document {
  std::string rdf_xml;
  std::string functional;
};

struct ImportedDocument {
  std::string iri;
  std::string rdf_xml;
};

/// One test case. Which of the four questions it asks follows from its types.
struct PublishedCase {
  std::string identifier;
  bool is_consistent = false;    ///< a ConsistencyTest
  bool is_inconsistent = false;  ///< an InconsistencyTest
  bool is_dl = false;            ///< of the species DL
  Document premise;
  Document conclusion;      ///< entailed
  Document non_conclusion;  ///< not entailed
  std::vector<ImportedDocument> imports;
};

/// The approved cases with the direct semantics, in the order of the file. The error is one line.
/// https://www.w3.org/TR/owl2-test/ section 3 describes the format.
[[nodiscard]] std::expected<std::vector<PublishedCase>, std::string> read_published_cases(
    const std::filesystem::path& all_rdf);

/// all.rdf below $GEMINGA_TEST_DATA or ../shared/data; nothing where neither has it.
[[nodiscard]] std::optional<std::filesystem::path> find_published_cases();

}  // namespace geminga::owl2

#endif
