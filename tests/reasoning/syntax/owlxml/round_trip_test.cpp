// Random ontologies of every kind of axiom, written as OWL/XML by a writer of its own, are read as they were.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/owlxml/reading.hpp"
#include "reasoning/syntax/owlxml/writer.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::owlxml {
namespace {

TEST(RoundTrip, GivesTheAxiomsThatWereWrittenInTheirOrder) {
  for (const compare::Profile profile : compare::profiles) {
    for (std::uint64_t seed = 1; seed <= test::rounds(60U); ++seed) {
      const owl::Ontology source = compare::random_ontology(profile, seed, 40);
      const Reading reading(owl_xml(source));
      ASSERT_EQ(reading.error, "") << compare::to_string(profile) << ' ' << seed << '\n' << owl_xml(source);
      ASSERT_EQ(rdf::functional(reading.source), rdf::functional(source))
          << compare::to_string(profile) << ' ' << seed << '\n'
          << owl_xml(source);
    }
  }
}

}  // namespace
}  // namespace geminga::owlxml
