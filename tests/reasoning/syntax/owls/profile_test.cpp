// OWL-S descriptions as collections have them, from the tidy to the careless.
#include "reasoning/syntax/owls/profile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "scratch.hpp"

namespace geminga::owls {
namespace {

using rdf::Scratch;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string document(const std::string& body, const std::string& owls = "http://www.daml.org/services/owl-s/1.1/") {
  return "<?xml version=\"1.0\" encoding=\"WINDOWS-1252\"?>\n<rdf:RDF xmlns:owl=\"http://www.w3.org/2002/07/owl#\"\n "
         "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" xmlns:service=\"" +
         owls + "Service.owl#\" xmlns:process=\"" + owls + "Process.owl#\" xmlns:profile=\"" + owls +
         "Profile.owl#\"\n xml:base=\"http://127.0.0.1/services/1.1/book_price_service.owls\">\n"
         "<owl:Ontology rdf:about=\"\"><owl:imports "
         "rdf:resource=\"http://127.0.0.1/ontology/books.owl\"/></owl:Ontology>\n" +
         body + "</rdf:RDF>\n";
}

std::string parameter(const std::string& kind, const std::string& name, const std::string& type) {
  return "<process:" + kind + " rdf:ID=\"" + name +
         "\"><process:parameterType rdf:datatype=\"http://www.w3.org/2001/XMLSchema#anyURI\">" + type +
         "</process:parameterType></process:" + kind + ">\n";
}

const std::string& tidy() {
  static const std::string body =
      "<service:Service rdf:ID=\"S\"><service:presents rdf:resource=\"#P\"/></service:Service>\n"
      "<profile:Profile rdf:ID=\"P\"><profile:serviceName xml:lang=\"en\">Caf\xe9</profile:serviceName>"
      "<profile:hasInput rdf:resource=\"#_BOOK\"/><profile:hasOutput rdf:resource=\"#_PRICE\"/></profile:Profile>\n"
      "<process:AtomicProcess rdf:ID=\"A\"><process:hasInput rdf:resource=\"#_BOOK\"/><process:hasOutput "
      "rdf:resource=\"#_PRICE\"/></process:AtomicProcess>\n" +
      parameter("Input", "_BOOK", "http://127.0.0.1/ontology/books.owl#Book") +
      parameter("Output", "_PRICE", "\n http://127.0.0.1/ontology/concept.owl#Price \n");
  return body;
}

std::expected<Document, syntax::LoadError> read(const std::string& content) {
  const Scratch scratch;
  return read_profiles(scratch.write("service.owls", content));
}

TEST(Profile, NamesTheTypesOfItsParameters) {
  const auto found = read(document(tidy()));
  ASSERT_TRUE(found) << found.error().text;
  ASSERT_EQ(found->profiles.size(), 1U);
  EXPECT_EQ(found->profiles[0].iri, "http://127.0.0.1/services/1.1/book_price_service.owls#P");
  EXPECT_THAT(found->profiles[0].inputs, ElementsAre("http://127.0.0.1/ontology/books.owl#Book"));
  EXPECT_THAT(found->profiles[0].outputs, ElementsAre("http://127.0.0.1/ontology/concept.owl#Price"));
  EXPECT_THAT(found->imports, ElementsAre("http://127.0.0.1/ontology/books.owl"));
  EXPECT_FALSE(found->broken_off);
}

TEST(Profile, IsTheSameWhereverOwlsIsPublished) {
  for (const char* place :
       {"http://www.daml.org/services/owl-s/1.2/", "http://localhost:8888/owl_s/1.0/", "file:///"}) {
    const auto found = read(document(tidy(), place));
    ASSERT_TRUE(found && found->profiles.size() == 1) << place;
    EXPECT_THAT(found->profiles[0].inputs, ElementsAre("http://127.0.0.1/ontology/books.owl#Book")) << place;
  }
}

TEST(Profile, MayHoldItsParametersInside) {
  const auto found = read(document(
      "<profile:Profile rdf:ID=\"P\"><profile:hasInput>" + parameter("Input", "_A", "http://o#A") +
      "</profile:hasInput><profile:hasInput><process:Input><process:parameterType rdf:resource=\"http://o#A\"/>"
      "</process:Input></profile:hasInput><profile:hasOutput rdf:resource=\"http://o#B\"/><profile:hasParameter>" +
      parameter("Output", "_C", "#C") + "</profile:hasParameter></profile:Profile>"));
  ASSERT_TRUE(found && found->profiles.size() == 1);
  EXPECT_THAT(found->profiles[0].inputs, ElementsAre("http://o#A", "http://o#A"));
  EXPECT_THAT(found->profiles[0].outputs,
              testing::UnorderedElementsAre("http://o#B", "http://127.0.0.1/services/1.1/book_price_service.owls#C"));
}

TEST(Profile, MayLackInputsOutputsAndTypes) {
  const auto found =
      read(document("<profile:Profile rdf:ID=\"P\"><profile:hasOutput "
                    "rdf:resource=\"#_X\"/></profile:Profile><process:Output rdf:ID=\"_X\"/>"));
  ASSERT_TRUE(found && found->profiles.size() == 1);
  EXPECT_THAT(found->profiles[0].inputs, IsEmpty());
  EXPECT_THAT(found->profiles[0].outputs, ElementsAre(""));
}

TEST(Profile, FindsParametersThatAreNamedByAnotherUrlOfTheFile) {
  const auto found =
      read(document("<profile:Profile rdf:ID=\"P\"><profile:hasInput rdf:resource=\"http://elsewhere/s.owls#_A\"/>"
                    "<profile:hasInput rdf:resource=\"#_FORGOTTEN\"/></profile:Profile>" +
                    parameter("Input", "_A", "http://o#A")));
  ASSERT_TRUE(found && found->profiles.size() == 1);
  EXPECT_THAT(found->profiles[0].inputs, testing::UnorderedElementsAre("http://o#A", ""));
}

TEST(Profile, IsReadFromTheProcessWhereThereIsNoneOrABareOne) {
  const std::string process =
      "<process:AtomicProcess rdf:ID=\"A\"><process:hasInput rdf:resource=\"#_A\"/></process:AtomicProcess>" +
      parameter("Input", "_A", "http://o#A");
  for (const std::string& body : {process, process + "<profile:Profile rdf:ID=\"P\"/>"}) {
    const auto found = read(document(body));
    ASSERT_TRUE(found && found->profiles.size() == 1);
    EXPECT_THAT(found->profiles[0].inputs, ElementsAre("http://o#A"));
  }
}

TEST(Profile, IsNoneInAnOntology) {
  const auto found = read(document("<owl:Class rdf:ID=\"Profile\"/><owl:ObjectProperty rdf:ID=\"hasInput\"/>"));
  ASSERT_TRUE(found);
  EXPECT_THAT(found->profiles, IsEmpty());
}

TEST(Profile, CountsAsFarAsItsFileCanBeRead) {
  const auto found = read(document(tidy() + "<broken>"));
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->broken_off);
  EXPECT_THAT(found->broken_off->file, HasSubstr("service.owls"));
  ASSERT_EQ(found->profiles.size(), 1U);
  EXPECT_THAT(found->profiles[0].outputs, ElementsAre("http://127.0.0.1/ontology/concept.owl#Price"));
}

TEST(Profile, HasAsManyParametersAsThereMayBe) {
  for (const std::size_t count : {max_parameters - 1, max_parameters, max_parameters + 1}) {
    std::string body = "<profile:Profile rdf:ID=\"P\">";
    for (std::size_t at = 0; at < count; ++at)
      body += "<profile:hasInput rdf:resource=\"http://o#A" + std::to_string(at) + "\"/>";
    const auto found = read(document(body + "</profile:Profile>"));
    EXPECT_EQ(found.has_value(), count <= max_parameters) << count;
    EXPECT_EQ(found ? found->profiles[0].inputs.size() : 0, count <= max_parameters ? count : 0);
  }
}

}  // namespace
}  // namespace geminga::owls
