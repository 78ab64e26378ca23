// Values of literals and how datatypes lie in each other.
#include "reasoning/owl/datatypes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace geminga::owl {
namespace {

std::string iri_of(std::string_view name) {
  if (name.starts_with("owl:")) return "http://www.w3.org/2002/07/owl#" + std::string(name.substr(4));
  if (name.starts_with("rdf:")) return "http://www.w3.org/1999/02/22-rdf-syntax-ns#" + std::string(name.substr(4));
  return "http://www.w3.org/2001/XMLSchema#" + std::string(name);
}

Datatype type(std::string_view name) { return Datatype::find(iri_of(name)).value(); }

std::string canonical(std::string_view lexical, std::string_view name, std::string_view language = "") {
  bool is_ill_formed = false;
  const auto value = DataValue::read(lexical, iri_of(name), language, is_ill_formed);
  return value ? value->canonical : is_ill_formed ? "ill-formed" : "unknown";
}

bool is_in(std::string_view lexical, std::string_view literal_type, std::string_view name) {
  bool is_ill_formed = false;
  return DataValue::read(lexical, iri_of(literal_type), "", is_ill_formed).value().is_in(type(name));
}

TEST(Datatypes, GiveEqualValuesOneForm) {
  const struct {
    const char* lexical;
    const char* name;
    const char* canonical;
  } cases[] = {
      {"1", "integer", "1"},
      {"+001", "int", "1"},
      {" 1 ", "integer", "1"},
      {"1.0", "decimal", "1"},
      {"-0.50", "decimal", "-0.5"},
      {".5", "decimal", "0.5"},
      {"-0", "integer", "0"},
      {"7/1", "owl:rational", "7"},
      {"14/2", "owl:rational", "7"},
      {"0/3", "owl:rational", "0"},
      {"-6/4", "owl:rational", "-1.5"},
      {"1/8", "owl:rational", "0.125"},
      {"3/50", "owl:rational", "0.06"},
      {"100/3", "owl:rational", "100/3"},
      {"-2/6", "owl:rational", "-1/3"},
      {"1", "boolean", "true"},
      {"false", "boolean", "false"},
      {"0fB7", "hexBinary", "0FB7"},
      {"a", "string", "sa"},
      {" a  b ", "token", "sa b"},
      {"a@", "rdf:PlainLiteral", "sa"},
      {"2020-01-02T03:04:05+00:00", "dateTime", "2020-01-02T03:04:05Z"},
      {"2020-01-02T03:04:05.50", "dateTime", "2020-01-02T03:04:05.5"},
      {"2000-02-29T23:59:59.000-14:00", "dateTime", "2000-02-29T23:59:59-14:00"},
      {"-0004-02-29T24:00:00.0Z", "dateTime", "-0004-03-01T00:00:00Z"},
      {"2019-02-28T24:00:00", "dateTime", "2019-03-01T00:00:00"},
      {"2020-02-28T24:00:00", "dateTime", "2020-02-29T00:00:00"},
      {"2020-12-31T24:00:00+05:00", "dateTime", "2021-01-01T00:00:00+05:00"},
      {"9999-12-31T24:00:00", "dateTime", "10000-01-01T00:00:00"},
      {"-0001-12-31T24:00:00", "dateTime", "0000-01-01T00:00:00"},
      {"-10000-12-31T24:00:00", "dateTime", "-9999-01-01T00:00:00"},
      {"-0000-01-01T00:00:00", "dateTime", "0000-01-01T00:00:00"},
      {"12000-02-29T00:00:00", "dateTime", "12000-02-29T00:00:00"},
      {"Y Q = =", "base64Binary", "YQ=="},
      {"YWI=", "base64Binary", "YWI="},
      {"", "base64Binary", ""},
      {"1e0", "double", "1p+0"},
      {"1.0", "double", "1p+0"},
      {"INF", "float", "INF"},
      {"1E39", "float", "INF"},
      {"-1E39", "float", "-INF"},
      {"1E309", "double", "INF"},
      {"1E-46", "float", "0p+0"},
      {"-1E-46", "float", "-0p+0"},
      {"1E-400", "double", "0p+0"},
      {"1E999999999999", "double", "INF"},
  };
  for (const auto& one : cases)
    EXPECT_EQ(canonical(one.lexical, one.name), one.canonical) << one.lexical << " " << one.name;
  EXPECT_EQ(canonical("a@EN", "rdf:PlainLiteral"), canonical("a", "rdf:langString", "en"));
  EXPECT_NE(canonical("a", "rdf:langString", "de"), canonical("a", "rdf:langString", "en"));
}

TEST(Datatypes, RefuseWhatIsNotOfTheirForm) {
  const struct {
    const char* lexical;
    const char* name;
  } cases[] = {
      {"", "integer"},
      {"1.0", "integer"},
      {"-1", "nonNegativeInteger"},
      {"256", "unsignedByte"},
      {"128", "byte"},
      {"abc", "decimal"},
      {".", "decimal"},
      {"+-1", "integer"},
      {"yes", "boolean"},
      {"0f0", "hexBinary"},
      {"a b", "NCName"},
      {"1a", "Name"},
      {"1", "owl:real"},
      {"1/0", "owl:rational"},
      {"nan", "double"},
      {"inf", "float"},
      {"0x1", "double"},
      {"x", "rdf:langString"},
      {"2020-01-02", "dateTime"},
      {"2000-02-30T00:00:00", "dateTime"},
      {"1900-02-29T00:00:00", "dateTime"},
      {"2000-13-01T00:00:00", "dateTime"},
      {"2000-00-01T00:00:00", "dateTime"},
      {"2000-01-00T00:00:00", "dateTime"},
      {"2000-01-01T00:00:60", "dateTime"},
      {"2000-01-01T00:60:00", "dateTime"},
      {"2000-01-01T24:00:01", "dateTime"},
      {"2000-01-01T24:00:00.5", "dateTime"},
      {"2000-01-01T25:00:00", "dateTime"},
      {"2000-01-01T00:00:00+14:01", "dateTime"},
      {"2000-01-01T00:00:00+13:60", "dateTime"},
      {"2000-01-01T00:00:00.", "dateTime"},
      {"02000-01-01T00:00:00", "dateTime"},
      {"200-01-01T00:00:00", "dateTime"},
      {"-2000-01-01T00:00:0", "dateTime"},
      {"-", "dateTime"},
      {"YQ=", "base64Binary"},
      {"YR==", "base64Binary"},
      {"Y===", "base64Binary"},
      {"Y!==", "base64Binary"},
      {"YWI=YWI=", "base64Binary"},
      {"2020-01-02T03:04:05", "dateTimeStamp"},
      {"99999999999999999999", "long"},
  };
  for (const auto& one : cases)
    EXPECT_EQ(canonical(one.lexical, one.name), "ill-formed") << one.lexical << " " << one.name;
  EXPECT_EQ(canonical("2020", "gYear"), "unknown");
}

TEST(Datatypes, LieInEachOther) {
  const struct {
    const char* sub;
    const char* super;
  } within[] = {
      {"integer", "decimal"},
      {"decimal", "owl:rational"},
      {"owl:rational", "owl:real"},
      {"byte", "short"},
      {"unsignedInt", "long"},
      {"unsignedByte", "nonNegativeInteger"},
      {"positiveInteger", "nonNegativeInteger"},
      {"negativeInteger", "nonPositiveInteger"},
      {"NCName", "Name"},
      {"language", "token"},
      {"string", "rdf:PlainLiteral"},
      {"rdf:langString", "rdf:PlainLiteral"},
      {"dateTimeStamp", "dateTime"},
  };
  for (const auto& one : within) {
    EXPECT_TRUE(type(one.sub).is_within(type(one.super))) << one.sub << " " << one.super;
    EXPECT_FALSE(type(one.super).is_within(type(one.sub))) << one.super << " " << one.sub;
    EXPECT_FALSE(type(one.sub).is_disjoint(type(one.super))) << one.sub << " " << one.super;
  }
  const struct {
    const char* one;
    const char* other;
    bool is_disjoint;
  } pairs[] = {
      {"positiveInteger", "nonPositiveInteger", true},
      {"positiveInteger", "negativeInteger", true},
      {"nonNegativeInteger", "nonPositiveInteger", false},
      {"byte", "unsignedLong", false},
      {"float", "double", true},
      {"double", "decimal", true},
      {"string", "rdf:langString", true},
      {"string", "anyURI", true},
      {"boolean", "integer", true},
  };
  for (const auto& pair : pairs) {
    EXPECT_EQ(type(pair.one).is_disjoint(type(pair.other)), pair.is_disjoint) << pair.one << " " << pair.other;
    EXPECT_EQ(type(pair.other).is_disjoint(type(pair.one)), pair.is_disjoint) << pair.one << " " << pair.other;
  }
}

TEST(Datatypes, HoldValues) {
  EXPECT_TRUE(is_in("5", "byte", "positiveInteger"));
  EXPECT_FALSE(is_in("0", "byte", "positiveInteger"));
  EXPECT_TRUE(is_in("5.0", "decimal", "integer"));
  EXPECT_FALSE(is_in("5.5", "decimal", "integer"));
  EXPECT_TRUE(is_in("18446744073709551615", "integer", "unsignedLong"));
  EXPECT_FALSE(is_in("18446744073709551616", "integer", "unsignedLong"));
  EXPECT_TRUE(is_in("-9223372036854775808", "integer", "long"));
  EXPECT_FALSE(is_in("-9223372036854775809", "integer", "long"));
  EXPECT_TRUE(is_in("en-GB", "string", "language"));
  EXPECT_FALSE(is_in("a b", "string", "NMTOKEN"));
  EXPECT_TRUE(is_in("a b", "string", "token"));
  EXPECT_FALSE(is_in(" a", "string", "token"));
  EXPECT_TRUE(is_in("2020-01-02T03:04:05+01:00", "dateTime", "dateTimeStamp"));
  EXPECT_FALSE(is_in("2020-01-02T03:04:05", "dateTime", "dateTimeStamp"));
}

}  // namespace
}  // namespace geminga::owl
