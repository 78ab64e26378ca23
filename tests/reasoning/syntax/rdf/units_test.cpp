// Units in the forms of QUDT 2.1 and OM 2.0, and the errors of others. Names, factors and vectors are those of the
// published ontologies; the texts were written here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "reading.hpp"
#include "reasoning/owl/canonical.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::rdf {
namespace {

using owl::DeclaredUnit;
using owl::DeclaredUnits;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

constexpr std::string_view prefixes =
    "@prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix qkdv: <http://qudt.org/vocab/dimensionvector/> . "
    "@prefix qudt: <http://qudt.org/schema/qudt/> . @prefix unit: <http://qudt.org/vocab/unit/> . "
    "@prefix quantitykind: <http://qudt.org/vocab/quantitykind/> . @prefix xsd: <http://www.w3.org/2001/XMLSchema#> . "
    "@prefix om: <http://www.ontology-of-units-of-measure.org/resource/om-2/> . @prefix team: <http://team.example/> "
    ".\n";

DeclaredUnits units(const std::string& turtle) {
  const auto loaded = load_text("a.ttl", std::string(prefixes) + turtle);
  EXPECT_TRUE(loaded) << to_string(loaded.error());
  return loaded ? owl::units_of(loaded->source) : DeclaredUnits();
}

/// The unit with this name; one without factor where there is none.
DeclaredUnit named(const DeclaredUnits& declared, std::string_view name) {
  for (const owl::UnitName& one : declared.names) {
    if (one.text == name) return declared.units[one.unit];
  }
  return {.iri = {}, .factor = 0, .alone = {}, .symbol = {}};
}

/// "factor m2.kg-1": the exponents that are not 0.
std::string said(const DeclaredUnits& declared, std::string_view name) {
  constexpr std::string_view bases[] = {"m", "kg", "s", "A", "K", "cd", "rad", "bit", "share", "dB", "mol"};
  const DeclaredUnit unit = named(declared, name);
  std::string text = std::to_string(unit.factor);
  if (unit.offset != 0) text += " + " + std::to_string(unit.offset);
  for (std::size_t base = 0; base < owl::unit_base_count; ++base) {
    const int exponent = unit.dimension[base];
    if (exponent != 0) text += " " + std::string(bases[base]) + (exponent == 1 ? "" : std::to_string(exponent));
  }
  return unit.alone ? text + " of " + declared.units[*unit.alone].iri : text;
}

std::vector<std::string> reasons(const DeclaredUnits& declared) {
  std::vector<std::string> all;
  for (const owl::LeftOut& one : declared.left_out) {
    all.push_back(one.construct + ": " + std::to_string(one.count) + ", " +
                  one.first.substr(one.first.find_last_of('/') + 1));
  }
  return all;
}

constexpr std::string_view length = "qudt:hasDimensionVector qkdv:A0E0L1I0M0H0T0D0";

TEST(Units, OfQudtHaveFactorOffsetAndDimension) {
  const DeclaredUnits declared = units(
      "<http://qudt.org/2.1/vocab/unit> a owl:Ontology ; owl:imports <http://qudt.org/2.1/schema/facade/qudt> .\n"
      "unit:A-HR-PER-KiloGM\n  a qudt:Unit ;\n  qudt:conversionMultiplier 3600.0 ;\n"
      "  qudt:conversionMultiplierSN 3.6E3 ;\n  qudt:hasDimensionVector qkdv:A0E1L0I0M-1H0T1D0 ;\n"
      "  qudt:hasQuantityKind quantitykind:ElectricChargePerMass ;\n  qudt:symbol \"A·h/kg\" ;\n"
      "  qudt:ucumCode \"A.h.kg-1\"^^qudt:UCUMcs ;\n  qudt:ucumCode \"A.h/kg\"^^qudt:UCUMcs ;\n.\n"
      "unit:DEG_F\n  a qudt:Unit ;\n  qudt:conversionMultiplier 0.5555555555555556 ;\n"
      "  qudt:conversionOffset 459.67 ;\n  qudt:hasDimensionVector qkdv:A0E0L0I0M0H1T0D0 ;\n"
      "  qudt:hasQuantityKind quantitykind:Temperature ;\n  qudt:symbol \"°F\" ;\n.\n"
      "unit:DEG_C a qudt:Unit ; qudt:conversionMultiplier 1.0 ; qudt:conversionOffset 273.15 ;\n"
      "  qudt:hasDimensionVector qkdv:A0E0L0I0M0H1T0D0 ; qudt:symbol \"°C\" .\n"
      "unit:MOL-PER-L a qudt:Unit ; qudt:conversionMultiplierSN 1.0E3 ;\n"
      "  qudt:hasDimensionVector qkdv:A1E0L-3I0M0H0T0D0 ; qudt:symbol \"mol/L\" .\n");
  EXPECT_EQ(declared.units.size(), 4U);
  EXPECT_THAT(reasons(declared), IsEmpty());
  EXPECT_EQ(said(declared, "http://qudt.org/vocab/unit/A-HR-PER-KiloGM"), "3600.000000 kg-1 s A");
  EXPECT_EQ(said(declared, "A·h/kg"), "3600.000000 kg-1 s A");
  EXPECT_EQ(said(declared, "A.h.kg-1"), "3600.000000 kg-1 s A");
  EXPECT_EQ(named(declared, "A.h.kg-1").symbol, "A·h/kg");
  EXPECT_EQ(said(declared, "mol/L"), "1000.000000 m-3 mol");
  // 32 °F and 0 °C are 273.15 K.
  const DeclaredUnit fahrenheit = named(declared, "°F");
  EXPECT_NEAR(32 * fahrenheit.factor + fahrenheit.offset, 273.15, 1e-9);
  EXPECT_DOUBLE_EQ(named(declared, "°C").offset, 273.15);
}

TEST(Units, OfQudtAreToldApartByTheKindsOfTheirQuantities) {
  const std::string none = " ; qudt:hasDimensionVector qkdv:A0E0L0I0M0H0T0D1 ; qudt:hasQuantityKind quantitykind:";
  const std::string rate = " ; qudt:hasDimensionVector qkdv:A0E0L0I0M0H0T-1D0 ; qudt:hasQuantityKind quantitykind:";
  const std::string one = " a qudt:Unit ; qudt:conversionMultiplier ";
  const DeclaredUnits declared =
      units("unit:GON" + one + "0.015707963267948967" + none + "PlaneAngle .\n" + "unit:NAT" + one + "1.0" + none +
            "InformationEntropy .\n" + "unit:SR" + one + "1.0" + none + "SolidAngle .\n" + "unit:PPB" + one +
            "0.000000001" + none + "DimensionlessRatio .\n" + "unit:NUM" + one + "1.0" + none + "Count .\n" +
            "unit:EACH" + one + "1.0" + none + "Count .\n" + "unit:GON-PER-MIN" + one + "0.000261799" + rate +
            "AngularVelocity .\n" + "unit:BQ" + one + "1.0" + rate + "Activity .\n" + "unit:ERLANG-PER-SEC" + one +
            "1.0" + rate + "DataThing .\n" + "unit:N-M-PER-MilliRAD" + one +
            "1000.0 ; qudt:hasDimensionVector qkdv:A0E0L2I0M1H0T-2D0 ; "
            "qudt:hasQuantityKind quantitykind:SpringConstant .\n" +
            "unit:BIT-PER-M" + one +
            "0.69314718055994530941723212145818 ; "
            "qudt:hasDimensionVector qkdv:A0E0L-1I0M0H0T0D0 ; qudt:hasQuantityKind quantitykind:LinearBitDensity .\n" +
            "unit:NUM_RATIO" + one + "1.0" + none + "DimensionlessRatio , quantitykind:NeutronNumber .\n" +
            "unit:CYC-PER-SEC" + one + "1.0" + rate + "RotationalFrequency , quantitykind:RotationalVelocity .\n" +
            "unit:PER-MIN" + one + "0.016666666666666666" + rate + "Frequency , quantitykind:RotationalFrequency .\n" +
            "unit:PicoFARAD-PER-M" + one +
            "0.000000000001 ; qudt:hasDimensionVector qkdv:A0E2L-3I0M-1H0T4D0 ; qudt:hasQuantityKind "
            "quantitykind:Permittivity .\n" +
            "unit:ODD" + one + "2.0" + none + "Angle , quantitykind:DimensionlessRatio .\n");
  const auto by_name = [&](const std::string& name) { return said(declared, "http://qudt.org/vocab/unit/" + name); };
  const std::string space = "http://qudt.org/vocab/unit/";
  EXPECT_EQ(by_name("GON"), "0.015708 rad");
  EXPECT_EQ(by_name("NAT"), "1.442695 bit");
  EXPECT_EQ(by_name("SR"), "1.000000");
  EXPECT_EQ(by_name("PPB"), "0.000000 share");
  EXPECT_EQ(by_name("NUM"), "1.000000 of " + space + "NUM");
  EXPECT_EQ(by_name("EACH"), "1.000000 of " + space + "EACH") << "what cannot be decided compares only with itself";
  EXPECT_EQ(by_name("GON-PER-MIN"), "0.000262 s-1 rad");
  EXPECT_EQ(by_name("BQ"), "1.000000 s-1");
  EXPECT_EQ(by_name("ERLANG-PER-SEC"), "1.000000 of " + space + "ERLANG-PER-SEC");
  EXPECT_EQ(by_name("N-M-PER-MilliRAD"), "1000.000000 of " + space + "N-M-PER-MilliRAD") << "no energy";
  EXPECT_EQ(by_name("NUM_RATIO"), "1.000000 of " + space + "NUM_RATIO") << "a ratio of what is counted";
  EXPECT_EQ(by_name("CYC-PER-SEC"), "1.000000 of " + space + "CYC-PER-SEC");
  EXPECT_EQ(by_name("PER-MIN"), "0.016667 s-1");
  EXPECT_EQ(by_name("PicoFARAD-PER-M"), "0.000000 m-3 kg-1 s4 A2") << "no radian";
  EXPECT_EQ(by_name("BIT-PER-M"), "1.000000 m-1 bit");
  EXPECT_EQ(by_name("ODD"), "2.000000 of " + space + "ODD");
}

TEST(Units, OfOmAreResolvedByThoseThatTheyAreMadeOf) {
  const DeclaredUnits declared = units(
      "om:hasUnit a owl:ObjectProperty . om:hasFactor a owl:DatatypeProperty . om:symbol a owl:AnnotationProperty .\n"
      "om:metre a owl:NamedIndividual , om:SingularUnit , om:Unit ; om:hasDimension om:length-Dimension ; om:symbol "
      "\"m\" .\n"
      "om:kilogram a om:PrefixedUnit ; om:hasPrefix om:kilo ; om:hasUnit om:gram ; om:symbol \"kg\" .\n"
      "om:gram a om:SingularUnit , om:Unit ; om:hasUnit om:kilogram ; om:hasFactor 0.0010 ; om:symbol \"g\" .\n"
      "om:kilo a om:SIPrefix ; om:hasFactor 1000 ; om:symbol \"k\" .\n"
      "om:micro a om:SIPrefix ; om:hasFactor 0.000001 ; om:symbol \"μ\" ; om:alternativeSymbol \"u\" .\n"
      "om:microgram a owl:NamedIndividual , om:PrefixedUnit ; om:hasPrefix om:micro ; om:hasUnit om:gram ; om:symbol "
      "\"μg\" .\n"
      "om:centimetre a om:PrefixedUnit ; om:hasPrefix om:centi ; om:hasUnit om:metre . om:centi om:hasFactor 0.01 .\n"
      "om:cubicCentimetre a om:CubicPrefixedMetre ; om:hasBase om:centimetre ; om:hasExponent 3 ; om:symbol \"cm3\" .\n"
      "om:microgramPerCubicCentimetre a om:UnitDivision ; om:hasDenominator om:cubicCentimetre ;\n"
      "  om:hasNumerator om:microgram ; om:alternativeSymbol \"μg cm-3\" , \"μg·cm-3\" ; om:symbol \"μg/cm3\" .\n"
      "om:reciprocalSecond-Time a om:UnitExponentiation ; om:hasBase om:second-Time ; om:hasExponent -1 .\n"
      "om:_100Kilometre a om:UnitMultiple ; om:hasUnit om:kilometre ; om:hasFactor 100 ; om:symbol \"100 km\" .\n"
      "om:kilometre a om:PrefixedUnit ; om:hasPrefix om:kilo ; om:hasUnit om:metre .\n"
      "om:degreeCelsius a om:SingularUnit , om:Unit ; om:hasUnit om:kelvin ; om:symbol \"°C\" .\n"
      "om:degreeCelsiusPerHour a om:UnitDivision ; om:hasNumerator om:degreeCelsius ; om:hasDenominator om:hour .\n"
      "om:hour a om:SingularUnit , om:Unit ; om:hasUnit om:second-Time ; om:hasFactor 3600 .\n"
      "om:joule a om:SingularUnit , om:Unit . om:molar a om:UnitDivision ; om:hasNumerator om:mole ; om:hasDenominator "
      "om:cubicCentimetre .\n"
      "om:percent a om:SingularUnit ; om:hasUnit om:one ; om:hasFactor 0.01 ; om:symbol \"%\" .\n"
      "om:revolution a om:SingularUnit ; om:hasUnit om:radian ; om:hasFactor 6.283185 ; om:symbol \"rev\" .\n"
      "om:cup a om:Unit . om:dozenCups a om:UnitMultiple ; om:hasUnit om:cup ; om:hasFactor 12 .\n"
      "om:_3cups a om:Measure ; om:hasUnit om:cup ; om:hasNumericalValue 3 .\n");
  const auto by_name = [&](const std::string& name) { return said(declared, std::string(owl::om_namespace) + name); };
  EXPECT_THAT(reasons(declared), IsEmpty());
  EXPECT_EQ(by_name("metre"), "1.000000 m");
  EXPECT_EQ(by_name("kilogram"), "1.000000 kg");
  EXPECT_EQ(by_name("gram"), "0.001000 kg");
  EXPECT_EQ(named(declared, "μg").factor, 1e-9);
  EXPECT_EQ(by_name("cubicCentimetre"), "0.000001 m3");
  EXPECT_EQ(said(declared, "μg/cm3"), "0.001000 m-3 kg");
  EXPECT_EQ(said(declared, "μg·cm-3"), "0.001000 m-3 kg");
  EXPECT_EQ(by_name("reciprocalSecond-Time"), "1.000000 s-1");
  EXPECT_EQ(by_name("_100Kilometre"), "100000.000000 m");
  EXPECT_EQ(named(declared, "100 km").factor, 0) << "nobody can write it behind a number";
  EXPECT_EQ(by_name("degreeCelsius"), "1.000000 + 273.150000 K");
  EXPECT_EQ(by_name("degreeCelsiusPerHour"), "0.000278 s-1 K") << "a difference";
  EXPECT_EQ(by_name("joule"), "1.000000 m2 kg s-2");
  EXPECT_EQ(by_name("molar"), "1000000.000000 m-3 mol");
  EXPECT_EQ(said(declared, "%"), "0.010000 share");
  EXPECT_EQ(said(declared, "rev"), "6.283185 rad");
  EXPECT_EQ(by_name("cup"), "1.000000 of " + std::string(owl::om_namespace) + "cup");
  EXPECT_EQ(by_name("dozenCups"), "12.000000 of " + std::string(owl::om_namespace) + "cup");
  EXPECT_EQ(by_name("_3cups"), "0.000000") << "a measure is no unit";
}

TEST(Units, OfATeamAreMadeOfThoseThatAreKnown) {
  const DeclaredUnits declared =
      units("team:Pitch a qudt:Unit ; qudt:conversionMultiplier 105 ; qudt:symbol \"pitch\" ; " + std::string(length) +
            " .\nteam:Half a om:UnitMultiple ; om:hasUnit team:Pitch ; om:hasFactor 0.5 ; om:symbol \"half\" .\n"
            "team:Rod a om:UnitMultiple ; om:hasUnit om:metre ; om:hasFactor 5.0292 ; om:symbol \"rod\" .\n");
  EXPECT_EQ(said(declared, "pitch"), "105.000000 m");
  EXPECT_EQ(said(declared, "http://team.example/Pitch"), "105.000000 m");
  EXPECT_EQ(said(declared, "half"), "52.500000 m");
  EXPECT_EQ(said(declared, "rod"), "5.029200 m");
}

TEST(Units, AreLeftOutWithAReasonAndAPlace) {
  const auto one = [](const std::string& said) { return reasons(units("\nteam:X a qudt:Unit ; " + said + " .")); };
  const std::string of_length = std::string(length) + " ; qudt:conversionMultiplier ";
  EXPECT_THAT(one(of_length + "1"), IsEmpty());
  const std::string is_odd =
      "a unit whose factor is not positive, or too large or too small, like http://team.example/X";
  for (const std::string factor : {"0", "0.0", "-1", "1e-310", "1e-400"}) {
    EXPECT_THAT(one(of_length + "\"" + factor + "\"^^xsd:double"), ElementsAre(HasSubstr("a unit w"))) << factor;
  }
  EXPECT_THAT(one(of_length + "0"), ElementsAre(is_odd + ": 1, a.ttl:3"));
  for (const std::string factor : {"NaN", "INF", "-INF", "1e400", "x", "", "1,5", "0x10", " 1"}) {
    EXPECT_THAT(one(of_length + "\"" + factor + "\""), ElementsAre(HasSubstr("no finite number"))) << factor;
  }
  EXPECT_THAT(one(std::string(length)), ElementsAre(HasSubstr("a unit without qudt:conversionMultiplier")));
  EXPECT_THAT(one("qudt:conversionMultiplier 1"), ElementsAre(HasSubstr("hasDimensionVector that can be read")));
  for (const std::string vector :
       {"A0E0L1I0M0H0T0", "A0E0L1I0M0H0T0D1", "A0E0L0I0M0H0T0D0", "A0E0L17I0M0H0T0D0", "L1", "A0E0L0dot5I0M0H0T0D0",
        "A0E0L99999999999I0M0H0T0D0", "A0E0L--1I0M0H0T0D0", "A0E0LI0M0H0T0D0"}) {
    EXPECT_THAT(one("qudt:conversionMultiplier 1 ; qudt:hasDimensionVector qkdv:" + vector),
                ElementsAre(HasSubstr("hasDimensionVector that can be read")))
        << vector;
  }
  EXPECT_THAT(one("qudt:conversionMultiplier 1 ; qudt:hasDimensionVector qkdv:A0E0L16I0M0H0T-16D0"), IsEmpty());
  EXPECT_THAT(one(of_length + "1 , 2"), ElementsAre(HasSubstr("two different things")));
  EXPECT_THAT(one(of_length + "1 , 1.0 , 1.0e0"), IsEmpty()) << "one number in three forms";
  EXPECT_THAT(one(of_length + "1 ; qudt:conversionOffset 1e308 , 2"), ElementsAre(HasSubstr("two different things")));
  EXPECT_THAT(one(of_length + "1e10 ; qudt:conversionOffset 1e308"), ElementsAre(HasSubstr("offset is too large")));
}

TEST(Units, OfOmAreLeftOutWithAReason) {
  const auto one = [](const std::string& said) { return reasons(units("\n" + said + " .")); };
  EXPECT_THAT(one("team:A a om:Unit ; om:hasUnit team:A"), ElementsAre(HasSubstr("made of itself")));
  EXPECT_THAT(one("team:A a om:Unit ; om:hasUnit team:B . team:B a om:Unit ; om:hasUnit team:A"),
              UnorderedElementsAre(HasSubstr("made of itself"), HasSubstr("one that is left out")));
  EXPECT_THAT(one("team:A om:hasTerm1 team:B ; om:hasTerm2 team:B . team:B om:hasTerm1 team:A ; om:hasTerm2 om:metre"),
              UnorderedElementsAre(HasSubstr("made of itself"), HasSubstr("one that is left out")));
  EXPECT_THAT(one("team:A a om:Unit ; om:hasUnit team:Unknown"), ElementsAre(HasSubstr("not declared")));
  EXPECT_THAT(one("team:A om:hasPrefix om:kilo ; om:hasUnit om:metre"),
              ElementsAre(HasSubstr("a prefix whose factor")));
  EXPECT_THAT(one("team:A om:hasPrefix om:kilo"), ElementsAre(HasSubstr("a part is missing")));
  EXPECT_THAT(one("team:A om:hasNumerator om:metre"), ElementsAre(HasSubstr("a part is missing")));
  EXPECT_THAT(one("team:A om:hasTerm1 om:metre ; om:hasTerm2 om:metre , om:second-Time"),
              ElementsAre(HasSubstr("two different")));
  for (const std::string exponent : {"0", "17", "-17", "1.5", "1e300", "99999999999999999999"}) {
    EXPECT_THAT(one("team:A om:hasBase om:metre ; om:hasExponent " + exponent), ElementsAre(HasSubstr("an exponent")))
        << exponent;
  }
  EXPECT_THAT(one("team:A om:hasBase om:metre ; om:hasExponent 16"), IsEmpty());
  EXPECT_THAT(one("team:A om:hasBase team:B ; om:hasExponent 9 . team:B om:hasBase om:metre ; om:hasExponent 2"),
              ElementsAre(HasSubstr("an exponent over 16")));
  EXPECT_THAT(
      one("team:A om:hasBase team:B ; om:hasExponent 2 . team:B a om:Unit ; om:hasUnit om:metre ; om:hasFactor 1e200"),
      ElementsAre(HasSubstr("too large or too small")));
  EXPECT_THAT(one("team:A om:hasTerm1 team:Cup ; om:hasTerm2 om:metre . team:Cup a om:Unit"),
              ElementsAre(HasSubstr("a kind of its own")));
  EXPECT_THAT(one("team:A a om:Unit ; om:hasUnit om:degreeCelsius ; om:hasFactor 10"),
              ElementsAre(HasSubstr("with an offset")));
}

TEST(Units, MayBeMadeOfEachOtherAsDeepAsTheirNumberAllows) {
  std::string chain = "team:U0 a om:Unit ; om:hasUnit om:metre ; om:hasFactor 2 .\n";
  for (std::size_t at = 1; at + 1 < owl::max_units; ++at) {
    chain += "team:U" + std::to_string(at) + " a om:Unit ; om:hasUnit team:U" + std::to_string(at - 1) + " .\n";
  }
  const std::string last = "http://team.example/U" + std::to_string(owl::max_units - 2);
  EXPECT_EQ(said(units(chain), last), "2.000000 m");
  EXPECT_EQ(units(chain + "team:A a om:Unit .").units.size(), owl::max_units);
  const DeclaredUnits over = units(chain + "team:A a om:Unit . team:B a om:Unit .");
  EXPECT_TRUE(over.units.empty() && over.names.empty());
  EXPECT_THAT(reasons(over), ElementsAre(HasSubstr("more than 16384")));
}

TEST(Units, HaveNoNameThatTwoOfThemHaveUnlessTheyAreTheSame) {
  const std::string one = " a qudt:Unit ; " + std::string(length) + " ; qudt:symbol \"x\" ; qudt:conversionMultiplier ";
  EXPECT_EQ(said(units("team:A" + one + "2 . team:B" + one + "2.0 ."), "x"), "2.000000 m");
  const DeclaredUnits declared = units("team:A" + one + "2 .\nteam:B" + one + "3 .");
  EXPECT_EQ(named(declared, "x").factor, 0);
  EXPECT_EQ(said(declared, "http://team.example/B"), "3.000000 m");
  EXPECT_THAT(reasons(declared), ElementsAre("a symbol of units that differ, like x: 1, a.ttl:2"));
  std::string many;
  for (int at = 0; at < 10'000; ++at) many += "team:A" + std::to_string(at) + one + std::to_string(at + 1) + " .\n";
  const DeclaredUnits crowd = units(many);
  EXPECT_EQ(crowd.units.size(), 10'000U);
  EXPECT_EQ(named(crowd, "x").factor, 0);
}

TEST(Units, HaveSymbolsThatCanStandBehindANumber) {
  for (const std::string symbol :
       {"", "3m", "-x", "+x", ".x", "a b", "a(b)", "a{b}", "a*", "a:b", "a'", "a,b", "<x>"}) {
    const DeclaredUnits declared = units("team:A a qudt:Unit ; " + std::string(length) +
                                         " ; qudt:conversionMultiplier 1 ; qudt:symbol \"" + symbol + "\" .");
    EXPECT_EQ(declared.names.size(), 1U) << symbol;
    EXPECT_EQ(declared.units[0].symbol, "") << symbol;
  }
  for (const std::size_t size :
       {owl::max_unit_symbol_octets - 1, owl::max_unit_symbol_octets, owl::max_unit_symbol_octets + 1}) {
    const DeclaredUnits declared =
        units("team:A a qudt:Unit ; " + std::string(length) + " ; qudt:conversionMultiplier 1 ; qudt:symbol \"" +
              std::string(size, 'x') + "\" .");
    EXPECT_EQ(declared.names.size(), size <= owl::max_unit_symbol_octets ? 2U : 1U);
  }
}

TEST(Units, WithVeryLongNamesOrValuesAreLeftOutAndNothingElseIs) {
  const std::string space = "http://team.example/";
  for (const std::size_t size : {owl::max_unit_text_octets, owl::max_unit_text_octets + 1}) {
    const std::string iri = space + std::string(size - space.size(), 'x');
    const DeclaredUnits declared = units("<" + iri + "> a qudt:Unit ; " + std::string(length) +
                                         " ; qudt:conversionMultiplier 1 .\n"
                                         "team:B a qudt:Unit ; " +
                                         std::string(length) + " ; qudt:conversionMultiplier 1 ; qudt:symbol \"" +
                                         std::string(size, 'y') + "\" .\n");
    EXPECT_EQ(declared.units.size(), size <= owl::max_unit_text_octets ? 2U : 1U);
    if (size > owl::max_unit_text_octets) {
      EXPECT_THAT(reasons(declared), ElementsAre("a name or value of more than 512 octets: 1, a.ttl:2"));
    }
  }
}

TEST(Units, AreReadUpToSoManyStatements) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("a.ttl");
  for (std::size_t at = 0; at + 2 < owl::max_unit_statements; ++at) {
    source.add_unit_statement("http://team.example/A", owl::UnitWord::qudt_ucum, "x" + std::to_string(at), file, 1);
  }
  source.add_unit_statement("http://team.example/A", owl::UnitWord::qudt_multiplier, "2", file, 1);
  source.add_unit_statement("http://team.example/A", owl::UnitWord::qudt_dimension, "/A0E0L1I0M0H0T0D0", file, 1);
  EXPECT_EQ(owl::units_of(source).units.size(), 1U);
  source.add_unit_statement("http://team.example/A", owl::UnitWord::qudt_symbol, "a", file, 1);
  EXPECT_EQ(source.unit_statements().size(), owl::max_unit_statements + 1);
  source.add_unit_statement("http://team.example/A", owl::UnitWord::qudt_symbol, "b", file, 1);
  EXPECT_EQ(source.unit_statements().size(), owl::max_unit_statements + 1);
  EXPECT_TRUE(owl::units_of(source).units.empty());
  EXPECT_FALSE(source.problem());
}

TEST(Units, AreTheSameWhateverTheOrderAndChangeTheDigest) {
  const std::string one = "team:A a qudt:Unit ; qudt:conversionMultiplier 2 ; " + std::string(length) + " .\n";
  const std::string other = "team:B a om:Unit ; om:hasUnit team:A ; om:symbol \"b\" .\n";
  const auto digest = [](const std::string& text) {
    return owl::digest(load_text("a.ttl", std::string(prefixes) + "team:C a owl:Class .\n" + text)->source);
  };
  EXPECT_EQ(digest(one + other), digest(other + one));
  EXPECT_NE(digest(one + other), digest(one + "team:B a om:Unit ; om:hasUnit team:A ; om:symbol \"c\" .\n"));
}

}  // namespace
}  // namespace geminga::rdf
