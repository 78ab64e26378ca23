// Sets of data values: intervals in each layer of each family, but for finitely many values.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_SET_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_VALUES_VALUE_SET_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "reasoning/dl/hypertableau/values/value.hpp"

namespace geminga::hypertableau {

/// A place between numbers: just before or just after one.
struct Cut {
  Number at;
  bool is_after = false;
  friend bool operator==(const Cut&, const Cut&) = default;
  friend bool operator<(const Cut& a, const Cut& b) { return a.at < b.at || (a.at == b.at && a.is_after < b.is_after); }
};

/// A set of numbers: it begins outside or inside, and every cut changes that.
class Intervals {
 public:
  Intervals() = default;
  /// From a cut on, to a cut; nothing: without end.
  [[nodiscard]] static Intervals all();
  [[nodiscard]] static Intervals from(Cut cut);
  [[nodiscard]] static Intervals to(Cut cut);
  [[nodiscard]] static Intervals between(const Number& low, const Number& high);

  [[nodiscard]] bool contains(const Number& number) const;
  [[nodiscard]] Intervals complement() const;
  [[nodiscard]] Intervals intersection(const Intervals& other) const;
  [[nodiscard]] bool begins_inside() const { return begins_inside_; }
  [[nodiscard]] const std::vector<Cut>& cuts() const { return cuts_; }

 private:
  bool begins_inside_ = false;
  std::vector<Cut> cuts_;  ///< ascending
};

/// As many values as can be counted; more are many.
inline constexpr std::uint64_t many_values = std::uint64_t{1} << 40;

class ValueSet {
 public:
  [[nodiscard]] static ValueSet nothing() { return {}; }
  [[nodiscard]] static ValueSet everything();
  [[nodiscard]] static ValueSet one(const Value& value);
  [[nodiscard]] static ValueSet enumerated(const std::vector<Value>& values);
  /// Everything of a layer whose position is in the intervals.
  [[nodiscard]] static ValueSet layer(owl::DataFamily family, std::uint8_t layer, const Intervals& intervals);

  [[nodiscard]] bool contains(const Value& value) const;
  [[nodiscard]] ValueSet complement() const;
  [[nodiscard]] ValueSet intersection(const ValueSet& other) const;
  [[nodiscard]] ValueSet union_with(const ValueSet& other) const {
    return complement().intersection(other.complement()).complement();
  }
  /// Never too large a number; many_values or more: do not count on it being finite.
  [[nodiscard]] std::uint64_t count() const;
  /// Up to `limit` values, smallest first, of those that can be listed.
  [[nodiscard]] std::vector<Value> list(std::size_t limit) const;

 private:
  static constexpr std::size_t families = owl::data_family_count;
  using Layers = std::array<std::array<Intervals, text_layers>, families>;

  Layers layers_;
  std::set<Value> exceptions_;  ///< inside where the layers say outside, and the other way
};

}  // namespace geminga::hypertableau

#endif
