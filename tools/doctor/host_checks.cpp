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

/// Whether the networks have addresses in common.
bool overlap(const std::string& a, const std::string& b) {
  const auto address = [](const std::string& network) { return network.substr(0, network.find('/')); };
  return is_in_network(address(a), b) == Truth::yes || is_in_network(address(b), a) == Truth::yes;
}

/// Two interfaces in one network: routes back lead through one of them, and a strict kernel drops what comes in on the
/// other (RFC 3704, section 2.2).
void check_return_paths(const Host& host, Findings& findings) {
  for (const HostInterface& one : host.interfaces) {
    if (one.is_loopback || !one.is_up || !one.has_carrier || !one.is_strict) continue;
    for (const HostInterface& other : host.interfaces) {
      if (&other == &one || other.is_loopback || !other.is_up || !other.has_carrier) continue;
      const bool is_shared = std::ranges::any_of(one.networks, [&](const std::string& network) {
        return std::ranges::any_of(other.networks, [&](const std::string& more) { return overlap(network, more); });
      });
      if (!is_shared) continue;
      findings.push_back(
          {Severity::risk, "rp_filter_strict",
           one.name + " and " + other.name + " are in one network, and the kernel takes a datagram only " +
               "on the interface that the route back leads through: what comes in on the other is lost.",
           "rp_filter is 1 for " + one.name, "Make it loose.", "sysctl -w net.ipv4.conf.all.rp_filter=2"});
      return;
    }
  }
}

void check_keys(const Host& host, Findings& findings) {
  constexpr unsigned of_others = 077;
  for (const KeyFile& key : host.keys) {
    if ((key.mode & of_others) == 0) continue;
    findings.push_back({Severity::failure, "key_readable",
                        "Others than its owner may read or write a key of the team; the daemon refuses such a file.",
                        key.path + " has further permissions than 600", "Take them away, and reload the daemon.",
                        "chmod 600 " + key.path});
  }
}

}  // namespace

Findings check_host(const Host& host, bool uses_loopback) {
  Findings findings;
  std::vector<std::string> down;
  bool can_speak = uses_loopback;
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
  check_return_paths(host, findings);
  check_keys(host, findings);
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
  const std::string process = std::to_string(host.daemons.front().process);
  if (error.kind == ClientError::Kind::timed_out) {
    return {{Severity::failure, "daemon_silent", "A gemingad runs on this host, and does not answer in time.",
             error.text + " Process " + process + ": " + host.daemons.front().command,
             "See whether it is stopped (state T), or busy.", "ps -o pid,stat,time,args -p " + process}};
  }
  return {{Severity::failure, "daemon_silent",
           "A gemingad runs on this host and does not answer at " +
               (connect.empty() ? std::string("its usual address") : std::string(connect)) + '.',
           error.text + "; process " + process + ": " + host.daemons.front().command,
           "Name its address by --connect or GEMINGA_CONNECT.",
           host.has_packaged_socket ? "geminga-query --connect /run/geminga/gcnp doctor" : ""}};
}

void drop_consequences(Findings& findings) {
  struct Consequence {
    std::string_view code;
    std::vector<std::string_view> causes;
  };
  const Consequence consequences[] = {
      {"alone",
       {"firewall_in", "firewall_out", "no_multicast_route", "no_interface", "nowhere_heard", "mtu_small",
        "other_group", "unsealed_heard", "other_key", "key_missing", "other_version", "off_link", "other_port",
        "other_multicast", "one_family"}},
      {"deaf_to_us", {"firewall_out", "no_multicast_route"}},
      {"nowhere_heard", {"no_interface"}},
      {"ontologies_differ", {"two_teams"}},
      {"other_key", {"key_missing"}},
      {"loss_high", {"flood"}},
  };
  const Findings all = findings;
  const auto is_found = [&](std::string_view code) {
    return std::ranges::find(all, code, &Finding::code) != all.end();
  };
  for (const Consequence& one : consequences) {
    if (std::ranges::any_of(one.causes, is_found))
      std::erase_if(findings, [&](const Finding& finding) { return finding.code == one.code; });
  }
}

void sort_by_severity(Findings& findings) { std::ranges::stable_sort(findings, {}, &Finding::severity); }

}  // namespace geminga::doctor
