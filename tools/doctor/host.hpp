// This host as its kernel describes it: interfaces, daemons, and the socket for local programs.
#ifndef GEMINGA_DOCTOR_HOST_HPP
#define GEMINGA_DOCTOR_HOST_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace geminga::doctor {

struct HostInterface {
  std::string name;
  bool is_up = false;
  bool has_carrier = false;  ///< a cable or a radio is connected
  bool can_multicast = false;
  bool is_loopback = false;
  bool is_wireless = false;
  bool saves_power = false;  ///< the radio sleeps between beacons and may miss multicasts
  std::size_t mtu = 0;       ///< octets; 0: unknown
  bool is_strict = false;    ///< rp_filter=1: takes IPv4 datagrams only where the route back leads through it
  std::vector<std::string> addresses;
  std::vector<std::string> networks{};  ///< of its IPv4 addresses: `10.0.0.1/24`
};

/// A file with a key of the team.
struct KeyFile {
  std::string path;
  unsigned mode = 0;  ///< its permissions
};

/// A gemingad in the network namespace of this process.
struct RunningDaemon {
  int process = 0;
  std::string command;  ///< its arguments, separated by blanks
};

struct Host {
  std::vector<HostInterface> interfaces;
  std::vector<RunningDaemon> daemons;
  bool has_packaged_socket = false;     ///< /run/geminga/gcnp is there
  bool may_use_packaged_socket = true;  ///< this user may connect to it
  std::string user;                     ///< of this process
  std::vector<KeyFile> keys{};          ///< those that daemons are started with, and those in /etc/geminga
  /// The firewall's own lists; empty where it is not there, or this user may not read it.
  std::string nft_ruleset{};
  std::string iptables_rules{};
  std::string ip6tables_rules{};
};

/// Asks the kernel, and, where they are installed, `iw` for the power save of radios, and `nft`, `iptables-save` and
/// `ip6tables-save` for the firewall. Writes nothing.
[[nodiscard]] Host look_at_host();

}  // namespace geminga::doctor

#endif
