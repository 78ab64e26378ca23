// A document in disguise says what the plain one says, whatever its base, encoding and leftovers are.
#include "compare/disguises.hpp"

#include <gtest/gtest.h>

#include "compare/shapes.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/syntax/owlxml/read.hpp"
#include "reasoning/syntax/rdf/reading.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::compare {
namespace {

std::uint64_t digest_of_owl_xml(const std::string& text) {
  owl::Ontology source;
  const auto read = owlxml::read(text, source.add_file("t.owx"), source);
  EXPECT_TRUE(read) << (read ? "" : to_string(read.error())) << '\n' << text;
  return owl::digest(source);
}

std::uint64_t digest_of_rdf_xml(const std::string& text) {
  const auto loaded = rdf::load_text("t.rdf", text);
  EXPECT_TRUE(loaded) << (loaded ? "" : to_string(loaded.error())) << '\n' << text;
  return loaded ? owl::digest(loaded->source) : 0;
}

TEST(Disguises, OfOwlXmlAndRdfXmlSayTheSame) {
  for (std::uint64_t seed = 1; seed <= test::rounds(40U); ++seed) {
    const Profile profile = profiles[seed % std::size(profiles)];
    for (const owl::Ontology& source : {random_ontology(profile, seed, 20), qualified_numbers(seed)}) {
      const Disguised xml = in_owl_xml(source, seed, Disguise::all);
      ASSERT_EQ(digest_of_owl_xml(xml.document), digest_of_owl_xml(xml.plain)) << "seed " << seed << '\n'
                                                                               << xml.plain << '\n'
                                                                               << xml.document;
      const Disguised triples = in_rdf_xml(source, seed, Disguise::all);
      ASSERT_EQ(digest_of_rdf_xml(triples.document), digest_of_rdf_xml(triples.plain)) << "seed " << seed << '\n'
                                                                                       << triples.plain << '\n'
                                                                                       << triples.document;
    }
  }
}

}  // namespace
}  // namespace geminga::compare
