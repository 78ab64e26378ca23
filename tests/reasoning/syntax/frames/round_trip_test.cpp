// Random ontologies of every kind of axiom, written in Manchester syntax by a writer of its own, are read as they were.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reasoning/syntax/frames/reading.hpp"
#include "reasoning/syntax/frames/writer.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "support/random_ontology.hpp"
#include "support/rounds.hpp"

namespace geminga::frames {
namespace {

/// In any order, without what is declared by being the subject of a frame.
std::vector<std::string> sorted_axioms(const owl::Ontology& source) {
  std::vector<std::string> lines = rdf::functional(source);
  std::ranges::sort(lines);
  return lines;
}

TEST(RoundTrip, GivesTheAxiomsThatWereWritten) {
  for (const compare::Profile profile : compare::profiles) {
    for (std::uint64_t seed = 1; seed <= test::rounds(60U); ++seed) {
      const owl::Ontology source = compare::random_ontology(profile, seed, 40);
      const Reading reading(manchester(source));
      ASSERT_EQ(reading.error, "") << compare::to_string(profile) << ' ' << seed << '\n' << manchester(source);
      ASSERT_EQ(sorted_axioms(reading.source), sorted_axioms(source))
          << compare::to_string(profile) << ' ' << seed << '\n'
          << manchester(source);
    }
  }
}

}  // namespace
}  // namespace geminga::frames
