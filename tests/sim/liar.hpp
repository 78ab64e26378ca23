// Somebody on the simulated link who hears everything and says what others would: the attacker of the liar scenarios.
#ifndef GEMINGA_TESTS_SIM_LIAR_HPP
#define GEMINGA_TESTS_SIM_LIAR_HPP

#include <map>
#include <string>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// Needs no secret: what it says is made of what it has heard. It may use any source address.
class Liar {
 public:
  /// Listens to `world` from now on, instead of anybody who did before.
  explicit Liar(World& world);

  [[nodiscard]] bool has_heard(const Host& host) const { return states_.contains(host.name()); }
  /// The last state that this host has announced, a part of it as it was sent.
  [[nodiscard]] announcement::Announcement last_state(const Host& host) const { return states_.at(host.name()); }
  /// The last presence that this host has sent.
  [[nodiscard]] announcement::Announcement last_presence(const Host& host) const { return presences_.at(host.name()); }
  [[nodiscard]] static std::string address_of(const Host& host) { return host.ports().front().address; }

  /// Says it to everybody, from a source address.
  void say(const announcement::Announcement& announcement, const std::string& source);
  /// Everything that this host has said so far, again.
  void replay(const Host& host, const std::string& source);

 private:
  World& world_;
  std::map<std::string, announcement::Announcement> states_;  ///< by the name of the host
  std::map<std::string, announcement::Announcement> presences_;
  std::map<std::string, std::vector<std::string>> datagrams_;
};

}  // namespace geminga::sim

#endif
