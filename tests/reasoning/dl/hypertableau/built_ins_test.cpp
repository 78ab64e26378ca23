// The built-ins of SWRL, each with its edges.
#include "reasoning/dl/hypertableau/rules/built_ins.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reasoning/dl/hypertableau/rules/patterns.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::hypertableau {
namespace {

/// Values as they are written: `5`, `2.5`, `true`, `1e0` for a double, `f1` for a float, `@2020-01-01T00:00:00` for a
/// time, `?` for an argument that is missing, anything else for a text.
std::optional<Value> value(const std::string& text) {
  if (text == "?") return std::nullopt;
  std::string type = "string";
  std::string lexical = text;
  const bool is_number = text.find_first_not_of("-0123456789.") == std::string::npos && !text.empty();
  if (is_number) type = text.find('.') == std::string::npos ? "integer" : "decimal";
  if (text == "true" || text == "false") type = "boolean";
  if (text == "NaN" || text == "INF" ||
      (text.size() > 2 && text.find_first_not_of("-0123456789.e") == std::string::npos &&
       text.find('e') != std::string::npos))
    type = "double";
  if (text.starts_with('f') && text.size() > 1 && text.find_first_not_of("0123456789.", 1) == std::string::npos) {
    type = "float";
    lexical = text.substr(1);
  }
  if (text.starts_with('@')) {
    type = "dateTime";
    lexical = text.substr(1);
  }
  owl::Ontology source;
  return value_of(source, source.literal(lexical, "http://www.w3.org/2001/XMLSchema#" + type));
}

struct Case {
  const char* name;
  std::vector<std::string> arguments;
  Holds holds = Holds::yes;
  std::string bound{};  ///< of the argument that is missing
};

void check(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    const auto form = clauses::find_built_in("http://www.w3.org/2003/11/swrlb#" + std::string(one.name));
    ASSERT_TRUE(form) << one.name;
    std::vector<std::optional<Value>> values;
    std::string all = one.name;
    for (const std::string& argument : one.arguments) {
      values.push_back(value(argument));
      all += ' ' + argument;
    }
    EXPECT_EQ(evaluate(form->built_in, values), one.holds) << all;
    EXPECT_TRUE(one.bound.empty() || (values[0] && *values[0] == *value(one.bound))) << all;
  }
}

TEST(BuiltIns, CompareValuesOfOneKind) {
  check({{"equal", {"5", "5.0"}},
         {"equal", {"5", "5e0"}},
         {"equal", {"5", "5x"}, Holds::no},
         {"notEqual", {"5", "5x"}},
         {"notEqual", {"a", "a"}, Holds::no},
         {"lessThan", {"5", "5.1"}},
         {"lessThan", {"5", "5"}, Holds::no},
         {"lessThan", {"9", "10"}},
         {"lessThan", {"a9", "a10"}, Holds::no},
         {"lessThan", {"a", "5"}, Holds::no},
         {"greaterThanOrEqual", {"f0.5", "0.5"}},
         {"greaterThan", {"INF", "1000000000000000000000"}},
         {"lessThan", {"false", "true"}},
         {"lessThanOrEqual", {"NaN", "NaN"}, Holds::no},
         {"equal", {"NaN", "NaN"}, Holds::no},
         {"notEqual", {"NaN", "NaN"}}});
}

TEST(BuiltIns, CompareTimesByTheirInstant) {
  check({{"equal", {"@2020-01-01T12:00:00Z", "@2020-01-01T14:00:00+02:00"}},
         {"lessThan", {"@2020-01-01T12:00:00", "@2020-01-01T12:00:01"}},
         {"lessThan", {"@2020-01-01T12:00:00", "@2020-01-02T02:00:01Z"}},
         {"lessThan", {"@2020-01-01T12:00:00", "@2020-01-02T02:00:00Z"}, Holds::no},
         {"greaterThan", {"@2020-01-01T12:00:00", "@2020-01-02T02:00:00Z"}, Holds::no},
         {"equal", {"@2020-01-01T12:00:00", "@2020-01-01T12:00:00Z"}, Holds::no}});
}

TEST(BuiltIns, WorkExactlyWithIntegersAndDecimals) {
  check({{"add", {"?", "1", "2", "0.5"}, Holds::yes, "3.5"},
         {"add", {"?", "9223372036854775807", "1"}, Holds::yes, "9223372036854775808"},
         {"add", {"4", "1", "2"}, Holds::no},
         {"add", {"?", "1", "a"}, Holds::no},
         {"subtract", {"?", "0.3", "0.1"}, Holds::yes, "0.2"},
         {"multiply", {"?", "1.5", "1.5"}, Holds::yes, "2.25"},
         {"divide", {"?", "7", "2"}, Holds::yes, "3.5"},
         {"divide", {"?", "2", "3"}, Holds::yes, "0.666666666666666667"},
         {"divide", {"?", "1", "0"}, Holds::no},
         {"integerDivide", {"?", "-7", "2"}, Holds::yes, "-3"},
         {"integerDivide", {"?", "7", "0"}, Holds::no},
         {"mod", {"?", "-7", "2"}, Holds::yes, "-1"},
         {"mod", {"?", "7", "0"}, Holds::no},
         {"pow", {"?", "2", "10"}, Holds::yes, "1024"},
         {"pow", {"?", "2", "-1"}, Holds::yes, "0.5"},
         {"pow", {"?", "0", "-1"}, Holds::no},
         {"unaryMinus", {"?", "0.5"}, Holds::yes, "-0.5"},
         {"unaryPlus", {"?", "-5"}, Holds::yes, "-5"},
         {"abs", {"?", "-5"}, Holds::yes, "5"},
         {"ceiling", {"?", "-1.5"}, Holds::yes, "-1"},
         {"floor", {"?", "-1.5"}, Holds::yes, "-2"},
         {"round", {"?", "2.5"}, Holds::yes, "3"},
         {"round", {"?", "-2.5"}, Holds::yes, "-2"},
         {"roundHalfToEven", {"?", "2.5"}, Holds::yes, "2"},
         {"roundHalfToEven", {"?", "3.5"}, Holds::yes, "4"},
         {"roundHalfToEven", {"?", "1.255", "2"}, Holds::yes, "1.26"}});
}

TEST(BuiltIns, LeaveOpenWhatIsTooLarge) {
  const auto power = [](unsigned digits) { return "1" + std::string(digits, '0'); };
  check({{"multiply", {"?", power(1000), power(1000)}, Holds::yes},
         {"multiply", {"?", power(1001), power(1000)}, Holds::unknown},
         {"pow", {"?", "1", "1000"}, Holds::yes, "1"},
         {"pow", {"?", "1", "1001"}, Holds::unknown},
         {"pow", {"?", "10", "0.5"}, Holds::unknown},
         {"stringConcat", {"?", std::string(max_text_octets - 1, 'a'), "b"}, Holds::yes},
         {"stringConcat", {"?", std::string(max_text_octets, 'a'), "b"}, Holds::unknown},
         {"upperCase", {"?", "ß"}, Holds::unknown},
         {"lowerCase", {"?", "Ő"}, Holds::unknown},
         {"matches", {"a", "(a"}, Holds::unknown}});
}

TEST(BuiltIns, WorkWithDoublesAsTheyAre) {
  check({{"add", {"?", "1e0", "2"}, Holds::yes, "3e0"},
         {"divide", {"?", "1e0", "0"}, Holds::yes, "INF"},
         {"multiply", {"?", "-1e0", "2.5"}, Holds::yes, "-2.5e0"},
         {"add", {"?", "f0.5", "1"}, Holds::yes, "f1.5"},
         {"subtract", {"?", "INF", "INF"}, Holds::yes, "NaN"},
         {"integerDivide", {"?", "1e0", "0e0"}, Holds::no},
         {"integerDivide", {"?", "-7e0", "2"}, Holds::yes, "-3"},
         {"integerDivide", {"?", "1e300", "1e-300"}, Holds::no},
         {"roundHalfToEven", {"?", "3.567812e3", "2"}, Holds::yes, "3.56781e3"},
         {"roundHalfToEven", {"?", "4.7564e-3", "2"}, Holds::yes, "0e0"},
         {"roundHalfToEven", {"?", "INF", "2"}, Holds::yes, "INF"},
         {"roundHalfToEven", {"?", "1e0", "2e0"}, Holds::no},
         {"round", {"?", "0.49999999999999994e0"}, Holds::yes, "0e0"},
         {"round", {"?", "4503599627370497e0"}, Holds::yes, "4503599627370497e0"},
         {"round", {"?", "-2.5e0"}, Holds::yes, "-2e0"},
         {"round", {"?", "-0.2e0"}, Holds::yes, "-0e0"},
         {"cos", {"?", "0"}, Holds::yes, "1e0"},
         {"sin", {"?", "0"}, Holds::yes, "0e0"},
         {"tan", {"?", "0e0"}, Holds::yes, "0e0"}});
}

TEST(BuiltIns, LookAtTextsAndMakeThem) {
  check({{"stringConcat", {"?", "ab", "c", "d"}, Holds::yes, "abcd"},
         {"stringConcat", {"abc", "ab", "d"}, Holds::no},
         {"substring", {"?", "motor car", "6"}, Holds::yes, " car"},
         {"substring", {"?", "metadata", "4", "3"}, Holds::yes, "ada"},
         {"substring", {"?", "abcde", "1.5", "2.6"}, Holds::yes, "bcd"},
         {"substring", {"?", "äbc", "2", "9"}, Holds::yes, "bc"},
         {"substring", {"?", "abc", "0.5e0", "1"}, Holds::yes, "a"},
         {"substring", {"?", "abc", "-42", "INF"}, Holds::yes, "abc"},
         {"substring", {"?", "abc", "NaN"}, Holds::yes, ""},
         {"substring", {"?", "abc", "0", "2"}, Holds::yes, "a"},
         {"stringLength", {"?", "äbc"}, Holds::yes, "3"},
         {"stringLength", {"?", "abc"}, Holds::yes, "3"},
         {"stringLength", {"?", "5"}, Holds::no},
         {"normalizeSpace", {"?", "  a  b "}, Holds::yes, "a b"},
         {"upperCase", {"?", "aB"}, Holds::yes, "AB"},
         {"upperCase", {"?", "Jürgen"}, Holds::yes, "JÜRGEN"},
         {"lowerCase", {"?", "ÄÖ×"}, Holds::yes, "äö×"},
         {"lowerCase", {"?", "aB"}, Holds::yes, "ab"},
         {"contains", {"abc", "bc"}},
         {"contains", {"abc", "Bc"}, Holds::no},
         {"containsIgnoreCase", {"abc", "Bc"}},
         {"startsWith", {"abc", "ab"}},
         {"endsWith", {"abc", "ab"}, Holds::no},
         {"stringEqualIgnoreCase", {"ABC", "abc"}},
         {"stringEqualIgnoreCase", {"ä", "Ä"}, Holds::yes},
         {"substringBefore", {"?", "tattoo", "attoo"}, Holds::yes, "t"},
         {"substringAfter", {"?", "tattoo", "tat"}, Holds::yes, "too"},
         {"booleanNot", {"?", "true"}, Holds::yes, "false"},
         {"booleanNot", {"false", "true"}},
         {"booleanNot", {"?", "a"}, Holds::no}});
}

TEST(BuiltIns, MatchAndReplaceByPatternsOfXPath) {
  // The examples of XQuery 1.0 and XPath 2.0 Functions and Operators, sections 7.6.2, 7.6.3 and 7.4.9.
  check({{"matches", {"abracadabra", "bra"}},
         {"matches", {"abracadabra", "^a.*a$"}},
         {"matches", {"abracadabra", "^bra"}, Holds::no},
         {"matches", {"a\nb", "a.b"}, Holds::no},
         {"matches", {"a\nb", "^b"}, Holds::no},
         {"matches", {"a\rb", "a.b"}, Holds::unknown},
         {"matches", {"robot_12", "^[A-Za-z_]+\\d{2,3}$"}},
         {"matches", {"\u0967", "^\\d$"}},
         {"matches", {"é", "^\\w$"}},
         {"matches", {"a-b", "^[\\w-]+$"}},
         {"matches", {"a b", "\\S\\s\\S"}},
         {"matches", {"Ab", "^\\p{Lu}\\P{Lu}$"}},
         {"matches", {"", ""}},
         {"matches", {"abc", "(?:b|x)c"}},
         {"replace", {"?", "abracadabra", "bra", "*"}, Holds::yes, "a*cada*"},
         {"replace", {"?", "abracadabra", "a.*a", "*"}, Holds::yes, "*"},
         {"replace", {"?", "abracadabra", "a.*?a", "*"}, Holds::yes, "*c*bra"},
         {"replace", {"?", "abracadabra", "a(.)", "a$1$1"}, Holds::yes, "abbraccaddabbra"},
         {"replace", {"?", "AAAA", "A+?", "b"}, Holds::yes, "bbbb"},
         {"replace", {"?", "abc", "b", "\\$$0\\\\"}, Holds::yes, "a$b\\c"},
         {"replace", {"?", "abc", "(x)|b", "[$1]"}, Holds::yes, "a[]c"},
         {"replace", {"?", "abc", "x*", "-"}, Holds::unknown},
         {"replace", {"?", "abc", "b", "$"}, Holds::unknown},
         {"replace", {"abc", "abd", "d", "c"}},
         {"translate", {"?", "bar", "abc", "ABC"}, Holds::yes, "BAr"},
         {"translate", {"?", "--aaa--", "abc-", "ABC"}, Holds::yes, "AAA"},
         {"translate", {"?", "abcdabc", "abc", "äB"}, Holds::yes, "äBdäB"}});
  // Patterns that RE2 has not, or means otherwise.
  for (const char* pattern : {"(a)\\1",      "[a-z-[aeiou]]",
                              "\\i",         "\\p{IsBasicLatin}",
                              "\\p{Cn}",     "\\p{Greek}",
                              "a**",         "a{,3}",
                              "*a",          "a)",
                              "(a",          "]",
                              "[]",          "[^]",
                              "[a",          "{",
                              "(?i)a",       "\\bA",
                              "\\x41",       "\\Qa",
                              "[[:alpha:]]", "[a-c-e]",
                              "[\\d-z]",     "[z-a]",
                              "[\\W]",       "a{1001}",
                              "^*",          "\\"})
    check({{"matches", {"a", pattern}, Holds::unknown}});
  for (const std::size_t size : {max_pattern_octets - 1, max_pattern_octets, max_pattern_octets + 1}) {
    const std::string pattern(size, 'a');
    check({{"matches", {pattern, pattern}, size <= max_pattern_octets ? Holds::yes : Holds::unknown}});
  }
}

TEST(BuiltIns, WithOtherNamesAreNotKnown) {
  EXPECT_FALSE(clauses::find_built_in("http://www.w3.org/2003/11/swrlb#date"));
  EXPECT_FALSE(clauses::find_built_in("http://swrl.stanford.edu/ontologies/built-ins/3.3/swrlx.owl#add"));
}

}  // namespace
}  // namespace geminga::hypertableau
