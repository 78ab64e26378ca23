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
  std::vector<std::string> addresses;
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
};

/// Asks the kernel, and `iw` for the power save of radios where it is installed. Reads /proc and /sys and writes
/// nothing.
[[nodiscard]] Host look_at_host();

}  // namespace geminga::doctor

#endif
