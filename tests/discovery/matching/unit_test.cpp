// The units of WHERE.md.
#include "discovery/matching/unit.hpp"

#include <gtest/gtest.h>

#include <compare>
#include <string>
#include <utility>

#include "discovery/matching/unit_name.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/owl/unit.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {
namespace {

bool are_equal(const std::string& a, const std::string& b) {
  const auto one = quantity(a);
  const auto other = quantity(b);
  EXPECT_TRUE(one) << a;
  EXPECT_TRUE(other) << b;
  return one && other && compare(*one, *other) == std::partial_ordering::equivalent;
}

TEST(Unit, IsConvertedToItsBase) {
  for (const auto& [one, other] : {std::pair{"1 km", "1000 m"},
                                   {"1 min", "60 s"},
                                   {"1 h", "3.6 ks"},
                                   {"36 km/h", "10 m/s"},
                                   {"180 deg", "3.141592653589793 rad"},
                                   {"60 rpm", "360 deg/s"},
                                   {"1 kWh", "3.6 MJ"},
                                   {"1 N", "1 kg*m/s^2"},
                                   {"1 N", "1 kg.m.s-2"},
                                   {"1 m\u00b2", "1 m2"},
                                   {"1 m^2", "10000 cm2"},
                                   {"1 l", "1 dm3"},
                                   {"1 \u00b5s", "1 us"},
                                   {"1 KiB", "1024 B"},
                                   {"1 kB", "8 kbit"},
                                   {"1 Mbit/s", "125 kB/s"},
                                   {"1 Mbps", "1 Mbit/s"},
                                   {"30 fps", "30 Hz"},
                                   {"50 %", "500000 ppm"},
                                   {"0 \u00b0C", "273.15 K"},
                                   {"212 degF", "100 degC"},
                                   {"1 in", "25.4 mm"},
                                   {"12 V", "12 W/A"},
                                   {"1 Ah", "3600 C"}}) {
    EXPECT_TRUE(are_equal(one, other)) << one << " and " << other;
  }
}

TEST(Unit, MayBeNamedAsQudtDoes) {
  for (const auto& [one, other] : {std::pair{"350 unit:CentiM", "3.5 m"},
                                   {"36 unit:KiloM-PER-HR", "10 unit:M-PER-SEC"},
                                   {"1 unit:N", "1 unit:KiloGM-M-PER-SEC2"},
                                   {"1 http://qudt.org/vocab/unit/KiloW-HR", "3.6 MJ"},
                                   {"1 unit:M2", "10000 cm2"},
                                   {"1 unit:KibiBYTE", "1024 B"},
                                   {"1 unit:MegaBIT-PER-SEC", "1 Mbps"},
                                   {"60 unit:REV-PER-MIN", "360 unit:DEG-PER-SEC"},
                                   {"30 unit:FRAME-PER-SEC", "30 unit:HZ"},
                                   {"0 unit:DEG_C", "273.15 unit:K"},
                                   {"1 unit:MI_N", "1852 m"},
                                   {"3 unit:DeciB", "3 dB"},
                                   {"50 unit:PERCENT", "50 %"},
                                   {"2unit:MIN", "120 s"},
                                   {"1 unit:W-PER-M2-K", "1 W/m2/K"}}) {
    EXPECT_TRUE(are_equal(one, other)) << one << " and " << other;
  }
  for (const char* text :
       {"unit:", "unit:m", "unit:FURLONG", "unit:MilliIN", "unit:DeciBYTE", "unit:KibiM", "unit:PER-M", "unit:M-",
        "unit:-M", "unit:M--M", "unit:M-PER", "unit:M-PER-PER-SEC", "unit:M5", "unit:M22", "unit:M/s",
        "http://qudt.org/vocab/unit/", "http://example.org/unit/M", "unit:DEG_C-PER-SEC"}) {
    EXPECT_FALSE(unit(text)) << text;
  }
}

TEST(Unit, OfQudtHasAShortName) {
  const auto product = [](std::size_t factors) {
    std::string name = "CD";
    for (std::size_t at = 1; at < factors; ++at) name += at % 2 == 0 ? "-CD" : "-PER-CD";
    return name;
  };
  // Thirty-one, thirty-two and thirty-three octets.
  EXPECT_TRUE(unit("unit:FARAD-PER-CentiM-CentiM-CentiM3"));
  EXPECT_EQ(std::string("FARAD-PER-CentiM-CentiM-CentiM3").size(), max_unit_name_octets - 1);
  EXPECT_TRUE(unit("unit:FARAD-PER-CentiM2-CentiM-CentiM3"));
  EXPECT_FALSE(unit("unit:FARAD2-PER-CentiM2-CentiM-CentiM3"));
  EXPECT_FALSE(unit("unit:" + product(6))) << "PER once";
}

TEST(Unit, OfAnotherKindIsNotComparable) {
  for (const auto& [one, other] : {std::pair{"1 m", "1 s"},
                                   {"1 m", "1 m2"},
                                   {"1 rad", "100 %"},
                                   {"1 Hz", "1 rpm"},
                                   {"1 bit", "1 %"},
                                   {"1 dB", "1 %"}}) {
    const auto order = compare(*quantity(one), *quantity(other));
    EXPECT_EQ(order, std::partial_ordering::unordered) << one << " and " << other;
  }
}

TEST(Unit, ThatNobodyKnowsIsNone) {
  for (const char* text : {"",   "x",  "metre", "Nm",     "kmin",   "kkm",    "m/",    "/s",   "m//s", "m s",
                           " m", "m ", "m0",    "m5",     "m^",     "^2",     "2",     "m^0",  "m2-1", "\xff",
                           "*",  ".",  "k",     "\u00b2", "degC/s", "m.degC", "kdegC", "KiHz", "Kim"}) {
    EXPECT_FALSE(unit(text)) << text;
  }
}

TEST(Unit, IsReadUpToItsLengthAndItsExponents) {
  const auto repeated = [](std::size_t times) {
    std::string text = "m";
    for (std::size_t i = 1; i < times; ++i) text += "/m";
    return text;
  };
  ASSERT_EQ(repeated(16).size(), max_unit_octets - 1);
  EXPECT_TRUE(unit(repeated(16)));
  EXPECT_FALSE(unit(repeated(17)));
  EXPECT_TRUE(unit("F4"));
  EXPECT_FALSE(unit("F4.F4")) << "s^32 is no unit that anybody means";
  EXPECT_FALSE(unit("Tm4.Tm4.Tm4.Tm4.Tm4.Tm4.Tm4.Tm4"));
  EXPECT_TRUE(unit("m4/m4/s4.s4"));
}

TEST(Unit, AQuantityNeedsBothAndIsFinite) {
  for (const char* text :
       {"3", "m", "", "3 ", " 3 m", "3 m ", "x3 m", "1e999 m", "1e308 km", "NaN m", "inf m", "3  "}) {
    EXPECT_FALSE(quantity(text)) << text;
  }
  EXPECT_TRUE(quantity("3m"));
  EXPECT_TRUE(quantity("-3.5e2   mm"));
  EXPECT_FALSE(quantity("1e5")) << "an exponent is none";
}

TEST(Unit, ADifferenceOfTemperaturesHasNoZero) {
  EXPECT_DOUBLE_EQ(difference("5 degC")->value, 5);
  EXPECT_DOUBLE_EQ(difference("9 degF")->value, 5);
  EXPECT_DOUBLE_EQ(difference("5 cm")->value, quantity("5 cm")->value);
}

/// A team's units: `pitch` and `goal` are lengths, `cup` is a kind of its own, `m` and `kpitch` are what nobody may
/// say.
vocabulary::Units declared() {
  owl::Ontology source;
  source.add_file("units.ttl");
  source.add_prefix("team", "https://team.example/#");
  source.add_prefix("u", "http://qudt.org/vocab/unit/");
  const auto add = [&](const std::string& iri, const char* factor, const char* symbol, const char* vector,
                       const char* offset = "0") {
    source.add_unit_statement(iri, owl::UnitWord::qudt_multiplier, factor, owl::FileId{0}, 1);
    source.add_unit_statement(iri, owl::UnitWord::qudt_offset, offset, owl::FileId{0}, 1);
    source.add_unit_statement(iri, owl::UnitWord::qudt_dimension, vector, owl::FileId{0}, 1);
    source.add_unit_statement(iri, owl::UnitWord::qudt_symbol, symbol, owl::FileId{0}, 1);
  };
  const std::string om = "http://www.ontology-of-units-of-measure.org/resource/om-2/";
  add("https://team.example/#Pitch", "105", "pitch", "/A0E0L1I0M0H0T0D0");
  add("https://team.example/#Goal", "7.32", "goal", "/A0E0L1I0M0H0T0D0");
  add("https://team.example/#Cup", "1", "cup", "/A0E0L0I0M0H0T0D1");
  add("https://team.example/#Mug", "1", "mug", "/A0E0L0I0M0H0T0D1");
  add("https://team.example/#Metre", "2", "m", "/A0E0L1I0M0H0T0D0");
  add("http://qudt.org/vocab/unit/MOL", "1", "mol", "/A1E0L0I0M0H0T0D0");
  add("http://qudt.org/vocab/unit/M", "3", "metre", "/A0E0L1I0M0H0T0D0");
  add("http://qudt.org/vocab/unit/FATHOM", "1.8288", "fath", "/A0E0L1I0M0H0T0D0");
  add("http://qudt.org/vocab/unit/DEG_X", "2", "degX", "/A0E0L0I0M0H1T0D0", "10");
  add(om + "fathom-USSurvey", "1.828804", "fathom", "/A0E0L1I0M0H0T0D0");
  const auto base = [&](const char* name, const char* symbol) {
    source.add_unit_statement(om + name, owl::UnitWord::type, om + "Unit", owl::FileId{0}, 1);
    source.add_unit_statement(om + name, owl::UnitWord::om_symbol, symbol, owl::FileId{0}, 1);
  };
  base("degreeCelsius", "\u00b0C");
  source.add_unit_statement(om + "degree", owl::UnitWord::om_factor, "0.01745329", owl::FileId{0}, 1);
  source.add_unit_statement(om + "degree", owl::UnitWord::om_unit, om + "radian", owl::FileId{0}, 1);
  base("degree", "\u00b0");
  auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, *el::classify(source)));
  return vocabulary::Vocabulary(std::move(ontology).value()).units();
}

bool are_equal(const std::string& a, const std::string& b, const vocabulary::Units& units) {
  const auto one = quantity(a, units);
  const auto other = quantity(b, units);
  EXPECT_TRUE(one) << a;
  EXPECT_TRUE(other) << b;
  return one && other && compare(*one, *other) == std::partial_ordering::equivalent;
}

TEST(Unit, MayBeDeclaredByAnOntology) {
  const vocabulary::Units units = declared();
  for (const auto& [one, other] : {std::pair{"2 pitch", "210 m"},
                                   {"1 team:Pitch", "105 m"},
                                   {"1 https://team.example/#Pitch", "105 m"},
                                   {"1 <https://team.example/#Pitch>", "105 m"},
                                   {"1 pitch/s", "105 m/s"},
                                   {"1 kg.pitch2", "11025 kg.m2"},
                                   {"1 pitch^-1", "0.009523809523809525 m-1"},
                                   {"2 mol/m3", "2 mol.m-3"},
                                   {"1 unit:FATHOM", "182.88 cm"},
                                   {"1 u:FATHOM", "182.88 cm"},
                                   {"1 http://qudt.org/vocab/unit/FATHOM", "182.88 cm"},
                                   {"1 <https://qudt.org/vocab/unit/FATHOM>", "182.88 cm"},
                                   {"1 om:fathom-USSurvey", "1.828804 m"},
                                   {"3 cup", "3 team:Cup"},
                                   {"5 degX", "30 K"},
                                   {"20 om:degreeCelsius", "293.15 K"},
                                   {"90 om:degree", "90 deg"}}) {
    EXPECT_TRUE(are_equal(one, other, units)) << one << ' ' << other;
    EXPECT_FALSE(quantity(one)) << one << " means nothing without the ontology";
  }
  EXPECT_DOUBLE_EQ(difference("5 degX", units)->value, 10);
  EXPECT_EQ(compare(*quantity("3 cup", units), *quantity("3 mug", units)), std::partial_ordering::unordered);
  EXPECT_EQ(compare(*quantity("3 cup", units), *quantity("3 m/m", units)), std::partial_ordering::unordered);
}

TEST(Unit, OfTheTableMeansTheSameUnderEveryOntology) {
  const vocabulary::Units units = declared();
  EXPECT_TRUE(are_equal("1 m", "100 cm", units));
  EXPECT_TRUE(are_equal("1 unit:M", "1 m", units));
  EXPECT_TRUE(are_equal("1 <http://qudt.org/vocab/unit/M>", "1 m", units));
  EXPECT_TRUE(are_equal("1 team:Metre", "2 m", units)) << "by its own name it is what it is";
}

TEST(Unit, ThatAnOntologyDoesNotDeclareOrNobodyCanMakeIsNone) {
  const vocabulary::Units units = declared();
  for (const char* text : {"pitc",
                           "Pitch",
                           "kpitch",
                           "pitch/",
                           "cup/s",
                           "cup2",
                           "degX/s",
                           "team:",
                           "team:Nothing",
                           ":Pitch",
                           "nobody:Pitch",
                           "<https://team.example/#Pitch",
                           "https://team.example/#",
                           "unit:",
                           "unit:X",
                           "om:",
                           "om:Pitch",
                           "<>",
                           ":",
                           "pitch17.pitch"}) {
    EXPECT_FALSE(unit(text, units)) << text;
  }
  EXPECT_TRUE(unit("pitch4.pitch4.pitch4.pitch4", units));
  EXPECT_FALSE(unit("pitch4.pitch4.pitch4.pitch4.goal", units)) << "over 16";
  const std::string space = "https://team.example/#";
  EXPECT_FALSE(unit(space + std::string(max_unit_name + 1 - space.size(), 'x'), units));
}

}  // namespace
}  // namespace geminga::matching
