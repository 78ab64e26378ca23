// One pair of request and offer, aspect by aspect, in words: what `query why` says of it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_CHECKS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_CHECKS_HPP

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/matching/obstacle.hpp"
#include "discovery/matching/request.hpp"
#include "discovery/participant/clients/answering.hpp"

namespace geminga::participant {

/// A request that is asked about, stated by somebody or by nobody.
struct Asked {
  registry::SubscriptionEntry entry;
  std::shared_ptr<const matching::Request> request;  ///< prepared from it
  bool is_any_mode = false;                          ///< it takes each offer's own
  bool is_living = true;
};

/// What was found out about one aspect.
struct Check {
  std::string_view what;
  matching::Obstacle obstacle = matching::Obstacle::none;
  std::string text;
  std::string mend{};   ///< what would mend it; empty where it is well
  std::string proof{};  ///< the axioms that say so, one a line
  [[nodiscard]] bool is_ok() const { return obstacle == matching::Obstacle::none; }
};

/// How much is searched for a check of the identity.
enum class Depth : std::uint8_t {
  words,   ///< only what is known already
  search,  ///< the axioms that say so, or what is missing: milliseconds
};

/// What a search for the axioms counts as, in entries.
inline constexpr std::size_t cost_of_proof = 2000;
/// Octets of the axioms that are told; those behind are left out.
inline constexpr std::size_t max_proof_bytes = 4096;

/// The identity as a user would write it.
[[nodiscard]] std::string words(const vocabulary::Vocabulary& vocabulary, const Identity& identity);

/// How what is offered is turned into what is asked for, whether that is accepted or not; null where nothing does.
[[nodiscard]] std::shared_ptr<const vocabulary::Chain> chain_of(const matching::Matcher& matcher, const Asked& asked,
                                                                const registry::PublicationEntry& offer);

/// Mode, identity, provider, protocol, condition, and where there are any the scopes and the provider's condition.
[[nodiscard]] std::vector<Check> checks_of(const matching::Matcher& matcher, const Asked& asked,
                                           const registry::PublicationEntry& offer, Depth depth);
/// The first of them that stands in the way: identity, mode, protocol, provider, scope, condition, the provider's
/// condition. Nothing where none does.
[[nodiscard]] const Check* first_obstacle(const std::vector<Check>& checks);
/// What was found about a pair that does not meet, with the sentence of its first obstacle.
[[nodiscard]] Check misfit_of(const matching::Matcher& matcher, const Asked& asked,
                              const registry::PublicationEntry& offer, matching::Obstacle obstacle);

/// Appends `check ok text`, and where they say something `code mend proof`.
void append_check(Line& line, const Check& check);

}  // namespace geminga::participant

#endif
