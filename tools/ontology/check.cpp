// `geminga-ontology check`: the faults and omissions of an ontology before robots rely on it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/findings/findings.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/loading/consistency.hpp"
#include "reasoning/compiled/similar.hpp"

namespace geminga::ontology {
namespace {

/// The most axioms of one construct that are shown without --all.
constexpr std::size_t max_shown = 5;

struct CheckRequest {
  std::vector<std::string> files;
  bool as_json = false;
  bool shows_all = false;
  bool is_lenient = false;
  bool is_strict = false;
};

/// The lines of a list; without `shows_all` the first ones.
std::string lines_of(const std::vector<std::string>& lines, bool shows_all) {
  std::string text;
  const std::size_t shown = shows_all ? lines.size() : std::min(lines.size(), max_shown);
  for (std::size_t at = 0; at < shown; ++at) text += "  " + lines[at] + '\n';
  if (shown < lines.size()) text += "  and " + std::to_string(lines.size() - shown) + " more: --all\n";
  return text;
}

/// The construct with its count and first place; with `shows_all` each place where the reader met it.
std::string group_as_text(const LeftOutGroup& entry, bool shows_all) {
  std::string text = "  " + entry.summary.construct + ": " + std::to_string(entry.summary.count) + ", first at " +
                     entry.summary.first + '\n';
  if (shows_all && entry.places.size() > 1) {
    for (const Place& one : entry.places) text += "    at " + place(one.file, one.line) + '\n';
  }
  return text;
}

std::string left_out_as_text(const Findings& findings, bool shows_all) {
  std::string text;
  if (!findings.left_out.empty()) text += "Left out:\n";
  for (const LeftOutGroup& entry : findings.left_out) {
    text += group_as_text(entry, shows_all);
    const std::size_t shown = shows_all ? entry.axioms.size() : std::min(entry.axioms.size(), max_shown);
    for (std::size_t at = 0; at < shown; ++at) text += "    " + axiom_line(entry.axioms[at]) + '\n';
    if (shown < entry.axioms.size())
      text += "    and " + std::to_string(entry.axioms.size() - shown) + " more: --all\n";
  }
  if (!findings.remarks.empty()) text += "Read otherwise than written:\n";
  for (const LeftOutGroup& remark : findings.remarks) text += group_as_text(remark, shows_all);
  const auto is_not_simple = [](const LeftOutGroup& entry) {
    return entry.summary.construct.ends_with("of a property that is not simple");
  };
  if (std::ranges::any_of(findings.left_out, is_not_simple))
    text +=
        "OWL 2 DL allows none of this for a property that is transitive or has a chain. Characteristics of it are "
        "used\n"
        "for neighbours that are told or made, and the rest is left out.\n";
  if (findings.touched && !findings.touched->empty())
    text += "What was left out may matter to the superclasses of " +
            counted(findings.touched->size(), "class", "classes") + ":\n" + lines_of(*findings.touched, shows_all);
  if (!findings.gaps.empty()) text += "Not searched to the end:\n";
  for (const std::string& gap : findings.gaps) text += "  " + gap + '\n';
  return text;
}

std::string open_as_text(const Open& open, bool shows_all) {
  std::string text;
  if (open.consistency) text += "Not decided: whether the files contradict themselves.\n";
  if (!open.classes.empty())
    text += "Not decided: whether more is above " + counted(open.classes.size(), "class", "classes") + ":\n" +
            lines_of(open.classes, shows_all);
  if (open.held_up_by) text += "Held up by " + *open.held_up_by + '\n';
  return text;
}

std::string sources_as_text(const Sources& sources) {
  std::string text = counted(sources.files.size(), "file", "files") + ", ";
  if (sources.triples) text += counted(*sources.triples, "triple", "triples") + ", ";
  text += counted(sources.classes, "class", "classes") + ", " + counted(sources.axioms, "axiom", "axioms") + '\n';
  for (const owl::LoadedFile& file : sources.files)
    text += "  " + base::printable(file.path, 4096) +
            (file.ontology_iri.empty() ? "" : "  <" + file.ontology_iri + ">") + '\n';
  return text;
}

/// The units of measurement; nothing where the files have none.
std::string units_as_text(const Sources& sources) {
  if (sources.units == 0 && sources.units_left_out.empty()) return {};
  std::string text = "Units of measurement for conditions: " + std::to_string(sources.units) + " read";
  text += sources.units_left_out.empty() ? "\n" : "; left out:\n";
  for (const owl::LeftOut& one : sources.units_left_out) {
    text += "  " + base::printable(one.construct, 400) + ": " + std::to_string(one.count);
    text += one.first.empty() ? "\n" : ", first at " + one.first + '\n';
  }
  return text;
}

std::string refused_as_text(const Sources& sources, bool shows_all) {
  if (sources.refused.empty()) return {};
  std::vector<std::string> lines;
  for (const syntax::LoadError& one : sources.refused) lines.push_back(syntax::to_string(one));
  return "Files that cannot be read (the rest is checked without them):\n" + lines_of(lines, shows_all);
}

std::string doubts_as_text(const Sources& sources) {
  std::string text;
  if (sources.outgrown) text += "Older than its sources: " + *sources.outgrown + '\n';
  text += unresolved_as_text(sources.unresolved);
  if (!sources.conflicts.empty()) text += "Prefixes that mean several IRIs (write the others in full):\n";
  for (const rdf::PrefixConflict& conflict : sources.conflicts) {
    text += "  " + conflict.prefix + ": is <" + conflict.chosen + ">, not";
    for (const std::string& other : conflict.others) text += " <" + other + ">";
    text += '\n';
  }
  return text;
}

std::string problems_as_text(const Findings& findings) {
  std::string text;
  const auto add_reason = [&](const std::vector<explanation::ExplainedAxiom>& reason) {
    for (const explanation::ExplainedAxiom& axiom : reason) text += "    because " + axiom_line(axiom) + '\n';
  };
  if (!findings.is_consistent) {
    text += findings.contradiction.empty() ? "Which axioms contradict each other was not found: geminga-ontology "
                                             "explain --inconsistent looks longer.\n"
                                           : "These contradict each other, and no fewer of them do:\n";
    add_reason(findings.contradiction);
  }
  if (!findings.unsatisfiable.empty())
    text += findings.is_consistent ? "Classes that can have no instance:\n"
                                   : "Classes that can have no instance even if all facts are left aside:\n";
  bool is_derived = false;
  std::size_t unexplained = 0;
  for (const Unsatisfiable& found : findings.unsatisfiable) {
    if (found.root && !std::exchange(is_derived, true))
      text += "Classes that can have none because of these (mend those first, and check again):\n";
    text += "  " + found.name + '\n';
    if (found.root) text += "    depends on " + *found.root + '\n';
    add_reason(found.reason);
    if (found.reason.empty()) ++unexplained;
  }
  if (unexplained > 0)
    text += "No reason was looked for or found for " + counted(unexplained, "class", "classes") +
            " without a \"because\" (each may depend on others): geminga-ontology explain --super owl:Nothing looks "
            "longer.\n";
  if (!findings.is_searched_without_facts)
    text +=
        "There may be more classes that can have no instance even if all facts are left aside: check looked for no "
        "more of them.\n";
  if (!findings.collisions.found.empty())
    text += "Names with equal 32-bit identities (they never match by accident):\n";
  for (const Collision& collision : findings.collisions.found) {
    text += "  0x" + base::to_hex(collision.id, 8) + ':';
    for (const std::string& name : collision.names) text += ' ' + name;
    text += '\n';
  }
  if (!findings.collisions.is_whole)
    text += "Identities of concepts with representations were not compared: there are too many.\n";
  return text;
}

std::string names_as_text(const NameFindings& names, bool shows_all) {
  std::string text;
  const auto add = [&](std::string_view head, const std::vector<std::string>& lines) {
    if (!lines.empty()) text += std::string(head) + '\n' + lines_of(lines, shows_all);
  };
  const auto doubtful = [](const std::vector<DoubtfulName>& found) {
    std::vector<std::string> lines;
    for (const DoubtfulName& name : found) {
      const std::string what = name.kind == "word" ? "" : "  (" + std::string(name.kind) + ')';
      const std::string meant = compiled::did_you_mean(name.similar);
      std::string line = base::printable(name.name, 400);
      line.append(what).append(meant).append("   [").append(place(name.file, name.line)).append("]");
      lines.push_back(std::move(line));
    }
    return lines;
  };
  add("Names that RDF, RDFS, OWL and XSD do not have (what is said with them is lost):", doubtful(names.unknown_words));
  add("Names that are used and nowhere declared:", doubtful(names.undeclared));
  std::vector<std::string> others;
  for (const OtherNamespace& other : names.others)
    others.push_back(other.iri + "  " + counted(other.names, "name", "names") + ", like " +
                     base::printable(other.first, 400));
  add("Namespaces of names that nothing here declares (no problem, unless their ontology was to be given, too):",
      others);
  std::vector<std::string> clashes;
  for (const LabelClash& clash : names.clashes) {
    std::string& line = clashes.emplace_back('"' + base::printable(clash.label, 200) + "\":");
    for (const std::string& name : clash.classes) line += ' ' + base::printable(name, 400);
  }
  add("Labels of several classes (no problem, but robots must be given prefix:Name then):", clashes);
  return text;
}

Exit report(const Findings& findings, const CheckRequest& request) {
  const std::string text = request.as_json
                               ? as_json(findings)
                               : sources_as_text(findings.sources) + units_as_text(findings.sources) +
                                     left_out_as_text(findings, request.shows_all) +
                                     open_as_text(findings.open, request.shows_all) + doubts_as_text(findings.sources) +
                                     refused_as_text(findings.sources, request.shows_all) +
                                     names_as_text(findings.names, request.shows_all) + problems_as_text(findings) +
                                     verdict(findings) + '\n';
  return print_or_say(text, findings.has_problem() ? Exit::no : Exit::yes);
}

/// The exit status where a limit may have ended the search for reasons.
Exit after_reasons(const base::Budget& budget, Exit exit) {
  if (exit == Exit::usage || !budget.is_spent()) return exit;
  return say_error(*budget.reason() + ": there may be more reasons than are printed: raise it", Exit::timed_out);
}

Exit check(const CheckRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  if (is_compiled(request.files)) {
    const auto compiled = open_compiled(request.files.front());
    if (!compiled) return say_failure(compiled.error().text, request.as_json, Exit::no);
    return after_reasons(budget, report(find(*compiled, budget), request));
  }
  auto classified = classify_files(request.files, {.as_json = request.as_json,
                                                   .leaves_out_refused = !request.is_strict,
                                                   .is_lenient = request.is_lenient,
                                                   .budget = &budget});
  if (!classified)
    return say_failure(classified.error().text, request.as_json,
                       classified.error().is_unreadable || request.is_strict ? Exit::usage : Exit::no);
  const auto ontology = compile_or_say(*classified);
  if (!ontology) return Exit::usage;
  Progress progress(!request.as_json);
  progress.show("looking for reasons");
  const Findings findings = find(*classified, *ontology, budget);
  progress.clear();
  const Exit exit = report(findings, request);
  if (exit == Exit::usage) return exit;
  if (classified->classification.is_cut_off) return exit_of(*classified, exit);
  return after_reasons(budget, exit);
}

}  // namespace

void add_check(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<CheckRequest>();
  CLI::App* command =
      program.add_subcommand("check",
                             "Load and classify; list what could not be used, the units of measurement that were read, "
                             "names that are nowhere declared, classes that can have no "
                             "instance, and hash collisions");
  add_files(*command, request->files);
  command->add_flag("--json", request->as_json,
                    "print one JSON document, with every axiom and place of what was left out");
  command->add_flag("--all", request->shows_all,
                    "list every axiom and each place of what was left out, not only " + std::to_string(max_shown) +
                        " axioms a construct");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      std::string(
          "\nExit status 1: a file is wrong (in a folder the others are still used); the ontology contradicts itself;\n"
          "a class can have no instance; two names have the same hash; a name is not one that RDF, RDFS, OWL or XSD\n"
          "define in their namespaces; or nothing declares a name although the files declare others of its namespace.\n"
          "Namespaces of which the files declare nothing are listed, and are no problem.\n"
          "Exit status 2: a file cannot be read: it is not there, its compression is damaged, or it is in no known\n"
          "syntax. Exit status 4: --time-limit or --steps was reached; what is printed is right. What is not\n"
          "decided is named, be it because of these or of limits of the engines.\n"
          "A single file that compile wrote is verified, and the findings in its sources are printed; exit status 1\n"
          "also if it is damaged or older than they are.\n"
          "In the document of --json `unsatisfiable_is_whole` is false where the files contradict themselves and more\n"
          "classes than those of `unsatisfiable` may have no instance even if all facts are left aside, and\n"
          "`collisions_is_whole` is false where not all identities were compared.\n") +
      consistency_of_json +
      "\nExamples:\n  geminga-ontology check my-team.ttl team/\n  geminga-ontology check team.geminga");
  run_when_named(*command, choice, request, check);
}

}  // namespace geminga::ontology
