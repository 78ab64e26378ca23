// The part of an ontology that matters for some names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Extract : public testing::Test {
 protected:
  Extract() {
    program_.write(
        "a.ofn",
        "Prefix(:=<http://e/>)\nPrefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>)\nOntology(<http://e/o>\n"
        "Declaration(Class(:A)) Declaration(Class(:Far))\n"
        "SubClassOf(Annotation(Annotation(rdfs:label \"deep\") rdfs:comment \"why\") :A ObjectSomeValuesFrom(:p :B))\n"
        "SubClassOf(ObjectSomeValuesFrom(:p :B) :C)\nSubClassOf(:C :Above)\nSubClassOf(:Below :A)\n"
        "SubClassOf(:Far :Off)\nAnnotationAssertion(rdfs:label :A \"an A\")\n"
        "AnnotationAssertion(rdfs:label :Far \"far\")\n)\n");
  }
  const Program program_;
};

TEST_F(Extract, KeepsWhatFollowsBetweenTheNamesWithDeclarationsAndAnnotations) {
  for (const std::string out : {"m.ofn", "m.omn", "m.owx", "m.ttl", "m.owl", "m.nt"}) {
    ASSERT_EQ(program_.run({"extract", "a.ofn", ":A", ":C", "-o", out}).status, 0);
    EXPECT_EQ(program_.run({"classify", "--closure", out}).out, "http://e/A\thttp://e/C\n") << out;
    const Outcome text = program_.run({"convert", out, "-o", "-", "--to", "functional"});
    EXPECT_THAT(text.out, AllOf(HasSubstr("\"an A\""), HasSubstr("\"why\""), HasSubstr("\"deep\""))) << out;
    EXPECT_THAT(text.out, AllOf(Not(HasSubstr("Far")), Not(HasSubstr("Below")), Not(HasSubstr("Above")))) << out;
    EXPECT_THAT(program_.run({"check", out}).out, HasSubstr("Complete")) << "each property has a declaration";
  }
}

TEST_F(Extract, GoesUpOrDownWhereThatIsWanted) {
  ASSERT_EQ(program_.run({"extract", "a.ofn", ":A", "--kind", "bottom", "-o", "up.ofn"}).status, 0);
  EXPECT_EQ(program_.run({"classify", "--closure", "up.ofn"}).out,
            "http://e/A\thttp://e/Above\nhttp://e/A\thttp://e/C\nhttp://e/C\thttp://e/Above\n");
  ASSERT_EQ(program_.run({"extract", "a.ofn", "--name", ":A", "--kind", "top", "-o", "down.ofn"}).status, 0);
  EXPECT_EQ(program_.run({"classify", "--closure", "down.ofn"}).out, "http://e/Below\thttp://e/A\n");
}

TEST_F(Extract, TakesNamesFromAFile) {
  program_.write("names.txt", "# the names\n\n :A \r\n<http://e/C>\n");
  ASSERT_EQ(program_.run({"extract", "a.ofn", "--names", "names.txt", "-o", "m.ofn"}).status, 0);
  EXPECT_EQ(program_.run({"classify", "--closure", "m.ofn"}).out, "http://e/A\thttp://e/C\n");
}

TEST_F(Extract, SaysEachNameThatItDoesNotKnow) {
  const Outcome outcome = program_.run({"extract", "a.ofn", ":A", ":Nix", "nowhere", "-o", "m.ofn"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(":Nix is no class"), HasSubstr("nowhere is no class")));
  const Outcome mistyped = program_.run({"extract", "a.ofn", ":A", "nowhere.ttl", "-o", "m.ofn"});
  EXPECT_EQ(mistyped.status, 2);
  EXPECT_THAT(mistyped.err, HasSubstr("nowhere.ttl: cannot be opened"));
  EXPECT_FALSE(std::filesystem::exists(program_.folder() / "m.ofn"));
  EXPECT_EQ(program_.run({"extract", "a.ofn", "-o", "m.ofn"}).status, 2);
  EXPECT_EQ(program_.run({"extract", ":A", "-o", "m.ofn"}).status, 2);
  EXPECT_EQ(program_.run({"extract", "a.ofn", ":A", "-o", "a.ofn"}).status, 2) << "its own source";
  EXPECT_EQ(program_.run({"extract", "a.ofn", ":A", "--names", "nowhere.txt", "-o", "m.ofn"}).status, 2);
}

}  // namespace
}  // namespace geminga::ontology
