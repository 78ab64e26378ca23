// geminga-query doctor: looks for the usual causes of silence on this host, in the team, and in what is asked for.
#include <boost/json/object.hpp>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "doctor/examination.hpp"
#include "doctor/other_view.hpp"
#include "doctor/report.hpp"
#include "query/command.hpp"
#include "query/listing.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"
#include "shell/table.hpp"

namespace geminga::query {
namespace {

using doctor::Answers;
using doctor::Finding;
using doctor::Findings;
using doctor::Severity;
using doctor::word;

/// Writes one paragraph, wrapped to the terminal, behind a title.
void print_part(const Context& context, std::string_view title, std::string_view text) {
  if (text.empty()) return;
  constexpr std::size_t indent = 11;
  const std::size_t columns = context.terminal.columns > 2 * indent ? context.terminal.columns - indent : 0;
  const std::string clean = shell::printable(text);
  const std::vector<std::string> lines = columns == 0 ? std::vector{clean} : shell::wrapped(clean, columns);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const std::string begin = line == 0 ? "  " + std::string(title) : "";
    std::cout << begin << std::string(indent - begin.size(), ' ') << shell::encoded(context.terminal, lines[line])
              << '\n';
  }
}

void print_findings(const Context& context, const Findings& findings, const std::optional<Answers>& answers) {
  if (findings.empty()) {
    const std::size_t known = answers ? answers->participants.size() : 0;
    std::cout << "Healthy: nothing is wrong on this host and among " << known
              << (known == 1 ? " participant.\n" : " participants.\n");
    return;
  }
  for (const Finding& finding : findings) {
    const auto colour = finding.severity == Severity::failure ? shell::Colour::red : shell::Colour::yellow;
    std::cout << shell::coloured(context.terminal, colour, word(finding.severity)) << ' ' << finding.code << '\n';
    print_part(context, "what", finding.what);
    print_part(context, "seen", finding.seen);
    print_part(context, "do", finding.remedy);
    if (!finding.command.empty()) std::cout << "  command  " << shell::printable(finding.command) << '\n';
  }
}

/// Writes the report. False: it could not be written, which has been said.
bool write_report(const std::string& file, const boost::json::object& report) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  shell::print(out, report);
  out.close();
  if (out) return true;
  shell::complain(program, file + ": cannot be written: name another file for --report");
  return false;
}

struct Wishes {
  std::string report;
  bool is_nameless = false;
  std::string with;
};

void print_side_by_side(const Context& context, const doctor::OtherView& other, const Answers& ours) {
  if (!other.is_answered) return;
  shell::Table table({{"WHAT"}, {"HERE", false, 20}, {shell::printable(other.name), false, 20}});
  for (const auto& row : doctor::side_by_side(other, ours)) table.add({row.what, row.here, row.there});
  table.print(std::cout, context.terminal);
}

shell::ExitStatus diagnose(const Context& context, Result<Client, ClientError>& client, const Wishes& wishes) {
  if (refuses_watch(context, "doctor")) return shell::ExitStatus::wrong_use;
  if (!client && client.error().kind == ClientError::Kind::wrong_use) return shell::report(program, client.error());
  const auto looked =
      doctor::examine(client, {.version = GEMINGA_VERSION, .connect = context.common.connect, .with = wishes.with});
  if (!looked) return shell::report(program, looked.error());
  const auto& [findings, host, answers, other] = *looked;
  if (!wishes.report.empty()) {
    const auto names = wishes.is_nameless ? doctor::Names::numbered : doctor::Names::as_they_are;
    if (!write_report(wishes.report, doctor::report_of(findings, host, answers, other, names)))
      return shell::ExitStatus::wrong_use;
  }
  if (context.common.is_json) {
    shell::print(std::cout, doctor::to_json(*looked));
  } else {
    if (other) print_side_by_side(context, *other, *answers);
    print_findings(context, findings, answers);
  }
  return findings.empty() ? shell::ExitStatus::found : shell::ExitStatus::nothing;
}

}  // namespace

void add_doctor(CLI::App& app, RunEvenAlone& selected) {
  CLI::App* command = app.add_subcommand("doctor", "Look for the usual causes of silence, and say what to do");
  const auto wishes = std::make_shared<Wishes>();  // lives as long as the command's function
  command
      ->add_option(
          "--with", wishes->with,
          "Also ask this participant (its name, identifier or address) what it hears, and show both views; its "
          "owner has to allow it (diagnose)")
      ->type_name("HOST");
  CLI::Option* report = command->add_option(
      "--report", wishes->report,
      "Also write all that was seen into this file, as JSON, to be sent to others; it contains no keys");
  report->type_name("FILE");
  command
      ->add_flag("--without-names", wishes->is_nameless,
                 "In the report, replace the names of hosts, users, programs and services by numbers")
      ->needs(report);
  command->footer(
      "Examples:\n  geminga-query doctor\n  geminga-query doctor --with robot2\n  geminga-query doctor --report "
      "report.json --without-names\n  geminga-query "
      "--json doctor | "
      "jq "
      "'.findings[].code'\nExit status 0: nothing is wrong; 1: something is.");
  command->callback([&selected, wishes] {
    selected = [wishes](const Context& context, Result<Client, ClientError>& client) {
      return diagnose(context, client, *wishes);
    };
  });
}

}  // namespace geminga::query
