// Consumers that accept conversions, and the converters that they take part with (CONVERSIONS.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_CONVERSIONS_CONSUMER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONVERSIONS_CONSUMER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "discovery/matching/conditions/audience.hpp"
#include "discovery/matching/conditions/scope.hpp"
#include "discovery/registry/entry.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// The most converters of one participant that take part in chains, of all other hosts together, and of all.
inline constexpr std::size_t max_converters_of_participant = 16;
inline constexpr std::size_t max_remote_converters = 240;
inline constexpr std::size_t max_converters = max_remote_converters + max_converters_of_participant;

/// A set of converters, each by its place in Converters.
class Places {
 public:
  void insert(std::uint32_t place) { words_[place / 64] |= bit(place); }
  void erase(std::uint32_t place) { words_[place / 64] &= ~bit(place); }
  [[nodiscard]] bool contains(std::uint32_t place) const { return (words_[place / 64] & bit(place)) != 0; }
  [[nodiscard]] bool is_empty() const { return words_ == std::array<std::uint64_t, max_converters / 64>{}; }
  [[nodiscard]] bool meets(const Places& other) const {
    for (std::size_t word = 0; word < words_.size(); ++word) {
      if ((words_[word] & other.words_[word]) != 0) return true;
    }
    return false;
  }
  friend auto operator<=>(const Places&, const Places&) = default;

 private:
  static std::uint64_t bit(std::uint32_t place) { return std::uint64_t{1} << (place % 64); }
  std::array<std::uint64_t, max_converters / 64> words_{};
};
static_assert(max_converters % 64 == 0);

/// A converter with its parsed audience and its step.
struct Converter {
  registry::PublicationEntry entry;
  Audience audience;
  vocabulary::Step step;
};

/// A subscription that accepts conversions.
struct Consumer {
  registry::SubscriptionEntry entry;
  std::optional<Scope> scope;    ///< nothing: it cannot be read, and admits nobody
  vocabulary::Units declared{};  ///< the units that conditions of converters may use beside the table

  /// Whether the consumer takes part with a converter: by protocol, provider, both scopes, the converter's condition,
  /// and whether it can be reached.
  [[nodiscard]] bool takes_part(const Converter& converter) const;

  /// The converters that it takes part with, remembered by Converters for one version of them.
  mutable Places partners{};
  mutable std::uint64_t version = 0;
  mutable std::uint64_t reviewed = 0;  ///< the version by which its pairs were judged
  mutable bool has_changed = false;    ///< one that it takes or took part with has changed since
};

}  // namespace geminga::matching

#endif
