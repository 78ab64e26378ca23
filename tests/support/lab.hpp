// Hosts on one network, each with a gemingad: in network namespaces if the user may make them, else all on `lo`.
#ifndef GEMINGA_TESTS_SUPPORT_LAB_HPP
#define GEMINGA_TESTS_SUPPORT_LAB_HPP

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "support/process.hpp"
#include "support/talk.hpp"

namespace geminga::system {

/// A lab of anonymous network namespaces: one for each host, joined by a bridge in one more. Each lives as long as a
/// process of the lab does, and the kernel kills those with the test. Nothing has a name, so nothing can be left
/// behind. If namespaces may not be made, each host is a daemon on `lo` with a GCNP port of its own and one UDP port
/// for the lab.
class Lab {
 public:
  explicit Lab(std::size_t hosts);
  ~Lab();
  Lab(const Lab&) = delete;
  Lab& operator=(const Lab&) = delete;

  /// Whether hosts have namespaces; in words: way().
  [[nodiscard]] bool has_namespaces() const;
  [[nodiscard]] std::string way() const;

  /// Starts a gemingad on the host, named `robotN`, with further flags, and waits until it is ready and has read its
  /// ontology: one that takes half a second, as on a busy machine, is read while the daemon already serves.
  void start(std::size_t host, const std::vector<std::string>& flags = {});
  /// The two halves of start(), to start several at once: begins, and waits until it is ready.
  void begin(std::size_t host, const std::vector<std::string>& flags = {});
  void wait_until_ready(std::size_t host);
  /// Starts all hosts, one after the other.
  void start_all(const std::vector<std::string>& flags = {});
  /// The daemon of a host, as it was last started.
  [[nodiscard]] Process& daemon(std::size_t host);
  /// Connects to the daemon of a host.
  [[nodiscard]] Talk talk(std::size_t host, const std::string& address = "127.0.0.1");
  /// Waits until the daemon of a host knows exactly so many participants, itself included.
  [[nodiscard]] bool wait_for_participants(std::size_t host, std::size_t count);

  /// How a program is started on a host, e.g. a second daemon.
  [[nodiscard]] Process::Start on(std::size_t host, std::vector<std::string> words) const;
  /// Calls `action` with the test's own thread on the host: sockets that it makes stay there.
  void visit(std::size_t host, const std::function<void()>& action) const;

  /// Takes the host off the network like a radio that is switched off: its interface is set down. Without namespaces
  /// its daemon is stopped (SIGSTOP) instead, so that nobody hears it and it hears nobody.
  void cut(std::size_t host);
  void join(std::size_t host);

  /// Whether lose() and part() can be called: there are namespaces, and nftables.
  [[nodiscard]] static bool can_lose();
  /// Makes each host miss this share of what the others send, each independently. Call once.
  void lose(double share);

  /// Parts the network between the hosts below `border` and the others, or joins it again. Requires can_lose().
  void part(std::size_t border);
  void heal();

  /// Makes the bridge keep multicasts from the host, as a switch that snoops on IGMP may: it hears nobody, and all hear
  /// it. Only with namespaces.
  void keep_multicasts_from(std::size_t host);

  /// Keeps the multicasts of each of the two from the other, as an access point may: a third host hears both. Requires
  /// can_lose().
  void keep_multicasts_between(std::size_t one, std::size_t other);
  /// Keeps all that the host says from the others: it hears them. Requires can_lose().
  void mute(std::size_t host);

  /// Moves hosts to a further link, with addresses of their own, and joins one more host to it. Links are counted from
  /// 1, and the first one of all hosts is 0. The interface of the one between is wlanN there, N the number of the link.
  /// Call before daemons start. Only with namespaces.
  void add_link(std::size_t between, const std::vector<std::size_t>& hosts);
  /// The address of a host on a link that was added.
  [[nodiscard]] static std::string address_on(std::size_t link, std::size_t host);
  /// Makes a host between two links translate addresses: what it forwards out of `outer` comes from its own address
  /// there, and announcements to that address go to `inside`. Requires can_lose().
  void translate(std::size_t host, const std::string& outer, const std::string& inside);
  /// Gives a host a way to other addresses through another host on its link.
  void route(std::size_t host, const std::string& addresses, const std::string& through);
  /// Takes that way away again.
  void end_route(std::size_t host, const std::string& addresses);

  /// Removes the host's IPv4 address. Only with namespaces.
  void take_ipv4(std::size_t host);

  [[nodiscard]] std::uint16_t gcnp_port(std::size_t host) const;
  [[nodiscard]] std::uint16_t udp_port() const;
  /// The interface that the host's daemon uses.
  [[nodiscard]] std::string interface_of(std::size_t host) const;
  /// The address that others see of the host.
  [[nodiscard]] std::string address_of(std::size_t host) const;

 private:
  struct Host;
  class Namespaces;
  std::unique_ptr<Namespaces> namespaces_;
  std::vector<Host> hosts_;
  std::uint16_t udp_port_ = 4717;
};

}  // namespace geminga::system

#endif
