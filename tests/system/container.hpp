// The network side of containers and tunnels on hosts of a lab, without a program that makes containers.
#ifndef GEMINGA_TESTS_SYSTEM_CONTAINER_HPP
#define GEMINGA_TESTS_SYSTEM_CONTAINER_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "support/lab.hpp"

namespace geminga::system {

/// A network namespace of its own on one host, joined as Docker and Podman do it. Requires Lab::can_lose(), since the
/// bridge needs nftables. One for each host and way.
class Container {
 public:
  enum class Way {
    bridge,   ///< behind a bridge of the host, which translates addresses (the default of Docker)
    macvlan,  ///< a second address on the host's own network
  };

  Container(const Lab& lab, std::size_t host, Way way);
  ~Container();
  Container(const Container&) = delete;
  Container& operator=(const Container&) = delete;

  /// How a program is started in it.
  [[nodiscard]] Process::Start on(std::vector<std::string> words) const;
  /// Connects to the daemon in it.
  [[nodiscard]] Talk talk() const;
  /// The address that it has itself.
  [[nodiscard]] std::string address() const;
  /// Leads what comes to this port of its host to the same one in it, as `docker run --publish` does. A bridge only.
  void publish(std::uint16_t port, const std::string& protocol) const;

 private:
  void visit(const std::function<void()>& action) const;
  void join_bridge();
  void join_network();

  const Lab& lab_;
  std::size_t host_;
  Way way_;
  int namespace_ = -1;
};

/// A tunnel between two hosts of a lab, `tun0` on both, with the properties of WireGuard's: point to point, no
/// multicast, an MTU of 1280. A thread carries its packets. Requires namespaces and /dev/net/tun.
class Tunnel {
 public:
  Tunnel(const Lab& lab, std::size_t one, std::size_t other);
  ~Tunnel();
  Tunnel(const Tunnel&) = delete;
  Tunnel& operator=(const Tunnel&) = delete;

  [[nodiscard]] static bool can_be_made();
  /// The address of a host in it: 0 the first, 1 the other.
  [[nodiscard]] static std::string address_of(std::size_t end);

 private:
  void carry() const;

  int ends_[2] = {-1, -1};
  int stop_[2] = {-1, -1};
  std::thread carrier_;
};

}  // namespace geminga::system

#endif
