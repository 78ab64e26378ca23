// Links between two ontologies: by names and neighbours, mended so that no class becomes unsatisfiable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/json.hpp>

#include "ontology/alignment/thesaurus.hpp"
#include "ontology/alignment/words.hpp"
#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(WordsOfNames, AreCutAtSignsCaseAndDigits) {
  EXPECT_THAT(words_of_name("Conference_paper"), ElementsAre("conference", "paper"));
  EXPECT_THAT(words_of_name("PDFFile2go"), ElementsAre("pdf", "file", "2", "go"));
  EXPECT_THAT(words_of_name("  --  "), IsEmpty());
  EXPECT_THAT(words_of_name("Größe"), ElementsAre("größe"));
}

TEST(WordsOfNames, HaveNoPlural) {
  EXPECT_THAT(words_of_name("bodies boxes classes sensors status analysis glass"),
              ElementsAre("body", "box", "class", "sensor", "status", "analysis", "glass"));
}

TEST(WordsOfNames, OfPropertiesHaveNoDirection) {
  EXPECT_THAT(words_of_property("hasPart"), ElementsAre("part"));
  EXPECT_THAT(words_of_property("isAuthorOf"), ElementsAre("author"));
  EXPECT_THAT(words_of_property("isOf"), ElementsAre("is", "of"));
}

TEST(WordsOfNames, OfClassesEndWithWhatTheyAre) {
  EXPECT_THAT(words_of_class("Head_of_Department"), ElementsAre("department", "head"));
  EXPECT_THAT(words_of_class("of"), ElementsAre("of"));
  EXPECT_THAT(words_of_class("ListOf"), ElementsAre("list", "of"));
}

TEST(WordsOfNames, OfPropertiesMayEndWithAPreposition) {
  EXPECT_EQ(preposition_of("isPartOf"), "of");
  EXPECT_EQ(preposition_of("hasPart"), "");
  EXPECT_EQ(preposition_of("of"), "");
}

TEST(Thesaurus, KnowsTheSensesOfWordsPhrasesAndFormsOfVerbs) {
  const Program program;
  program.write("index.noun",
                "  1 a licence\nlast_name n 1 2 @ ~ 1 0 06336904  \nsurname n 1 2 @ ~ 1 0 06336904  \n"
                "z n 6 1 @ 6 0 00000001 00000002 00000003 00000004 00000005 00000006  \n");
  program.write("index.verb", "keep v 1 1 @ 1 0 06336904  \nstore v 1 1 @ 1 0 00000007");
  const auto read = Thesaurus::read(program.folder() / "in");
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->senses_of("surname").size(), 1U);
  EXPECT_EQ(read->senses_of("surname")[0].number, read->senses_of("last_name")[0].number);
  EXPECT_NE(read->senses_of("keep")[0].number, read->senses_of("surname")[0].number) << "a verb is no noun";
  EXPECT_EQ(read->senses_of("stored").size(), 1U);
  EXPECT_EQ(read->senses_of("storing").size(), 1U);
  EXPECT_EQ(read->senses_of("z").size(), Thesaurus::most_senses);
  EXPECT_FALSE(read->senses_of("z").back().is_frequent);
  EXPECT_THAT(read->senses_of("last"), IsEmpty());
  EXPECT_THAT(read->senses_of(""), IsEmpty());
  EXPECT_FALSE(Thesaurus::read(program.folder() / "nowhere"));
}

TEST(LikenessOfWords, AllowsSlipsInLongWordsAlone) {
  EXPECT_EQ(likeness("ball", "ball"), 1);
  EXPECT_EQ(likeness("ball", "bell"), 0);
  EXPECT_GT(likeness("localisation", "localization"), 0.9);
  EXPECT_EQ(likeness("camera", "sensor"), 0);
}

class Align : public testing::Test {
 protected:
  Align() {
    program_.turtle(
        "a.ttl",
        ":Robot a owl:Class . :MobileRobot a owl:Class ; rdfs:subClassOf :Robot . :Laser_Scanner a owl:Class ; "
        "rdfs:subClassOf :Robot . :hasPart a owl:ObjectProperty ; rdfs:domain :Robot . :X1 a owl:Class ; "
        "rdfs:label \"thermal camera\" .");
    program_.write(
        "b.ttl",
        "@prefix : <http://f/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: "
        "<http://www.w3.org/2000/01/rdf-schema#> . :robots a owl:Class . :robot_mobile a owl:Class ; rdfs:subClassOf "
        ":robots . :LaserScanner a owl:Class . :part a owl:ObjectProperty ; rdfs:domain :robots . :Y a owl:Class ; "
        "rdfs:label \"Thermal Cameras\"@en . :Weather a owl:Class .");
  }
  const Program program_;
};

TEST_F(Align, FindsNamesInOtherFormsAndLabels) {
  const Outcome outcome = program_.run({"align", "a.ttl", "b.ttl"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "http://e/Laser_Scanner\t=\thttp://f/LaserScanner\t1.00\n"
            "http://e/MobileRobot\t=\thttp://f/robot_mobile\t1.00\n"
            "http://e/Robot\t=\thttp://f/robots\t1.00\n"
            "http://e/X1\t=\thttp://f/Y\t1.00\n"
            "http://e/hasPart\t=\thttp://f/part\t1.00\n");
  EXPECT_THAT(program_.run({"align", "a.ttl", "b.ttl", "--reasons"}).out,
              HasSubstr("http://f/Y\t1.00\tboth are named \"thermal camera\"\n"));
}

TEST_F(Align, WritesTheLinksAsAnOntology) {
  for (const std::string out : {"out.ttl", "out.ofn", "out.omn"}) {
    ASSERT_EQ(program_.run({"align", "a.ttl", "b.ttl", "-o", out}).status, 0);
    EXPECT_EQ(
        program_.run({"subsumes", out, "b.ttl", "--sub", "<http://e/MobileRobot>", "--super", "<http://f/robots>"})
            .status,
        0)
        << out;
    EXPECT_THAT(program_.run({"convert", out, "-o", "-", "--to", "functional"}).out,
                AllOf(HasSubstr("EquivalentObjectProperties("), Not(HasSubstr("SubClassOf"))))
        << out;
  }
}

TEST_F(Align, TakesOutTheWorstLinkThatMakesAClassUnsatisfiable) {
  program_.turtle("c.ttl", ":Sensor a owl:Class . :Camera rdfs:subClassOf :Sensor . :Camera a owl:Class .");
  program_.write("d.ttl",
                 "@prefix : <http://f/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: "
                 "<http://www.w3.org/2000/01/rdf-schema#> . :Sensors a owl:Class . :Camera a owl:Class . :Sensors "
                 "owl:disjointWith :Camera .");
  const Outcome outcome = program_.run({"align", "c.ttl", "d.ttl", "--json"});
  const boost::json::object found = boost::json::parse(outcome.out).as_object();
  EXPECT_EQ(found.at("links").as_array().size(), 1U);
  ASSERT_EQ(found.at("rejected").as_array().size(), 1U);
  EXPECT_THAT(std::string(found.at("rejected").at(0).at("because").as_string()), HasSubstr("can have no instance"));
  EXPECT_EQ(found.at("certain"), true);
  ASSERT_EQ(program_.run({"align", "c.ttl", "d.ttl", "-o", "out.ttl"}).status, 0);
  EXPECT_EQ(program_.run({"check", "c.ttl", "d.ttl", "out.ttl"}).out.find("no instance"), std::string::npos);
}

TEST_F(Align, DerivesNothingNewWithinOneOntologyWhereThatIsWanted) {
  program_.turtle("c.ttl", ":Sensor a owl:Class . :Camera a owl:Class .");
  program_.write(
      "d.ttl",
      "@prefix : <http://f/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: "
      "<http://www.w3.org/2000/01/rdf-schema#> . :Sensor a owl:Class . :Camera a owl:Class ; rdfs:subClassOf "
      ":Sensor .");
  EXPECT_EQ(boost::json::parse(program_.run({"align", "c.ttl", "d.ttl", "--json"}).out).at("links").as_array().size(),
            2U);
  const Outcome outcome = program_.run({"align", "c.ttl", "d.ttl", "--conservative"});
  EXPECT_THAT(outcome.err, HasSubstr("was taken out: with it e:Camera is subsumed by e:Sensor"));
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 1);
}

TEST_F(Align, LinksNarrowerAndBroaderClassesWhereTheyAreWanted) {
  program_.turtle("c.ttl", ":Scanner a owl:Class . :ThermalCamera a owl:Class .");
  program_.write(
      "d.ttl",
      "@prefix : <http://f/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: "
      "<http://www.w3.org/2000/01/rdf-schema#> . :Scanner a owl:Class . :LaserScanner a owl:Class . :Camera a "
      "owl:Class . :StereoCamera a owl:Class ; rdfs:subClassOf :Camera .");
  const Outcome outcome = program_.run({"align", "c.ttl", "d.ttl", "--subsumptions"});
  EXPECT_EQ(outcome.out,
            "http://e/Scanner\t=\thttp://f/Scanner\t1.00\n"
            "http://e/ThermalCamera\t=\thttp://f/Camera\t0.72\n"
            "http://e/Scanner\t>\thttp://f/LaserScanner\t0.60\n");
  ASSERT_EQ(program_.run({"align", "c.ttl", "d.ttl", "--subsumptions", "-o", "out.ttl"}).status, 0);
  EXPECT_EQ(program_
                .run({"subsumes", "out.ttl", "c.ttl", "d.ttl", "--sub", "<http://f/LaserScanner>", "--super",
                      "<http://e/Scanner>"})
                .status,
            0);
}

TEST_F(Align, KeepsPropertiesOfOtherDirectionsApart) {
  program_.turtle("c.ttl", ":hasPart a owl:ObjectProperty .");
  program_.write(
      "d.ttl",
      "@prefix : <http://f/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . :isPartOf a owl:ObjectProperty .");
  const Outcome outcome = program_.run({"align", "c.ttl", "d.ttl"});
  EXPECT_EQ(outcome.status, 1) << outcome.out;
}

TEST_F(Align, RefusesAFolderWithoutWordNetThatIsNamed) {
  const Outcome outcome = program_.run({"align", "a.ttl", "b.ttl", "--wordnet", "."});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("index.noun cannot be read"));
}

TEST_F(Align, EndsWithOneWhereNothingIsAlikeAndWithTwoWhereAFileIsBroken) {
  program_.turtle("c.ttl", ":Weather a owl:Class .");
  program_.turtle("d.ttl", ":Kick a owl:Class .");
  EXPECT_EQ(program_.run({"align", "c.ttl", "d.ttl"}).status, 1);
  EXPECT_EQ(program_.run({"align", "c.ttl", "c.ttl"}).status, 1) << "the same names need no link";
  EXPECT_EQ(program_.run({"align", "c.ttl", "nowhere.ttl"}).status, 2);
  EXPECT_EQ(program_.run({"align", "a.ttl", "b.ttl", "-o", "a.ttl"}).status, 2) << "its own source";
}

TEST_F(Align, LinksNothingThatBothOntologiesHave) {
  const std::string shared = ":Box a owl:Class . :Crate a owl:Class ; rdfs:label \"box\" . ";
  program_.turtle("one.ttl", shared + ":Parcel a owl:Class ; rdfs:label \"parcel\" .");
  program_.turtle("other.ttl", shared + ":Packet a owl:Class ; rdfs:label \"parcel\" .");
  const auto links = program_.run({"align", "one.ttl", "other.ttl"});
  EXPECT_EQ(links.status, 0) << links.err;
  EXPECT_THAT(links.out, AllOf(HasSubstr("http://e/Parcel\t=\thttp://e/Packet"), Not(HasSubstr("Crate"))));
}

}  // namespace
}  // namespace geminga::ontology
