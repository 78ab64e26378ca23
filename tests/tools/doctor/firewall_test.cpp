// The firewall's lists, as nft and iptables-save write them.
#include "doctor/firewall.hpp"

#include <gtest/gtest.h>

namespace geminga::doctor {
namespace {

using Verdict = Passage::Verdict;

const Crossing in{.way = Way::in, .interface = "wlan0", .group = "239.192.47.17", .port = 4717};
const Crossing out{.way = Way::out, .interface = "wlan0", .group = "239.192.47.17", .port = 4717};
const Crossing in_ipv6{.way = Way::in, .interface = "wlan0", .group = "ff02::4717", .port = 4717};

std::string match(const std::string& left, const std::string& right, const std::string& op = "==") {
  return R"({"match": {"op": ")" + op + R"(", "left": )" + left + R"(, "right": )" + right + "}}";
}
const std::string dport = R"({"payload": {"protocol": "udp", "field": "dport"}})";
const std::string saddr = R"({"payload": {"protocol": "ip", "field": "saddr"}})";
const std::string daddr = R"({"payload": {"protocol": "ip", "field": "daddr"}})";
const std::string iifname = R"({"meta": {"key": "iifname"}})";
const std::string state = R"({"ct": {"key": "state"}})";

/// A table with one chain at input, and the rules of it.
std::string ruleset(const std::vector<std::string>& rules, const std::string& policy = "accept",
                    const std::string& family = "inet") {
  std::string text = R"({"nftables": [{"metainfo": {"version": "1.0.6"}}, {"table": {"family": ")" + family +
                     R"(", "name": "f"}}, {"chain": {"family": ")" + family +
                     R"(", "table": "f", "name": "input", "hook": "input", "policy": ")" + policy + R"("}})";
  for (const std::string& name : {std::string("side")})
    text += R"(, {"chain": {"family": ")" + family + R"(", "table": "f", "name": ")" + name + R"("}})";
  for (const std::string& rule : rules) text += ", " + rule;
  return text + "]}";
}
std::string rule(const std::string& expressions, const std::string& chain = "input",
                 const std::string& family = "inet") {
  return R"({"rule": {"family": ")" + family + R"(", "table": "f", "chain": ")" + chain +
         R"(", "handle": 7, "expr": [)" + expressions + "]}}";
}
constexpr const char* drop = R"({"drop": null})";
constexpr const char* accept = R"({"accept": null})";

TEST(Nftables, IsJudgedForOurDatagram) {
  struct Case {
    const char* what;
    std::string list;
    Verdict verdict;
  };
  const Case cases[] = {
      {"no rules", ruleset({}), Verdict::passes},
      {"our port", ruleset({rule(match(dport, "4717") + "," + drop)}), Verdict::dropped},
      {"another port", ruleset({rule(match(dport, "4718") + "," + drop)}), Verdict::passes},
      {"a set of ports", ruleset({rule(match(dport, R"({"set": [22, 4717]})") + "," + drop)}), Verdict::dropped},
      {"a range", ruleset({rule(match(dport, R"({"range": [4000, 4717]})") + "," + drop)}), Verdict::dropped},
      {"a range below", ruleset({rule(match(dport, R"({"range": [4000, 4716]})") + "," + drop)}), Verdict::passes},
      {"a named set", ruleset({rule(match(dport, R"("@ports")") + "," + drop)}), Verdict::unknown},
      {"not our port", ruleset({rule(match(dport, "4717", "!=") + "," + drop)}), Verdict::passes},
      {"the group's network",
       ruleset({rule(match(daddr, R"({"prefix": {"addr": "224.0.0.0", "len": 4}})") + "," + drop)}), Verdict::dropped},
      {"an interface", ruleset({rule(match(iifname, R"("wlan0")") + "," + drop)}), Verdict::dropped},
      {"another interface", ruleset({rule(match(iifname, R"("eth*")") + "," + drop)}), Verdict::passes},
      {"an address that is not known", ruleset({rule(match(saddr, R"("10.0.0.9")") + "," + drop)}), Verdict::unknown},
      {"a policy", ruleset({}, "drop"), Verdict::dropped},
      {"a policy, and our port let in", ruleset({rule(match(dport, "4717") + "," + accept)}, "drop"), Verdict::passes},
      {"a policy, and answers let in",
       ruleset({rule(match(state, R"(["established", "related"])", "in") + "," + accept)}, "drop"), Verdict::dropped},
      {"a policy, and somebody let in", ruleset({rule(match(saddr, R"("10.0.0.9")") + "," + accept)}, "drop"),
       Verdict::unknown},
      {"a chain of its own", ruleset({rule(R"({"jump": {"target": "side"}})"), rule(drop, "side")}), Verdict::dropped},
      {"a chain that returns",
       ruleset({rule(R"({"jump": {"target": "side"}})"), rule(R"({"return": null})", "side"), rule(drop, "side")}),
       Verdict::passes},
      {"TCP", ruleset({rule(match(R"({"payload": {"protocol": "tcp", "field": "dport"}})", "4717") + "," + drop)}),
       Verdict::passes},
      {"the other family", ruleset({rule(drop, "input", "ip6")}, "accept", "ip6"), Verdict::passes},
      {"a counter before it", ruleset({rule(R"({"counter": {"packets": 3, "bytes": 9}},)" + std::string(drop))}),
       Verdict::dropped},
      {"a limit before it", ruleset({rule(R"({"limit": {"rate": 3}},)" + std::string(drop))}), Verdict::unknown},
      {"no JSON", "table inet f", Verdict::unknown},
      {"nothing", "", Verdict::unknown},
  };
  for (const Case& each : cases) EXPECT_EQ(judge_nft(each.list, in).verdict, each.verdict) << each.what;
  EXPECT_EQ(judge_nft(cases[1].list, in).rule, "inet f input: rule with handle 7");
  EXPECT_EQ(judge_nft(cases[1].list, out).verdict, Verdict::passes) << "it is for what comes in";
  EXPECT_EQ(judge_nft(cases[1].list, in_ipv6).verdict, Verdict::dropped) << "inet is both families";
}

TEST(Iptables, IsJudgedForOurDatagram) {
  const std::string head = "# Generated by iptables-save\n*filter\n:INPUT ";
  const std::string chains = " [0:0]\n:OUTPUT ACCEPT [0:0]\n:side - [0:0]\n";
  struct Case {
    const char* what;
    std::string policy;
    std::string rules;
    Verdict verdict;
  };
  const Case cases[] = {
      {"no rules", "ACCEPT", "", Verdict::passes},
      {"our port", "ACCEPT", "-A INPUT -p udp -m udp --dport 4717 -j DROP", Verdict::dropped},
      {"a list of ports", "ACCEPT",
       "-A INPUT -p udp -m multiport --dports 22,4700:4717 -j REJECT --reject-with icmp-port-unreachable",
       Verdict::dropped},
      {"another port", "ACCEPT", "-A INPUT -p udp -m udp --dport 4718 -j DROP", Verdict::passes},
      {"TCP", "ACCEPT", "-A INPUT -p tcp -m tcp --dport 4717 -j DROP", Verdict::passes},
      {"not the loopback", "ACCEPT", "-A INPUT ! -i lo -j DROP", Verdict::dropped},
      {"another interface", "ACCEPT", "-A INPUT -i eth+ -j DROP", Verdict::passes},
      {"a policy", "DROP", "-A INPUT -m conntrack --ctstate RELATED,ESTABLISHED -j ACCEPT", Verdict::dropped},
      {"a policy, and our port let in", "DROP",
       "-A INPUT -p udp -m udp --dport 4717 -m comment --comment \"a team -j\" -j ACCEPT", Verdict::passes},
      {"somebody's address", "DROP", "-A INPUT -s 10.0.0.9/32 -j ACCEPT", Verdict::unknown},
      {"multicasts", "ACCEPT", "-A INPUT -m pkttype --pkt-type multicast -j DROP", Verdict::dropped},
      {"a log", "ACCEPT", "-A INPUT -j LOG --log-prefix \"seen \"", Verdict::passes},
      {"a chain of its own", "ACCEPT", "-A INPUT -p udp -j side\n-A side -d 239.0.0.0/8 -j DROP", Verdict::dropped},
      {"what goes out", "ACCEPT", "-A OUTPUT -p udp -j DROP", Verdict::passes},
  };
  for (const Case& each : cases)
    EXPECT_EQ(judge_iptables(head + each.policy + chains + each.rules + "\nCOMMIT\n", in).verdict, each.verdict)
        << each.what;
  EXPECT_EQ(judge_iptables(head + "ACCEPT" + chains + cases[1].rules + "\nCOMMIT\n", in).rule,
            "filter INPUT: -A INPUT -p udp -m udp --dport 4717 -j DROP");
  EXPECT_EQ(judge_iptables(head + "ACCEPT" + chains + "-A OUTPUT -p udp -j DROP\nCOMMIT\n", out).verdict,
            Verdict::dropped);
  EXPECT_EQ(judge_iptables("", in).verdict, Verdict::unknown);
  EXPECT_EQ(judge_iptables("*\n:\n-A\n-A INPUT\n:INPUT\n\"", in).verdict, Verdict::unknown);
}

TEST(Networks, HaveTheAddressesOfTheirPrefix) {
  EXPECT_EQ(is_in_network("239.192.47.17", "239.192.0.0/16"), Truth::yes);
  EXPECT_EQ(is_in_network("239.192.47.17", "239.193.0.0/16"), Truth::no);
  EXPECT_EQ(is_in_network("239.192.47.17", "239.192.47.17"), Truth::yes);
  EXPECT_EQ(is_in_network("239.192.47.17", "0.0.0.0/0"), Truth::yes);
  EXPECT_EQ(is_in_network("239.192.47.17", "ff02::/16"), Truth::no);
  EXPECT_EQ(is_in_network("ff02::4717", "ff02::/16"), Truth::yes);
  for (const char* wrong : {"", "x", "10.0.0.0/33", "10.0.0.0/", "10.0.0.0/-1", "10.0.0.0/8x"})
    EXPECT_EQ(is_in_network("10.0.0.1", wrong), Truth::unknown) << wrong;
}

}  // namespace
}  // namespace geminga::doctor
