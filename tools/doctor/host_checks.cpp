#include <algorithm>

#include "doctor/checks.hpp"

namespace geminga::doctor {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_interface(const HostInterface& interface, Findings& findings) {
  if (interface.saves_power) {
    findings.push_back({Severity::risk, "wifi_power_save",
                        "The radio of " + interface.name +
                            " sleeps between beacons, and access points keep or drop "
                            "multicasts for it.",
                        "`iw dev " + interface.name + " get power_save` says on", "Switch its power save off.",
                        "iw dev " + interface.name + " set power_save off"});
  }
  if (interface.mtu != 0 && interface.mtu < least_mtu) {
    findings.push_back({Severity::failure, "mtu_small",
                        "Packets on " + interface.name + " hold " + std::to_string(interface.mtu) +
                            " octets. Announcements need " + std::to_string(least_mtu) + ", and larger ones are lost.",
                        "the MTU of the interface", "Raise it to 1280 at least.",
                        "ip link set " + interface.name + " mtu " + std::to_string(least_mtu)});
  }
}

}  // namespace

Findings check_host(const Host& host) {
  Findings findings;
  std::vector<std::string> down;
  bool can_speak = false;
  for (const HostInterface& interface : host.interfaces) {
    if (interface.is_loopback) continue;
    const bool is_usable =
        interface.is_up && interface.has_carrier && interface.can_multicast && !interface.addresses.empty();
    can_speak = can_speak || is_usable;
    if (!is_usable) {
      down.push_back(interface.name + (!interface.is_up           ? " (down)"
                                       : !interface.has_carrier   ? " (no cable, or no access point)"
                                       : !interface.can_multicast ? " (no multicast)"
                                                                  : " (no address)"));
    } else {
      check_interface(interface, findings);
    }
  }
  if (!can_speak) {
    findings.push_back(
        {Severity::failure, "no_interface",
         "No network interface can be used: one has to be up and connected, with an address and multicast.",
         down.empty() ? "there is none but the loopback" : joined(down),
         "Connect this host. For daemons of one host alone, start them with --interface lo.",
         down.empty() ? "" : "ip link set " + down.front().substr(0, down.front().find(' ')) + " up"});
  }
  if (host.daemons.size() > 1) {
    std::string seen;
    for (const RunningDaemon& daemon : host.daemons)
      seen += (seen.empty() ? "process " : "; process ") + std::to_string(daemon.process) + ": " + daemon.command;
    findings.push_back(
        {Severity::risk, "two_daemons",
         "More than one gemingad runs on this host: programs of one do not see those of the other as local.", seen,
         "Stop all but one.", "kill " + std::to_string(host.daemons.back().process)});
  }
  return findings;
}

Findings check_absent_daemon(const Host& host, const ClientError& error, std::string_view connect) {
  if (host.daemons.empty()) {
    return {{Severity::failure, "daemon_away", "No gemingad runs on this host.", error.text, "Start it.",
             host.has_packaged_socket ? "systemctl start gemingad" : "gemingad &"}};
  }
  if (!host.may_use_packaged_socket) {
    return {{Severity::failure, "no_permission", "User " + host.user + " may not connect to the daemon's socket.",
             "/run/geminga/gcnp is there and closed to this user",
             "Add the user to the group geminga, and log in again.", "adduser " + host.user + " geminga"}};
  }
  return {
      {Severity::failure, "daemon_silent",
       "A gemingad runs on this host and does not answer at " +
           (connect.empty() ? std::string("its usual address") : std::string(connect)) + '.',
       error.text + "; process " + std::to_string(host.daemons.front().process) + ": " + host.daemons.front().command,
       "Name its address by --connect or GEMINGA_CONNECT.",
       host.has_packaged_socket ? "geminga-query --connect /run/geminga/gcnp doctor" : ""}};
}

void sort_by_severity(Findings& findings) { std::ranges::stable_sort(findings, {}, &Finding::severity); }

}  // namespace geminga::doctor
