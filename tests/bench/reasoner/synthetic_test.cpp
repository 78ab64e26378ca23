// The generator of large ontologies: its sizes, and the same ontology in both syntaxes and every time.
#include "bench/reasoner/synthetic.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::bench {
namespace {

/// The text of a writer.
std::string written(void (*write)(const Synthetic&, std::FILE*), const Synthetic& ontology) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* file = ::open_memstream(&text, &size);
  write(ontology, file);
  std::fclose(file);
  std::string copy(text, size);
  std::free(text);
  return copy;
}

owl::Ontology read(const std::string& functional) {
  owl::Ontology source;
  const auto document = functional::read(functional, source.add_file("synthetic.ofn"), source);
  EXPECT_TRUE(document) << document.error().text;
  EXPECT_TRUE(source.omissions().empty());
  return source;
}

TEST(SyntheticOntology, SaysTheSameInBothSyntaxes) {
  const Synthetic made = make_synthetic(400, 7);
  const owl::Ontology functional = read(written(write_functional, made));
  const auto path = std::filesystem::temp_directory_path() / ("synthetic-" + std::to_string(::getpid()) + ".rdf");
  std::FILE* file = std::fopen(path.c_str(), "w");
  write_rdf_xml(made, file);
  std::fclose(file);
  const auto rdf = rdf::load(std::vector{path.string()});
  std::filesystem::remove(path);
  ASSERT_TRUE(rdf) << syntax::to_string(rdf.error());
  EXPECT_EQ(owl::digest(functional), owl::digest(rdf->source));
  const auto classification = el::classify(functional);
  ASSERT_TRUE(classification);
  EXPECT_EQ(classification->class_count(), 402U);  // with owl:Thing and owl:Nothing
  EXPECT_EQ(classification->counts.axioms, axiom_count(made));
  EXPECT_TRUE(classification->unused.empty());
}

TEST(SyntheticOntology, IsMadeBySizeAndSeedAlone) {
  const std::string one = written(write_functional, make_synthetic(300, 1));
  EXPECT_EQ(one, written(write_functional, make_synthetic(300, 1)));
  EXPECT_NE(one, written(write_functional, make_synthetic(300, 2)));
}

TEST(SyntheticOntology, HasAboutTwoAxiomsAClass) {
  const Synthetic made = make_synthetic(20'000, 1);
  EXPECT_EQ(made.classes.size(), 20'000U);
  EXPECT_NEAR(static_cast<double>(axiom_count(made)) / 20'000, 722.0 / 350, 0.1);
}

}  // namespace
}  // namespace geminga::bench
