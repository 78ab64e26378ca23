// The units of a compiled ontology: found by their names, and refused where a number of theirs is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/compiled/container.hpp"
#include "reasoning/owl/left_out.hpp"
#include "small_units.hpp"
#include "support/written.hpp"

namespace geminga::compiled {
namespace {

using testing::HasSubstr;

/// `Cup`, `Goal` and `Pitch`, in this order, and one that is left out.
std::vector<std::byte> small() {
  owl::Ontology source = owl::written("SubClassOf(A B)\n");
  add_small_units(source);
  return compile(source, owl::classified(source));
}

std::string refusal(std::vector<std::byte> bytes) {
  const auto ontology = Ontology::from_bytes(std::move(bytes));
  return ontology ? "" : ontology.error().text;
}

TEST(CompiledUnits, AreFoundByTheirNames) {
  const auto ontology = Ontology::from_bytes(small());
  ASSERT_TRUE(ontology);
  const UnitsView units = ontology->units();
  ASSERT_EQ(units.size(), 3U);
  ASSERT_EQ(units.name_end.size(), 4U);
  const auto pitch = units.find("https://t.example/#", "Pitch");
  ASSERT_TRUE(pitch);
  EXPECT_EQ(units.find("pitch"), pitch);
  EXPECT_EQ(units.find("p", "itch"), pitch);
  EXPECT_EQ(units.factor[*pitch], 105);
  EXPECT_EQ(units.dimension[*pitch * owl::unit_base_count], 1);
  EXPECT_EQ(units.name(units.symbol[*pitch]), "pitch");
  EXPECT_EQ(units.alone[*pitch], UnitsView::none);
  const auto cup = units.find("https://t.example/#Cup");
  ASSERT_TRUE(cup);
  EXPECT_EQ(units.alone[*cup], *cup);
  EXPECT_EQ(units.symbol[*cup], UnitsView::none);
  for (const char* unknown : {"", "pitc", "pitchx", "Pitch", "https://t.example/#Bad", "~"}) {
    EXPECT_FALSE(units.find(unknown)) << unknown;
  }
  const auto left_out = ontology->units_left_out();
  ASSERT_EQ(left_out.size(), 1U);
  EXPECT_THAT(left_out[0].construct, HasSubstr("whose factor is not positive"));
  EXPECT_EQ(left_out[0].first, "written.ofn:4");
  EXPECT_TRUE(std::ranges::none_of(ontology->left_out(), [](const owl::LeftOut& one) {
    return one.construct.contains("unit");
  })) << "the taxonomy is complete without them";
}

TEST(CompiledUnits, AreNoneWhereNoneAreDeclared) {
  const compiled::Ontology ontology = owl::loaded("SubClassOf(A B)\n");
  EXPECT_EQ(ontology.units().size(), 0U);
  EXPECT_FALSE(ontology.units().find("m"));
  EXPECT_TRUE(ontology.units_left_out().empty());
}

TEST(CompiledUnits, AreRefusedWhereANumberIsWrong) {
  const auto refused = [](auto array, std::size_t at, auto value) {
    std::vector<std::byte> bytes = small();
    const auto view = view_taxonomy(*Container::open(bytes));
    EXPECT_TRUE(view);
    const auto numbers = array(units_of(*view));
    EXPECT_LT(at, numbers.size());
    const auto offset = reinterpret_cast<const std::byte*>(numbers.data() + at) - bytes.data();
    *reinterpret_cast<decltype(value)*>(bytes.data() + offset) = value;
    seal(bytes);
    const std::string why = refusal(std::move(bytes));
    EXPECT_TRUE(why.empty() || why.contains("at offset ")) << why;
    return why;
  };
  const auto factor = [](const UnitsView& units) { return units.factor; };
  const auto offset = [](const UnitsView& units) { return units.offset; };
  const auto dimension = [](const UnitsView& units) { return units.dimension; };
  const auto alone = [](const UnitsView& units) { return units.alone; };
  const auto symbol = [](const UnitsView& units) { return units.symbol; };
  const auto name_end = [](const UnitsView& units) { return units.name_end; };
  const auto unit_of_name = [](const UnitsView& units) { return units.unit_of_name; };
  EXPECT_EQ(refused(factor, 0, 1e300), "");
  for (const double wrong : {0.0, -1.0, 1e-310, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THAT(refused(factor, 2, wrong), HasSubstr("the factor of a unit")) << wrong;
  }
  EXPECT_THAT(refused(offset, 1, std::nan("")), HasSubstr("the offset of a unit"));
  EXPECT_EQ(refused(offset, 1, -1e300), "");
  EXPECT_EQ(refused(dimension, 3, std::int8_t{-16}), "");
  EXPECT_THAT(refused(dimension, 3, std::int8_t{17}), HasSubstr("the exponent of a unit"));
  EXPECT_THAT(refused(dimension, 3, std::int8_t{-128}), HasSubstr("the exponent of a unit"));
  EXPECT_EQ(refused(alone, 0, std::uint32_t{2}), "");
  EXPECT_THAT(refused(alone, 0, std::uint32_t{3}), HasSubstr("the kind of a unit"));
  EXPECT_EQ(refused(symbol, 0, std::uint32_t{3}), "");
  EXPECT_THAT(refused(symbol, 0, std::uint32_t{4}), HasSubstr("the symbol of a unit"));
  EXPECT_THAT(refused(unit_of_name, 0, std::uint32_t{3}), HasSubstr("the unit of a name"));
  EXPECT_THAT(refused(name_end, 0, std::uint32_t{1'000'000}), HasSubstr("the end of the name of a unit"));
  EXPECT_THAT(refused(name_end, 3, std::uint32_t{1}), HasSubstr("the end of the name of a unit"));
  EXPECT_THAT(refused(name_end, 1, std::uint32_t{0}), HasSubstr("name"));
}

}  // namespace
}  // namespace geminga::compiled
