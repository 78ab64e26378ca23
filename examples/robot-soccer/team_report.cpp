// Tells in plain words who of the team gets what: which requests are met exactly, which only thanks to the ontology and
// why, and which by nobody. Asks the local daemon; any host of the team gives the same answer.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "geminga/client.hpp"

namespace {

using geminga::Answer;
using geminga::Client;
using geminga::Record;

/// One request as every host of a kind states it.
struct Request {
  std::string module;
  std::string concept_name;
  auto operator<=>(const Request&) const = default;
};

/// The result over all hosts.
struct Outcome {
  int asked = 0;
  int met = 0;
  int exactly = 0;
  std::set<std::string> given;  ///< the concepts that came in place of the one that was asked for
};

Answer ask(Client& client, std::string_view kind, const std::vector<std::pair<std::string, std::string>>& parameters) {
  auto answer = client.query(kind, parameters);
  if (answer) return std::move(*answer);
  std::cerr << "team_report: " << kind << ": " << answer.error().text << '\n';
  std::exit(3);
}

Outcome& add(std::map<Request, Outcome>& outcomes, const Record& request, const Answer& matches) {
  Outcome& outcome = outcomes[{std::string(request["name"]), std::string(request["concept"])}];
  ++outcome.asked;
  outcome.met += matches.records.empty() ? 0 : 1;
  outcome.exactly +=
      std::ranges::any_of(matches.records, [](const Record& m) { return m["degree"] == "exact"; }) ? 1 : 0;
  for (const Record& match : matches.records) {
    if (match["degree"] != "exact") outcome.given.emplace(match["concept"]);
  }
  return outcome;
}

void print_row(const std::string& module, const std::string& what, const Outcome& outcome) {
  std::cout << "  " << std::left << std::setw(20) << module << std::setw(34) << what << outcome.met << " of "
            << outcome.asked << '\n';
}

void print_why(Client& client, const Request& request, const Outcome& outcome) {
  for (const std::string& given : outcome.given) {
    std::cout << "      is given " << given << ", because\n";
    for (const Record& axiom : ask(client, "explain", {{"sub", given}, {"super", request.concept_name}}).records) {
      const std::string file(axiom["file"]);
      std::cout << "        " << axiom["axiom"] << "   (" << file.substr(file.rfind('/') + 1) << ':' << axiom["line"]
                << ")\n";
    }
  }
}

}  // namespace

int main() {
  auto client = Client::connect();
  if (!client) {
    std::cerr << "team_report: " << client.error().text << '\n';
    return 3;
  }
  std::map<Request, Outcome> outcomes;
  for (const Record& request : ask(*client, "requests", {}).records) {
    std::vector<std::pair<std::string, std::string>> wanted{{"concept", std::string(request["concept"])},
                                                            {"mode", std::string(request["mode"])}};
    if (!request["provider"].empty()) wanted.emplace_back("provider", request["provider"]);
    if (!request["representation"].empty()) wanted.emplace_back("representation", request["representation"]);
    add(outcomes, request, ask(*client, "match", wanted));
  }
  const auto section = [&](const char* title, auto&& belongs, bool with_reasons) {
    std::cout << '\n'
              << title << "\n  " << std::left << std::setw(20) << "module" << std::setw(34) << "asks for" << "met on\n";
    for (const auto& [request, outcome] : outcomes) {
      if (!belongs(outcome)) continue;
      print_row(request.module, request.concept_name, outcome);
      if (with_reasons) print_why(*client, request, outcome);
    }
  };
  section("Requests that are met exactly", [](const Outcome& o) { return o.exactly > 0; }, false);
  section(
      "Requests that are met only thanks to the ontology, and why",
      [](const Outcome& o) { return o.met > 0 && o.exactly == 0; }, true);
  section("Requests that nobody serves", [](const Outcome& o) { return o.met == 0; }, false);
}
