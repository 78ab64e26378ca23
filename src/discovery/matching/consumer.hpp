// Who asks for what may have to be converted, and with which converters it takes part (CONVERSIONS.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_CONSUMER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONSUMER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "discovery/matching/audience.hpp"
#include "discovery/matching/scope.hpp"
#include "discovery/registry/entry.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Converters of one participant that take part in chains, and of all other hosts together.
inline constexpr std::size_t max_converters_of_participant = 16;
inline constexpr std::size_t max_remote_converters = 240;
inline constexpr std::size_t max_converters = max_remote_converters + max_converters_of_participant;

/// A set of places of converters.
class Places {
 public:
  void insert(std::uint32_t place) { words_[place / 64] |= bit(place); }
  [[nodiscard]] bool contains(std::uint32_t place) const { return (words_[place / 64] & bit(place)) != 0; }
  [[nodiscard]] bool is_empty() const { return words_ == std::array<std::uint64_t, max_converters / 64>{}; }
  friend auto operator<=>(const Places&, const Places&) = default;

 private:
  static std::uint64_t bit(std::uint32_t place) { return std::uint64_t{1} << (place % 64); }
  std::array<std::uint64_t, max_converters / 64> words_{};
};
static_assert(max_converters % 64 == 0);

/// A converter with what is computed of it.
struct Converter {
  registry::PublicationEntry entry;
  Audience audience;
  vocabulary::Step step;
};

struct Consumer {
  registry::SubscriptionEntry entry;
  std::optional<Scope> scope;    ///< nothing: it cannot be read
  vocabulary::Units declared{};  ///< beside the table: what the conditions of converters may be written in

  /// Whether it takes part with a converter: by protocol, provider, and the scopes and the condition of both.
  [[nodiscard]] bool takes_part(const Converter& converter) const;

  /// Remembered by Converters: with whom it took part when they had this version.
  mutable Places partners{};
  mutable std::uint64_t version = 0;
};

}  // namespace geminga::matching

#endif
