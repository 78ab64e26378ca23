// Preferences of a consumer: `favour`, `prefer` and `rank` of a subscription (PREFERENCES.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_ARBITRATION_PREFERENCES_HPP
#define GEMINGA_DISCOVERY_MATCHING_ARBITRATION_PREFERENCES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/matching/arbitration/rank.hpp"
#include "discovery/matching/conditions/unit.hpp"
#include "discovery/matching/degrees/degree.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// How many wishes `prefer` may have; one more is refused with 422.
inline constexpr std::size_t max_wishes = 4;

/// The criteria of ranking, in the usual order.
enum class Criterion : std::uint8_t { favour, priority, prefer, degree, distance };
inline constexpr std::size_t criterion_count = 5;

/// One wish of `prefer`: `accuracy asc by 5 cm`.
struct Wish {
  std::string key;
  bool is_descending = false;
  /// How much better a candidate must be to take an incumbent's place, in the base unit.
  double margin = 0;
  /// The dimension of the margin; nothing where no margin is stated. Values of another dimension count as absent.
  std::optional<Dimension> dimension{};
  friend bool operator==(const Wish&, const Wish&) = default;
};

/// A value: copies and moves. Borrows nothing.
class Preferences {
 public:
  /// No preferences: the usual order.
  Preferences() = default;
  /// Reads the preferences of a subscription. `declared` are the units that are known beside the table. The error (422)
  /// says what cannot be read.
  [[nodiscard]] static std::expected<Preferences, Error> parse(const Subscription& subscription,
                                                               const vocabulary::Units& declared = {});

  /// The place of a publication in the preferred order: one number for each criterion and wish, the lesser the better.
  /// The scores of all publications have the same length. Empty, without an allocation, where there are no preferences.
  [[nodiscard]] Score score(const registry::PublicationEntry& publication, const Match& match) const {
    return is_usual() ? Score() : stated_score(publication, match);
  }
  /// Whether nothing is preferred.
  [[nodiscard]] bool is_usual() const { return favoured_.empty() && wishes_.empty() && !is_reordered_; }
  /// How much better each number of a score must be to push out an incumbent.
  [[nodiscard]] Score margins() const;
  /// The lead of one publication over another in words: "whose rate is 30 against 10". Empty where only the key
  /// decides.
  [[nodiscard]] std::string lead(const registry::PublicationEntry& better, const Match& its_match,
                                 const registry::PublicationEntry& worse, const Match& others_match) const;

  friend bool operator==(const Preferences&, const Preferences&) = default;

 private:
  [[nodiscard]] Score stated_score(const registry::PublicationEntry& publication, const Match& match) const;
  [[nodiscard]] double favour(const registry::PublicationEntry& publication) const;

  std::vector<ProviderFilter> favoured_;
  std::vector<Wish> wishes_;
  vocabulary::Units declared_;  ///< units beside the table; none without wishes
  std::array<Criterion, criterion_count> order_{Criterion::favour, Criterion::priority, Criterion::prefer,
                                                Criterion::degree, Criterion::distance};
  bool is_reordered_ = false;
};

/// The error of `favour`, `prefer` and `rank`, to refuse them with 422.
[[nodiscard]] std::optional<Error> check_preferences(const Subscription& subscription,
                                                     const vocabulary::Units& declared = {});

}  // namespace geminga::matching

#endif
