// Sweeping over cuts, and counting.
#include "reasoning/dl/hypertableau/values/value_set.hpp"

#include <algorithm>

namespace geminga::hypertableau {
namespace {

using owl::DataFamily;

constexpr std::size_t index(DataFamily family) { return static_cast<std::size_t>(family); }

/// Whether positions of the layer are whole numbers.
bool is_discrete(DataFamily family, std::uint8_t layer) {
  return family == DataFamily::number ? layer == 0 : family != DataFamily::time;
}

std::uint64_t power(std::uint64_t base, const Number& exponent) {
  if (exponent >= 40) return many_values;
  std::uint64_t result = 1;
  for (int at = 0; at < static_cast<int>(exponent); ++at) result = std::min(result * base, many_values);
  return result;
}

/// How many values there are at a position, at least.
std::uint64_t multiplicity(DataFamily family, std::uint8_t layer, const Number& position) {
  switch (family) {
    case DataFamily::hex:
    case DataFamily::base64:
      return power(256, position);
    case DataFamily::uri:
      return power(26, position);
    case DataFamily::time:
      return layer == 0 ? 1681 : 1;  // time zones from -14:00 to +14:00
    case DataFamily::text: {
      if (position == 0) return layer == 2 ? 1 : layer == language_layer ? many_values : 0;  // "" is a token
      if (layer == language_layer) return many_values;
      // Of length 1: tab, LF, CR; the space; a punctuation mark; a digit; the colon; the underscore; a letter.
      static constexpr std::array<std::uint64_t, 7> singles = {3, 1, 20, 10, 1, 1, 52};
      return position == 1 ? singles[layer] : power(10, position);
    }
    case DataFamily::xml:
      return many_values;
    default:
      return 1;
  }
}

/// Which positions a layer has.
Intervals domain_of(DataFamily family, std::uint8_t layer) {
  switch (family) {
    case DataFamily::number:
    case DataFamily::time:
      return Intervals::all();
    case DataFamily::double_:
      return layer == 0 ? Intervals::between(rank_of(-std::numeric_limits<double>::infinity()),
                                             rank_of(std::numeric_limits<double>::infinity()))
                        : Intervals::between(0, 0);
    case DataFamily::float_:
      return layer == 0 ? Intervals::between(rank_of(-std::numeric_limits<float>::infinity()),
                                             rank_of(std::numeric_limits<float>::infinity()))
                        : Intervals::between(0, 0);
    case DataFamily::boolean:
      return Intervals::between(0, 1);
    default:
      return Intervals::from({0, false});
  }
}

/// The least whole number after a cut, and the greatest before one.
boost::multiprecision::cpp_int whole_after(const Cut& cut) {
  using boost::multiprecision::cpp_int;
  const cpp_int over = boost::multiprecision::numerator(cut.at);
  const cpp_int under = boost::multiprecision::denominator(cut.at);
  cpp_int floor = over / under;
  if (over < 0 && floor * under != over) --floor;
  const bool is_whole = floor * under == over;
  return is_whole && !cut.is_after ? floor : cpp_int(floor + 1);
}
boost::multiprecision::cpp_int whole_before(const Cut& cut) { return whole_after(cut) - 1; }

std::uint64_t saturated(std::uint64_t a, std::uint64_t b) { return std::min(a + b, many_values); }

}  // namespace

Intervals Intervals::all() {
  Intervals result;
  result.begins_inside_ = true;
  return result;
}
Intervals Intervals::from(Cut cut) {
  Intervals result;
  result.cuts_.push_back(std::move(cut));
  return result;
}
Intervals Intervals::to(Cut cut) {
  Intervals result = all();
  result.cuts_.push_back(std::move(cut));
  return result;
}
Intervals Intervals::between(const Number& low, const Number& high) {
  Intervals result;
  if (low <= high) result.cuts_ = {{low, false}, {high, true}};
  return result;
}

bool Intervals::contains(const Number& number) const {
  const auto before = std::ranges::count_if(
      cuts_, [&](const Cut& cut) { return cut.at < number || (cut.at == number && !cut.is_after); });
  return begins_inside_ != (before % 2 == 1);
}

Intervals Intervals::complement() const {
  Intervals result = *this;
  result.begins_inside_ = !begins_inside_;
  return result;
}

Intervals Intervals::intersection(const Intervals& other) const {
  Intervals result;
  bool in_first = begins_inside_;
  bool in_second = other.begins_inside_;
  bool is_inside = result.begins_inside_ = in_first && in_second;
  auto first = cuts_.begin();
  auto second = other.cuts_.begin();
  while (first != cuts_.end() || second != other.cuts_.end()) {
    const bool takes_first = second == other.cuts_.end() || (first != cuts_.end() && !(*second < *first));
    const bool takes_second = first == cuts_.end() || (second != other.cuts_.end() && !(*first < *second));
    const Cut cut = takes_first ? *first : *second;
    if (takes_first) {
      in_first = !in_first;
      ++first;
    }
    if (takes_second) {
      in_second = !in_second;
      ++second;
    }
    if ((in_first && in_second) == is_inside) continue;
    is_inside = !is_inside;
    result.cuts_.push_back(cut);
  }
  return result;
}

ValueSet ValueSet::everything() {
  ValueSet result;
  for (std::size_t family = 0; family < families; ++family) {
    for (std::uint8_t layer = 0; layer < layer_count(DataFamily{static_cast<std::uint8_t>(family)}); ++layer) {
      result.layers_[family][layer] = domain_of(DataFamily{static_cast<std::uint8_t>(family)}, layer);
    }
  }
  return result;
}

ValueSet ValueSet::one(const Value& value) {
  ValueSet result;
  result.exceptions_.insert(value);
  return result;
}

ValueSet ValueSet::enumerated(const std::vector<Value>& values) {
  ValueSet result;
  result.exceptions_.insert(values.begin(), values.end());
  return result;
}

ValueSet ValueSet::layer(DataFamily family, std::uint8_t layer, const Intervals& intervals) {
  ValueSet result;
  result.layers_[index(family)][layer] = intervals.intersection(domain_of(family, layer));
  return result;
}

bool ValueSet::contains(const Value& value) const {
  return layers_[index(value.family)][value.layer].contains(value.position) != exceptions_.contains(value);
}

ValueSet ValueSet::complement() const {
  ValueSet result = everything();
  for (std::size_t family = 0; family < families; ++family) {
    for (std::size_t layer = 0; layer < text_layers; ++layer) {
      result.layers_[family][layer] = result.layers_[family][layer].intersection(layers_[family][layer].complement());
    }
  }
  result.exceptions_ = exceptions_;
  return result;
}

ValueSet ValueSet::intersection(const ValueSet& other) const {
  ValueSet result;
  for (std::size_t family = 0; family < families; ++family) {
    for (std::size_t layer = 0; layer < text_layers; ++layer) {
      result.layers_[family][layer] = layers_[family][layer].intersection(other.layers_[family][layer]);
    }
  }
  for (const auto* exceptions : {&exceptions_, &other.exceptions_}) {
    for (const Value& value : *exceptions) {
      const bool is_in = contains(value) && other.contains(value);
      if (is_in != result.layers_[index(value.family)][value.layer].contains(value.position)) {
        result.exceptions_.insert(value);
      }
    }
  }
  return result;
}

namespace {

/// The values of one layer between two cuts; nothing: without end.
std::uint64_t count_between(DataFamily family, std::uint8_t layer, const Cut* low, const Cut* high) {
  if (low == nullptr || high == nullptr) return many_values;
  if (!is_discrete(family, layer)) {
    if (low->at < high->at) return many_values;
    if (family == DataFamily::time) return multiplicity(family, layer, low->at);
    // A single number of a layer that has no whole numbers, or no decimals, ...
    if (layer == 3) return 0;
    const auto denominator = boost::multiprecision::denominator(low->at);
    auto reduced = denominator;
    while (reduced % 2 == 0) reduced /= 2;
    while (reduced % 5 == 0) reduced /= 5;
    const std::uint8_t own = denominator == 1 ? 0 : reduced == 1 ? 1 : 2;
    return own == layer ? 1 : 0;
  }
  const auto first = whole_after(*low);
  const auto last = whole_before(*high);
  if (first > last) return 0;
  const bool is_single = family == DataFamily::number || family == DataFamily::double_ ||
                         family == DataFamily::float_ || family == DataFamily::boolean;
  if (is_single) {
    const auto count = last - first + 1;
    return count > many_values ? many_values : static_cast<std::uint64_t>(count);
  }
  if (last - first > 64) return many_values;
  std::uint64_t count = 0;
  for (auto at = first; at <= last; ++at) count = saturated(count, multiplicity(family, layer, Number(at)));
  return count;
}

/// Calls `visit(low, high)` for each interval.
template <typename Visit>
void each_interval(const Intervals& intervals, Visit&& visit) {
  const auto& cuts = intervals.cuts();
  std::size_t at = 0;
  if (intervals.begins_inside()) {
    visit(static_cast<const Cut*>(nullptr), cuts.empty() ? nullptr : &cuts[0]);
    at = 1;
  }
  for (; at < cuts.size(); at += 2) visit(&cuts[at], at + 1 < cuts.size() ? &cuts[at + 1] : nullptr);
}

}  // namespace

std::uint64_t ValueSet::count() const {
  std::uint64_t count = 0;
  for (std::size_t at = 0; at < families; ++at) {
    const DataFamily family{static_cast<std::uint8_t>(at)};
    for (std::uint8_t layer = 0; layer < layer_count(family); ++layer) {
      each_interval(layers_[at][layer], [&](const Cut* low, const Cut* high) {
        count = saturated(count, count_between(family, layer, low, high));
      });
    }
  }
  if (count >= many_values) return many_values;
  std::uint64_t removed = 0;
  for (const Value& value : exceptions_) {
    if (contains(value)) {
      ++count;
    } else {
      ++removed;
    }
  }
  return count > removed ? count - removed : 0;
}

std::vector<Value> ValueSet::list(std::size_t limit) const {
  std::vector<Value> values;
  for (const Value& value : exceptions_) {
    if (contains(value) && values.size() < limit) values.push_back(value);
  }
  for (std::size_t at = 0; at < families; ++at) {
    const DataFamily family{static_cast<std::uint8_t>(at)};
    for (std::uint8_t layer = 0; layer < layer_count(family); ++layer) {
      if (!is_discrete(family, layer)) continue;
      each_interval(layers_[at][layer], [&](const Cut* low, const Cut* high) {
        if (low == nullptr) return;
        for (auto position = whole_after(*low); values.size() < limit; ++position) {
          if (high != nullptr && position > whole_before(*high)) return;
          Value value{family, layer, Number(position), {}};
          const bool is_empty_text = family == DataFamily::text && position == 0;
          if ((family == DataFamily::text && !is_empty_text) || multiplicity(family, layer, value.position) != 1)
            return;
          if (is_empty_text) value.text.assign(1, 's');  // as el::DataValue writes it
          if (!exceptions_.contains(value)) values.push_back(std::move(value));
        }
      });
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

}  // namespace geminga::hypertableau
