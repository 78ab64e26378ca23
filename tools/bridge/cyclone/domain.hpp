// The readers and writers of a DDS domain, as Cyclone DDS discovers them.
#ifndef GEMINGA_BRIDGE_CYCLONE_DOMAIN_HPP
#define GEMINGA_BRIDGE_CYCLONE_DOMAIN_HPP

#include <dds/dds.h>

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "bridge/ros/endpoint.hpp"
#include "bridge/team/tally.hpp"

namespace geminga::bridge {

/// Readers and writers that are known at a time. Another one is left out and counted.
inline constexpr std::size_t max_endpoints = 8192;
/// Participants whose host and program are known at a time. Those of others stay unknown.
inline constexpr std::size_t max_dds_participants = 1024;

/// A participant of its own, with readers of the builtin topics only (OMG DDS 1.4, section 2.2.5): it writes and reads
/// no data. Cyclone's threads are its own; functions are called within look() only. Neither copies nor moves.
class Domain {
 public:
  struct Told {
    std::function<void(const std::string& key, const Endpoint&)> found;  ///< or it has changed
    std::function<void(const std::string& key)> gone;
  };

  /// Joins a domain, at most max_domain, by the configuration in $CYCLONEDDS_URI. The error is one line. Borrows the
  /// tally.
  [[nodiscard]] static std::expected<std::unique_ptr<Domain>, std::string> join(std::uint32_t number, Tally& tally,
                                                                                Told told);
  ~Domain();
  Domain(const Domain&) = delete;
  Domain& operator=(const Domain&) = delete;

  /// Takes what was discovered since. Never waits.
  void look();
  [[nodiscard]] std::size_t endpoints() const { return endpoints_.size(); }

 private:
  struct Names {
    std::string host, process;
  };
  struct Known {
    Endpoint endpoint;
    std::string participant;
  };

  Domain(dds_entity_t participant, Tally& tally, Told told);
  void take(const dds_builtintopic_participant_t& sample, bool is_alive);
  void take(const dds_builtintopic_endpoint_t& sample, bool is_alive, bool is_writer);

  dds_entity_t participant_;
  dds_entity_t participants_;
  dds_entity_t writers_;
  dds_entity_t readers_;
  std::string own_;  ///< the key of our participant
  Tally& tally_;
  Told told_;
  std::map<std::string, Names> names_;
  std::map<std::string, Known> endpoints_;
};

}  // namespace geminga::bridge

#endif
