// Data values, and where each lies in its value space.
//
// Every family of values is a few layers, and every layer is ordered by a number: numbers by themselves, strings and
// binaries by their length, times by their instant, floats by their rank. Facets are intervals of such layers.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_HPP

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::hypertableau {

using Number = boost::multiprecision::cpp_rational;

/// Longer lexical forms of numbers and times are not worked with: they are unknown values.
inline constexpr std::size_t max_number_digits = 2000;

/// The layers of each family. Those of numbers: integers, other decimals, other rationals, other reals. Those of texts:
/// by the last type of the chain string .. language, then those with a language. Floats: NaN is the second. Times: with
/// a time zone, without.
inline constexpr std::uint8_t number_layers = 4;
inline constexpr std::uint8_t text_layers = 8;
inline constexpr std::uint8_t language_layer = 7;

/// Equal values, and only these, are equal.
struct Value {
  owl::DataFamily family = owl::DataFamily::text;
  std::uint8_t layer = 0;
  Number position;
  std::string text;  ///< where a position has more than one value
  friend bool operator==(const Value&, const Value&) = default;
  friend bool operator<(const Value& a, const Value& b) {
    return std::tie(a.family, a.layer, a.position, a.text) < std::tie(b.family, b.layer, b.position, b.text);
  }
};

[[nodiscard]] std::uint8_t layer_count(owl::DataFamily family);

/// The value of a literal term; nothing where its datatype is unknown or it is too long.
[[nodiscard]] std::optional<Value> value_of(const owl::Ontology& source, owl::TermId literal);
/// The same of a literal that was read.
[[nodiscard]] std::optional<Value> value_of(owl::DataValue read);
/// The value that is this rational number.
[[nodiscard]] Value value_of_number(const Number& number);

/// A finite or infinite float by its rank: neighbours differ by 1, and -0 comes just before 0.
[[nodiscard]] Number rank_of(double value);
[[nodiscard]] Number rank_of(float value);

}  // namespace geminga::hypertableau

#endif
