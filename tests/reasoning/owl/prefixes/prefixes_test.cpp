// Short names: by the prefixes of files, and by those that are found for other namespaces.
#include "reasoning/owl/prefixes/prefixes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace geminga::owl {
namespace {

/// Names two classes of a namespace, the fewest that get a prefix.
void add_two(Ontology& source, const std::string& space) {
  source.named_class(space + "One");
  source.named_class(space + "Two");
}

TEST(Prefixes, OfTheFilesComeFirst) {
  Ontology source;
  source.add_file("a.owl", "http://x/pizza.owl");
  add_two(source, "http://x/pizza.owl#");
  source.add_prefix("p", "http://x/pizza.owl#");
  const Prefixes prefixes(source);
  EXPECT_EQ(prefixes.short_name("http://x/pizza.owl#One"), "p:One");
  EXPECT_EQ(prefixes.short_name("http://www.w3.org/2002/07/owl#Thing"), "owl:Thing");
  EXPECT_EQ(prefixes.short_name("http://y/One"), "<http://y/One>");
}

TEST(Prefixes, TheOntologyIriIsTheEmptyOneWhereNoFileSaysOtherwise) {
  for (const std::string end : {"#", "/"}) {
    Ontology source;
    source.add_file("a.owl", "http://x/pizza.owl");
    add_two(source, "http://x/pizza.owl" + end);
    EXPECT_EQ(Prefixes(source).short_name("http://x/pizza.owl" + end + "Margherita"), ":Margherita");
  }
  Ontology whole;
  whole.add_file("a.owl", "http://x/pizza#");
  add_two(whole, "http://x/pizza#");
  EXPECT_EQ(Prefixes(whole).short_name("http://x/pizza#Margherita"), ":Margherita");
}

TEST(Prefixes, TheEmptyOneOfAFileKeepsItsMeaning) {
  Ontology source;
  source.add_file("a.owl", "http://x/pizza.owl");
  source.add_prefix("", "http://elsewhere/#");
  add_two(source, "http://x/pizza.owl#");
  EXPECT_EQ(Prefixes(source).short_name("http://x/pizza.owl#Margherita"), "pizza:Margherita");
}

TEST(Prefixes, OfSeveralOntologiesAreWordsOfTheirNamespaces) {
  Ontology source;
  source.add_file("a.owl", "http://x/one.owl");
  source.add_file("b.owl", "http://x/two");
  add_two(source, "http://x/one.owl#");
  add_two(source, "http://x/two/");
  const Prefixes prefixes(source);
  EXPECT_EQ(prefixes.short_name("http://x/one.owl#A"), "one:A");
  EXPECT_EQ(prefixes.short_name("http://x/two/A"), "two:A");
}

TEST(Prefixes, AWordThatIsTakenGetsANumberAndTheFullerNamespaceChoosesFirst) {
  Ontology source;
  source.add_prefix("soma", "http://declared/");
  add_two(source, "http://b/soma#");
  add_two(source, "http://a/soma#");
  source.named_class("http://a/soma#Three");
  const Prefixes prefixes(source);
  EXPECT_EQ(prefixes.short_name("http://declared/A"), "soma:A");
  EXPECT_EQ(prefixes.short_name("http://a/soma#A"), "soma2:A");
  EXPECT_EQ(prefixes.short_name("http://b/soma#A"), "soma3:A");
  std::set<std::string> words;
  for (const auto& [word, iri] : prefixes.all()) EXPECT_TRUE(words.insert(word).second) << word;
}

TEST(Prefixes, DoNotDependOnTheOrderOfNames) {
  const std::vector<std::string> spaces = {"http://a/x#", "http://b/x#", "http://c/y/"};
  Ontology forwards;
  for (const std::string& space : spaces) add_two(forwards, space);
  Ontology backwards;
  for (auto space = spaces.rbegin(); space != spaces.rend(); ++space) add_two(backwards, *space);
  EXPECT_EQ(Prefixes(forwards).all(), Prefixes(backwards).all());
}

TEST(Prefixes, ANamespaceNeedsTwoNames) {
  Ontology source;
  for (std::size_t number = 1; number < min_names_of_prefix; ++number)
    source.named_class("http://x/y#N" + std::to_string(number));
  EXPECT_EQ(Prefixes(source).short_name("http://x/y#N1"), "<http://x/y#N1>");
  source.individual("http://x/y#Last");
  EXPECT_EQ(Prefixes(source).short_name("http://x/y#N1"), "y:N1");
}

TEST(Prefixes, AreFoundForSoManyNamespacesOnly) {
  for (const std::size_t count : {max_found_prefixes - 1, max_found_prefixes, max_found_prefixes + 1}) {
    Ontology source;
    for (std::size_t number = 0; number < count; ++number) add_two(source, "http://x/n" + std::to_string(number) + "#");
    constexpr std::size_t usual = 4;
    EXPECT_EQ(Prefixes(source).all().size(), usual + std::min(count, max_found_prefixes));
  }
}

TEST(Prefixes, AnAwkwardNameIsWrittenInFull) {
  Ontology source;
  add_two(source, "http://x/y#");
  EXPECT_EQ(Prefixes(source).short_name("http://x/y#a(b)"), "<http://x/y#a(b)>");
  EXPECT_EQ(Prefixes(source).short_name("http://x/y#"), "<http://x/y#>");
}

TEST(Prefixes, AWordIsTheLastPieceThatCanBeOne) {
  EXPECT_EQ(word_of_namespace("http://www.co-ode.org/ontologies/pizza/2005/05/16/pizza.owl#"), "pizza");
  EXPECT_EQ(word_of_namespace("http://www.ifomis.org/bfo/1.1#"), "bfo");
  EXPECT_EQ(word_of_namespace("http://www.w3.org/ns/sosa/"), "sosa");
  EXPECT_EQ(word_of_namespace("http://www.example.org/"), "example");
  EXPECT_EQ(word_of_namespace("https://e#"), "e");
  EXPECT_EQ(word_of_namespace("http://123.45/#"), "ns");
  EXPECT_EQ(word_of_namespace("#"), "ns");
  EXPECT_EQ(word_of_namespace(""), "ns");
}

TEST(Prefixes, NoWordIsTheSchemeOfAnIri) {
  Ontology source;
  add_two(source, "http://x/http#");
  EXPECT_EQ(Prefixes(source).short_name("http://x/http#A"), "http2:A");
}

}  // namespace
}  // namespace geminga::owl
