// The published household ontology: its unsatisfiable classes are explained by minimal sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/explanation/proof.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::explanation {
namespace {

namespace fs = std::filesystem;

/// A path in the published data, or an empty one if this checkout has none.
fs::path published(const std::string& path) {
  const char* named = std::getenv("GEMINGA_TEST_DATA");
  for (const fs::path& root :
       {fs::path(named == nullptr ? "" : named), fs::path(GEMINGA_SOURCE_DIR) / "../shared/data"}) {
    if (!root.empty() && fs::exists(root / path)) return root / path;
  }
  std::cout << "There is no " << path << " in $GEMINGA_TEST_DATA or ../shared/data: nothing is explained.\n";
  return {};
}

/// The merged file is RDF/XML, which one reader reads.
std::optional<rdf::Loaded> load_soma() {
  const fs::path file = published("ontologies/soma/all-modules-merged.rdf");
  if (file.empty()) return std::nullopt;
  auto loaded = rdf::load(std::vector{file.string()});
  EXPECT_TRUE(loaded) << (loaded ? "" : syntax::to_string(loaded.error()));
  if (!loaded) return std::nullopt;
  return std::move(*loaded);
}

TEST(Published, SomaHasEightUnsatisfiableClassesAndEachIsExplainedMinimally) {
  const auto loaded = load_soma();
  if (!loaded) return;
  const auto classified = reasoner::classify(loaded->source);
  ASSERT_TRUE(classified) << classified.error().text;
  const auto ontology = compiled::Ontology::from_bytes(compiled::compile(loaded->source, *classified));
  ASSERT_TRUE(ontology) << ontology.error().text;
  const taxonomy::ClassNumber nothing = *ontology->find_iri(owl::owl_nothing);
  int explained = 0;
  for (std::uint32_t number = 0; number < ontology->class_count(); ++number) {
    const taxonomy::ClassNumber sub{number};
    if (sub == nothing || ontology->is_satisfiable(sub)) continue;
    SCOPED_TRACE(ontology->iri(sub));
    Explainer explainer(*ontology, sub, nothing);
    const auto found = explainer.find_one();
    ASSERT_TRUE(found);
    // The judge is the whole reasoner, and not the oracle of the search.
    const owl::Ontology& source = explainer.module().source();
    EXPECT_EQ(reasoner::entails(source, *found, explainer.sub(), explainer.super()).verdict, reasoner::Verdict::yes);
    for (const std::uint32_t axiom : *found) {
      AxiomSet fewer = *found;
      std::erase(fewer, axiom);
      EXPECT_EQ(reasoner::entails(source, fewer, explainer.sub(), explainer.super()).verdict, reasoner::Verdict::no)
          << explainer.module().explained(axiom).text;
    }
    const Proof proof = prove(explainer, *found);
    EXPECT_EQ(proof.axioms.size(), found->size());
    EXPECT_FALSE(proof.steps.empty());
    ++explained;
  }
  EXPECT_EQ(explained, 8);
}

}  // namespace
}  // namespace geminga::explanation
