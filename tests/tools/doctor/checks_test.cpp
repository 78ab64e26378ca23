// Each check on recorded answers: what namespaces cannot make (Wi-Fi, a host without interfaces, many daemons) is seen
// here only.
#include "doctor/checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "doctor/other_view.hpp"

namespace geminga::doctor {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> codes(const Findings& findings) {
  std::vector<std::string> list;
  for (const Finding& finding : findings) list.push_back(finding.code);
  return list;
}

Record record(std::vector<std::pair<std::string, std::string>> fields) {
  return {.kind = "", .fields = std::move(fields), .attributes = {}};
}

HostInterface wired() {
  return {.name = "eth0",
          .is_up = true,
          .has_carrier = true,
          .can_multicast = true,
          .is_loopback = false,
          .is_wireless = false,
          .saves_power = false,
          .mtu = 1500,
          .is_strict = false,
          .addresses = {"10.0.0.1"},
          .networks = {"10.0.0.1/24"}};
}

Host healthy_host() {
  Host host;
  host.interfaces = {wired()};
  host.daemons = {{.process = 17, .command = "gemingad"}};
  host.user = "robot";
  return host;
}

Sending passes(const Crossing&) { return Sending::leaves; }
Sending has_no_route(const Crossing& out) { return out.is_ipv6() ? Sending::no_route : Sending::leaves; }
bool leads_there(const std::string&) { return true; }

Answers healthy_team() {
  Answers answers;
  answers.status = record({{"version", "1.0.0"},
                           {"uptime", "100"},
                           {"interval", "2.000"},
                           {"port", "4717"},
                           {"multicast", "239.192.47.17,ff02::4717"}});
  answers.interfaces = {record({{"name", "eth0"}, {"addresses", "10.0.0.1"}, {"quiet", "0.5"}})};
  answers.participants = {
      record({{"id", "00000001"}, {"name", "one"}, {"ontology", "aa"}, {"self", "1"}}),
      record({{"id", "00000002"}, {"name", "two"}, {"ontology", "aa"}, {"loss", "0.3"}, {"addresses", "10.0.0.2"}})};
  return answers;
}

TEST(Doctor, FindsNothingWhereNothingIsWrong) {
  EXPECT_THAT(check_host(healthy_host()), IsEmpty());
  EXPECT_THAT(check_daemon(healthy_team(), "1.0.0"), IsEmpty());
  EXPECT_THAT(check_team(healthy_team(), true), IsEmpty());
  EXPECT_THAT(check_requests(healthy_team()), IsEmpty());
  EXPECT_THAT(check_firewall(healthy_host(), healthy_team(), &passes), IsEmpty());
  EXPECT_THAT(check_multicast_routes(healthy_team(), &passes), IsEmpty());
  EXPECT_THAT(check_addresses(healthy_host(), healthy_team(), &leads_there), IsEmpty());
  EXPECT_THAT(check_overheard(healthy_host(), healthy_team(), {}), IsEmpty());
}

TEST(Doctor, FindsAClockThatWasSet) {
  Answers answers = healthy_team();
  answers.status.fields.emplace_back("started", "1000000000");
  for (const auto& [clock, is_found] : {std::pair(1000000100.0, false), std::pair(1000000102.0, false),
                                        std::pair(1000000102.5, true), std::pair(1000000097.5, true)}) {
    answers.asked_from = clock;
    answers.asked_until = clock;
    EXPECT_EQ(codes(check_daemon(answers, "1.0.0")) == std::vector<std::string>{"clock_jumped"}, is_found) << clock;
  }
  answers.asked_from = 1000000090;
  answers.asked_until = 1000000110;
  EXPECT_THAT(check_daemon(answers, "1.0.0"), IsEmpty()) << "the daemon answered late, and the clock may be right";
}

TEST(Doctor, FindsAnInterfaceOnWhichNothingComesInForFourIntervals) {
  Answers answers = healthy_team();
  for (const auto& [quiet, is_found] : {std::pair("7.9", false), std::pair("8.0", false), std::pair("8.1", true)}) {
    answers.interfaces[0].fields.back().second = quiet;
    EXPECT_EQ(codes(check_firewall(healthy_host(), answers, &passes)) == std::vector<std::string>{"firewall_in"},
              is_found)
        << quiet;
    EXPECT_THAT(codes(check_firewall(healthy_host(), answers, [](const Crossing&) { return Sending::refused; })),
                ElementsAre("firewall_out"))
        << "what does not go out does not come back";
  }
}

TEST(Doctor, FindsAGroupWithoutARouteWhereTheInterfaceHasAnAddressOfItsFamily) {
  Answers answers = healthy_team();
  EXPECT_THAT(check_multicast_routes(answers, &has_no_route), IsEmpty()) << "it speaks IPv4 alone";
  for (const auto& [addresses, severity] :
       {std::pair("10.0.0.1,fd00::1", Severity::risk), std::pair("fd00::1", Severity::failure)}) {
    answers.interfaces[0].fields[1].second = addresses;
    const Findings found = check_multicast_routes(answers, &has_no_route);
    ASSERT_THAT(codes(found), ElementsAre("no_multicast_route")) << addresses;
    EXPECT_EQ(found[0].severity, severity) << addresses;
    EXPECT_EQ(found[0].command, "ip -6 route add multicast ff00::/8 dev eth0 table local");
  }
  EXPECT_THAT(check_firewall(healthy_host(), answers, &has_no_route), IsEmpty());
  answers.interfaces[0].fields[1].second = "127.0.0.1,::1";
  answers.interfaces[0].fields.emplace_back("loopback", "1");
  EXPECT_THAT(check_multicast_routes(answers, &has_no_route), IsEmpty()) << "the loopback speaks IPv4";
}

TEST(Doctor, FindsAKeyThatOthersMayRead) {
  Host host = healthy_host();
  host.keys = {{.path = "/etc/geminga/team.key", .mode = 0600}};
  EXPECT_THAT(check_host(host), IsEmpty());
  for (const unsigned mode : {0640U, 0604U, 0620U}) {
    host.keys[0].mode = mode;
    EXPECT_THAT(codes(check_host(host)), ElementsAre("key_readable"));
  }
}

TEST(Doctor, FindsAStrictKernelOnlyWhereTwoInterfacesShareANetwork) {
  Host host = healthy_host();
  HostInterface radio = wired();
  radio.name = "wlan0";
  radio.is_strict = true;
  radio.networks = {"10.0.1.2/24"};
  host.interfaces.push_back(radio);
  EXPECT_THAT(check_host(host), IsEmpty());
  host.interfaces[1].networks = {"10.0.0.2/24"};
  EXPECT_THAT(codes(check_host(host)), ElementsAre("rp_filter_strict"));
}

TEST(Doctor, FindsServicesAtAddressesThatLeadNowhereOrHere) {
  Answers answers = healthy_team();
  answers.services = {record({{"participant_name", "two"}, {"address", "10.0.0.2"}}),
                      record({{"participant_name", "one"}, {"address", "172.17.0.1"}, {"local", "1"}})};
  const auto to_ten = [](const std::string& address) { return address.starts_with("10."); };
  EXPECT_THAT(check_addresses(healthy_host(), answers, to_ten), IsEmpty());
  answers.services[0].fields[1].second = "172.17.0.1";
  EXPECT_THAT(codes(check_addresses(healthy_host(), answers, to_ten)), ElementsAre("address_unreachable"));
  answers.services[0].fields[1].second = "10.0.0.1";
  const Findings findings = check_addresses(healthy_host(), answers, to_ten);
  EXPECT_THAT(codes(findings), ElementsAre("address_unreachable"));
  EXPECT_THAT(findings[0].what, testing::HasSubstr("it is an address of this host, too"));
}

TEST(Doctor, SaysOfAHostBehindARelayThatTheRelayCarriesNoDataAndNoQuestions) {
  Answers answers = healthy_team();
  answers.participants[1].fields.emplace_back("path", "base/tower");
  answers.services = {record({{"provider", "00000002/1"}, {"participant_name", "two"}, {"address", "172.17.0.1"}})};
  const auto to_ten = [](const std::string& address) { return address.starts_with("10."); };
  const Findings findings = check_addresses(healthy_host(), answers, to_ten);
  ASSERT_THAT(codes(findings), ElementsAre("address_unreachable"));
  EXPECT_THAT(findings[0].what, testing::HasSubstr("It is heard through base/tower, and a relay passes on"));
  EXPECT_THAT(check_addresses(healthy_host(), answers, &leads_there), IsEmpty()) << "there is a route";
  Answers translated = answers;
  translated.services[0].fields.emplace_back("reachable", "no");
  translated.participants[1].fields.emplace_back("observed", "198.51.100.7");
  const Findings behind = check_addresses(healthy_host(), translated, &leads_there);
  ASSERT_THAT(codes(behind), ElementsAre("address_unreachable"));
  EXPECT_THAT(behind[0].what, testing::HasSubstr("come from 198.51.100.7, so that a translation of addresses lies"));
  EXPECT_THAT(behind[0].what, testing::HasSubstr("with reach=any alone"));
  EXPECT_THAT(behind[0].remedy, testing::HasSubstr("announce-address"));
  EXPECT_THAT(check_team(answers, true), IsEmpty());
  OtherView other;
  other.name = "two (00000002)";
  other.is_known = true;
  other.path = "base/tower";
  const Findings of_other = check_other(other, answers, "1.0.0");
  ASSERT_THAT(codes(of_other), ElementsAre("other_behind_relay"));
  EXPECT_EQ(of_other[0].command, "geminga-query doctor --with tower");
}

TEST(Doctor, LeavesOutWhatFollowsFromAnotherFinding) {
  const auto finding = [](std::string code) {
    return Finding{
        .severity = Severity::risk, .code = std::move(code), .what = {}, .seen = {}, .remedy = {}, .command = {}};
  };
  Findings findings{finding("alone"), finding("deaf_to_us"), finding("firewall_in")};
  drop_consequences(findings);
  EXPECT_THAT(codes(findings), ElementsAre("deaf_to_us", "firewall_in"));
  findings.push_back(finding("firewall_out"));
  drop_consequences(findings);
  EXPECT_THAT(codes(findings), ElementsAre("firewall_in", "firewall_out"));
}

TEST(Doctor, NamesTheInterfacesThatCannotBeUsedOnlyWhereNoneCan) {
  Host host = healthy_host();
  HostInterface radio = wired();
  radio.name = "wlan0";
  radio.has_carrier = false;
  host.interfaces.push_back(radio);
  EXPECT_THAT(check_host(host), IsEmpty()) << "the other one is enough";
  host.interfaces = {radio};
  const Findings findings = check_host(host);
  EXPECT_THAT(codes(findings), ElementsAre("no_interface"));
  EXPECT_EQ(findings[0].seen, "wlan0 (no cable, or no access point)");
  host.interfaces.clear();
  EXPECT_EQ(check_host(host)[0].seen, "there is none but the loopback");
  EXPECT_THAT(check_host(host, true), IsEmpty()) << "its daemon was told to use that";
}

TEST(Doctor, FindsARadioThatSleepsAndAnMtuThatIsTooSmall) {
  Host host = healthy_host();
  host.interfaces[0].saves_power = true;
  EXPECT_THAT(codes(check_host(host)), ElementsAre("wifi_power_save"));
  host.interfaces[0].saves_power = false;
  host.interfaces[0].mtu = least_mtu;
  EXPECT_THAT(check_host(host), IsEmpty());
  host.interfaces[0].mtu = least_mtu - 1;
  EXPECT_THAT(codes(check_host(host)), ElementsAre("mtu_small"));
}

TEST(Doctor, FindsASecondDaemon) {
  Host host = healthy_host();
  host.daemons.push_back({.process = 18, .command = "gemingad --name b"});
  const Findings findings = check_host(host);
  EXPECT_THAT(codes(findings), ElementsAre("two_daemons"));
  EXPECT_EQ(findings[0].seen, "process 17: gemingad; process 18: gemingad --name b");
}

TEST(Doctor, SaysWhyNoDaemonAnswers) {
  const ClientError error{.kind = ClientError::Kind::unreachable, .text = "nobody listens there", .code = {}};
  Host host = healthy_host();
  EXPECT_THAT(codes(check_absent_daemon(host, error, "")), ElementsAre("daemon_silent"));
  const ClientError late{.kind = ClientError::Kind::timed_out, .text = "no answer in time", .code = {}};
  EXPECT_EQ(check_absent_daemon(host, late, "").at(0).command, "ps -o pid,stat,time,args -p 17");
  host.has_packaged_socket = true;
  host.may_use_packaged_socket = false;
  EXPECT_EQ(check_absent_daemon(host, error, "")[0].command, "adduser robot geminga");
  host.daemons.clear();
  EXPECT_EQ(check_absent_daemon(host, error, "")[0].command, "systemctl start gemingad");
}

TEST(Doctor, FindsWhatTheDaemonSaysOfItself) {
  for (const auto& [key, code] :
       std::vector<std::pair<std::string, std::string>>{{"configuration_failed", "configuration_failed"},
                                                        {"ontology_failed", "ontology_failed"},
                                                        {"ontology_contradiction", "ontology_contradiction"},
                                                        {"contested_for", "identity_contested"},
                                                        {"dropped_no_peer", "peer_one_sided"},
                                                        {"dropped_off_link", "off_link"},
                                                        {"dropped_overrun", "flood"},
                                                        {"heard_full", "team_full"},
                                                        {"refused_services", "registry_full"},
                                                        {"clients_refused", "clients_full"},
                                                        {"redraws", "identifier_clash"},
                                                        {"rejected_other-version", "other_version"},
                                                        {"log_dropped", "log_dropped"}}) {
    Answers answers = healthy_team();
    answers.status.fields.emplace_back(key, "3");
    const Findings findings = check_daemon(answers, "1.0.0");
    EXPECT_THAT(codes(findings), ElementsAre(code));
    EXPECT_EQ(findings[0].seen, "status: " + key + "=3");
    answers.status.fields.back().second = "0";
    EXPECT_THAT(check_daemon(answers, "1.0.0"), IsEmpty()) << key;
    answers.status.fields.back().second = "3";
    answers.earlier_status = answers.status;
    EXPECT_EQ(check_daemon(answers, "1.0.0").at(0).seen,
              "status: " + key + "=3 since the daemon started, none of them just now");
  }
  Answers poor = healthy_team();
  poor.status.fields.emplace_back("memory_kept_back", "4194304");
  EXPECT_THAT(check_daemon(poor, "1.0.0"), IsEmpty());
  poor.status.fields.back().second = "4194303";
  EXPECT_THAT(codes(check_daemon(poor, "1.0.0")), ElementsAre("memory_short"));
  EXPECT_THAT(codes(check_daemon(healthy_team(), "1.0.1")), ElementsAre("version_differs"));
  Answers mute = healthy_team();
  mute.interfaces.clear();
  EXPECT_THAT(codes(check_daemon(mute, "1.0.0")), ElementsAre("nowhere_heard"));
}

TEST(Doctor, FindsLossThatDeadlinesDoNotBearOnlyWhereItIsSure) {
  Answers answers = healthy_team();
  Record& neighbour = answers.participants[1];
  neighbour.fields[3] = {"loss", "0.95"};
  EXPECT_THAT(check_team(answers, true), IsEmpty()) << "a daemon that does not say how sure it is";
  for (const auto& [least, is_found] :
       {std::pair("0.000", false), std::pair("0.400", false), std::pair("0.401", true)}) {
    neighbour.fields.resize(5);
    neighbour.fields.emplace_back("loss_least", least);
    EXPECT_EQ(codes(check_team(answers, true)) == std::vector<std::string>{"loss_high"}, is_found) << least;
  }
  EXPECT_EQ(check_team(answers, true).at(0).seen, "participants: loss=0.95 loss_least=0.401");
}

TEST(Doctor, FindsAHostThatIsAloneOnlyWhenOthersHadTimeToSpeak) {
  Answers answers = healthy_team();
  answers.participants.pop_back();
  EXPECT_THAT(codes(check_team(answers, true)), ElementsAre("alone"));
  EXPECT_THAT(check_team(answers, false).at(0).seen, testing::HasSubstr("without root only ports and groups near"));
  answers.status.fields[1].second = "10";
  EXPECT_THAT(check_team(answers, true), IsEmpty());
  answers.status.fields[1].second = "40";
  answers.status.fields[2].second = "10.000";
  EXPECT_THAT(check_team(answers, true), IsEmpty()) << "one that speaks each ten seconds had less time";
  answers.status.fields[1].second = "40.001";
  EXPECT_THAT(codes(check_team(answers, true)), ElementsAre("alone"));
}

TEST(Doctor, FindsStrangersKeysAndDigests) {
  Answers answers = healthy_team();
  answers.status.fields.emplace_back("heard_other-group", "2");
  answers.status.fields.emplace_back("sealing_unknown-key", "5");
  answers.security = {record({{"mode", "encrypted"}, {"keys", "aaaa"}}),
                      record({{"participant", "00000002"}, {"name", "two"}, {"lacks", "aaaa"}})};
  answers.participants[1].fields[2].second = "bb";
  EXPECT_THAT(codes(check_team(answers, true)),
              ElementsAre("other_group", "other_key", "key_lacking", "ontologies_differ"));
}

TEST(Doctor, GroupsRequestsByTheirReason) {
  Answers answers = healthy_team();
  for (int number = 0; number < 5; ++number) {
    answers.unmatched.push_back(record({{"subscription", "1/2/" + std::to_string(number)},
                                        {"name", "module" + std::to_string(number)},
                                        {"why", "nobody"},
                                        {"because", "nobody offers it"}}));
  }
  const Findings findings = check_requests(answers);
  EXPECT_THAT(codes(findings), ElementsAre("unmatched"));
  EXPECT_EQ(findings[0].what, "5 requests are served by nobody (module0, module1, module2, ...): nobody offers it");
  EXPECT_EQ(findings[0].command, "geminga-query why 1/2/0");
  for (std::size_t one = 0; one < 5; ++one) {
    auto& fields = answers.unmatched[one].fields;
    fields[1].second = "vision";
    fields[3].second = "nobody offers text=service" + std::to_string(one) + ": start it";
    fields.emplace_back("text", "service" + std::to_string(one));
  }
  EXPECT_EQ(check_requests(answers).at(0).what, "5 requests are served by nobody (vision): nobody offers it: start it");
}

TEST(Doctor, SaysTheWorstFirst) {
  Findings findings{{.severity = Severity::risk, .code = "a", .what = {}, .seen = {}, .remedy = {}, .command = {}},
                    {.severity = Severity::failure, .code = "b", .what = {}, .seen = {}, .remedy = {}, .command = {}},
                    {.severity = Severity::risk, .code = "c", .what = {}, .seen = {}, .remedy = {}, .command = {}}};
  sort_by_severity(findings);
  EXPECT_THAT(codes(findings), ElementsAre("b", "a", "c"));
}

}  // namespace
}  // namespace geminga::doctor
