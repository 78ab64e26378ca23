// Parts that the lines of several answers have in common.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_LINES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_LINES_HPP

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "discovery/gcnp/parameters.hpp"
#include "discovery/matching/matcher.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/participant/clients/answering.hpp"
#include "discovery/participant/knowledge/resolver.hpp"

namespace geminga::participant {

/// Octets of the reason why an expression has no place.
inline constexpr std::size_t max_problem_bytes = 400;

inline void append_flag(Line& line, std::string_view key, bool value) { append(line, key, value ? "1" : "0"); }

/// The identity as a user would write it.
[[nodiscard]] std::string words(const vocabulary::Vocabulary& vocabulary, const Identity& identity);
/// Seconds with three decimals; a negative duration counts as 0.
[[nodiscard]] std::string seconds(base::Duration duration);
/// Three decimals.
[[nodiscard]] std::string decimal(double number);

/// The time since an entry was last heard; 0 for one of our own.
template <typename Entry>
[[nodiscard]] std::string age(const registry::Table<Entry>& known, const membership::Neighbours& neighbours,
                              base::Instant now, const Entry& entry) {
  if (entry.is_local) return "0.000";
  const auto* stored = known.find(entry.key);
  const base::Instant updated = stored == nullptr ? base::Instant() : stored->updated;
  return seconds(now - std::max(updated, neighbours.affirmed(entry.key.participant).value_or(updated)));
}

/// `service provider name participant_name`, and of a request `subscription consumer name participant_name`.
void append_party(Line& line, const registry::PublicationEntry& entry);
void append_party(Line& line, const registry::SubscriptionEntry& entry);
/// `mode address port protocol priority`, as in events.
void append_channel(Line& line, const Publication& publication);

/// How a line tells names of the ontology.
enum class Names : std::uint8_t {
  with_prefixes,
  full,  ///< as IRIs in angle brackets
};

/// The work of comparing two expressions, in entries.
inline constexpr std::size_t cost_of_compared_expressions = 16;

/// Decides which entries pass a FILTER. Its names are resolved by the vocabulary in force when it is made.
class Sieve {
 public:
  [[nodiscard]] static std::expected<Sieve, Error> make(Resolver& resolver, const gcnp::ListFilter& filter);
  /// Whether an entry by this peer, with this identity and mode, is let through. The reasoner compares two expressions.
  [[nodiscard]] bool passes(const vocabulary::Vocabulary& vocabulary, const ServiceKey& key,
                            const std::string& participant_name, const std::string& peer_name, const Identity& identity,
                            ChannelMode mode) const;
  [[nodiscard]] Names names() const { return filter_.with_iris ? Names::full : Names::with_prefixes; }
  /// The work that comparing with an identity takes beside looking at one entry, in entries.
  [[nodiscard]] std::size_t cost_of(const Identity& identity) const {
    return place_ && has_expression(identity) ? cost_of_compared_expressions : 0;
  }
  /// Whether the finished line is let through.
  [[nodiscard]] bool passes(const Line& line) const;

 private:
  [[nodiscard]] bool is_wanted(const vocabulary::Vocabulary& vocabulary, const Identity& identity) const;

  Sieve(const Resolver& resolver, gcnp::ListFilter filter) : resolver_(&resolver), filter_(std::move(filter)) {}

  const Resolver* resolver_;
  gcnp::ListFilter filter_;
  std::optional<Identity> identity_;
  Expressions::Place place_;  ///< of the identity where it is an expression
};

}  // namespace geminga::participant

#endif
