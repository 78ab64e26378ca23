// Each limit: one below and the limit itself are read, one above is refused with its line.
#include <gtest/gtest.h>

#include <functional>

#include "reasoning/syntax/functional/reading.hpp"

namespace geminga::functional {
namespace {

std::string repeat(std::string_view text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

/// Refuses what `make` writes for limit + 1 with `error`, and reads it for limit - 1 and limit.
void expect_limit(std::size_t limit, const FunctionalLimits& limits,
                  const std::function<std::string(std::size_t)>& make, const std::string& error) {
  EXPECT_EQ(Reading(make(limit - 1), limits).error, "");
  EXPECT_EQ(Reading(make(limit), limits).error, "");
  EXPECT_EQ(Reading(make(limit + 1), limits).error, error);
}

TEST(Limits, BoundTheFile) {
  const std::string text = ontology("SubClassOf(:A :B)");
  FunctionalLimits limits;
  limits.file_bytes = text.size() + 1;
  EXPECT_EQ(Reading(text, limits).error, "");
  limits.file_bytes = text.size();
  EXPECT_EQ(Reading(text, limits).error, "");
  limits.file_bytes = text.size() - 1;
  EXPECT_EQ(Reading(text, limits).error, "t.ofn: larger than " + std::to_string(text.size() - 1) + " bytes: split it");
}

TEST(Limits, BoundIrisWrittenInFull) {
  expect_limit(
      8192, {}, [](std::size_t size) { return ontology("Declaration(Class(<" + std::string(size, 'a') + ">))"); },
      "t.ofn:2: an IRI of more than 8192 bytes");
}

TEST(Limits, BoundIrisBehindAPrefix) {
  // The IRI of the prefix has nine bytes.
  expect_limit(
      8192, {}, [](std::size_t size) { return ontology("Declaration(Class(:" + std::string(size - 9, 'a') + "))"); },
      "t.ofn:2: an IRI of more than 8192 bytes");
}

TEST(Limits, BoundNamesAsTheyAreWritten) {
  FunctionalLimits limits;
  limits.iri_bytes = 60;
  const auto escaped = [](std::size_t size) {
    return "Prefix(:=<e>)\nOntology(Declaration(Class(:a" + repeat("\\.", (size - 2) / 2) + std::string(size % 2, 'b') +
           ")))";
  };
  expect_limit(60, limits, escaped, "t.ofn:2: a name of more than 60 bytes");
  const auto blank = [](std::size_t size) {
    return "Ontology(\nClassAssertion(owl:Thing _:" + std::string(size, 'b') + "))";
  };
  expect_limit(60, limits, blank, "t.ofn:2: the name of a blank node of more than 60 bytes");
  const auto language = [](std::size_t size) {
    return "Ontology(\nAnnotation(rdfs:label \"x\"@" + std::string(size, 'e') + "))";
  };
  expect_limit(60, limits, language, "t.ofn:2: a language tag of more than 60 bytes");
  const auto number = [](std::size_t size) {
    return "Ontology(\nSubClassOf(owl:Thing ObjectMinCardinality(" + std::string(size, '0') +
           " owl:topObjectProperty)))";
  };
  expect_limit(60, limits, number, "t.ofn:2: a word of more than 60 bytes");
}

TEST(Limits, BoundTexts) {
  const auto plain = [](std::size_t size) {
    return ontology("DataPropertyAssertion(:d :i \"" + std::string(size, 'a') + "\")");
  };
  expect_limit(std::size_t{1} << 20, {}, plain, "t.ofn:2: a text of more than 1048576 bytes");
  const auto comment = [](std::size_t size) {
    return ontology("AnnotationAssertion(rdfs:comment :A \"\n" + std::string(size - 1, 'a') + "\")");
  };
  expect_limit(std::size_t{1} << 20, {}, comment, "t.ofn:2: a text of more than 1048576 bytes");
}

TEST(Limits, BoundTextsWithoutTheirEscapes) {
  FunctionalLimits limits;
  limits.literal_bytes = 100;
  const auto escaped = [](std::size_t size) {
    return ontology("DataPropertyAssertion(:d :i \"" + repeat("\\\"", size) + "\")");
  };
  expect_limit(100, limits, escaped, "t.ofn:2: a text of more than 100 bytes");
}

TEST(Limits, BoundTheNestingOfExpressions) {
  const auto nested = [](std::size_t levels) {
    return ontology("SubClassOf(:A\n" + repeat("ObjectComplementOf(", levels) + ":A" + std::string(levels, ')') + ")");
  };
  expect_limit(512, {}, nested, "t.ofn:3: more than 512 levels of nesting");
}

TEST(Limits, BoundTheNestingOfRangesAndProperties) {
  FunctionalLimits limits;
  limits.nesting = 2;
  const auto ranges = [](std::size_t levels) {
    return ontology("DataPropertyRange(:d " + repeat("DataComplementOf(", levels) + "xsd:int" +
                    std::string(levels, ')') + ")");
  };
  expect_limit(2, limits, ranges, "t.ofn:2: more than 2 levels of nesting");
  EXPECT_EQ(Reading(ontology("SubClassOf(:A ObjectComplementOf(ObjectHasSelf(:p)))"), limits).error, "");
  EXPECT_EQ(Reading(ontology("SubClassOf(:A ObjectComplementOf(ObjectHasSelf(ObjectInverseOf(:p))))"), limits).error,
            "t.ofn:2: more than 2 levels of nesting");
}

TEST(Limits, BoundTheNestingOfAnnotations) {
  const auto nested = [](std::size_t levels) {
    return ontology(repeat("Annotation(", levels) + repeat(" :n :v)", levels));
  };
  expect_limit(512, {}, nested, "t.ofn:2: more than 512 levels of nesting");
}

TEST(Limits, BoundOperands) {
  FunctionalLimits limits;
  limits.operands = 10;
  const auto list = [](std::string_view head, std::string_view operand, std::string_view tail) {
    return [=](std::size_t count) { return ontology(std::string(head) + repeat(operand, count) + std::string(tail)); };
  };
  const std::string error = "t.ofn:2: more than 10 operands";
  expect_limit(10, limits, list("EquivalentClasses(", ":A ", ")"), error);
  expect_limit(10, limits, list("SubClassOf(:A ObjectUnionOf(", ":A ", "))"), error);
  expect_limit(10, limits, list("HasKey(:A (", ":p ", ") ())"), error);
  expect_limit(10, limits, list("DatatypeDefinition(:T DatatypeRestriction(xsd:int", " xsd:length \"1\"", "))"), error);
  expect_limit(10, limits, list("SubClassOf(:A DataSomeValuesFrom(", ":d ", "DataOneOf(\"1\")))"), error);
}

TEST(Limits, AllowAMillionOperands) {
  FunctionalLimits limits;
  const auto individuals = [](std::size_t count) {
    return ontology("DifferentIndividuals(" + repeat(":i ", count) + ")");
  };
  expect_limit(limits.operands, limits, individuals, "t.ofn:2: more than 1000000 operands");
}

TEST(Limits, BoundPrefixes) {
  const auto prefixes = [](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
      text += "Prefix(p" + std::to_string(i) + ":=<http://e/>)\nPrefix(p0:=<http://e/>)";
    return text + "Ontology()";
  };
  expect_limit(10'000, {}, prefixes, "t.ofn:10001: more than 10000 prefixes");
}

TEST(Limits, BoundImports) {
  const auto imports = [](std::size_t count) {
    std::string text = "Ontology(";
    for (std::size_t i = 0; i < count; ++i)
      text += "Import(<http://e/" + std::to_string(i) + ">) Import(<http://e/0>)\n";
    return text + ")";
  };
  expect_limit(10'000, {}, imports, "t.ofn:10001: more than 10000 imports");
}

TEST(Limits, BoundWrongAxioms) {
  FunctionalLimits limits;
  limits.wrong_axioms = 10;
  const auto wrong = [](std::size_t count) {
    std::string lines;
    for (std::size_t at = 0; at < count; ++at) lines += "SubClassOf(:A)\n";
    return ontology(lines);
  };
  expect_limit(10, limits, wrong, "t.ofn:12: expected a class expression, found ')'");
}

TEST(Limits, OfTheSourceRefuseTheFile) {
  owl::SourceLimits source_limits;
  source_limits.axioms = 2;
  owl::Ontology source(source_limits);
  const std::string text = ontology("SubClassOf(:A :B) SubClassOf(:B :C) SubClassOf(:C :D)");
  const auto result = read(text, source.add_file("t.ofn"), source);
  ASSERT_FALSE(result);
  EXPECT_EQ(to_string(result.error()).substr(0, 7), "t.ofn: ");
}

}  // namespace
}  // namespace geminga::functional
