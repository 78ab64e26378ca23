// Ontologies that others published in both syntaxes must give the same axioms from both.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/functional/reading.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::functional {
namespace {

namespace fs = std::filesystem;
using Axioms = std::set<std::string>;

/// A path in the data that nobody here wrote, or an empty one where this checkout has none.
fs::path published(const std::string& path) {
  const char* named = std::getenv("GEMINGA_TEST_DATA");
  for (const fs::path& root :
       {fs::path(named == nullptr ? "" : named), fs::path(GEMINGA_SOURCE_DIR) / "../shared/data"}) {
    if (!root.empty() && fs::exists(root / path)) return root / path;
  }
  return {};
}

std::string content_of(const fs::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

Axioms axioms_of(const owl::Ontology& source, bool with_declarations) {
  const std::vector<std::string> lines = rdf::functional(source, with_declarations);
  return {lines.begin(), lines.end()};
}

/// The members of one set that the other lacks, one a line.
std::string missing(const Axioms& wanted, const Axioms& found) {
  std::string lines;
  for (const std::string& axiom : wanted) {
    if (!found.contains(axiom)) lines += axiom + '\n';
  }
  return lines;
}

TEST(Published, SomaHasTheSameAxiomsInBothSyntaxes) {
  const fs::path folder = published("ontologies/soma");
  if (folder.empty()) GTEST_SKIP() << "no ontologies/soma in $GEMINGA_TEST_DATA or ../shared/data";
  owl::Ontology source;
  std::vector<std::string> others;
  std::size_t imports = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".owl") continue;
    const std::string content = content_of(entry.path());
    if (syntax::detect_syntax(entry.path().string(), content) != syntax::Syntax::functional) {
      others.push_back(entry.path().string());
      continue;
    }
    const auto document = read(content, source.add_file(entry.path().filename().string()), source);
    ASSERT_TRUE(document) << to_string(document.error());
    EXPECT_TRUE(document->ontology_iri.starts_with("http://www.")) << document->ontology_iri;
    imports += document->imports.size();
  }
  EXPECT_EQ(source.files().size(), 15U);
  EXPECT_EQ(imports, 37U);
  EXPECT_TRUE(source.omissions().empty());
  EXPECT_GT(source.labels().size(), 500U);
  // USD is a part of SOMA that is published in RDF/XML.
  ASSERT_EQ(others.size(), 1U);
  const auto usd = rdf::load(others);
  ASSERT_TRUE(usd) << to_string(usd.error());
  Axioms published_axioms = axioms_of(source, true);
  published_axioms.merge(axioms_of(usd->source, true));

  const auto merged = rdf::load(std::vector{(folder / "all-modules-merged.rdf").string()});
  ASSERT_TRUE(merged) << to_string(merged.error());
  const Axioms merged_axioms = axioms_of(merged->source, true);
  EXPECT_GT(merged_axioms.size(), 3500U);
  EXPECT_EQ(missing(merged_axioms, published_axioms), "");
  EXPECT_EQ(missing(published_axioms, merged_axioms), "");
}

/// The ontologies of the W3C's test cases, by test case and property ("fsPremiseOntology").
std::map<std::string, std::map<std::string, std::string>> test_cases(const fs::path& file) {
  const rdf::Scratch scratch;
  std::string declarations = "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n";
  for (const char* syntax : {"fs", "rdfXml"}) {
    for (const char* part : {"Premise", "Conclusion", "NonConclusion"})
      declarations += std::string("<http://www.w3.org/2007/OWL/testOntology#") + syntax + part +
                      "Ontology> a owl:DatatypeProperty .\n";
  }
  const auto loaded = rdf::load(std::vector{file.string(), scratch.write("properties.ttl", declarations)});
  std::map<std::string, std::map<std::string, std::string>> cases;
  if (!loaded) return cases;
  const owl::Ontology& source = loaded->source;
  for (std::size_t number = 0; number < source.axiom_count(); ++number) {
    const owl::Axiom axiom = source.axiom(number);
    if (axiom.kind != owl::AxiomKind::data_property_assertion) continue;
    const std::string_view property = source.name_of(axiom.arguments[0]);
    const std::string_view name = source.name_of(axiom.arguments[1]);
    cases[std::string(name.substr(name.rfind('/') + 1))][std::string(property.substr(property.rfind('#') + 1))] =
        source.name_of(axiom.arguments[2]);
  }
  return cases;
}

TEST(Published, TestCasesOfTheW3cHaveTheSameAxiomsInBothSyntaxes) {
  const fs::path file = published("owl2-testcases/all.rdf");
  if (file.empty()) GTEST_SKIP() << "no owl2-testcases/all.rdf in $GEMINGA_TEST_DATA or ../shared/data";
  // Where the two texts of one test case differ themselves.
  const std::map<std::string, std::string> different = {
      {"New-2DFeature-2DKeys-2D007", "the RDF lacks SubClassOf(:Man :Person)"},
      {"New-2DFeature-2DObjectPropertyChain-2D001", "the RDF does not declare :hasAunt in the conclusion"},
      {"New-2DFeature-2DObjectQCR-2D001", "Chris and Stewie stand in the other order"},
      {"New-2DFeature-2DRational-2D002", "an rdf:List ends in rdf: and not in rdf:nil"},
      {"New-2DFeature-2DRational-2D003", "an rdf:List ends in rdf: and not in rdf:nil"},
  };
  const rdf::Scratch scratch;
  std::size_t count = 0;
  std::size_t compared = 0;
  for (const auto& [name, texts] : test_cases(file)) {
    for (const std::string part : {"PremiseOntology", "ConclusionOntology", "NonConclusionOntology"}) {
      const auto text = texts.find("fs" + part);
      if (text == texts.end()) continue;
      ++count;
      const Reading reading(text->second);
      EXPECT_EQ(reading.error, "") << name;
      EXPECT_EQ(syntax::detect_syntax("case.owl", text->second), syntax::Syntax::functional) << name;
      EXPECT_TRUE(reading.source.omissions().empty()) << name;
      const auto rdf_text = texts.find("rdfXml" + part);
      if (rdf_text == texts.end() || different.contains(name)) continue;
      ++compared;
      const auto loaded = rdf::load(std::vector{scratch.write("case.rdf", rdf_text->second)});
      ASSERT_TRUE(loaded) << name << ": " << to_string(loaded.error());
      EXPECT_EQ(axioms_of(reading.source, false), axioms_of(loaded->source, false)) << name << ' ' << part;
    }
  }
  EXPECT_EQ(count, 62U);
  EXPECT_EQ(compared, 38U);
}

}  // namespace
}  // namespace geminga::functional
