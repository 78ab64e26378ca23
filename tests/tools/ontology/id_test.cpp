// The vectors of src/identity/IDENTITY.md, as the program prints them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::HasSubstr;

TEST(Id, OfIrisNeedsNoOntology) {
  const Program program;
  for (const char* name : {"http://example.org/a", "<http://example.org/a>"}) {
    const Outcome outcome = program.run({"id", name});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "2331597606\n");
  }
  EXPECT_EQ(program.run({"id", "http://example.org/a", "<http://example.org/b>"}).out, "926581932\n");
}

TEST(Id, JsonShowsTheCanonicalForm) {
  const Outcome outcome = Program().run({"id", "--json", "http://example.org/a", "http://example.org/b"});
  const boost::json::value found = boost::json::parse(outcome.out);
  EXPECT_EQ(found.at("id"), 926581932);
  EXPECT_EQ(found.at("hex"), "0x373a84ac");
  EXPECT_EQ(found.at("canonical"), "<http://example.org/a><http://example.org/b>");
}

TEST(Id, ResolvesPrefixesInTheShippedOntologiesAndInThoseNamed) {
  const Program program;
  const Outcome shipped_name = program.run({"id", "soccer:BallInfo", "--json"});
  EXPECT_EQ(shipped_name.status, 0) << shipped_name.err;
  EXPECT_THAT(shipped_name.out, HasSubstr("<https://geminga.example/soccer#BallInfo>"));
  program.write("a.ttl",
                "@prefix x: <http://example.org/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . x:a a owl:Class .");
  EXPECT_EQ(program.run({"id", "x:a", "--ontology", "a.ttl"}).out, "2331597606\n");
  EXPECT_EQ(program.run({"id", "--ontology", "a.ttl", "--", "x:a"}).out, "2331597606\n");
}

TEST(Id, RefusesWhatIsNoName) {
  const Program program;
  for (const char* name :
       {"", "<>", "<http://a b>", "http://a<b", "http://a\xff", "http://a\nb", "nope:A", "soccer:NoSuchThing"}) {
    const Outcome outcome = program.run({"id", name});
    EXPECT_EQ(outcome.status, 2) << name;
    EXPECT_EQ(outcome.out, "") << name;
  }
}

}  // namespace
}  // namespace geminga::ontology
