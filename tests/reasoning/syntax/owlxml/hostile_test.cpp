// Entities that would open files or expand without end, depths, broken XML, and limits with one beyond.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reasoning/syntax/owlxml/reading.hpp"

namespace geminga::owlxml {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string times(std::size_t count, std::string_view text) {
  std::string all;
  for (std::size_t at = 0; at < count; ++at) all += text;
  return all;
}

std::string with_entities(std::string_view entities, std::string_view content) {
  return "<!DOCTYPE Ontology [\n" + std::string(entities) + "]>\n" + ontology(content);
}

TEST(Hostile, EntitiesOpenNothing) {
  for (const std::string_view entity :
       {"<!ENTITY x SYSTEM \"file:///etc/passwd\">", "<!ENTITY x PUBLIC \"x\" \"http://127.0.0.1/x\">",
        "<!ENTITY % x SYSTEM \"file:///etc/passwd\"> %x;"})
    EXPECT_THAT(Reading(with_entities(entity, "<Import>&x;</Import>")).error,
                HasSubstr("the entity x is not a plain internal one"))
        << entity;
  EXPECT_EQ(Reading("<!DOCTYPE Ontology SYSTEM \"file:///etc/passwd\">" + ontology("")).error, "")
      << "named, and never opened";
}

TEST(Hostile, EntitiesDoNotExpandWithoutEnd) {
  std::string laughs = "<!ENTITY a0 \"ha\">\n";
  for (int level = 1; level < 20; ++level)
    laughs +=
        "<!ENTITY a" + std::to_string(level) + " \"" + times(10, "&a" + std::to_string(level - 1) + ";") + "\">\n";
  EXPECT_EQ(Reading(with_entities(laughs, "<Import>&a19;</Import>")).error,
            "t.owx:7: the entity a5 has more than 65536 bytes");
  EXPECT_EQ(Reading(with_entities("<!ENTITY a \"b?c=d&amp;e\"><!ENTITY b \"http://&a;\">\n", "<Import>&b;</Import>"))
                .document.imports.at(0)
                .iri,
            "http://b?c=d&e");
  EXPECT_EQ(
      Reading(with_entities("<!ENTITY a \"&#252;&#xFC;&#37;20\"><!ENTITY b \"http://&a;\">\n", "<Import>&b;</Import>"))
          .document.imports.at(0)
          .iri,
      "http://üü%20");
  for (const std::string value : {"<Class/>", "&#60;Class/>", "&#x3C;Class/>", "&#38;#60;Class/>", "&lt;Class/>"})
    EXPECT_THAT(Reading(with_entities("<!ENTITY a \"" + value + "\">\n", "&a;")).error, HasSubstr("has markup in it"))
        << value;
  XmlLimits limits;
  limits.entity_bytes = 5;
  EXPECT_EQ(Reading(with_entities("<!ENTITY a \"abcde\">\n", ""), limits).error, "");
  EXPECT_THAT(Reading(with_entities("<!ENTITY a \"abcdef\">\n", ""), limits).error,
              HasSubstr("the entity a has more than 5 bytes"));
  limits = {};
  limits.entities = 1;
  EXPECT_EQ(Reading(with_entities("<!ENTITY a \"a\">\n", ""), limits).error, "");
  EXPECT_THAT(Reading(with_entities("<!ENTITY a \"a\"><!ENTITY b \"b\">\n", ""), limits).error,
              HasSubstr("more than 1 entities"));
}

TEST(Hostile, BrokenXmlIsRefusedWithItsLine) {
  EXPECT_THAT(Reading("").error, StartsWith("t.owx:"));
  EXPECT_THAT(Reading("<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\">\n<Import>").error, StartsWith("t.owx:2: "));
  EXPECT_THAT(Reading(ontology("</Import>")).error, StartsWith("t.owx:2: Opening and ending tag mismatch"));
  EXPECT_THAT(Reading(ontology("\n<Import>\xff</Import>")).error, StartsWith("t.owx:3: "));
  EXPECT_THAT(Reading(ontology("<Import>&nothing;</Import>")).error, HasSubstr("Entity 'nothing' not defined"));
}

TEST(Limits, OfElementsInEachOther) {
  XmlLimits limits;
  limits.nesting = 10;
  const auto nested = [&](std::size_t levels, const XmlLimits& in) {
    return Reading(ontology("<SubClassOf><Class IRI='A'/>" + times(levels - 3, "<ObjectComplementOf>") +
                            "<Class IRI='B'/>" + times(levels - 3, "</ObjectComplementOf>") + "</SubClassOf>"),
                   in)
        .error;
  };
  EXPECT_EQ(nested(9, limits), "");
  EXPECT_EQ(nested(10, limits), "");
  EXPECT_EQ(nested(11, limits), "t.owx:2: more than 10 levels of elements");
  EXPECT_EQ(nested(250, {}), "");
  EXPECT_THAT(nested(100'000, {}), HasSubstr("more than 250 levels of elements"));
}

TEST(Limits, OfNamesTextsPrefixesImportsOperandsAndTheFile) {
  XmlLimits limits;
  limits.iri_bytes = 12;
  EXPECT_EQ(Reading(ontology("<Declaration><Class IRI='abc'/></Declaration>"), limits).error, "");
  EXPECT_EQ(Reading(ontology("<Declaration><Class IRI='abcd'/></Declaration>"), limits).error,
            "t.owx:2: an IRI of more than 12 bytes");
  limits = {};
  limits.literal_bytes = 3;
  const auto text = [&](std::string_view of) {
    return Reading(ontology("<Annotation><AnnotationProperty IRI='n'/><Literal>" + std::string(of) +
                            "</Literal></Annotation>"),
                   limits)
        .error;
  };
  EXPECT_EQ(text("abc"), "");
  EXPECT_EQ(text("abcd"), "t.owx:2: a text of more than 3 bytes");
  limits = {};
  limits.prefixes = 1;
  limits.imports = 1;
  EXPECT_EQ(Reading(ontology("<Prefix name='a' IRI='a:a'/><Import>a</Import>"), limits).error, "");
  EXPECT_EQ(Reading(ontology("<Prefix name='a' IRI='a:a'/><Prefix name='b' IRI='b:b'/>"), limits).error,
            "t.owx:2: more than 1 prefixes");
  EXPECT_EQ(Reading(ontology("<Import>a</Import><Import>b</Import>"), limits).error, "t.owx:2: more than 1 imports");
  limits = {};
  limits.operands = 3;
  const auto classes = [&](std::size_t count) {
    return Reading(ontology("<DisjointClasses>" + times(count, "<Class IRI='A'/>") + "</DisjointClasses>"), limits)
        .error;
  };
  EXPECT_EQ(classes(3), "");
  EXPECT_EQ(classes(4), "t.owx:2: more than 3 operands");
  limits = {};
  limits.attributes = 3;
  const auto attributes = [&](std::string_view of) {
    return Reading(ontology("<Declaration>\n<Class " + std::string(of) + "/></Declaration>"), limits).error;
  };
  EXPECT_EQ(attributes("IRI='>>>>>>>>>>>>>>>>>>' a=\"''''''''\""), "");
  EXPECT_EQ(attributes("IRI='a' b='b' c='c'"), "");
  EXPECT_EQ(attributes("IRI='a' b='b' c='c' d='d'"), "t.owx:3: more than 3 attributes of an element");
  EXPECT_EQ(attributes("IRI='a'/><!-- '' '' '' '' '' '' '' '' '' '' --><Class IRI='b'"), "");
  limits = {};
  EXPECT_EQ(Reading(ontology("<Declaration " + times(300'000, "a='a' ") + "/>")).error,
            "t.owx:2: more than 1024 attributes of an element");
  const std::string empty = ontology("");
  limits.file_bytes = empty.size();
  EXPECT_EQ(Reading(empty, limits).error, "");
  EXPECT_EQ(Reading(empty + ' ', limits).error,
            "t.owx: larger than " + std::to_string(empty.size()) + " bytes: split it");
}

}  // namespace
}  // namespace geminga::owlxml
