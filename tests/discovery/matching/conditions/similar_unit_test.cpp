#include "discovery/matching/conditions/similar_unit.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace geminga::matching {
namespace {

TEST(SimilarUnit, IsOfTheNameWrittenOutOrInAnotherCase) {
  for (const auto& [written, meant] : std::vector<std::pair<std::string, std::string>>{{"metres", "m"},
                                                                                       {"meter", "m"},
                                                                                       {"Kilometres", "km"},
                                                                                       {"milliseconds", "ms"},
                                                                                       {"hertz", "Hz"},
                                                                                       {"HZ", "Hz"},
                                                                                       {"KHZ", "kHz"},
                                                                                       {"degrees", "deg"},
                                                                                       {"kmH", ""},
                                                                                       {"parsecs", ""},
                                                                                       {"", ""},
                                                                                       {"kilo", ""}})
    EXPECT_EQ(similar_unit(written), meant) << written;
}

}  // namespace
}  // namespace geminga::matching
