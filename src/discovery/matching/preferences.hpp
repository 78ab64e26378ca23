// Whom a consumer wants first: `favour`, `prefer` and `rank` of a subscription (PREFERENCES.md).
#ifndef GEMINGA_DISCOVERY_MATCHING_PREFERENCES_HPP
#define GEMINGA_DISCOVERY_MATCHING_PREFERENCES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/matching/arbitration.hpp"
#include "discovery/matching/degree.hpp"
#include "discovery/matching/unit.hpp"
#include "discovery/registry/entry.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// How many wishes `prefer` may have; one more is refused with 422.
inline constexpr std::size_t max_wishes = 4;

/// By what candidates are ranked, in the usual order.
enum class Criterion : std::uint8_t { favour, priority, prefer, degree, distance };
inline constexpr std::size_t criterion_count = 5;

/// One wish of `prefer`: `accuracy asc by 5 cm`.
struct Wish {
  std::string key;
  bool is_descending = false;
  /// A candidate must be better by so much to take an incumbent's place. In the unit's base unit.
  double margin = 0;
  /// That of the margin's unit; nothing where none is stated. Values of another one count as absent.
  std::optional<Dimension> dimension{};
  friend bool operator==(const Wish&, const Wish&) = default;
};

/// A value: copies and moves. Borrows nothing.
class Preferences {
 public:
  /// None: the usual order.
  Preferences() = default;
  /// Reads what a subscription says, with the units that are known beside the table; the error (422) says what cannot
  /// be read.
  [[nodiscard]] static std::expected<Preferences, Error> of(const Subscription& subscription,
                                                            const vocabulary::Units& declared = {});

  /// Where a publication stands in the order that is preferred: one number for each thing that it is ranked by, the
  /// lesser the better, all the same number of them. Empty without preferences. Allocates only with them.
  [[nodiscard]] Score score(const registry::PublicationEntry& publication, const Match& match) const {
    return is_usual() ? Score() : stated_score(publication, match);
  }
  /// By how much each number of a score must be better to push out an incumbent.
  [[nodiscard]] Score margins() const;
  /// By what `better` is ahead of `worse`: "whose rate is 30 against 10". Empty where neither is ahead but by its key.
  [[nodiscard]] std::string lead(const registry::PublicationEntry& better, const Match& its_match,
                                 const registry::PublicationEntry& worse, const Match& others_match) const;

  friend bool operator==(const Preferences&, const Preferences&) = default;

 private:
  [[nodiscard]] bool is_usual() const { return favoured_.empty() && wishes_.empty() && !is_reordered_; }
  [[nodiscard]] Score stated_score(const registry::PublicationEntry& publication, const Match& match) const;
  [[nodiscard]] double favour(const registry::PublicationEntry& publication) const;

  std::vector<ProviderFilter> favoured_;
  std::vector<Wish> wishes_;
  vocabulary::Units declared_;  ///< beside the table; none without wishes
  std::array<Criterion, criterion_count> order_{Criterion::favour, Criterion::priority, Criterion::prefer,
                                                Criterion::degree, Criterion::distance};
  bool is_reordered_ = false;
};

/// Whether a publication is of one of these providers (PARTICIPANT[/PEER], each by id or by name). An empty part stands
/// for any.
[[nodiscard]] bool is_of(const ProviderFilter& provider, const registry::PublicationEntry& publication);

/// Reads `favour`, `prefer` and `rank`; used to refuse bad ones with 422.
[[nodiscard]] std::optional<Error> check_preferences(const Subscription& subscription,
                                                     const vocabulary::Units& declared = {});

}  // namespace geminga::matching

#endif
