#include "doctor/other_view.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "doctor/checks.hpp"

namespace geminga::doctor {
namespace {

constexpr std::chrono::milliseconds poll_spacing{100};

const Record* find(const std::vector<Record>& participants, std::string_view id) {
  const auto found = std::ranges::find_if(participants, [&](const Record& one) { return one["id"] == id; });
  return found == participants.end() ? nullptr : &*found;
}

const Record* self_of(const std::vector<Record>& participants) {
  const auto found = std::ranges::find_if(participants, [](const Record& one) { return one["self"] == "1"; });
  return found == participants.end() ? nullptr : &*found;
}

/// Sorts the lines of an answer by what they are about.
void take(OtherView& other, std::vector<Record> lines) {
  for (Record& line : lines) {
    const std::string part(line["part"]);
    std::erase_if(line.fields, [](const auto& field) { return field.first == "part"; });
    if (part == "status") {
      for (auto& field : line.fields) other.answers.status.fields.push_back(std::move(field));
    } else if (part == "interfaces") {
      other.answers.interfaces.push_back(std::move(line));
    } else if (part == "participants") {
      other.answers.participants.push_back(std::move(line));
    }
  }
}

std::string way(const Record* heard) {
  if (heard == nullptr) return "not heard";
  return "heard " + std::string((*heard)["heard"]) + " s ago, loss " + std::string((*heard)["loss"]) +
         ((*heard)["hears_us"] == "0" ? ", does not hear it back" : "");
}

}  // namespace

std::expected<OtherView, ClientError> ask_other(Client& client, const Answers& ours, const std::string& host) {
  OtherView other;
  other.name = host;
  for (const Record& one : ours.participants) {
    const std::vector<std::string> addresses = parts_of(one["addresses"]);
    const bool is_meant =
        one["id"] == host || one["name"] == host || std::ranges::find(addresses, host) != addresses.end();
    if (!is_meant || one["self"] == "1" || other.is_known) continue;
    other.is_known = true;
    other.id = one["id"];
    other.name = words_for(one, "id");
    other.path = one["path"];
  }
  if (!other.path.empty()) return other;
  const auto end = std::chrono::steady_clock::now() + time_to_answer;
  while (other.is_known && !other.is_answered && std::chrono::steady_clock::now() < end) {
    auto answer = client.query("diagnosis", {{"participant", other.id}});
    if (!answer && answer.error().kind != ClientError::Kind::refused) return std::unexpected(answer.error());
    if (!answer) break;  // it has just gone
    other.is_answered = answer->end["state"] == "answered";
    if (other.is_answered) {
      take(other, std::move(answer->records));
    } else if (auto waited = client.next_event(poll_spacing); !waited) {
      return std::unexpected(waited.error());
    }
  }
  return other;
}

Findings check_other(const OtherView& other, const Answers& ours, std::string_view version) {
  if (!other.is_known) {
    return {{Severity::failure, "other_unknown", other.name + " is not heard here, so it cannot be asked.",
             "participants: no such identifier, name or address", "Run the doctor there, too.",
             "gemingad --peer " + other.name}};
  }
  if (!other.path.empty()) {
    return {{Severity::risk, "other_behind_relay",
             other.name + " is heard through " + other.path + ", and a relay passes no questions on.",
             "participants: path=" + other.path,
             "Ask the relay next to this host, or run the doctor on a host of that link.",
             "geminga-query doctor --with " + other.path.substr(other.path.rfind('/') + 1)}};
  }
  if (!other.is_answered) {
    return {{Severity::risk, "other_silent", other.name + " is heard and does not tell its view.",
             "diagnosis: no answer within 6 s",
             "Set diagnose = true there; it answers in a sealed team, and without a key only a host that it names by "
             "--peer. If it does, it does not hear this host.",
             "gemingad --diagnose"}};
  }
  Findings findings;
  Answers theirs = other.answers;
  for (Findings more : {check_daemon(theirs, version),
                        check_firewall(Host{}, theirs, [](const Crossing&) { return Sending::leaves; })}) {
    for (Finding& finding : more) {
      finding.code += "_there";
      finding.what = "On " + other.name + ": " + finding.what;
      finding.command.clear();
      findings.push_back(std::move(finding));
    }
  }
  const Record* self = self_of(ours.participants);
  const Record* of_us = self == nullptr ? nullptr : find(theirs.participants, (*self)["id"]);
  if (self != nullptr && of_us == nullptr && find(theirs.participants, other.id) != nullptr) {
    findings.push_back({Severity::failure, "unknown_there", other.name + " does not know this host.",
                        "its participants have no " + std::string((*self)["id"]),
                        "See whether it hears any multicast of this host.", ""});
  }
  if (of_us != nullptr && number((*of_us)["loss_least"]) > bearable_loss) {
    findings.push_back({Severity::risk, "loss_high_there",
                        "Many announcements of this host are lost on the way to " + other.name + '.',
                        "its participants: loss=" + std::string((*of_us)["loss"]) +
                            " loss_least=" + std::string((*of_us)["loss_least"]),
                        "Look at the radio link.", ""});
  }
  return findings;
}

std::vector<Compared> side_by_side(const OtherView& other, const Answers& ours) {
  std::vector<Compared> rows;
  for (const char* key : {"version", "uptime", "interval", "ontology", "sealing", "port", "multicast", "participants",
                          "publications", "subscriptions"}) {
    rows.push_back({key, std::string(ours.status[key]), std::string(other.answers.status[key])});
  }
  const auto interfaces = [](const std::vector<Record>& all) {
    std::string text;
    for (const Record& one : all)
      text += (text.empty() ? "" : ", ") + std::string(one["name"]) + ' ' + std::string(one["addresses"]);
    return text;
  };
  rows.push_back({"interfaces", interfaces(ours.interfaces), interfaces(other.answers.interfaces)});
  const Record* self = self_of(ours.participants);
  const std::string our_id(self == nullptr ? "" : (*self)["id"]);
  rows.push_back({"each other", way(find(ours.participants, other.id)), way(find(other.answers.participants, our_id))});
  std::map<std::string, std::string> others;  // names by identifier
  for (const auto* all : {&ours.participants, &other.answers.participants}) {
    for (const Record& one : *all) {
      std::string& name = others[std::string(one["id"])];
      if (name.empty()) name = words_for(one, "id");
    }
  }
  for (const auto& [id, name] : others) {
    if (id == our_id || id == other.id) continue;
    rows.push_back({name, way(find(ours.participants, id)), way(find(other.answers.participants, id))});
  }
  return rows;
}

}  // namespace geminga::doctor
