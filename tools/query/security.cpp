// geminga-query security: datagrams by mode and key, rejected datagrams with the reason, and the keys that participants
// lack.
#include "answers/security.hpp"

#include <iostream>

#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/describe.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

using answers::Security;

void print_own_sealing(const Context& context, const Security& security) {
  if (security.head["keys"].empty()) {
    shell::print_wrapped(
        std::cout, context.terminal,
        "Nothing is sealed: there is no key. Datagrams of any host on the link are accepted: see gemingad "
        "--generate-key.");
    return;
  }
  // The first key is the one that seals; in mode `prepared` nothing is sealed yet.
  const std::string keys(security.head["keys"]);
  const std::string mode(security.head["mode"]);
  const std::string sends =
      mode == "prepared" ? "plain datagrams" : "datagrams sealed with key " + keys.substr(0, keys.find(','));
  const bool has_many = keys.find(',') != std::string::npos;
  const std::string plain = mode == "prepared" || mode == "mixed" ? ", and plain ones" : "";
  shell::print_wrapped(std::cout, context.terminal,
                       shell::printable("Mode " + mode + ": this host sends " + sends + ", and accepts those with " +
                                        (has_many ? "one of the keys " : "key ") + keys + plain + "."));
}

std::string_view dash(std::string_view text) { return text.empty() ? "-" : text; }

void print_security(const Context& context, const Security& security) {
  print_own_sealing(context, security);
  shell::Table participants(
      {{"PARTICIPANT"}, {"NAME", false, 8}, {"MODE"}, {"SEALS WITH"}, {"OPENS WITH", false, 10}, {"LACKS", false, 9}});
  for (const auto& record : security.participants) {
    participants.add({record["participant"], record["name"], record["protection"], dash(record["key"]),
                      dash(record["keys"]), dash(record["lacks"])});
  }
  participants.print(std::cout, context.terminal, "\nOther participants and their keys:\n");
  shell::Table datagrams({{"DATAGRAMS", true}, {"SEALED"}, {"KEY"}, {"REJECTED AS"}});
  for (const auto& record : security.datagrams) {
    datagrams.add({record["datagrams"], record["protection"], dash(record["key"]), dash(record["rejected"])});
  }
  datagrams.print(std::cout, context.terminal, "\nThe last thousand datagrams received:\n");
  shell::Table rejected({{"FROM", false, 12}, {"SEALED"}, {"KEY"}, {"REJECTED AS"}, {"COUNT", true}, {"LAST", true}});
  for (const auto& record : security.rejected) {
    rejected.add({record["source"], record["protection"], dash(record["key"]), record["rejected"], record["count"],
                  shell::duration_words(record["age"])});
  }
  rejected.print(std::cout, context.terminal, "\nRejected, by sender and reason:\n");
}

}  // namespace

void add_security(CLI::App& app, Run& selected) {
  CLI::App* command = app.add_subcommand(
      "security",
      "Show which datagrams were heard, by mode of sealing and key, what was rejected, and who lacks a key");
  command->footer(
      "Examples:\n  geminga-query security\n  geminga-query --json security | jq '.participants[] | select(.lacks != "
      "[])'\nWhile keys are rotated: when LACKS is empty in every row, everybody has the new key; when SEALS WITH is "
      "the "
      "new key in every row, the old one can go.");
  command->callback([&selected] {
    selected = [](const Context& context, Client& client) {
      return show_once(context, client, "security", {}, [&](const Answer& answer) {
        const Security security = answers::security_of(answer);
        if (context.common.is_json) {
          shell::print(std::cout, answers::security_document(security));
        } else {
          print_security(context, security);
        }
        return shell::ExitStatus::found;
      });
    };
  });
}

}  // namespace geminga::query
