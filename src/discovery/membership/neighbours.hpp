// The participants that are known, as everybody but the table sees them.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOURS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOURS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "discovery/membership/records.hpp"

namespace geminga::membership {

/// Reads the records of the table and changes nothing.
class Neighbours {
 public:
  explicit Neighbours(const Records& records) : records_(records) {}

  [[nodiscard]] std::size_t size() const { return records_.size(); }
  [[nodiscard]] bool is_known(ParticipantId id) const { return records_.record(id) != nullptr; }
  [[nodiscard]] std::optional<Neighbour> find(ParticipantId id) const;
  /// In ascending order of identifier.
  void for_each(const std::function<void(const Neighbour&)>& visit) const;
  /// When a datagram last proved that a known participant still offers and asks for what was last heard of it.
  [[nodiscard]] std::optional<base::Instant> affirmed(ParticipantId id) const;
  /// Counts how often a participant came or went, or changed its name or ontology. The same number means the same
  /// participants with the same names and ontologies.
  [[nodiscard]] std::uint64_t roster() const { return records_.roster(); }
  /// The share of all participants' last datagrams that was lost, in [0, 1); nothing: too few were heard.
  [[nodiscard]] std::optional<double> loss() const { return records_.loss(); }

  /// The ways to a known participant; nothing: it is unknown.
  [[nodiscard]] std::optional<Reach> reach(ParticipantId id) const;
  /// The ways to each participant, in ascending order of identifier.
  void for_each_reach(const std::function<void(const Reach&)>& visit) const;
  /// Whether a known participant is heard by ourselves, so that no relay is needed.
  [[nodiscard]] bool is_heard_directly(ParticipantId id, base::Instant now) const;

 private:
  const Records& records_;
};

}  // namespace geminga::membership

#endif
