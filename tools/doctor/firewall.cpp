#include "doctor/firewall.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace geminga::doctor {
namespace {

/// Deeper jumps than any list has; the kernel allows 16.
constexpr int max_depth = 16;

/// The ends that a walk may come to. Several are possible where a condition is unknown.
struct Ends {
  bool accepts = false;
  bool drops = false;
  bool goes_on = false;  ///< reaches the end of the chain, or returns
  std::string rule{};    ///< the first that may drop

  void add(const Ends& other) {
    accepts = accepts || other.accepts;
    drops = drops || other.drops;
    if (rule.empty()) rule = other.rule;
  }
};

class Walk {
 public:
  explicit Walk(const std::vector<FirewallChain>& chains) : chains_(chains) {}

  Ends through(const FirewallChain& chain, int depth) const {
    Ends ends;
    for (const FirewallRule& rule : chain.rules) {
      if (rule.applies == Truth::no || rule.action == FirewallRule::Action::goes_on) continue;
      const Ends here = by(chain, rule, depth);
      ends.add(here);
      if (rule.applies == Truth::yes && !here.goes_on) return ends;
      if (rule.applies == Truth::yes && rule.action == FirewallRule::Action::returns) break;
    }
    ends.goes_on = true;
    return ends;
  }

 private:
  Ends by(const FirewallChain& chain, const FirewallRule& rule, int depth) const {
    using Action = FirewallRule::Action;
    switch (rule.action) {
      case Action::accept:
        return {.accepts = true};
      case Action::drop:
        return {.drops = true, .rule = chain.name + ": " + rule.text};
      case Action::jump:
      case Action::go_to: {
        const auto target = std::ranges::find(chains_, rule.target, &FirewallChain::name);
        if (target == chains_.end() || depth == max_depth) return unclear();
        Ends ends = through(*target, depth + 1);
        // Behind a chain that was gone to, the policy of the base chain decides, which is not known here.
        if (rule.action == Action::go_to && ends.goes_on) ends.add(unclear());
        return ends;
      }
      case Action::unknown:
        return unclear();
      case Action::goes_on:
      case Action::returns:
        break;
    }
    return {.goes_on = true};
  }

  static Ends unclear() { return {.accepts = true, .drops = true, .goes_on = true}; }

  const std::vector<FirewallChain>& chains_;
};

struct Octets {
  std::array<unsigned char, 16> octets{};
  std::size_t size = 0;
};

Octets octets_of(const std::string& address) {
  Octets read;
  if (::inet_pton(AF_INET, address.c_str(), read.octets.data()) == 1) read.size = 4;
  if (read.size == 0 && ::inet_pton(AF_INET6, address.c_str(), read.octets.data()) == 1) read.size = 16;
  return read;
}

}  // namespace

Truth is_in_network(const std::string& address, std::string_view network) {
  const std::size_t slash = network.find('/');
  const Octets member = octets_of(address);
  const Octets base = octets_of(std::string(network.substr(0, slash)));
  if (member.size == 0 || base.size == 0) return Truth::unknown;
  if (member.size != base.size) return Truth::no;
  std::size_t length = 8 * base.size;
  if (slash != std::string_view::npos) {
    const std::string_view digits = network.substr(slash + 1);
    const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), length);
    if (error != std::errc() || rest != digits.data() + digits.size() || length > 8 * base.size) return Truth::unknown;
  }
  for (std::size_t bit = 0; bit < length; ++bit) {
    const unsigned mask = 0x80U >> (bit % 8);
    if ((member.octets.at(bit / 8) & mask) != (base.octets.at(bit / 8) & mask)) return Truth::no;
  }
  return Truth::yes;
}

Passage walk(const std::vector<FirewallChain>& chains) {
  bool is_unclear = false;
  for (const FirewallChain& chain : chains) {
    if (!chain.is_base) continue;
    Ends ends = Walk(chains).through(chain, 0);
    if (ends.goes_on) {
      (chain.drops ? ends.drops : ends.accepts) = true;
      if (chain.drops && ends.rule.empty()) ends.rule = chain.name + ": policy drop";
    }
    if (ends.drops && !ends.accepts) return {.verdict = Passage::Verdict::dropped, .rule = ends.rule};
    is_unclear = is_unclear || ends.drops;
  }
  return {.verdict = is_unclear ? Passage::Verdict::unknown : Passage::Verdict::passes};
}

}  // namespace geminga::doctor
