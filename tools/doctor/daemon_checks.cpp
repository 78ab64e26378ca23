#include <algorithm>
#include <cmath>

#include "doctor/checks.hpp"

namespace geminga::doctor {
namespace {

/// One key of `query status` that is there only where something is wrong.
struct Symptom {
  std::string_view key;
  Severity severity;
  std::string_view code;
  std::string_view what;
  std::string_view remedy;
  std::string_view command;
};

constexpr Symptom symptoms[] = {
    {"configuration_failed", Severity::failure, "configuration_failed",
     "The configuration could not be read again; the daemon follows the former one.", "Mend the place that it names.",
     "systemctl reload gemingad"},
    {"ontology_failed", Severity::failure, "ontology_failed", "An ontology could not be read.",
     "Mend the file that it names, and read it again.", "geminga-query ontology"},
    {"ontology_contradiction", Severity::failure, "ontology_contradiction",
     "The ontology contradicts itself, so that no concept matches.", "See which axioms do so.",
     "geminga-ontology explain --inconsistent FILES"},
    {"ontology_undecided", Severity::risk, "ontology_undecided",
     "A limit ended the search for what follows from the ontology; matches may be missing.",
     "Compile it by hand with more time, and give the daemon the compiled file.",
     "geminga-ontology compile FILES -o team.geminga"},
    {"contested_for", Severity::failure, "identity_contested",
     "Somebody else announces in the name of this participant.",
     "Find the host that contested_from of geminga-query status names, and keep it off this network.",
     "geminga-query status"},
    {"refused_services", Severity::failure, "registry_full",
     "Services of the team were refused, since the limits of the registry are reached.", "See who announces so many.",
     "geminga-query participants"},
    {"heard_full", Severity::failure, "team_full",
     "There is no room for further participants: all 1024 places are taken.", "See who they are, and seal the team.",
     "geminga-query participants"},
    {"converters_postponed", Severity::risk, "converters_postponed",
     "Changes to converters wait, since too many come in a second.", "See who changes its converters so often.",
     "geminga-query services"},
    {"redraws", Severity::risk, "identifier_clash",
     "This participant had to take another identifier, since others had the same one.",
     "If it goes on, a program forges announcements: find it.", "geminga-query security"},
    {"dropped_off_link", Severity::failure, "off_link",
     "Announcements come from addresses that are in no network of this host: hosts on one link have different "
     "networks.",
     "Give all hosts addresses of one network.", "ip -br address"},
    {"rejected_other-version", Severity::failure, "other_version",
     "Announcements of another version of the protocol are heard and ignored.", "Install one version on all hosts.",
     "gemingad --version"},
    {"sealing_other-version", Severity::failure, "other_version",
     "Sealed announcements of another version are heard and ignored.", "Install one version on all hosts.",
     "gemingad --version"},
    {"peers_silent", Severity::risk, "peer_silent", "Hosts that are named by --peer have not been heard for 15 s.",
     "See whether they run, and, without a key, name this host, too.", "geminga-query participants"},
    {"clients_refused", Severity::failure, "clients_full", "Local programs were refused: too many are connected.",
     "See who they are.", "geminga-query status"},
    {"dropped_no_peer", Severity::failure, "peer_one_sided",
     "A host names this one by --peer, and is not named here: without a key both sides have to.",
     "Name it here, too, or give the team a key.", "gemingad --peer HOST"},
    {"dropped_wrong_way", Severity::risk, "peer_wrong_way",
     "Datagrams claim the address of a --peer and come in where that peer cannot be.",
     "Look at the routes, or find the program that forges them.", "ip route get HOST"},
    {"dropped_overrun", Severity::risk, "flood", "Datagrams came faster than they could be read.",
     "See what floods this network.", "geminga-query security"},
    {"log_dropped", Severity::risk, "log_dropped", "Lines of the daemon's log were dropped: nobody read them in time.",
     "See where its standard error goes.", ""},
};

}  // namespace

Findings check_daemon(const Answers& answers, std::string_view version) {
  Findings findings;
  for (const Symptom& symptom : symptoms) {
    const std::string_view value = answers.status[symptom.key];
    if (value.empty() || value == "0") continue;
    findings.push_back({symptom.severity, std::string(symptom.code), std::string(symptom.what),
                        words_for_count(answers, symptom.key), std::string(symptom.remedy),
                        std::string(symptom.command)});
  }
  if (const std::string_view running = answers.status["version"]; !running.empty() && running != version) {
    findings.push_back(
        {Severity::risk, "version_differs",
         "The daemon is of version " + std::string(running) + ", this program of version " + std::string(version) + '.',
         "status: version", "Start the daemon again after an upgrade.", "systemctl restart gemingad"});
  }
  constexpr double kept_back = 4 << 20;
  if (const std::string_view left = answers.status["memory_kept_back"]; !left.empty() && number(left) < kept_back) {
    findings.push_back({Severity::failure, "memory_short", "The daemon's memory is short: it gives up participants.",
                        "status: memory_kept_back=" + std::string(left), "Give it more memory.",
                        "systemctl show gemingad -p MemoryMax"});
  }
  if (const double started = number(answers.status["started"]); started > 0 && answers.asked_until > 0) {
    // The answer was given at some time between.
    const double most = answers.asked_until - started - number(answers.status["uptime"]);
    const double least = answers.asked_from - started - number(answers.status["uptime"]);
    const double step = least > 0 ? least : std::min(most, 0.0);
    if (std::abs(step) > clock_step) {
      findings.push_back(
          {Severity::risk, "clock_jumped",
           "The clock of this host was set by " + std::to_string(std::lround(step)) +
               " s, or the host slept, since the daemon started. Discovery does not depend on it; time " +
               "stamps in logs and messages do.",
           "status: started and uptime against the wall clock", "See whether it is synchronised.",
           "timedatectl status"});
    }
  }
  for (const Record& interface : answers.interfaces) {
    if (interface["ignored"] != "1") continue;
    findings.push_back({Severity::risk, "interface_ignored",
                        "There is no room for interface " + std::string(interface["name"]) + ": 64 are in use.",
                        "interfaces: ignored=1", "Name those that matter by --interface.",
                        "gemingad --interface NAME"});
  }
  if (answers.interfaces.empty()) {
    findings.push_back({Severity::failure, "nowhere_heard", "The daemon speaks on no interface: nobody hears it.",
                        "interfaces: none", "See which interfaces it may use, and whether they are up.",
                        "ip -br address"});
  }
  return findings;
}

}  // namespace geminga::doctor
