// The worked examples of MANCHESTER.md, and edge cases.
#include <gtest/gtest.h>

#include <fstream>

#include "place.hpp"
#include "reasoning/owl/print.hpp"
#include "support/written.hpp"

namespace geminga::manchester {
namespace {

/// The ontology of MANCHESTER.md's examples.
owl::Ontology example() {
  owl::Ontology source = owl::written(
      "SubClassOf(Camera Sensor)\nSubClassOf(Sensor ObjectSomeValuesFrom(observes Thing))\nDeclaration(Ball)\n"
      "Declaration(LeftEye)\nDeclaration(OilBall)\nObjectPropertyDomain(partOf Thing)\n"
      "SubClassOf(Ball DataSomeValuesFrom(d:weight x:decimal))\nClassAssertion(Thing i:robot1)\n");
  source.add_label("https://t.example/#LeftEye", "Left eye", "en");
  source.add_label("https://t.example/#OilBall", "Ölball", "de");
  return source;
}

std::string shortened(std::string text) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
      const std::size_t end = text.find('>', at);
      text.erase(end, 1);
      text.replace(at, from.size(), to);
    }
  };
  replace("<https://t.example/#", "t:");
  replace("<http://www.w3.org/2001/XMLSchema#", "xsd:");
  return text;
}

/// Pairs of lines between ```name and ``` in the document.
std::vector<std::pair<std::string, std::string>> examples(const std::string& name) {
  std::ifstream file(GEMINGA_SOURCE_DIR "/src/reasoning/syntax/manchester/MANCHESTER.md");
  std::vector<std::pair<std::string, std::string>> pairs;
  bool is_inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("```")) {
      is_inside = line == "```" + name;
    } else if (is_inside && line.starts_with("= ")) {
      pairs.back().second = line.substr(2);
    } else if (is_inside) {
      pairs.emplace_back(line, "");
    }
  }
  return pairs;
}

/// The error by the grammar alone; empty: none.
std::string grammar_error(std::string_view text) {
  const auto error = check_grammar(text);
  return error ? to_string(*error) : "";
}

TEST(Expression, IsCheckedByTheGrammarWithoutNames) {
  for (const auto& [text, expected] : examples("canonical")) EXPECT_EQ(grammar_error(text), "") << text;
  for (const char* text :
       {"Robot", "'left eye' and p some (q only (A or not B))", "p value 5.0", "p value x", "p some D[>= 5.0]",
        "p some (D or {5})", "p only (D and not {\"a\", true})", "p some (A or q some {5})", "p min 2", "p max 3 A",
        "p exactly 1 D[length 3]", "p exactly 1 {4}", "inverse p some {x, y}", "p Self and q value \"x\"@en",
        "p some (not (not (D[< 3])))", "p min 5 and q value \"x\"^^ns:type"}) {
    EXPECT_EQ(grammar_error(text), "") << text;
  }
  EXPECT_EQ(grammar_error("Robot and"),
            "column 10: expected a class, a property, 'not', 'inverse', '(' or '{', found the end");
  for (const char* text :
       {"((((", "A B", "p some", "p some (D or {5}", "p min x", "{5}", "p some (A or 5 and q some B)", "p value",
        "p Self A", "A or ()", "p some D[5]", "p value \"a", "\xff"}) {
    EXPECT_NE(grammar_error(text), "") << text;
  }
}

TEST(Expression, IsCheckedByTheGrammarWithinItsLimits) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '(') + "A" + std::string(levels, ')'); };
  const std::size_t most = ExpressionLimits{}.nesting;
  EXPECT_EQ(grammar_error(nested(most)), "");
  EXPECT_NE(grammar_error(nested(most + 1)), "");
  EXPECT_NE(grammar_error(std::string(ExpressionLimits{}.text_bytes + 1, 'A')), "");
}

TEST(Expression, IsReadAsTheSpecificationShows) {
  const Asked asked(example());
  const auto pairs = examples("canonical");
  ASSERT_GE(pairs.size(), 15U);
  for (const auto& [text, expected] : pairs) EXPECT_EQ(shortened(asked.read(text)), expected) << text;
}

TEST(Expression, IsRefusedAsTheSpecificationShows) {
  const Asked asked(example());
  const auto pairs = examples("refused");
  ASSERT_GE(pairs.size(), 15U);
  for (const auto& [text, expected] : pairs) EXPECT_EQ(asked.read(text), expected) << text;
}

TEST(CanonicalForm, IsItsOwn) {
  const Asked asked(example());
  for (const auto& [text, expected] : examples("canonical")) {
    const std::string once = asked.read(text);
    EXPECT_EQ(asked.read(once), once) << text;
  }
}

TEST(CanonicalForm, TakesSetsOutOfSetsThatAreLeftAlone) {
  const Asked asked(example());
  EXPECT_EQ(shortened(asked.read("((Sensor and Ball) or (Ball and Sensor)) and Camera")),
            "t:Ball and t:Camera and t:Sensor");
}

TEST(Expression, IsPrintedSoThatItIsReadAgain) {
  const Asked asked(example());
  for (const auto& [text, expected] : examples("canonical")) {
    const auto read = parse(text, asked.names());
    ASSERT_TRUE(read) << text;
    const std::string printed = owl::print(
        read->source, read->term, [&](std::string_view iri) { return asked.ontology().short_name(iri); },
        owl::PrintStyle::parsing);
    EXPECT_EQ(asked.read(printed), asked.read(text)) << printed;
  }
}

TEST(Expression, IsRefusedOneLevelBeyondTheLimit) {
  const Asked asked(example());
  ExpressionLimits limits;
  const auto nested = [&](std::size_t levels) { return std::string(levels, '(') + "Ball" + std::string(levels, ')'); };
  for (const std::size_t levels : {limits.nesting - 1, limits.nesting}) {
    EXPECT_EQ(shortened(asked.read(nested(levels))), "t:Ball") << levels;
  }
  EXPECT_EQ(asked.read(nested(limits.nesting + 1)), "column 102: more than 100 levels of nesting");
  std::string negations;
  for (std::size_t at = 0; at <= limits.nesting; ++at) negations += "not ";
  EXPECT_EQ(asked.read(negations + "Ball"), "column 401: more than 100 levels of nesting");
  std::string restrictions;
  for (std::size_t at = 0; at < 2000; ++at) restrictions += "observes some ";
  EXPECT_EQ(asked.read(restrictions + "Ball"), "column 1401: more than 100 levels of nesting");
}

TEST(Expression, IsRefusedOnePartBeyondTheLimit) {
  const Asked asked(example());
  ExpressionLimits limits;
  limits.parts = 3;
  EXPECT_EQ(shortened(asked.read("Ball and Sensor", limits)), "t:Ball and t:Sensor");
  EXPECT_EQ(shortened(asked.read("Ball and observes some Ball", limits)), "t:Ball and (t:observes some t:Ball)");
  EXPECT_EQ(asked.read("Ball or Ball or Ball or Ball", limits), "column 25: more than 3 names and values");
  EXPECT_EQ(asked.read("weight some {1, 2, 3}", limits), "column 20: more than 3 names and values");
  EXPECT_EQ(asked.read("weight some {\"1\", \"2\", \"3\"}", limits), "column 24: more than 3 names and values");
}

TEST(Expression, IsRefusedOneOctetBeyondTheLimit) {
  const Asked asked(example());
  ExpressionLimits limits;
  limits.text_bytes = 20;
  EXPECT_EQ(shortened(asked.read("Ball and      Sensor", limits)), "t:Ball and t:Sensor");
  EXPECT_EQ(asked.read("Ball and       Sensor", limits), "column 1: more than 20 octets");
}

TEST(Expression, MayBeAnyOctets) {
  const Asked asked(example());
  EXPECT_EQ(asked.read("Ball \xff"), "column 1: no UTF-8");
  EXPECT_EQ(asked.read(std::string_view("Ball\0Ball", 9)).substr(0, 9), "column 1:");
  EXPECT_EQ(asked.read(""), "column 1: expected a class, a property, 'not', 'inverse', '(' or '{', found the end");
  EXPECT_EQ(asked.read("Ball and ^"), "column 10: a lone ^");
  EXPECT_EQ(asked.read("weight value \"a\\n\""), "column 14: a backslash stands before a quote or a backslash only");
}

TEST(Expression, HasOnlyLiteralsOfTheirDatatypes) {
  const Asked asked(example());
  EXPECT_EQ(asked.read("weight value \"heavy\"^^xsd:integer"), "column 14: a literal that is not of its datatype");
  EXPECT_EQ(asked.read("weight some integer[< \"1.5\"^^xsd:integer]"),
            "column 23: a literal that is not of its datatype");
}

TEST(Name, ThatFitsTwiceIsRefusedWithBoth) {
  owl::Ontology source = example();
  source.add(owl::AxiomKind::declaration, {source.named_class("https://u.example/Ball")}, owl::FileId{0}, 1);
  source.add(owl::AxiomKind::declaration, {source.data_property("https://t.example/#observes")}, owl::FileId{0}, 1);
  const Asked asked(source);
  EXPECT_EQ(asked.read("not Ball"), "column 5: 'Ball' may be t:Ball or <https://u.example/Ball>: say which");
  EXPECT_EQ(shortened(asked.read("not t:Ball")), "not t:Ball");
  EXPECT_EQ(asked.read("observes some Sensor"),
            "column 1: 'observes' is an object property and a data property: say which by its IRI");
}

TEST(Compound, IsWhatHasMoreThanAName) {
  for (const char* text : {"a and b", "not a", "(a)", "{a}", "'left eye'", "a some b", "<http://x> or <http://y>"}) {
    EXPECT_TRUE(is_compound(text)) << text;
  }
  for (const char* text :
       {"a", "t:a", "<http://x>", "left eye", "", "http://x/a", "a < b", "\"a and b\" c", "android"}) {
    EXPECT_FALSE(is_compound(text)) << text;
  }
}

}  // namespace
}  // namespace geminga::manchester
