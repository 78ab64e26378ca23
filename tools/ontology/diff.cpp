// `geminga-ontology diff`: the changes between two ontologies, and their consequences.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/json.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/comparison/consequences.hpp"
#include "ontology/comparison/statements.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/verdict.hpp"

namespace geminga::ontology {
namespace {

/// The most lines of a list, and reasons of one, that are shown without --all.
constexpr std::size_t max_lines = 20;
/// The most reasons that are looked for with --all, and for JSON.
constexpr std::size_t max_explained_differences = 200;

struct DiffRequest {
  std::string before;
  std::string after;
  std::vector<std::string> with;
  bool is_asserted = false;
  bool shows_all = false;
  bool is_lenient = false;
  bool as_json = false;
};

struct Difference {
  ChangedStatements statements;
  std::optional<ChangedConsequences> consequences;  ///< nothing with --asserted
  bool was_consistent = true;
  bool is_consistent = true;
  /// Whether each contradicts itself, with unknown; for JSON.
  std::optional<std::pair<reasoner::Answer, reasoner::Answer>> consistency;

  [[nodiscard]] bool is_empty() const {
    return statements.is_empty() && (!consequences || consequences->is_empty()) && was_consistent == is_consistent;
  }
};

/// Lines of one section, each behind `-` or `+`.
class DifferenceSection {
 public:
  explicit DifferenceSection(bool shows_all) : most_(shows_all ? static_cast<std::size_t>(-1) : max_lines) {}

  void add(char sign, const std::vector<std::string>& lines) {
    const std::size_t shown = std::min(lines.size(), most_);
    for (std::size_t at = 0; at < shown; ++at) text_ += std::string("  ") + sign + ' ' + lines[at] + '\n';
    if (shown < lines.size())
      text_ += std::string("  ") + sign + " and " + std::to_string(lines.size() - shown) + " more: --all\n";
  }
  /// The title, such as "Axioms: 2 removed, 1 added", and the lines; nothing where there are none.
  [[nodiscard]] std::string text(const std::string& title, std::size_t removed, std::size_t added) const {
    if (removed + added == 0) return {};
    return title + ": " + std::to_string(removed) + " removed, " + std::to_string(added) + " added\n" + text_;
  }

 private:
  std::size_t most_;
  std::string text_;
};

std::vector<std::string> axiom_lines_of(const std::vector<explanation::ExplainedAxiom>& axioms) {
  std::vector<std::string> lines;
  for (const explanation::ExplainedAxiom& one : axioms) lines.push_back(axiom_line(one));
  return lines;
}

std::string changed_as_text(const std::string& title, const Changed& changed, bool shows_all) {
  DifferenceSection section(shows_all);
  section.add('-', axiom_lines_of(changed.removed));
  section.add('+', axiom_lines_of(changed.added));
  return section.text(title, changed.removed.size(), changed.added.size());
}

/// One different subsumption in words with its reason; `sign` marks the axioms that the other ontology lacks.
std::string different_as_text(const Different& one, const compiled::Ontology& ontology, char sign) {
  const auto name = [&](const std::string& iri) {
    const auto number = ontology.find_iri(iri);
    return number ? ontology.short_name(*number) : "<" + iri + ">";
  };
  std::string text = one.super == owl::owl_nothing ? name(one.sub) + " can have no instance"
                                                   : name(one.sub) + " is subsumed by " + name(one.super);
  for (const ReasonAxiom& axiom : one.reason)
    text += "\n      because " + axiom_line(axiom.axiom) + (axiom.is_different ? std::string("  (") + sign + ')' : "");
  return text;
}

std::string different_as_text(const std::string& title, const std::vector<Different>& lost,
                              const std::vector<Different>& gained, const compiled::Ontology& before,
                              const compiled::Ontology& after, bool shows_all) {
  DifferenceSection section(shows_all);
  const auto lines = [&](const std::vector<Different>& all, const compiled::Ontology& ontology, char sign) {
    std::vector<std::string> found;
    for (const Different& one : all) {
      if (one.is_telling || shows_all) found.push_back(different_as_text(one, ontology, sign));
    }
    const std::size_t others = all.size() - found.size();
    if (others > 0) found.push_back("and " + std::to_string(others) + " that follow from these: --all");
    return found;
  };
  section.add('-', lines(lost, before, '-'));
  section.add('+', lines(gained, after, '+'));
  return section.text(title, lost.size(), gained.size());
}

std::string names_as_text(const Difference& difference, bool shows_all) {
  DifferenceSection section(shows_all);
  section.add('-', difference.statements.names_removed);
  section.add('+', difference.statements.names_added);
  return section.text("Names", difference.statements.names_removed.size(), difference.statements.names_added.size());
}

std::string as_text(const Difference& difference, const compiled::Ontology* before, const compiled::Ontology* after,
                    const DiffRequest& request) {
  std::string text = changed_as_text("Axioms", difference.statements.axioms, request.shows_all) +
                     changed_as_text("Annotations", difference.statements.annotations, request.shows_all) +
                     names_as_text(difference, request.shows_all);
  if (difference.consequences) {
    const ChangedConsequences& changed = *difference.consequences;
    text += different_as_text("Classes that can have no instance", changed.filled, changed.emptied, *before, *after,
                              request.shows_all);
    text += different_as_text("Subsumptions of classes that both have", changed.lost, changed.gained, *before, *after,
                              request.shows_all);
    if (!difference.was_consistent) text += request.before + " contradicts itself: everything follows from it.\n";
    if (!difference.is_consistent) text += request.after + " contradicts itself: everything follows from it.\n";
    if (!changed.is_compared && difference.was_consistent && difference.is_consistent)
      text += "What follows is not compared: there are too many subsumptions.\n";
    if (changed.may_miss) text += "Not everything that follows is known of both: geminga-ontology check says why.\n";
  }
  return difference.is_empty() ? text + "Both say the same.\n" : text;
}

boost::json::object changed_as_object(const Changed& changed) {
  return {{"removed", axiom_array(changed.removed)}, {"added", axiom_array(changed.added)}};
}

boost::json::array texts_of(const std::vector<explanation::ExplainedAxiom>& annotations) {
  boost::json::array list;
  for (const explanation::ExplainedAxiom& one : annotations) list.emplace_back(one.text);
  return list;
}

boost::json::array differences_as_array(const std::vector<Different>& list) {
  boost::json::array array;
  for (const Different& one : list) {
    boost::json::object object{{"sub", one.sub}, {"super", one.super}, {"telling", one.is_telling}};
    boost::json::array& reason = object["axioms"].emplace_array();
    for (const ReasonAxiom& axiom : one.reason) {
      boost::json::object entry = axiom_object(axiom.axiom);
      entry["different"] = axiom.is_different;
      reason.push_back(std::move(entry));
    }
    array.push_back(std::move(object));
  }
  return array;
}

std::string as_json(const Difference& difference) {
  const ChangedStatements& statements = difference.statements;
  boost::json::object document{
      {"same", difference.is_empty()},
      {"axioms", changed_as_object(statements.axioms)},
      {"annotations",
       {{"removed", texts_of(statements.annotations.removed)}, {"added", texts_of(statements.annotations.added)}}},
      {"names",
       {{"removed", boost::json::value_from(statements.names_removed)},
        {"added", boost::json::value_from(statements.names_added)}}}};
  if (difference.consequences) {
    const ChangedConsequences& changed = *difference.consequences;
    document["subsumptions"] = {{"lost", differences_as_array(changed.lost)},
                                {"gained", differences_as_array(changed.gained)}};
    document["unsatisfiable"] = {{"lost", differences_as_array(changed.filled)},
                                 {"gained", differences_as_array(changed.emptied)}};
    document["consistent"] = {{"before", verdict_as_json(difference.consistency->first.verdict)},
                              {"after", verdict_as_json(difference.consistency->second.verdict)}};
    document["compared"] = changed.is_compared;
    document["complete"] = !changed.may_miss;
  }
  return json_text(document) + '\n';
}

std::optional<ClassifiedFiles> files_of(const std::string& path, const DiffRequest& request, Progress& progress,
                                        base::Budget& budget) {
  std::vector<std::string> files{path};
  files.insert(files.end(), request.with.begin(), request.with.end());
  const LoadOptions options{.as_json = request.as_json,
                            .says_files = false,
                            .annotations = KeptAnnotations::all,
                            .is_lenient = request.is_lenient,
                            .budget = &budget};
  auto loaded = load(files, progress, options);
  auto classified = loaded ? request.is_asserted ? ClassifiedFiles{std::move(*loaded), {}}
                                                 : classify_files(std::move(*loaded), 0, progress, options)
                           : std::unexpected(loaded.error());
  progress.clear();
  if (classified) return std::move(*classified);
  say_failure(classified.error().text, request.as_json);
  return std::nullopt;
}

Exit diff(const DiffRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(first_half(limits));
  Progress progress(!request.as_json);
  auto before = files_of(request.before, request, progress, budget);
  auto after = before ? files_of(request.after, request, progress, budget) : std::nullopt;
  if (!after) return Exit::usage;
  Difference difference{compare_statements(before->loaded, after->loaded), {}, true, true, {}};
  if (request.is_asserted) {
    const std::string text = request.as_json ? as_json(difference) : as_text(difference, nullptr, nullptr, request);
    return print_or_say(text, difference.is_empty() ? Exit::yes : Exit::no);
  }
  const auto old_form = compile_or_say(*before);
  const auto new_form = old_form ? compile_or_say(*after) : std::nullopt;
  if (!new_form) return Exit::usage;
  difference.was_consistent = before->classification.is_consistent;
  difference.is_consistent = after->classification.is_consistent;
  base::Budget explaining = budget_of(limits);
  progress.show("looking for reasons");
  difference.consequences =
      compare_consequences({*before, *old_form}, {*after, *new_form},
                           request.shows_all || request.as_json ? max_explained_differences : max_lines, explaining);
  if (request.as_json)
    difference.consistency.emplace(consistency_of(*before, &explaining), consistency_of(*after, &explaining));
  progress.clear();
  if (!print(request.as_json ? as_json(difference) : as_text(difference, &*old_form, &*new_form, request)))
    return say_unwritten();
  const Exit exit = difference.is_empty() ? Exit::yes : Exit::no;
  const ClassifiedFiles& cut_off = before->classification.is_cut_off ? *before : *after;
  if (cut_off.classification.is_cut_off) return exit_of(cut_off, exit);
  if (explaining.is_spent())
    return say_error(*explaining.reason() + ": some differences have no reason here: raise it", Exit::timed_out);
  return exit;
}

}  // namespace

void add_diff(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<DiffRequest>();
  CLI::App* command = program.add_subcommand(
      "diff",
      "Print what changed between two ontologies, and which subsumptions follow anew or no longer, with reasons");
  command->add_option("OLD", request->before, "an ontology file, or a folder of them")->required()->type_name("");
  command->add_option("NEW", request->after, "another")->required()->type_name("");
  command->add_option("--with", request->with, "a file or folder that both import; may be given many times")
      ->type_name("FILE");
  command->add_flag("--asserted", request->is_asserted, "compare what the files say, and not what follows");
  command->add_flag(
      "--all", request->shows_all,
      "print everything, not only " + std::to_string(max_lines) + " lines a list and telling subsumptions");
  add_lenient(*command, request->is_lenient);
  command->add_flag("--json", request->as_json, "print one JSON document, with everything");
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nTwo axioms are the same wherever they stand, in whatever syntax, and with the operands of a set in any\n"
      "order; the labels of anonymous individuals do not count. Of the changed subsumptions between named classes\n"
      "that both have, those are printed that follow from no other changed one. In a reason, (+) or (-) follows\n"
      "an axiom that the other ontology does not have. In the document of --json `before` and `after` of `consistent`\n"
      "are null where that cannot be decided.\n"
      "Exit status: 0 both say the same, 1 they differ, 2 a file cannot be loaded, 4 a limit was reached.\n"
      "\nExamples:\n"
      "  geminga-ontology diff old/ team/\n"
      "  geminga-ontology diff old/robot-soccer.ttl robot-soccer.ttl --with core.ttl --json");
  run_when_named(*command, choice, request, diff);
}

}  // namespace geminga::ontology
