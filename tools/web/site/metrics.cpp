#include "web/site/metrics.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "answers/ontology.hpp"
#include "answers/security.hpp"
#include "base/text.hpp"
#include "web/site/limits.hpp"

namespace geminga::web {
namespace {

using Type = Family::Type;

/// A key of `status` as a metric.
struct Measure {
  std::string_view key;
  std::string_view name;
  Type type;
  std::string_view unit;
  std::string_view help;
};

constexpr auto measures = std::to_array<Measure>({
    {"uptime", "geminga_uptime_seconds", Type::gauge, "seconds", "Time since the daemon started"},
    {"interval", "geminga_interval_seconds", Type::gauge, "seconds", "Time between two announcements without a change"},
    {"participants", "geminga_participants", Type::gauge, "",
     "Participants that are known, the daemon itself included"},
    {"peers", "geminga_peers", Type::gauge, "", "Local programs that are connected"},
    {"publications", "geminga_publications", Type::gauge, "", "Services that are known"},
    {"subscriptions", "geminga_subscriptions", Type::gauge, "", "Requests that are known"},
    {"local_publications", "geminga_local_publications", Type::gauge, "", "Services of this host"},
    {"local_subscriptions", "geminga_local_subscriptions", Type::gauge, "", "Requests of this host"},
    {"statements", "geminga_statements", Type::counter, "", "Lines of local programs"},
    {"errors", "geminga_errors", Type::counter, "", "Lines of local programs that were refused"},
    {"events", "geminga_events", Type::counter, "", "Events that local programs were told"},
    {"clients", "geminga_clients", Type::counter, "", "Local programs that have connected"},
    {"clients_refused", "geminga_clients_refused", Type::counter, "", "Local programs for which there was no room"},
    {"clients_closed", "geminga_clients_closed", Type::counter, "",
     "Local programs that were closed for what they did"},
    {"lags", "geminga_client_lags", Type::counter, "", "Times that a local program did not read its events in time"},
    {"datagrams_sent", "geminga_datagrams_sent", Type::counter, "", "Datagrams sent"},
    {"datagrams_received", "geminga_datagrams_received", Type::counter, "", "Datagrams received"},
    {"bytes_sent", "geminga_sent_bytes", Type::counter, "bytes", "Octets sent in datagrams"},
    {"bytes_received", "geminga_received_bytes", Type::counter, "bytes", "Octets received in datagrams"},
    {"clashes", "geminga_clashes", Type::counter, "", "Times that the identifier was given up for another one"},
    {"contested", "geminga_contested_datagrams", Type::counter, "", "Datagrams of others under our identifier"},
    {"contradicted", "geminga_contradicted_datagrams", Type::counter, "",
     "Datagrams in our name that we have not sent"},
    {"participants_lost", "geminga_participants_lost", Type::counter, "", "Participants gone without a goodbye"},
    {"unheard_by", "geminga_participants_deaf", Type::gauge, "", "Participants that are heard and do not hear us"},
    {"ontology_others", "geminga_participants_other_ontology", Type::gauge, "", "Participants with another ontology"},
    {"memory", "geminga_memory_bytes", Type::gauge, "bytes", "Resident memory of the daemon"},
    {"peak_memory", "geminga_peak_memory_bytes", Type::gauge, "bytes", "The most resident memory since it started"},
    {"cpu", "geminga_cpu_seconds", Type::counter, "seconds", "Processor time of the daemon"},
    {"ontology_load", "geminga_ontology_load_seconds", Type::gauge, "seconds",
     "Time of the last reading of ontologies"},
    {"log_dropped", "geminga_log_dropped", Type::counter, "", "Lines of the log that were dropped"},
    {"refused_services", "geminga_refused_services", Type::counter, "",
     "Services of others for which there was no room"},
});

/// Keys of `status` that say nothing while their count is 0, and then are left out.
constexpr auto zero_unless_told = std::to_array<std::string_view>(
    {"contested", "contradicted", "participants_lost", "unheard_by", "ontology_others", "refused_services"});

/// Keys `PREFIX_WORD` of `status`, whose counts go into one metric with the word as a label.
struct Group {
  std::string_view prefix;
  std::string_view name;
  std::string_view label;
  Type type;
  std::string_view help;
};

constexpr auto groups = std::to_array<Group>({
    {"heard_", "geminga_announcements_heard", "kind", Type::counter, "Announcements by what they were to us"},
    {"rejected_", "geminga_datagrams_undecodable", "reason", Type::counter, "Datagrams that are no announcement"},
    {"sealing_", "geminga_datagrams_unsealed", "reason", Type::counter, "Datagrams not heard for their seal"},
    {"dropped_", "geminga_datagrams_dropped", "reason", Type::counter, "Datagrams that were not looked at"},
    {"matched_", "geminga_matches", "degree", Type::counter, "Services that requests of this host were given"},
});

/// The number of a text as it stands, if it is a decimal number.
std::optional<std::string> number(std::string_view text) {
  const bool is_number = !text.empty() && text.size() <= 32 && text.find_first_not_of("0123456789.") == text.npos &&
                         std::ranges::count(text, '.') <= 1 && text.front() != '.' && text.back() != '.';
  return is_number ? std::optional(std::string(text)) : std::nullopt;
}

Family made(std::string_view name, Type type, std::string_view unit, std::string_view help) {
  return {.name = std::string(name), .type = type, .unit = std::string(unit), .help = std::string(help)};
}

Family of_one(std::string_view name, std::string_view help, std::string value) {
  Family family = made(name, Type::gauge, "", help);
  family.samples.push_back({{}, std::move(value)});
  return family;
}

/// The answer of a question; null where there is none.
const Answer* answer_in(const std::vector<Outcome>& outcomes, std::string_view kind) {
  const auto& questions = metric_questions();
  const auto at = static_cast<std::size_t>(std::ranges::find(questions, kind, &Query::kind) - questions.begin());
  return at < outcomes.size() && outcomes[at] && outcomes[at]->has_value() ? &outcomes[at]->value() : nullptr;
}

void append_status(std::vector<Family>& families, const Record& status) {
  Family daemon = made("geminga_daemon", Type::info, "", "The daemon that answers");
  Labels labels;
  for (const char* key : {"version", "state", "participant", "name", "group", "ontology", "sealing"}) {
    if (!status[key].empty()) labels.emplace_back(key, status[key]);
  }
  daemon.samples.push_back({std::move(labels), "1"});
  families.push_back(std::move(daemon));
  for (const Measure& measure : measures) {
    const bool is_zero =
        status[measure.key].empty() && std::ranges::find(zero_unless_told, measure.key) != zero_unless_told.end();
    Family family = made(measure.name, measure.type, measure.unit, measure.help);
    if (const auto value = number(is_zero ? "0" : status[measure.key])) family.samples.push_back({{}, *value});
    families.push_back(std::move(family));
  }
  for (const Group& group : groups) {
    Family family = made(group.name, group.type, "", group.help);
    for (const auto& [key, text] : status.fields) {
      const auto value = number(text);
      if (!value || !key.starts_with(group.prefix)) continue;
      family.samples.push_back({{{std::string(group.label), key.substr(group.prefix.size())}}, *value});
    }
    families.push_back(std::move(family));
  }
  for (const char* key : {"ontology_loading", "ontology_failed", "ontology_contradiction", "configuration_failed"}) {
    const bool is_so = !status[key].empty() && status[key] != "0";
    families.push_back(
        of_one("geminga_" + std::string(key), "1 where query status says so, else 0", is_so ? "1" : "0"));
  }
}

void append_neighbours(std::vector<Family>& families, const Answer& participants) {
  Family loss =
      made("geminga_neighbour_loss_ratio", Type::gauge, "ratio", "Share of its announcements that were missed");
  Family least = made("geminga_neighbour_loss_least_ratio", Type::gauge, "ratio",
                      "Share of its announcements that was missed at least, if one allows for chance");
  Family age = made("geminga_neighbour_age_seconds", Type::gauge, "seconds", "Time since it was last heard");
  Family hears = made("geminga_neighbour_hears_us", Type::gauge, "", "0 where it has said that it does not hear us");
  Family reach =
      made("geminga_neighbour_reachable", Type::gauge, "", "0 where its address cannot be reached from this host");
  std::size_t told = 0;
  for (const Record& record : participants.records) {
    if (record["self"] == "1") continue;
    if (++told > max_neighbour_samples) break;
    const Labels labels{{"participant", std::string(record["id"])}, {"name", std::string(record["name"])}};
    if (const auto value = number(record["loss"])) loss.samples.push_back({labels, *value});
    if (const auto value = number(record["loss_least"])) least.samples.push_back({labels, *value});
    if (const auto value = number(record["heard"])) age.samples.push_back({labels, *value});
    hears.samples.push_back({labels, record["hears_us"] == "0" ? "0" : "1"});
    reach.samples.push_back({labels, record["reachable"] == "no" ? "0" : "1"});
  }
  for (Family* family : {&loss, &least, &age, &hears, &reach}) families.push_back(std::move(*family));
}

std::string identity_of(const Record& record) {
  if (!record["concept"].empty()) {
    return std::string(record["concept"]) +
           (record["representation"].empty() ? "" : " in " + std::string(record["representation"]));
  }
  return std::string(record[record["text"].empty() ? "id" : "text"]);
}

void append_requests(std::vector<Family>& families, const Answer& requests) {
  families.push_back(
      of_one("geminga_requests_unmatched", "Requests that nobody serves", std::to_string(requests.records.size())));
  Family each = made("geminga_request_unmatched", Type::gauge, "", "1 for each request that nobody serves");
  for (const Record& record : requests.records) {
    if (each.samples.size() == max_unmatched_samples) break;
    each.samples.push_back({{{"subscription", std::string(record["subscription"])},
                             {"consumer", std::string(record["name"])},
                             {"participant", std::string(record["participant_name"])},
                             {"identity", identity_of(record)},
                             {"why", std::string(record["why"])}},
                            "1"});
  }
  families.push_back(std::move(each));
}

void append_ontology(std::vector<Family>& families, const Answer& answer) {
  const answers::Ontology ontology = answers::ontology_of(answer);
  const bool is_loaded = ontology.head["loaded"] == "1";
  families.push_back(of_one("geminga_ontology_loaded", "1 where an ontology is in force", is_loaded ? "1" : "0"));
  if (!is_loaded) return;
  Family digest = made("geminga_ontology", Type::info, "", "The ontology in force");
  digest.samples.push_back({{{"digest", std::string(ontology.head["digest"])}}, "1"});
  families.push_back(std::move(digest));
  families.push_back(of_one("geminga_ontology_complete", "1 where all that follows from it was found",
                            ontology.head["complete"] == "1" ? "1" : "0"));
  if (const auto classes = number(ontology.head["classes"])) {
    families.push_back(of_one("geminga_ontology_classes", "Its named classes", *classes));
  }
  families.push_back(of_one("geminga_ontology_left_out", "Constructs that the reasoner does not use",
                            std::to_string(ontology.left_out.size())));
}

void append_security(std::vector<Family>& families, const Answer& answer) {
  const answers::Security security = answers::security_of(answer);
  const auto lacking =
      std::ranges::count_if(security.participants, [](const Record& one) { return !one["lacks"].empty(); });
  families.push_back(of_one("geminga_participants_lacking_key", "Participants that do not open with each of our keys",
                            std::to_string(lacking)));
  families.push_back(
      of_one("geminga_keys", "Keys of this daemon; 0: nothing is sealed",
             std::to_string(security.head["keys"].empty() ? 0 : std::ranges::count(security.head["keys"], ',') + 1)));
  families.push_back(of_one("geminga_rejected_sources", "Senders of the datagrams that were rejected lately",
                            std::to_string(security.rejected.size())));
}

void append_traffic(std::vector<Family>& families, const Traffic& traffic) {
  Family responses = made("geminga_web_responses", Type::counter, "", "Responses of geminga-web by status");
  for (const auto& [status, count] : traffic.responses) {
    responses.samples.push_back({{{"status", std::to_string(status)}}, std::to_string(count)});
  }
  families.push_back(std::move(responses));
  Family streams = made("geminga_web_streams", Type::counter, "", "Streams of events that geminga-web has begun");
  streams.samples.push_back({{}, std::to_string(traffic.streams)});
  families.push_back(std::move(streams));
}

}  // namespace

const std::vector<Query>& metric_questions() {
  static const std::vector<Query> questions{
      {"status"}, {"participants"}, {"requests", {{"unmatched", "1"}}}, {"ontology"}, {"security"}};
  return questions;
}

std::vector<Family> metrics(const std::vector<Outcome>& outcomes, const Traffic& traffic) {
  std::vector<Family> families;
  const Answer* status = answer_in(outcomes, "status");
  const bool is_up = status != nullptr && status->records.size() == 1;
  families.push_back(of_one("geminga_up", "1 where the daemon answers", is_up ? "1" : "0"));
  if (is_up) append_status(families, status->records.front());
  if (const Answer* answer = answer_in(outcomes, "participants")) append_neighbours(families, *answer);
  if (const Answer* answer = answer_in(outcomes, "requests")) append_requests(families, *answer);
  if (const Answer* answer = answer_in(outcomes, "ontology")) append_ontology(families, *answer);
  if (const Answer* answer = answer_in(outcomes, "security")) append_security(families, *answer);
  append_traffic(families, traffic);
  return families;
}

}  // namespace geminga::web
