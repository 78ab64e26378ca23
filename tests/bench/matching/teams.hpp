// Teams of one size: those who ask, and those who offer.
#ifndef GEMINGA_TESTS_BENCH_MATCHING_TEAMS_HPP
#define GEMINGA_TESTS_BENCH_MATCHING_TEAMS_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "bench/matching/tree.hpp"
#include "discovery/matching/matcher.hpp"

namespace geminga::matching {

/// How many services or consumers belong to the request or service that is measured.
inline constexpr std::uint32_t answers = 10;
/// What exact requests ask for.
[[nodiscard]] Identity rare_text();

[[nodiscard]] Identity identity(std::uint32_t of_class);
[[nodiscard]] registry::PublicationEntry service(std::uint32_t number, Identity identity);
/// Of a peer of our own.
[[nodiscard]] registry::SubscriptionEntry wish(std::uint32_t number, Identity identity);

/// Standing requests of local peers, of which a few want the rare class, by whatever name above it.
struct Consumers {
  explicit Consumers(std::uint32_t size);
  Matcher matcher;
};

/// Standing requests of local peers for whatever is not the rare class.
struct Strangers {
  explicit Strangers(std::uint32_t size);
  Matcher matcher;
};

/// Services of a team, of which a few are of the rare class, and a few have the rare text.
struct Providers {
  explicit Providers(std::uint32_t size);
  Matcher matcher;
  std::vector<registry::PublicationEntry> entries;
};

/// The team of this size, built when it is first asked for.
template <typename Team>
Team& team(std::int64_t size) {
  static std::map<std::int64_t, std::unique_ptr<Team>> teams;
  auto& one = teams[size];
  if (!one) one = std::make_unique<Team>(static_cast<std::uint32_t>(size));
  return *one;
}

}  // namespace geminga::matching

#endif
