// `query diagnosis`: what another participant hears and how it is; and our own answer to that question, which goes over
// the air.
#include <algorithm>
#include <array>
#include <string_view>

#include "discovery/announcement/limits.hpp"
#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"

namespace geminga::participant {
namespace {

/// The keys of `query status` that others are told of: no names of users, programs and files.
constexpr std::array told_of_status{"version",      "state",           "uptime",           "interval",   "participants",
                                    "publications", "subscriptions",   "ontology",         "sealing",    "port",
                                    "multicast",    "clients_refused", "refused_services", "unheard_by", "log_dropped"};
constexpr std::array<std::string_view, 6> told_counts{"rejected_",  "sealing_",    "dropped_",
                                                      "heard_full", "heard_other", "heard_contradiction"};
constexpr std::array told_of_interfaces{"name", "addresses", "sent", "received", "quiet", "ipv6"};
constexpr std::array told_of_participants{"id", "heard", "loss", "loss_least", "ontology", "hears_us"};

bool is_count(std::string_view key) {
  return std::ranges::any_of(told_counts, [&](std::string_view begin) { return key.starts_with(begin); });
}

/// One line of the air: what follows the number and `msg` in a line of GCNP.
std::string line_of(std::string_view part, Line parameters) {
  const gcnp::Statement statement{
      .id = 0, .command = "msg", .subcommand = std::string(part), .parameters = std::move(parameters)};
  std::string text = gcnp::to_line(statement);
  constexpr std::size_t beginning = std::string_view("0 msg ").size();
  constexpr std::size_t ending = std::string_view("\r\n").size();
  return text.substr(beginning, text.size() - beginning - ending);
}

/// Appends the parameters that `is_told` admits, in as many lines as they need.
template <typename IsTold>
void append(std::vector<std::string>& lines, std::string_view part, const Line& all, const IsTold& is_told) {
  Line here;
  for (const gcnp::Parameter& parameter : all) {
    if (!is_told(parameter.key)) continue;
    here.push_back(parameter);
    if (line_of(part, here).size() <= announcement::max_diagnosis_line_bytes) continue;
    here.pop_back();
    if (!here.empty()) lines.push_back(line_of(part, std::exchange(here, {})));
    if (line_of(part, {parameter}).size() <= announcement::max_diagnosis_line_bytes) here.push_back(parameter);
  }
  if (!here.empty()) lines.push_back(line_of(part, here));
}

template <typename Keys>
auto one_of(const Keys& keys) {
  return [&keys](std::string_view key) { return std::ranges::find(keys, key) != keys.end(); };
}

}  // namespace

std::vector<std::string> diagnosis_lines(const Answer& status, const Answer& interfaces, const Answer& participants,
                                         ParticipantId asker) {
  std::vector<std::string> lines;
  for (const Line& line : status.lines) {
    append(lines, "status", line, [](std::string_view key) { return one_of(told_of_status)(key) || is_count(key); });
  }
  for (const Line& line : interfaces.lines) append(lines, "interfaces", line, one_of(told_of_interfaces));
  // The line about the one that asks comes first, since not all may fit.
  for (const bool is_asker : {true, false}) {
    for (const Line& line : participants.lines) {
      if ((*line.front().value == to_string(asker)) == is_asker)
        append(lines, "participants", line, one_of(told_of_participants));
    }
  }
  return lines;
}

Answer answer_diagnosis(const Diagnoses::Diagnosis* diagnosis, base::Instant now) {
  Answer answer{.kind = "diagnosis", .lines = {}, .end = {}};
  if (diagnosis == nullptr) {
    append(answer.end, "state", "asked");
    return answer;
  }
  for (const std::string& text : diagnosis->lines) {
    // It comes from the air: a line that is no GCNP is left out.
    auto read = gcnp::parse("0 msg " + text);
    if (!read) continue;
    Line line;
    append(line, "part", read->subcommand);
    for (gcnp::Parameter& parameter : read->parameters) {
      if (parameter.key != "part") line.push_back(std::move(parameter));
    }
    answer.lines.push_back(std::move(line));
  }
  append(answer.end, "state", "answered");
  append(answer.end, "age", seconds(now - diagnosis->heard));
  return answer;
}

}  // namespace geminga::participant
