// The firewall's own list of rules, judged for one kind of datagram: announcements that come in or go out.
#ifndef GEMINGA_DOCTOR_FIREWALL_HPP
#define GEMINGA_DOCTOR_FIREWALL_HPP

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::doctor {

enum class Way : std::uint8_t { in, out };

/// An announcement as the firewall sees it: a UDP datagram to a group, of no connection.
struct Crossing {
  Way way = Way::in;
  std::string interface;
  std::string group;  ///< numeric
  std::uint16_t port = 0;
  [[nodiscard]] bool is_ipv6() const { return group.find(':') != std::string::npos; }
};

/// The way of such a datagram that goes out.
enum class Sending : std::uint8_t {
  leaves,
  refused,   ///< by a rule of the firewall
  no_route,  ///< it has no route to the group on that interface
};

/// The judgement of the rules about it.
struct Passage {
  enum class Verdict : std::uint8_t {
    passes,
    dropped,  ///< certainly: `rule` says where
    unknown,  ///< it depends on what is not known here (an address, a set), or the list cannot be read
  };
  Verdict verdict = Verdict::unknown;
  std::string rule{};  ///< the chain, and the number or the text of the rule; empty unless it is dropped
};

/// By the answer of `nft -j list ruleset` (libnftables-json(5)).
[[nodiscard]] Passage judge_nft(std::string_view ruleset, const Crossing& crossing);
/// By the answer of `iptables-save`, or of `ip6tables-save` for IPv6.
[[nodiscard]] Passage judge_iptables(std::string_view rules, const Crossing& crossing);

/// Whether a condition of a rule holds.
enum class Truth : std::uint8_t { no, yes, unknown };
[[nodiscard]] constexpr Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::unknown;
}
[[nodiscard]] constexpr Truth negated(Truth truth) {
  if (truth == Truth::unknown) return truth;
  return truth == Truth::yes ? Truth::no : Truth::yes;
}
[[nodiscard]] constexpr Truth truth_of(bool holds) { return holds ? Truth::yes : Truth::no; }
/// Whether the address is in `network`, which is an address with or without `/LENGTH`. Unknown where it is neither.
[[nodiscard]] Truth is_in_network(const std::string& address, std::string_view network);

/// One rule, with its conditions judged for the crossing.
struct FirewallRule {
  enum class Action : std::uint8_t { goes_on, accept, drop, jump, go_to, returns, unknown };
  Truth applies = Truth::yes;
  Action action = Action::goes_on;
  std::string target{};  ///< of a jump
  std::string text{};
};

struct FirewallChain {
  std::string name;      ///< unique in the list
  bool is_base = false;  ///< the kernel sends the crossing through it
  bool drops = false;    ///< by its policy
  std::vector<FirewallRule> rules{};
};

/// Sends the crossing through all base chains: what one of them certainly drops is dropped.
[[nodiscard]] Passage walk(const std::vector<FirewallChain>& chains);

}  // namespace geminga::doctor

#endif
