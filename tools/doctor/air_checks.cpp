// Checks of the way between this host and the link: firewall, addresses, and announcements that the daemon does not
// take.
#include <algorithm>
#include <map>
#include <set>

#include "doctor/checks.hpp"
#include "doctor/listening.hpp"

namespace geminga::doctor {
namespace {

std::uint16_t port_of(const Answers& answers) {
  const double port = number(answers.status["port"]);
  return port >= 1 && port <= 65535 ? static_cast<std::uint16_t>(port) : usual_port;
}

bool is_ipv6(std::string_view address) { return address.find(':') != std::string_view::npos; }

/// The groups that the daemon sends to on an interface: of IPv4 where it has an address of it.
std::vector<std::string> groups_on(const Record& interface, const Answers& answers) {
  const std::vector<std::string> addresses = parts_of(interface["addresses"]);
  const bool speaks_ipv6 = std::ranges::all_of(addresses, [](const std::string& one) { return is_ipv6(one); });
  std::vector<std::string> groups = parts_of(answers.status["multicast"]);
  std::erase_if(groups, [&](const std::string& group) { return is_ipv6(group) != speaks_ipv6; });
  return groups;
}

/// The rule of one of the firewall's lists that drops it; empty where none does.
std::string dropping_rule(const Host& host, const Crossing& crossing) {
  const std::string& iptables = crossing.is_ipv6() ? host.ip6tables_rules : host.iptables_rules;
  for (const auto& [tool, passage] : {std::pair("nft", judge_nft(host.nft_ruleset, crossing)),
                                      std::pair("iptables", judge_iptables(iptables, crossing))}) {
    if (passage.verdict == Passage::Verdict::dropped) return std::string(tool) + ", " + passage.rule;
  }
  return "";
}

std::string and_also(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

std::string list_command(const std::string& rule) {
  return rule.starts_with("iptables") ? "iptables -S" : "nft list ruleset";
}

}  // namespace

Habits habits_of(const Answers& answers) {
  return {.port = port_of(answers), .groups = parts_of(answers.status["multicast"])};
}

Findings check_firewall(const Host& host, const Answers& answers, TryToSend try_to_send) {
  Findings findings;
  const std::uint16_t port = port_of(answers);
  const std::string word = "UDP port " + std::to_string(port);
  const double patience = quiet_intervals * std::max(number(answers.status["interval"]), 0.05);
  for (const Record& interface : answers.interfaces) {
    const std::string name(interface["name"]);
    if (interface["ignored"] == "1") continue;
    std::string rule_out;
    std::string rule_in;
    bool refuses = false;
    bool has_route = true;
    for (const std::string& group : groups_on(interface, answers)) {
      const Crossing out{.way = Way::out, .interface = name, .group = group, .port = port};
      Crossing in = out;
      in.way = Way::in;
      const Sending sending = try_to_send(out);
      refuses = refuses || sending == Sending::refused;
      has_route = has_route && sending != Sending::no_route;
      if (rule_out.empty()) rule_out = dropping_rule(host, out);
      if (rule_in.empty()) rule_in = dropping_rule(host, in);
    }
    if (refuses || !rule_out.empty()) {
      findings.push_back(
          {Severity::failure, "firewall_out",
           "The firewall of this host drops the announcements that go out on " + name + ": nobody hears this host.",
           and_also(refuses ? "the kernel refuses a datagram to " + word : "", rule_out), "Let " + word + " out.",
           list_command(rule_out)});
    }
    // A datagram that does not go out does not come back either.
    const bool is_quiet = !refuses && has_route && rule_out.empty() && number(interface["quiet"]) > patience;
    if (is_quiet || !rule_in.empty()) {
      const std::string quiet = "for " + std::string(interface["quiet"]) +
                                " s nothing came in, not even this host's own multicasts (interfaces: quiet)";
      findings.push_back({Severity::failure, "firewall_in",
                          "Something on this host, most likely its firewall, drops the announcements that come in on " +
                              name + ": it hears nobody.",
                          and_also(is_quiet ? quiet : "", rule_in), "Let " + word + " in.", list_command(rule_in)});
    }
  }
  return findings;
}

namespace {

/// `is_all`: all addresses of the interface are of the family of the group.
Finding no_multicast_route(const std::string& interface, const std::string& group, bool is_all) {
  const std::string family = is_ipv6(group) ? "-6 " : "";
  return {is_all ? Severity::failure : Severity::risk,
          "no_multicast_route",
          "This host has no route to the group " + group + " on " + interface +
              ": nobody hears it there by that family of IP.",
          "the kernel says so when a datagram is sent there",
          "Give the interface its route for multicast back.",
          "ip " + family + "route add multicast " + (is_ipv6(group) ? "ff00::/8" : "224.0.0.0/4") + " dev " +
              interface + (is_ipv6(group) ? " table local" : "")};
}

/// `path`: the relays on the way to a participant to which there is no route; empty: none.
Finding address_unreachable(const std::string& participant, const std::string& address, const std::string& reason,
                            const std::string& path) {
  const std::string what = "Services of " + participant + " are announced at " + address +
                           ", which cannot be reached from here: " + reason + '.';
  const std::string command = "ip route get " + address;
  if (path.empty())
    return {Severity::failure,
            "address_unreachable",
            what,
            "services: address",
            "Have that host announce another address (announce-address), or add a route.",
            command};
  return {Severity::failure,
          "address_unreachable",
          what + " It is heard through " + path + ", and a relay passes on announcements, no data.",
          "services: address; participants: path=" + path,
          "Give this host a route there and that host one back, for example by way of the relay, which then has to "
          "forward IP.",
          command};
}

}  // namespace

Findings check_multicast_routes(const Answers& answers, TryToSend try_to_send) {
  Findings findings;
  const std::uint16_t port = port_of(answers);
  for (const Record& interface : answers.interfaces) {
    const std::string name(interface["name"]);
    if (interface["ignored"] == "1") continue;
    const std::vector<std::string> addresses = parts_of(interface["addresses"]);
    for (const std::string& group : parts_of(answers.status["multicast"])) {
      const auto same = [&](const std::string& one) { return is_ipv6(one) == is_ipv6(group); };
      const Crossing out{.way = Way::out, .interface = name, .group = group, .port = port};
      const bool is_all = std::ranges::all_of(addresses, same);
      if (interface["loopback"] == "1" && !is_all) continue;  // it is never given routes, and needs one family alone
      if (std::ranges::none_of(addresses, same) || try_to_send(out) != Sending::no_route) continue;
      findings.push_back(no_multicast_route(name, group, is_all));
    }
  }
  return findings;
}

Findings check_addresses(const Host& host, const Answers& answers, bool (*has_route)(const std::string&)) {
  std::set<std::string> ours;
  for (const HostInterface& interface : host.interfaces)
    ours.insert(interface.addresses.begin(), interface.addresses.end());
  std::map<std::string, std::string> reasons;  // by address; empty: it can be reached
  const auto reason_of = [&](const std::string& address) -> const std::string& {
    const auto [entry, is_new] = reasons.try_emplace(address);
    if (is_new && ours.contains(address)) entry->second = "it is an address of this host, too";
    if (is_new && entry->second.empty() && !has_route(address)) entry->second = "there is no route to it";
    return entry->second;
  };
  Findings findings;
  std::set<std::string> told;
  // The daemon alone hears from where words come.
  const auto translated = [](const Record& service, const Record* provider) {
    if (service["reachable"] != "no" || provider == nullptr) return std::string();
    const std::string observed((*provider)["observed"]);
    return observed.empty()
               ? "the daemon has no route to it"
               : "the words of its host come from " + observed + ", so that a translation of addresses lies between";
  };
  const auto participant_of = [&](const Record& service) -> const Record* {
    const std::string_view provider = service["provider"];
    const std::string_view id = provider.substr(0, provider.find('/'));
    const auto found = std::ranges::find_if(answers.participants, [&](const Record& one) { return one["id"] == id; });
    return found == answers.participants.end() ? nullptr : &*found;
  };
  for (const Record& service : answers.services) {
    const std::string address(service["address"]);
    if (service["local"] == "1" || address.empty() || address.find('%') != std::string::npos) continue;
    const Record* provider = participant_of(service);
    std::string reason = reason_of(address);
    const bool has_way = reason.empty();
    if (has_way) reason = translated(service, provider);
    const std::string key = std::string(service["participant_name"]) + ' ' + address;
    if (reason.empty() || !told.insert(key).second) continue;
    if (service["reachable"] == "no") reason += "; consumers here are told of them with reach=any alone";
    const std::string path(has_way || provider == nullptr ? "" : (*provider)["path"]);
    findings.push_back(address_unreachable(std::string(service["participant_name"]), address, reason, path));
  }
  return findings;
}

Findings check_overheard(const Host& host, const Answers& answers, const std::vector<Overheard>& overheard) {
  const std::uint16_t port = port_of(answers);
  const std::vector<std::string> groups = parts_of(answers.status["multicast"]);
  std::set<std::string, std::less<>> known;
  std::set<std::string, std::less<>> ours;
  for (const Record& participant : answers.participants) known.emplace(participant["id"]);
  std::set<std::string> families;
  for (const HostInterface& interface : host.interfaces) {
    for (const std::string& address : interface.addresses) {
      ours.insert(address);
      if (!interface.is_loopback) families.insert(interface.name + (is_ipv6(address) ? " 6" : " 4"));
    }
  }
  std::map<std::string, std::string> sources;  // by code
  const auto add = [&](const std::string& code, const Overheard& one, const std::string& words) {
    std::string& list = sources[code];
    list += (list.empty() ? "" : ", ") + one.source + words + " on " + one.interface;
  };
  for (const Overheard& one : overheard) {
    if (ours.contains(one.source)) continue;
    if (one.port != port) {
      add("other_port", one, " to port " + std::to_string(one.port));
    } else if (std::ranges::find(groups, one.group) == groups.end()) {
      add("other_multicast", one, " to " + one.group);
    } else if (!families.contains(one.interface + (one.is_ipv6() ? " 6" : " 4")) &&
               (one.participant.empty() ? known.size() < 2 : !known.contains(one.participant))) {
      add("one_family", one, "");
    }
  }
  Findings findings;
  const auto say = [&](const std::string& code, Severity severity, const std::string& what, const std::string& remedy,
                       const std::string& command) {
    if (const auto found = sources.find(code); found != sources.end())
      findings.push_back({severity, code, what, "overheard from " + found->second, remedy, command});
  };
  say("other_port", Severity::risk, "Announcements come to another port than " + std::to_string(port) + '.',
      "If those hosts are of this team, give all the same port.", "gemingad --port PORT");
  say("other_multicast", Severity::risk, "Announcements come to a multicast group that this daemon does not hear.",
      "If those hosts are of this team, give all the same multicast.", "gemingad --multicast ADDRESS");
  say("one_family", Severity::failure,
      "A host speaks a family of IP that this host does not have on that interface: they cannot hear each other.",
      "Give this host an address of that family, or that host one of ours.", "ip -br address");
  return findings;
}

}  // namespace geminga::doctor
