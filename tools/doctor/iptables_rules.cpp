// iptables' own list, as iptables-save(8) writes it.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "doctor/firewall.hpp"

namespace geminga::doctor {
namespace {

/// The words of a line; blanks within quotes do not part them.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ' ' && !is_quoted) {
      if (!words.back().empty()) words.emplace_back();
    } else if (c != '"') {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

bool is_in_ports(std::string_view list, std::uint16_t port) {
  std::istringstream ports{std::string(list)};
  for (std::string one; std::getline(ports, one, ',');) {
    const std::size_t colon = one.find(':');
    const int first = std::atoi(one.c_str());
    const int last = colon == std::string::npos ? first : std::atoi(one.c_str() + colon + 1);
    if (port >= first && port <= last) return true;
  }
  return false;
}

Truth is_interface(std::string_view name, std::string_view ours) {
  if (name.ends_with('+')) return truth_of(ours.starts_with(name.substr(0, name.size() - 1)));
  return truth_of(name == ours);
}

/// Whether the list of states has that of a datagram which belongs to no connection.
Truth has_new(std::string_view states) {
  return truth_of((',' + std::string(states) + ',').find(",NEW,") != std::string::npos);
}

Truth holds(const std::string& option, const std::string& operand, const Crossing& crossing) {
  if (option == "-p") return truth_of(operand == "udp" || operand == "17" || operand == "all");
  if (option == "-i") return crossing.way == Way::in ? is_interface(operand, crossing.interface) : Truth::no;
  if (option == "-o") return crossing.way == Way::out ? is_interface(operand, crossing.interface) : Truth::no;
  if (option == "-d") return is_in_network(crossing.group, operand);
  if (option == "--dport" || option == "--dports") return truth_of(is_in_ports(operand, crossing.port));
  if (option == "--state" || option == "--ctstate") return has_new(operand);
  if (option == "--pkt-type") return truth_of(operand == "multicast");
  if (option == "-m" || option == "--comment" || option == "--reject-with" || option == "--log-prefix")
    return Truth::yes;
  return Truth::unknown;
}

FirewallRule rule_of(const std::vector<std::string>& words, const Crossing& crossing, const std::string& table) {
  using Action = FirewallRule::Action;
  FirewallRule rule;
  bool is_negated = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    rule.text += (i == 0 ? "" : " ") + words[i];
    if (i < 2) continue;  // -A CHAIN
    if (words[i] == "!") {
      is_negated = true;
      continue;
    }
    const std::string operand = i + 1 < words.size() && !words[i + 1].starts_with('-') ? words[i + 1] : "";
    if (words[i] == "-j" || words[i] == "-g") {
      if (operand == "ACCEPT") {
        rule.action = Action::accept;
      } else if (operand == "DROP" || operand == "REJECT") {
        rule.action = Action::drop;
      } else if (operand == "RETURN") {
        rule.action = Action::returns;
      } else if (operand == "NFQUEUE" || operand == "QUEUE") {
        rule.action = Action::unknown;
      } else {
        rule.action = words[i] == "-j" ? Action::jump : Action::go_to;
        rule.target = table + ' ' + operand;
      }
    } else if (words[i].starts_with('-')) {
      const Truth truth = holds(words[i], operand, crossing);
      rule.applies = both(rule.applies, is_negated ? negated(truth) : truth);
      is_negated = false;
    }
  }
  return rule;
}

bool is_crossed(std::string_view chain, Way way) {
  return way == Way::in ? chain == "PREROUTING" || chain == "INPUT" : chain == "OUTPUT" || chain == "POSTROUTING";
}

}  // namespace

Passage judge_iptables(std::string_view rules, const Crossing& crossing) {
  std::vector<FirewallChain> chains;
  std::string table;
  std::istringstream lines{std::string(rules)};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('*')) {
      table = line.substr(1);
      continue;
    }
    const std::vector<std::string> words = words_of(line);
    if (table == "nat" || words.size() < 2) continue;  // multicasts are not translated
    if (words[0].starts_with(':')) {
      const std::string name = words[0].substr(1);
      chains.push_back(
          {.name = table + ' ' + name, .is_base = is_crossed(name, crossing.way), .drops = words[1] == "DROP"});
    } else if (words[0] == "-A") {
      const auto chain = std::ranges::find(chains, table + ' ' + words[1], &FirewallChain::name);
      if (chain != chains.end()) chain->rules.push_back(rule_of(words, crossing, table));
    }
  }
  // A target that is no chain of the list (LOG, MARK, ...) lets the datagram go on.
  for (FirewallChain& chain : chains) {
    for (FirewallRule& rule : chain.rules) {
      const bool is_known = std::ranges::find(chains, rule.target, &FirewallChain::name) != chains.end();
      if (rule.action == FirewallRule::Action::jump && !is_known) rule.action = FirewallRule::Action::goes_on;
    }
  }
  return chains.empty() ? Passage{} : walk(chains);
}

}  // namespace geminga::doctor
