// Hostile files: each is refused with its line, and costs little.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/rdf/reading.hpp"

namespace geminga::rdf {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string label(std::string_view text) {
  return "<rdf:Description rdf:about=\"http://e/A\"><rdfs:label>" + std::string(text) +
         "</rdfs:label></rdf:Description>\n";
}

TEST(Hostile, EntitiesThatExpandWithoutEndAreRefused) {
  std::string doctype = "<!DOCTYPE rdf:RDF [\n<!ENTITY a \"" + times(100, "x") + "\">\n";
  for (char name = 'b'; name <= 'i'; ++name) {
    const std::string reference = std::string("&") + static_cast<char>(name - 1) + ';';
    doctype += std::string("<!ENTITY ") + name + " \"" + times(20, reference) + "\">\n";
  }
  EXPECT_THAT(refusal("bomb.owl", xml(label("&i;"), doctype + "]>\n")), HasSubstr("expands to more than 65536 bytes"));
  const std::size_t text = doctype.find(times(100, "x"));
  doctype.replace(text, 100, times(100, "&#252;"));
  EXPECT_THAT(refusal("coded.owl", xml(label("&i;"), doctype + "]>\n")), HasSubstr("expands to more than 65536 bytes"));
}

TEST(Hostile, OneLargeEntityCannotBeRepeatedWithoutEnd) {
  const std::string doctype = "<!DOCTYPE rdf:RDF [\n<!ENTITY a \"" + times(60'000, "x") + "\">\n]>\n";
  EXPECT_THAT(refusal("flat.owl", xml(times(2000, label("&a;")), doctype)),
              HasSubstr("expands its entities to more than"));
  EXPECT_THAT(refusal("attributes.owl", xml(times(2000, "<rdf:Description rdf:about=\"http://e/&a;\"/>\n"), doctype)),
              StartsWith("attributes.owl:"));
}

TEST(Hostile, AnEntityThatContainsItselfIsRefused) {
  const std::string doctype = "<!DOCTYPE rdf:RDF [\n<!ENTITY a \"&b;\">\n<!ENTITY b \"&a;\">\n]>\n";
  EXPECT_EQ(refusal("circle.owl", xml(label("&a;"), doctype)),
            "circle.owl:3: declares the entity a by itself, or too deep");
}

TEST(Hostile, ParameterEntitiesAndOtherDeclarationsAreRefused) {
  EXPECT_EQ(refusal("declared.owl", xml("", "<!DOCTYPE rdf:RDF [\n\n<!ENTITY % p \"x\">\n]>\n")),
            "declared.owl:4: declares a parameter entity, which is never expanded: remove it");
  EXPECT_EQ(refusal("used.owl", xml("", "<!DOCTYPE rdf:RDF [\n%p;\n]>\n")),
            "used.owl:3: uses a parameter entity that it does not declare");
  EXPECT_EQ(refusal("attlist.owl", xml("", "<!DOCTYPE rdf:RDF [\n<!ATTLIST e:A e:b CDATA \"x\">\n]>\n")),
            "attlist.owl:3: declares a default value of an attribute in its DOCTYPE: write it where it belongs");
  EXPECT_EQ(refusal("other.owl", xml("", "<!DOCTYPE rdf:RDF [\n<!OTHER>\n]>\n")),
            "other.owl:3: declares something in its DOCTYPE that XML does not have");
  EXPECT_EQ(refusal("bare.owl", xml("", "<!DOCTYPE rdf:RDF [\n<!ENTITY a b>\n]>\n")),
            "bare.owl:3: declares an entity without a value");
  EXPECT_THAT(refusal("markup.owl", xml("", "<!DOCTYPE rdf:RDF [\n<!ENTITY a \"<e:A/>\">\n]>\n")),
              HasSubstr("markup.owl:3: declares an entity that holds markup"));
  for (const std::string reference :
       {"&#60;e:A/>", "&#x3c;e:A/>", "&#x03C;e:A/>", "&#38;a;", "&#x26;#60;", "x&#0;", "&#xD800;", "&#x110000;",
        "&#99999999999999999999;", "&#;", "&#x;", "&#+65;", "&#-1;", "&#X41;", "&#252", "&#11;", "&#xFFFE;"}) {
    EXPECT_THAT(refusal("coded.owl", xml("", "<!DOCTYPE rdf:RDF [\n<!ENTITY a \"" + reference + "\">\n]>\n")),
                HasSubstr("coded.owl:3: declares an entity that holds markup"))
        << reference;
  }
}

TEST(Hostile, DeepNestingIsRefusedBeforeRedlandSeesIt) {
  EXPECT_EQ(refusal("deep.owl", xml(times(100'000, "<e:A><e:p>"))), "deep.owl:3: nests elements more than 512 deep");
  const std::string head(turtle_prefixes);
  EXPECT_EQ(refusal("deep.ttl", head + ":a :p " + times(200'000, "[ :p ")),
            "deep.ttl:2: nests brackets more than 512 deep");
  EXPECT_EQ(refusal("lists.ttl", head + ":a :p " + times(200'000, "( ")),
            "lists.ttl:2: nests brackets more than 512 deep");
}

TEST(Hostile, NulBytesAreRefusedInEverySyntaxAndSpelling) {
  using std::string_literals::operator""s;
  EXPECT_EQ(refusal("nul.ttl", "\n\n<http://a> <http://b> <http://c\0d> .\n"s), "nul.ttl:3: holds a NUL byte");
  EXPECT_EQ(refusal("nul.nt", "<http://a> <http://b> \"c\0d\" .\n"s), "nul.nt:1: holds a NUL byte");
  EXPECT_EQ(refusal("nul.owl", xml("\n<e:A rdf:about=\"http://e/A\0B\"/>"s)), "nul.owl:4: holds a NUL byte");
  EXPECT_EQ(refusal("escaped.ttl", "<http://a> <http://b> \"c\\u0000d\" .\n"),
            "escaped.ttl:1: writes a NUL as \\u0000");
  EXPECT_EQ(refusal("escaped.nt", "<http://a> <http://b> <http://c\\U00000000d> .\n"),
            "escaped.nt:1: writes a NUL as \\U00000000");
  EXPECT_THAT(refusal("reference.owl", xml(label("c&#0;d"))), StartsWith("reference.owl:3: "));
  EXPECT_EQ(refusal("surrogate.ttl", "<http://a> <http://b> \"\\uD800\" .\n"),
            "surrogate.ttl:1: writes no character as \\uD800");
}

TEST(Hostile, BadUtf8FailsTheWholeFile) {
  const std::string words = "holds bytes that are no UTF-8: save it as UTF-8";
  EXPECT_EQ(refusal("bad.ttl", "\n<http://a> <http://b> \"\xff\" .\n"), "bad.ttl:2: " + words);
  EXPECT_EQ(refusal("overlong.nt", "<http://a> <http://b> \"\xc0\xaf\" .\n"), "overlong.nt:1: " + words);
  EXPECT_EQ(refusal("cut.ttl", "<http://a> <http://b> \"\xe2\x82"), "cut.ttl:1: " + words);
  EXPECT_EQ(refusal("bad.owl", xml("\n\n<!-- \xa4 -->")), "bad.owl:5: " + words);
  EXPECT_EQ(refusal("sixteen.owl", "\xff\xfe<"), "sixteen.owl: is in UTF-16 and ends within a character");
  EXPECT_EQ(refusal("seven.owl", "<?xml version=\"1.0\" encoding=\"UTF-7\"?>\n"),
            "seven.owl:1: is in an encoding that is not read: convert it to UTF-8");
}

TEST(Hostile, HugeTextsAreRefusedBeforeRedlandSeesThem) {
  const std::string huge = times(2'000'000, "x");
  EXPECT_EQ(refusal("text.nt", "<http://a> <http://b> \"" + huge + "\" .\n"),
            "text.nt:1: has a literal of more than 1048576 bytes");
  EXPECT_EQ(refusal("text.owl", xml(label(huge))), "text.owl:3: has a text of more than 1048576 bytes");
  EXPECT_EQ(refusal("iri.ttl", "<http://" + huge + "> a <http://b> .\n"),
            "iri.ttl:1: has an IRI of more than 8192 bytes");
  EXPECT_EQ(
      refusal("markup.owl", xml("<e:A><e:p rdf:parseType='Literal'>" + times(200'000, "<b>x</b>") + "</e:p></e:A>")),
      "markup.owl:3: has a text of more than 1048576 bytes");
}

TEST(Hostile, CommentsThatMakeLibxml2SlowAreRefused) {
  EXPECT_EQ(refusal("dashes.owl", xml("<!--" + times(1'000'000, "-"))),
            "dashes.owl:3: has -- inside a comment, which XML forbids");
  EXPECT_EQ(refusal("open.owl", xml("<!-- " + times(1'000'000, "x"))), "open.owl:3: has a comment without end");
}

TEST(Hostile, WhatIsCutOffIsRefusedAsAWhole) {
  EXPECT_THAT(refusal("cut.ttl", std::string(turtle_prefixes) + ":a a :B .\n:c a"), StartsWith("cut.ttl:3: "));
  const std::string whole = xml("<e:A rdf:about=\"http://e/a\">\n<e:p>x</e:p>\n</e:A>\n");
  for (std::size_t end = 0; end + 2 < whole.size(); ++end)
    EXPECT_THAT(refusal("cut.owl", whole.substr(0, end)), StartsWith("cut.owl:")) << "cut at " << end;
  EXPECT_EQ(refusal("whole.owl", whole), "accepted");
  EXPECT_THAT(refusal("tag.owl", xml("<e:A>\n<e:p>\n</e:A>\n")), StartsWith("tag.owl:5: "));
  EXPECT_THAT(refusal("bad.nt", "<http://a> <http://b> <http://c> .\n<http://a> <http://b> nonsense .\n"),
              StartsWith("bad.nt:2: "));
}

TEST(Hostile, IrisThatCannotBeWrittenBetweenAngleBracketsAreRefused) {
  EXPECT_THAT(refusal("angle.owl", xml("<e:A rdf:about=\"http://e/a&gt;&lt;http://e/b\"/>\n")),
              HasSubstr("has an IRI with a control character or an angle bracket in it"));
}

TEST(Hostile, ListsThatShareTheirTailsCostNoMoreThanTheFile) {
  std::string triples;
  for (int i = 0; i < 5000; ++i) {
    const std::string node = "_:l" + std::to_string(i);
    triples += node + " <http://www.w3.org/1999/02/22-rdf-syntax-ns#first> <http://e/A> .\n" + node +
               " <http://www.w3.org/1999/02/22-rdf-syntax-ns#rest> _:l" + std::to_string(i + 1) + " .\n<http://e/B" +
               std::to_string(i) + "> <http://www.w3.org/2002/07/owl#unionOf> _:l0 .\n";
  }
  const auto loaded = load_text("shared.nt", triples);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(loaded->source.axiom_count(), 0U);
  ASSERT_EQ(loaded->source.omissions().size(), 1U);
  EXPECT_EQ(loaded->source.omissions()[0].count, 5000U);
}

TEST(Hostile, OneSubjectOfAllTriplesCostsNoMoreThanTheFile) {
  // A careless mapping would look at all triples of a subject once for each of them.
  constexpr int count = 20'000;
  const std::string owl = "<http://www.w3.org/2002/07/owl#";
  const std::string type = " <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> ";
  const std::string sub_class = " <http://www.w3.org/2000/01/rdf-schema#subClassOf> ";
  std::string triples;
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    triples += "_:r " + owl + "onProperty> <http://e/p" + n + "> .\n";
    triples += "<http://e/R> " + owl + "onProperty> <http://e/p" + n + "> .\n";
    triples += "<http://e/p" + n + "> <http://www.w3.org/2000/01/rdf-schema#range> _:r .\n";
    triples +=
        "<http://e/A>" + sub_class + "_:c" + n + " .\n_:c" + n + ' ' + owl + "complementOf> <http://e/B" + n + "> .\n";
    triples += "_:x" + n + type + owl + "Axiom> .\n_:x" + n + ' ' + owl + "annotatedSource> <http://e/A> .\n_:x" + n +
               ' ' + owl + "annotatedProperty>" + sub_class + ".\n_:x" + n + ' ' + owl + "annotatedTarget> _:y" + n +
               " .\n_:y" + n + ' ' + owl + "complementOf> <http://e/B" + std::to_string(i + 1) + "> .\n";
    triples += "_:i" + type + "<http://e/T" + n + "> .\n<http://e/q" + n + "> " + owl + "inverseOf> _:i .\n";
    triples += "_:j " + owl + "inverseOf> _:k" + n + " .\n<http://e/q" + n + "> " + owl + "inverseOf> _:j .\n";
    triples += "<http://e/z> " + owl + "new" + n + "> <http://e/z> .\n";
  }
  triples += "_:i " + owl + "inverseOf> <http://e/p> .\n";
  const auto loaded = load_text("star.nt", triples);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  std::vector<std::string> constructs;
  for (const auto& omission : loaded->source.omissions())
    constructs.emplace_back(loaded->source.name(omission.construct));
  EXPECT_THAT(constructs, testing::IsSupersetOf({"an owl:Restriction with several constraints",
                                                 "an owl:Axiom whose own triple is missing", "owl:new0",
                                                 "other names that OWL 2 does not have"}));
  EXPECT_EQ(constructs.size(), 251U);
}

TEST(Hostile, ExpressionsNestedByBlankNodesDoNotExhaustTheStack) {
  std::string triples = "<http://e/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> _:l0 .\n";
  for (int i = 0; i < 100'000; ++i)
    triples += "_:l" + std::to_string(i) + " <http://www.w3.org/2002/07/owl#complementOf> _:l" + std::to_string(i + 1) +
               " .\n";
  const auto loaded = load_text("chain.nt", triples);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_FALSE(loaded->source.omissions().empty());
  EXPECT_EQ(loaded->source.name(loaded->source.omissions()[0].construct), "a class expression nested too deep");
}

}  // namespace
}  // namespace geminga::rdf
