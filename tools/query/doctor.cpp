// geminga-query doctor: looks for the usual causes of silence on this host, in the team, and in what is asked for.
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <boost/json/serialize.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>

#include "doctor/checks.hpp"
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

std::string_view word(Severity severity) { return severity == Severity::failure ? "failure" : "risk"; }

boost::json::object to_json(const Finding& finding) {
  return {
      {"severity", word(finding.severity)}, {"code", finding.code},      {"what", finding.what}, {"seen", finding.seen},
      {"remedy", finding.remedy},           {"command", finding.command}};
}

boost::json::object to_json(const Findings& findings) {
  boost::json::array list;
  for (const Finding& finding : findings) list.push_back(to_json(finding));
  return {{"healthy", findings.empty()}, {"findings", std::move(list)}};
}

boost::json::array to_json(const doctor::Host& host) {
  boost::json::array interfaces;
  for (const doctor::HostInterface& interface : host.interfaces) {
    interfaces.push_back({{"name", interface.name},
                          {"up", interface.is_up},
                          {"carrier", interface.has_carrier},
                          {"multicast", interface.can_multicast},
                          {"wireless", interface.is_wireless},
                          {"mtu", interface.mtu},
                          {"addresses", boost::json::array(interface.addresses.begin(), interface.addresses.end())}});
  }
  return interfaces;
}

/// A report for somebody who helps: findings, this host and the team, without keys and messages.
boost::json::object report_of(const Findings& findings, const doctor::Host& host,
                              const std::optional<Answers>& answers) {
  boost::json::object report = to_json(findings);
  report["interfaces_of_host"] = to_json(host);
  if (!answers) return report;
  report["status"] = shell::to_json(answers->status);
  report["interfaces"] = shell::to_json(answers->interfaces);
  report["participants"] = shell::to_json(answers->participants);
  report["security"] = shell::to_json(answers->security);
  report["ontology"] = shell::to_json(answers->ontology);
  report["unmatched"] = shell::to_json(answers->unmatched);
  return report;
}

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

shell::ExitStatus diagnose(const Context& context, Result<Client, ClientError>& client, const std::string& report) {
  if (refuses_watch(context, "doctor")) return shell::ExitStatus::wrong_use;
  if (!client && client.error().kind == ClientError::Kind::wrong_use) return shell::report(program, client.error());
  const doctor::Host host = doctor::look_at_host();
  Findings findings = doctor::check_host(host);
  std::optional<Answers> answers;
  const auto add = [&](Findings more) {
    findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  if (client) {
    auto asked = doctor::ask(*client);
    if (!asked) return shell::report(program, asked.error());
    answers = std::move(*asked);
    add(doctor::check_daemon(*answers, GEMINGA_VERSION));
    add(doctor::check_team(*answers));
    add(doctor::check_requests(*answers));
  } else {
    add(doctor::check_absent_daemon(host, client.error(), context.common.connect));
  }
  doctor::sort_by_severity(findings);
  if (!report.empty() && !write_report(report, report_of(findings, host, answers))) return shell::ExitStatus::wrong_use;
  if (context.common.is_json) {
    shell::print(std::cout, to_json(findings));
  } else {
    print_findings(context, findings, answers);
  }
  return findings.empty() ? shell::ExitStatus::found : shell::ExitStatus::nothing;
}

}  // namespace

void add_doctor(CLI::App& app, RunEvenAlone& selected) {
  CLI::App* command = app.add_subcommand("doctor", "Looks for the usual causes of silence, and says what to do");
  const auto report = std::make_shared<std::string>();  // lives as long as the command's function
  command
      ->add_option("--report", *report,
                   "Also write all that was seen into this file, as JSON, to send it to somebody: it has no keys")
      ->type_name("FILE");
  command->footer(
      "Examples:\n  geminga-query doctor\n  geminga-query doctor --report report.json\n  geminga-query --json doctor | "
      "jq "
      "'.findings[].code'\nExit status 0: nothing is wrong; 1: something is.");
  command->callback([&selected, report] {
    selected = [report](const Context& context, Result<Client, ClientError>& client) {
      return diagnose(context, client, *report);
    };
  });
}

}  // namespace geminga::query
