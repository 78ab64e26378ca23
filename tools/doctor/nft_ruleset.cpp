// nftables' own list, in the JSON of libnftables-json(5).
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/parse.hpp>
#include <boost/json/serialize.hpp>

#include "doctor/firewall.hpp"

namespace geminga::doctor {
namespace {

using boost::json::object;
using boost::json::value;

std::string text_at(const object& in, std::string_view key) {
  const value* found = in.if_contains(key);
  if (found == nullptr) return "";
  if (const auto* text = found->if_string()) return std::string(*text);
  if (const auto* number = found->if_int64()) return std::to_string(*number);
  return "";
}

const object* object_at(const value& in, std::string_view key) {
  const object* outer = in.if_object();
  const value* found = outer == nullptr ? nullptr : outer->if_contains(key);
  return found == nullptr ? nullptr : found->if_object();
}

/// The names of our datagram's part that a rule compares; empty: the part is not known here.
std::vector<std::string> part_of(const value& left, const Crossing& crossing) {
  if (const object* payload = object_at(left, "payload")) {
    const std::string protocol = text_at(*payload, "protocol");
    const std::string field = text_at(*payload, "field");
    if ((protocol == "udp" || protocol == "th") && field == "dport") return {std::to_string(crossing.port)};
    if (protocol == "ip" && field == "protocol") return {"udp", "17"};
    if (protocol == "ip6" && field == "nexthdr") return {"udp", "17"};
    if (protocol == (crossing.is_ipv6() ? "ip6" : "ip") && field == "daddr") return {crossing.group};
    return {};
  }
  if (const object* meta = object_at(left, "meta")) {
    const std::string key = text_at(*meta, "key");
    if (key == "l4proto") return {"udp", "17"};
    if (key == "nfproto") return {crossing.is_ipv6() ? "ipv6" : "ipv4"};
    if (key == "protocol") return {crossing.is_ipv6() ? "ip6" : "ip"};
    if (key == "pkttype") return {"multicast"};
    if (key == "iifname" || key == "iif") return {crossing.way == Way::in ? crossing.interface : ""};
    if (key == "oifname" || key == "oif") return {crossing.way == Way::out ? crossing.interface : ""};
  }
  if (const object* tracked = object_at(left, "ct"); tracked != nullptr && text_at(*tracked, "key") == "state")
    return {"new"};
  return {};
}

/// Whether another protocol than UDP, or the other family, is needed for the field to be there at all.
bool is_of_another_kind(const value& left, const Crossing& crossing) {
  const object* payload = object_at(left, "payload");
  if (payload == nullptr) return false;
  const std::string protocol = text_at(*payload, "protocol");
  return protocol == "tcp" || protocol == "icmp" || protocol == "icmpv6" || protocol == "sctp" ||
         protocol == (crossing.is_ipv6() ? "ip" : "ip6");
}

Truth equals(const std::vector<std::string>& part, const value& right) {
  if (const auto* list = right.if_array()) {  // flags, such as the states of a connection
    Truth found = Truth::no;
    for (const value& one : *list) {
      if (const Truth truth = equals(part, one); truth != Truth::no) found = truth;
    }
    return found;
  }
  if (const object* set = right.if_object()) {
    if (const value* elements = set->if_contains("set")) return equals(part, *elements);
    if (const object* prefix = object_at(right, "prefix"))
      return is_in_network(part.front(), text_at(*prefix, "addr") + '/' + text_at(*prefix, "len"));
    if (const value* range = set->if_contains("range"); range != nullptr && range->is_array()) {
      const auto& ends = range->get_array();
      if (ends.size() != 2 || !ends[0].is_int64() || !ends[1].is_int64()) return Truth::unknown;
      const long own = std::atol(part.front().c_str());
      return truth_of(own >= ends[0].get_int64() && own <= ends[1].get_int64());
    }
    return Truth::unknown;
  }
  if (const auto* number = right.if_int64()) return truth_of(part.front() == std::to_string(*number));
  if (const auto* text = right.if_string()) {
    if (text->starts_with('@')) return Truth::unknown;
    if (text->ends_with('*'))
      return truth_of(part.front().starts_with(std::string_view(*text).substr(0, text->size() - 1)));
    for (const std::string& name : part) {
      if (name == *text) return Truth::yes;
    }
    return Truth::no;
  }
  return Truth::unknown;
}

Truth holds(const object& match, const Crossing& crossing) {
  const value* left = match.if_contains("left");
  const value* right = match.if_contains("right");
  if (left == nullptr || right == nullptr) return Truth::unknown;
  if (is_of_another_kind(*left, crossing)) return Truth::no;
  const std::vector<std::string> part = part_of(*left, crossing);
  if (part.empty()) return Truth::unknown;
  const Truth truth = equals(part, *right);
  const std::string op = text_at(match, "op");
  if (op == "==" || op == "in") return truth;
  return op == "!=" ? negated(truth) : Truth::unknown;
}

FirewallRule rule_of(const object& rule, const Crossing& crossing, const std::string& table) {
  using Action = FirewallRule::Action;
  FirewallRule read;
  read.text = "rule with handle " + text_at(rule, "handle");
  const value* expressions = rule.if_contains("expr");
  if (expressions == nullptr || !expressions->is_array()) return read;
  for (const value& expression : expressions->get_array()) {
    const object* only = expression.if_object();
    if (only == nullptr || only->empty()) continue;
    const std::string_view word = only->begin()->key();
    const value& content = only->begin()->value();
    if (word == "match" && content.is_object()) {
      read.applies = both(read.applies, holds(content.get_object(), crossing));
    } else if (word == "accept") {
      read.action = Action::accept;
    } else if (word == "drop" || word == "reject") {
      read.action = Action::drop;
    } else if (word == "return") {
      read.action = Action::returns;
    } else if ((word == "jump" || word == "goto") && content.is_object()) {
      read.action = word == "jump" ? Action::jump : Action::go_to;
      read.target = table + ' ' + text_at(content.get_object(), "target");
    } else if (word != "counter" && word != "log" && word != "comment" && word != "mangle" && word != "notrack") {
      read.applies = both(read.applies, Truth::unknown);  // a limit, a set, a queue
      if (word == "vmap" || word == "queue" || word == "xt") read.action = Action::unknown;
    }
  }
  return read;
}

bool is_crossed(const object& chain, Way way) {
  const std::string hook = text_at(chain, "hook");
  return way == Way::in ? hook == "prerouting" || hook == "input" : hook == "output" || hook == "postrouting";
}

}  // namespace

Passage judge_nft(std::string_view ruleset, const Crossing& crossing) {
  boost::system::error_code error;
  const value document = boost::json::parse(ruleset, error);
  const object* whole = error ? nullptr : document.if_object();
  const value* list = whole == nullptr ? nullptr : whole->if_contains("nftables");
  if (list == nullptr || !list->is_array()) return {};
  std::vector<FirewallChain> chains;
  const auto table_of = [](const object& one) { return text_at(one, "family") + ' ' + text_at(one, "table"); };
  const auto is_ours = [&](const object& one) {
    const std::string family = text_at(one, "family");
    return family == "inet" || family == (crossing.is_ipv6() ? "ip6" : "ip");
  };
  for (const value& entry : list->get_array()) {
    if (const object* chain = object_at(entry, "chain"); chain != nullptr && is_ours(*chain)) {
      chains.push_back({.name = table_of(*chain) + ' ' + text_at(*chain, "name"),
                        .is_base = is_crossed(*chain, crossing.way),
                        .drops = text_at(*chain, "policy") == "drop"});
    }
  }
  for (const value& entry : list->get_array()) {
    const object* rule = object_at(entry, "rule");
    if (rule == nullptr || !is_ours(*rule)) continue;
    const std::string table = table_of(*rule);
    for (FirewallChain& chain : chains) {
      if (chain.name == table + ' ' + text_at(*rule, "chain")) chain.rules.push_back(rule_of(*rule, crossing, table));
    }
  }
  return walk(chains);
}

}  // namespace geminga::doctor
