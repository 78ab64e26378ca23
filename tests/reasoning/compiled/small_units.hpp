// Units for tests of the compiled form.
#ifndef GEMINGA_TESTS_REASONING_COMPILED_SMALL_UNITS_HPP
#define GEMINGA_TESTS_REASONING_COMPILED_SMALL_UNITS_HPP

#include <cstdint>
#include <string>
#include <utility>

#include "reasoning/owl/source.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::compiled {

/// Adds the units `Cup`, `Goal` and `Pitch`, and `Bad`, which is left out since its factor is 0.
inline void add_small_units(owl::Ontology& source) {
  const auto say = [&](const char* unit, owl::UnitWord word, const char* value, std::uint32_t line) {
    source.add_unit_statement(std::string("https://t.example/#") + unit, word, value, owl::FileId{0}, line);
  };
  for (const auto& [unit, factor] : {std::pair{"Pitch", "105"}, {"Goal", "7.32"}, {"Bad", "0"}}) {
    say(unit, owl::UnitWord::qudt_multiplier, factor, 4);
    say(unit, owl::UnitWord::qudt_dimension, "/A0E0L1I0M0H0T0D0", 4);
  }
  say("Pitch", owl::UnitWord::qudt_symbol, "pitch", 4);
  say("Cup", owl::UnitWord::type, "http://www.ontology-of-units-of-measure.org/resource/om-2/Unit", 5);
}

}  // namespace geminga::compiled

#endif
