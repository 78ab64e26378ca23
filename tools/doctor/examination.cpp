#include "doctor/examination.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

#include "doctor/checks.hpp"
#include "doctor/experiments.hpp"
#include "doctor/overhearing.hpp"
#include "doctor/report.hpp"
#include "doctor/steady.hpp"

namespace geminga::doctor {
namespace {

void append(Findings& findings, Findings more) {
  findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Listens to the link for a little longer than an interval, in which each neighbour speaks once without loss.
std::vector<Overheard> overhear(const Answers& answers) {
  constexpr double intervals = 1.25;
  constexpr double longest = 5;
  std::vector<std::string> interfaces;
  for (const Record& one : answers.interfaces) {
    if (one["loopback"] == "0") interfaces.emplace_back(one["name"]);
  }
  const double seconds = std::min(intervals * number(answers.status["interval"]), longest);
  return overhear(interfaces, habits_of(answers), std::chrono::milliseconds(std::lround(1000 * seconds)));
}

/// All that the daemon shows, in two looks with the time of listening between them, and the other one where it is to be
/// asked.
std::expected<void, ClientError> look(Client& client, const Wish& wish, Examination& into) {
  const auto first = ask(client);
  if (!first) return std::unexpected(first.error());
  const std::vector<Overheard> overheard = overhear(*first);
  auto second = ask(client);
  if (!second) return std::unexpected(second.error());
  into.answers = steady(*first, std::move(*second));
  Answers& answers = *into.answers;
  if (auto found = find_unknown(client, answers); !found) return std::unexpected(found.error());
  append(into.findings, check_daemon(answers, wish.version));
  append(into.findings, check_firewall(into.host, answers, &try_to_send));
  append(into.findings, check_multicast_routes(answers, &try_to_send));
  append(into.findings, check_team(answers, overhears_all()));
  append(into.findings, check_addresses(into.host, answers, &has_route));
  append(into.findings, check_overheard(into.host, answers, overheard));
  append(into.findings, check_requests(answers));
  if (wish.with.empty()) return {};
  auto asked_other = ask_other(client, answers, wish.with);
  if (!asked_other) return std::unexpected(asked_other.error());
  into.other = std::move(*asked_other);
  append(into.findings, check_other(*into.other, answers, wish.version));
  return {};
}

}  // namespace

std::expected<Examination, ClientError> examine(Result<Client, ClientError>& client, const Wish& wish) {
  Examination all;
  all.host = look_at_host();
  if (!client) {
    append(all.findings, check_absent_daemon(all.host, client.error(), wish.connect));
  } else if (const auto looked = look(*client, wish, all); !looked) {
    return std::unexpected(looked.error());
  }
  const bool uses_loopback = all.answers && std::ranges::any_of(all.answers->interfaces, [](const Record& one) {
                               return one["loopback"] == "1";
                             });
  append(all.findings, check_host(all.host, uses_loopback));
  drop_consequences(all.findings);
  sort_by_severity(all.findings);
  return all;
}

boost::json::object to_json(const Examination& examination) {
  boost::json::object document = to_json(examination.findings);
  if (examination.other) document["with"] = to_json(*examination.other);
  return document;
}

}  // namespace geminga::doctor
