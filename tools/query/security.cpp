// geminga-query security: datagrams by mode and key, rejected datagrams with the reason, and the keys that participants
// lack.
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <iostream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

/// The lines of the answer by kind (src/discovery/participant/QUERIES.md).
struct Security {
  Record head;
  std::vector<Record> datagrams;
  std::vector<Record> participants;
  std::vector<Record> rejected;
};

Security security_of(const Answer& answer) {
  const std::vector<Record> heads = with_field(answer, "mode");
  return {heads.empty() ? Record{} : heads.front(), with_field(answer, "datagrams"), with_field(answer, "participant"),
          with_field(answer, "source")};
}

void print_security_json(const Security& security) {
  boost::json::object object = shell::to_json(security.head);
  if (!object.contains("keys")) object["keys"] = boost::json::array();
  object["datagrams"] = shell::to_json(security.datagrams);
  boost::json::array participants = shell::to_json(security.participants);
  for (auto& participant : participants) {
    for (const char* list : {"keys", "lacks"}) {
      if (!participant.as_object().contains(list)) participant.as_object()[list] = boost::json::array();
    }
  }
  object["participants"] = std::move(participants);
  object["rejected"] = shell::to_json(security.rejected);
  shell::print(std::cout, object);
}

void print_own_sealing(const Context& context, const Security& security) {
  if (security.head["keys"].empty()) {
    shell::print_wrapped(std::cout, context.terminal,
                         "Nothing is sealed: there is no key. Whoever is on the link can be heard: see gemingad "
                         "--generate-key.");
    return;
  }
  const std::string keys(security.head["keys"]);
  shell::print_wrapped(std::cout, context.terminal,
                       shell::printable(std::string(security.head["mode"]) + ", keys " + keys + ": " +
                                        keys.substr(0, keys.find(',')) + " seals, all of them open"));
}

std::string_view dash(std::string_view text) { return text.empty() ? "-" : text; }

void print_security(const Context& context, const Security& security) {
  print_own_sealing(context, security);
  shell::Table participants(
      {{"PARTICIPANT"}, {"NAME", false, 8}, {"SAYS"}, {"SEALS WITH"}, {"OPENS WITH", false, 10}, {"LACKS", false, 9}});
  for (const auto& record : security.participants) {
    participants.add({record["participant"], record["name"], record["protection"], dash(record["key"]),
                      dash(record["keys"]), dash(record["lacks"])});
  }
  participants.print(std::cout, context.terminal, "\n");
  shell::Table datagrams({{"DATAGRAMS", true}, {"SEALED"}, {"KEY"}, {"REJECTED"}});
  for (const auto& record : security.datagrams) {
    datagrams.add({record["datagrams"], record["protection"], dash(record["key"]), dash(record["rejected"])});
  }
  datagrams.print(std::cout, context.terminal, "\nThe last datagrams, a thousand at most:\n");
  shell::Table rejected({{"FROM", false, 12}, {"SEALED"}, {"KEY"}, {"REJECTED"}, {"COUNT", true}, {"LAST", true}});
  for (const auto& record : security.rejected) {
    rejected.add({record["source"], record["protection"], dash(record["key"]), record["rejected"], record["count"],
                  shell::duration_words(record["age"])});
  }
  rejected.print(std::cout, context.terminal, "\nNot heard:\n");
}

}  // namespace

void add_security(CLI::App& app, Run& selected) {
  CLI::App* command =
      app.add_subcommand("security", "What is on the air by mode and key, what was rejected, who lacks which key");
  command->footer(
      "Examples:\n  geminga-query security\n  geminga-query --json security | jq '.participants[] | select(.lacks != "
      "[])'\nIn a rotation: LACKS is empty everywhere when everybody has the new key, and SEALS WITH shows it "
      "everywhere "
      "when the old one can go.");
  command->callback([&selected] {
    selected = [](const Context& context, Client& client) {
      return show_once(context, client, "security", {}, [&](const Answer& answer) {
        const Security security = security_of(answer);
        if (context.common.is_json) {
          print_security_json(security);
        } else {
          print_security(context, security);
        }
        return shell::ExitStatus::found;
      });
    };
  });
}

}  // namespace geminga::query
