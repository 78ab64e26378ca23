// Checks of one pair of request and offer, aspect by aspect, in the words of `query why`.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_CHECKS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_CHECKS_HPP

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/meeting/obstacle.hpp"
#include "discovery/matching/meeting/request.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/participant/clients/answering.hpp"

namespace geminga::participant {

/// A request that a query is about: one that a peer has stated, or a hypothetical one.
struct Asked {
  registry::SubscriptionEntry entry;
  std::shared_ptr<const matching::Request> request;  ///< prepared from it
  bool is_any_mode = false;                          ///< it takes each offer's own
  bool is_living = true;
};

/// The finding about one aspect.
struct Check {
  std::string_view what;
  matching::Obstacle obstacle = matching::Obstacle::none;
  std::string text;
  std::string mend{};                               ///< advice; empty where the aspect is ok
  std::string proof{};                              ///< the axioms that prove it, one a line
  std::optional<vocabulary::NearMisses> missing{};  ///< of concepts that do not fit, where they were compared
  [[nodiscard]] bool is_ok() const { return obstacle == matching::Obstacle::none; }
};

/// The effort for a check of the identity.
enum class Depth : std::uint8_t {
  words,   ///< nothing is searched for
  search,  ///< the axioms that prove it, or what is missing; takes milliseconds
};

/// The work of a search for axioms, in entries.
inline constexpr std::size_t cost_of_proof = 2000;
/// Octets of the axioms that are told; the rest is left out.
inline constexpr std::size_t max_proof_bytes = 4096;

/// The chain that converts an offer into what is asked for, whether that is accepted or not; null where there is none.
[[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain_of(const matching::Examination& examination,
                                                                const Asked& asked,
                                                                const registry::PublicationEntry& offer);

/// Checks mode, identity, provider, protocol and condition, and, where there are any, the scopes, the provider's
/// condition, the signature, and an address that cannot be reached.
[[nodiscard]] std::vector<Check> checks_of(const matching::Matcher& matcher, const membership::Neighbours& neighbours,
                                           const Asked& asked, const registry::PublicationEntry& offer, Depth depth);
/// The first failed check, in the order identity, mode, protocol, provider, scope, condition, the provider's condition,
/// signature, reach, arbitration; null where none failed.
[[nodiscard]] const Check* first_obstacle(const std::vector<Check>& checks);
/// The check that fails first for a pair that does not meet.
[[nodiscard]] Check misfit_of(const matching::Matcher& matcher, const membership::Neighbours& neighbours,
                              const Asked& asked, const registry::PublicationEntry& offer, matching::Obstacle obstacle);

/// Appends `check ok text`, those of `code mend proof` that are not empty, and what is missing.
void append_check(Line& line, const Check& check);

}  // namespace geminga::participant

#endif
