// One thread walks over a file and another builds: what comes of it is what comes of one thread.
#include <gtest/gtest.h>

#include "reasoning/syntax/owlxml/events.hpp"
#include "reasoning/syntax/owlxml/reading.hpp"

namespace geminga::owlxml {
namespace {

/// Everything that reading says.
std::vector<std::string> all_of(const Reading& reading) {
  std::vector<std::string> lines{reading.error};
  const auto add = [&](const std::vector<std::string>& more) { lines.insert(lines.end(), more.begin(), more.end()); };
  if (reading.error.empty()) add(reading.axioms());
  add(reading.remarks());
  add(reading.labels());
  return lines;
}

void expect_same(std::string_view text, XmlLimits limits = {}) {
  const Reading one(text, limits);
  limits.apart_bytes = 0;
  const Reading two(text, limits, 2);
  EXPECT_EQ(all_of(one), all_of(two)) << text.substr(0, 1000);
}

/// A class of this number, its axioms and its label.
std::string described(std::size_t number) {
  const std::string iri = "<Class IRI='#" + std::to_string(number) + "'/>";
  return "<Declaration>" + iri + "</Declaration>\n<SubClassOf>" + iri +
         "<ObjectSomeValuesFrom><ObjectProperty IRI='#p'/>" + "<Class IRI='#" + std::to_string(number / 2) +
         "'/></ObjectSomeValuesFrom></SubClassOf>\n" +
         "<AnnotationAssertion><AnnotationProperty abbreviatedIRI='rdfs:label'/><IRI>#" + std::to_string(number) +
         "</IRI>\n<Literal xml:lang='en'>class &lt;" + std::to_string(number) +
         "&gt;</Literal></AnnotationAssertion>\n";
}

TEST(Apart, AFileIsReadAsByOneThread) {
  std::string lines;
  for (std::size_t number = 0; number < 3000; ++number) lines += described(number);
  lines += "<AnnotationAssertion><AnnotationProperty abbreviatedIRI='rdfs:label'/><IRI>#long</IRI><Literal>" +
           std::string(200'000, 'x') + "</Literal></AnnotationAssertion>";
  expect_same(ontology(lines));
  EXPECT_EQ(Reading(ontology(lines)).error, "");
}

TEST(Apart, FaultsHaveTheLinesThatOneThreadGivesThem) {
  const std::string whole = ontology(described(1) + "<SubClassOf/>\nstray\n<Nonsense x='y'/>" + described(2));
  expect_same(whole);
  for (std::size_t end = 0; end < whole.size(); end += 7) expect_same(whole.substr(0, end));
  XmlLimits limits;
  limits.literal_bytes = 8;
  expect_same(whole, limits);
  limits = {};
  limits.operands = 1;
  expect_same(whole, limits);
  limits = {};
  limits.nesting = 3;
  expect_same(whole, limits);
}

TEST(Apart, AFileThatIsRefusedEarlyIsWalkedNoFurther) {
  std::string lines = "<Prefix name='a' IRI='http://e/'/>\n<Prefix name='b' IRI='http://e/'/>\n";
  for (std::size_t number = 0; number < 20'000; ++number) lines += described(number);
  XmlLimits limits;
  limits.prefixes = 1;
  expect_same(ontology(lines), limits);
}

}  // namespace
}  // namespace geminga::owlxml
