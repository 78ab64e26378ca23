// A variation is the same for the same seed, and says the same in both syntaxes that other reasoners read it in.
#include "compare/mutation.hpp"

#include <gtest/gtest.h>

#include <array>

#include "compare/functional_syntax.hpp"
#include "compare/shapes.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/syntax/functional/read.hpp"
#include "reasoning/syntax/owlxml/read.hpp"
#include "reasoning/syntax/owlxml/writer.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::compare {
namespace {

TEST(Mutation, IsTheSameForTheSameSeedAndInBothSyntaxes) {
  for (std::uint64_t seed = 1; seed <= test::rounds(40U); ++seed) {
    const owl::Ontology first = random_ontology(Profile::values, seed, 30);
    const owl::Ontology second = family(seed, 5);
    const std::array<const owl::Ontology*, 2> originals{&first, &second};
    const Mutation made = mutation(originals, seed);
    ASSERT_FALSE(made.source.problem()) << "seed " << seed;
    ASSERT_TRUE(made.source.omissions().empty())
        << "seed " << seed << ": " << made.words << ": " << made.source.name(made.source.omissions()[0].construct);
    const std::string document = functional_syntax(made.source);
    ASSERT_EQ(document, functional_syntax(mutation(originals, seed).source)) << "seed " << seed;
    owl::Ontology functional;
    ASSERT_TRUE(functional::read(document, functional.add_file("t.ofn"), functional)) << "seed " << seed;
    owl::Ontology xml;
    ASSERT_TRUE(owlxml::read(owlxml::owl_xml(made.source), xml.add_file("t.owx"), xml)) << "seed " << seed;
    ASSERT_EQ(owl::digest(functional), owl::digest(xml)) << "seed " << seed << '\n' << document;
  }
}

TEST(Mutation, DiffersFromItsOriginal) {
  const owl::Ontology original = qualified_numbers(1);
  const std::array<const owl::Ontology*, 1> originals{&original};
  for (std::uint64_t seed = 1; seed <= test::rounds(20U); ++seed)
    EXPECT_NE(owl::digest(mutation(originals, seed).source), owl::digest(original)) << "seed " << seed;
}

}  // namespace
}  // namespace geminga::compare
