// Teams of one size, made of consumers or of providers.
#ifndef GEMINGA_TESTS_BENCH_MATCHING_TEAMS_HPP
#define GEMINGA_TESTS_BENCH_MATCHING_TEAMS_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "bench/matching/tree.hpp"
#include "discovery/matching/matcher.hpp"

namespace geminga::matching {

/// How many services match the measured request, or consumers the measured service.
inline constexpr std::uint32_t answers = 10;
/// The identity that exact requests ask for.
[[nodiscard]] Identity rare_text();

[[nodiscard]] Identity identity(std::uint32_t of_class);
[[nodiscard]] registry::PublicationEntry service(std::uint32_t number, Identity identity);
/// A request of a peer of our own.
[[nodiscard]] registry::SubscriptionEntry wish(std::uint32_t number, Identity identity);

/// Requests of local peers, of which a few ask for the rare class or a class above it.
struct Consumers {
  explicit Consumers(std::uint32_t size);
  Matcher matcher;
};

/// Requests of local peers, none of which asks for the rare class.
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

/// The team of this size, built at the first call.
template <typename Team>
Team& team(std::int64_t size) {
  static std::map<std::int64_t, std::unique_ptr<Team>> teams;
  auto& one = teams[size];
  if (!one) one = std::make_unique<Team>(static_cast<std::uint32_t>(size));
  return *one;
}

}  // namespace geminga::matching

#endif
