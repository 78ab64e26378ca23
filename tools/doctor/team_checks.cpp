#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>

#include "doctor/checks.hpp"
#include "shell/describe.hpp"

namespace geminga::doctor {
namespace {

std::string percent(double share) { return std::to_string(std::lround(share * 100)) + " %"; }

void check_neighbour(const Record& neighbour, Findings& findings) {
  const std::string who = words_for(neighbour, "id");
  const std::string addresses(neighbour["addresses"]);
  const std::string first = addresses.substr(0, addresses.find(','));
  if (neighbour["hears_us"] == "0") {
    findings.push_back(
        {Severity::failure, "deaf_to_us", who + " is heard here and does not hear this host.",
         "it has said so for twelve intervals (participants: hears_us=0)",
         "A firewall, a switch that filters multicast, or a Wi-Fi access point keeps our multicasts from it. Open UDP "
         "port 4717 there, or name each host to the other.",
         first.empty() ? "" : "gemingad --peer " + first});
  }
  const double least = number(neighbour["loss_least"]);
  if (least > bearable_loss) {
    findings.push_back(
        {Severity::risk, "loss_high",
         "At least " + percent(least) + " of the announcements of " + who +
             " are lost: it may be told as gone while it lives.",
         "participants: loss=" + std::string(neighbour["loss"]) + " loss_least=" + std::string(neighbour["loss_least"]),
         "Look at the radio link, and at what else floods it.", first.empty() ? "" : "ping -c 20 " + first});
  }
}

void check_strangers(const Answers& answers, Findings& findings) {
  const Record& status = answers.status;
  const struct {
    std::string_view key;
    Severity severity;
    std::string_view code;
    std::string_view what;
    std::string_view remedy;
  } kinds[] = {
      {"heard_other-group", Severity::risk, "other_group",
       "Participants of another group are heard: they are not of this team.",
       "If they should be, give all hosts the same group."},
      {"sealing_plain", Severity::failure, "unsealed_heard",
       "Announcements without a seal are heard and ignored: a host of the team may lack the key.",
       "Give it the team's key."},
      {"sealing_unknown-key", Severity::failure, "other_key",
       "Announcements that are sealed with an unknown key are heard: another team, or a host with an old key.",
       "Compare the keys of the hosts."},
      {"sealing_downgraded", Severity::risk, "downgraded",
       "Announcements without a seal come in the name of a participant that seals.",
       "See from where, and find that program."},
      {"sealing_forged", Severity::risk, "forged", "Forged or damaged sealed announcements are heard.",
       "See from where, and find that program."},
  };
  for (const auto& kind : kinds) {
    const std::string_view count = status[kind.key];
    if (count.empty() || count == "0") continue;
    if (kind.code == "other_key" && status["sealing"] == "plain") {
      findings.push_back({Severity::failure, "key_missing",
                          "Sealed announcements are heard, and this host has no key: it may lack that of its team.",
                          words_for_count(answers, kind.key), "Give it the team's key.",
                          "gemingad --key-file team.key"});
      continue;
    }
    findings.push_back({kind.severity, std::string(kind.code), std::string(kind.what),
                        words_for_count(answers, kind.key), std::string(kind.remedy), "geminga-query security"});
  }
}

void check_keys(const std::vector<Record>& security, Findings& findings) {
  for (const Record& record : security) {
    if (record["participant"].empty() || record["lacks"].empty()) continue;
    findings.push_back(
        {Severity::failure, "key_lacking",
         words_for(record, "participant") + " lacks a key of this host: " + std::string(record["lacks"]) + '.',
         "security: lacks", "Copy the key file to it, and reload its daemon.", "systemctl reload gemingad"});
  }
}

/// The participants by the digest of their ontology, where there is more than one.
void check_digests(const Answers& answers, Findings& findings) {
  std::map<std::string, std::vector<std::string>> members;
  for (const Record& participant : answers.participants) {
    if (participant["ontology"].empty()) continue;  // it has changed just now
    members[std::string(participant["ontology"])].push_back(words_for(participant, "id"));
  }
  if (members.size() < 2) return;
  std::string seen;
  std::size_t teams = 0;
  for (const auto& [digest, names] : members) {
    teams += names.size() >= least_team ? 1 : 0;
    seen += (seen.empty() ? "" : "; ") + (digest == "-" ? "none" : digest) + ": ";
    for (const std::string& name : names) seen += (&name == &names.front() ? "" : ", ") + name;
  }
  for (const auto& [participant, names] : answers.unknown) {
    if (names.empty()) continue;
    seen += "; unknown here, of " + participant + ": ";
    for (const std::string& name : names) seen += (&name == &names.front() ? "" : ", ") + name;
  }
  if (teams >= 2 && answers.status["group"] == "default" && answers.status["sealing"] == "plain") {
    findings.push_back({Severity::risk, "two_teams",
                        "Two teams may share the group `default`, without a key: there are " + std::to_string(teams) +
                            " ontologies with several hosts each.",
                        seen, "Give each team a group of its own, or a key.", "gemingad --generate-key team.key"});
  }
  findings.push_back({Severity::risk, "ontologies_differ",
                      "Participants have different ontologies, and may understand a concept differently or not at all.",
                      seen, "Give all hosts the same files.", "geminga-query ontology"});
}

}  // namespace

Findings check_team(const Answers& answers, bool hears_all) {
  Findings findings;
  std::size_t others = 0;
  for (const Record& participant : answers.participants) {
    if (participant["self"] == "1") continue;
    ++others;
    check_neighbour(participant, findings);
  }
  const double time_to_wait = std::max(time_to_hear, intervals_to_hear * number(answers.status["interval"]));
  if (others == 0 && !answers.interfaces.empty() && number(answers.status["uptime"]) > time_to_wait) {
    findings.push_back({Severity::risk, "alone", "No other participant is heard.",
                        "participants: this host only, for " + std::string(answers.status["uptime"]) + " s" +
                            (hears_all ? "" : "; without root only ports and groups near the usual ones were heard"),
                        "If others should be: are they on this link, with the same group, port and key? Wi-Fi, the "
                        "bridges of Docker and "
                        "WSL often drop multicast; a firewall may drop UDP port 4717. Naming a host shows which it is.",
                        "gemingad --peer HOST"});
  }
  check_strangers(answers, findings);
  check_keys(answers.security, findings);
  check_digests(answers, findings);
  return findings;
}

namespace {

/// Publishers whose places for listeners are all taken state so (src/client/CHANNELS.md, "Places").
void check_places(const Answers& answers, Findings& findings) {
  for (const Record& service : answers.services) {
    for (const auto& [key, value] : service.attributes) {
      if (key != "channel.full" || value == "0") continue;
      findings.push_back({Severity::failure, "listeners_full",
                          "All " + value + " places for listeners of " + std::string(service["name"]) + " on " +
                              std::string(service["participant_name"]) + " are taken: further ones get nothing.",
                          "services: channel.full of " + std::string(service["service"]),
                          "End listeners that are not needed, or offer the service once more.",
                          "geminga-query why " + std::string(service["service"])});
    }
  }
}

}  // namespace

Findings check_requests(const Answers& answers) {
  struct Group {
    std::size_t count = 0;
    std::string because;
    std::string subscription;
    std::vector<std::string> consumers;
  };
  constexpr std::size_t named_consumers = 3;
  std::map<std::string, Group, std::less<>> groups;
  const std::vector<std::string> reasons = shell::reasons_of(answers.unmatched);
  for (std::size_t one = 0; one < answers.unmatched.size(); ++one) {
    const Record& request = answers.unmatched[one];
    const std::string_view why = request["why"];
    Group& group = groups[std::string(why)];
    if (++group.count == 1) {
      group.because = reasons[one];
      group.subscription = request["subscription"];
    }
    std::string consumer(request["name"].empty() ? request["consumer"] : request["name"]);
    if (std::ranges::find(group.consumers, consumer) == group.consumers.end())
      group.consumers.push_back(std::move(consumer));
  }
  Findings findings;
  for (const auto& [code, group] : groups) {
    std::string who;
    for (const std::string& consumer : group.consumers | std::views::take(named_consumers))
      who += (who.empty() ? "" : ", ") + consumer;
    if (group.consumers.size() > named_consumers) who += ", ...";
    findings.push_back({Severity::risk, "unmatched",
                        (group.count == 1 ? "One request is" : std::to_string(group.count) + " requests are") +
                            " served by nobody (" + who + "): " + group.because,
                        "requests: unmatched, " + (code.empty() ? std::string("no reason") : code),
                        "See what each would need.", "geminga-query why " + group.subscription});
  }
  check_places(answers, findings);
  return findings;
}

}  // namespace geminga::doctor
