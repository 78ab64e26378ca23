// `geminga-ontology classify`: the taxonomy or its closure, and figures of the run.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <fstream>
#include <memory>
#include <string>

#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/findings/findings.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "ontology/loading/refused.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::ontology {
namespace {

struct ClassifyRequest {
  std::vector<std::string> files;
  bool as_closure = false;
  bool as_json = false;
  bool are_properties = false;
  bool is_lenient = false;
  bool is_strict = false;
  unsigned threads = 1;
  std::string stats;
};

/// `left_out` is 0 where the taxonomy is complete: it counts axioms that were left out and reasons why searches were.
bool write_stats(const ClassifiedFiles& classified, unsigned threads, const std::string& path) {
  std::uint64_t left_out = classified.classification.gaps.size();
  for (const owl::LeftOut& entry : taxonomy::left_out(classified.loaded.source, classified.classification))
    left_out += entry.count;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const boost::json::object document{{"triples", classified.loaded.triples},
                                     {"classes", class_count(classified)},
                                     {"axioms", classified.classification.counts.axioms},
                                     {"left_out", left_out},
                                     {"load_ms", classified.load_ms},
                                     {"classify_ms", classified.classify_ms},
                                     {"peak_rss_kib", usage.ru_maxrss},
                                     {"threads", threads}};
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << json_text(document) << '\n';
  file.close();
  return file.good();
}

/// One object for each node of equivalents: {"classes": [...], "parents": [...]}, a parent by its first name.
boost::json::array nodes_of(const Hierarchy& hierarchy, std::string_view members_key) {
  boost::json::array nodes;
  for (std::uint32_t node = 0; node < hierarchy.members.row_count(); ++node) {
    if (hierarchy.members[node].empty()) continue;
    boost::json::array members;
    for (const std::uint32_t member : hierarchy.members[node]) members.emplace_back(hierarchy.iris[member]);
    boost::json::array parents;
    for (const std::uint32_t parent : hierarchy.parents_of(node)) parents.emplace_back(hierarchy.iris[parent]);
    nodes.push_back(boost::json::object{{members_key, std::move(members)}, {"parents", std::move(parents)}});
  }
  return nodes;
}

/// The taxonomies to write: of classes, or of object and data properties.
struct Taxonomies {
  Hierarchy classes;
  Hierarchy object_properties;
  Hierarchy data_properties;
};

/// Questions that are open, with the members that they have in the document of check.
void add_open(boost::json::object& document, const ClassifiedFiles& classified) {
  const reasoner::Undecided& undecided = classified.classification.undecided;
  const auto iri = [&](taxonomy::ClassNumber of) {
    return classified.loaded.source.name(classified.classification.classes[static_cast<std::size_t>(of)]);
  };
  document["gaps"] = boost::json::value_from(classified.classification.gaps);
  boost::json::object& open = document["undecided"].emplace_object();
  boost::json::array& classes = open["classes"].emplace_array();
  for (const taxonomy::ClassNumber of : undecided.classes) classes.emplace_back(iri(of));
  open["consistency"] = undecided.consistency;
  open["held_up_by"] = undecided.held_up_by ? boost::json::value(iri(*undecided.held_up_by)) : nullptr;
}

bool write_json(const Taxonomies& written, const ClassifiedFiles& classified, bool are_properties,
                const reasoner::Answer& consistency) {
  boost::json::object document;
  put_consistency(consistency, document);
  add_open(document, classified);
  document["nodes"] = nodes_of(written.classes, "classes");
  if (are_properties) {
    document["object_properties"] = nodes_of(written.object_properties, "properties");
    document["data_properties"] = nodes_of(written.data_properties, "properties");
  }
  return print_more(json_text(document) + '\n');
}

bool write_taxonomies(ClassifiedFiles& classified, const ClassifyRequest& request, base::Budget& budget) {
  const owl::Ontology& source = classified.loaded.source;
  const taxonomy::Classification& classification = classified.classification;
  Taxonomies written;
  written.classes = class_hierarchy(source, classification);
  if (request.are_properties) {
    written.object_properties =
        property_hierarchy(source, classification.object_properties, classification.is_consistent);
    written.data_properties = property_hierarchy(source, classification.data_properties, classification.is_consistent);
  }
  if (request.as_json) {
    const reasoner::Answer consistency = consistency_of(classified, &budget);
    return write_json(written, classified, request.are_properties, consistency);
  }
  const auto write_one = [&, short_name = short_names(source)](const Hierarchy& hierarchy) {
    return request.as_closure ? write_closure(hierarchy, print_more) : write_tree(hierarchy, short_name, print_more);
  };
  if (!request.as_closure && !classification.is_consistent)
    say_error("the ontology contradicts itself, so that everything follows from it: see geminga-ontology check");
  if (!request.are_properties) return write_one(written.classes);
  return write_one(written.object_properties) && write_one(written.data_properties);
}

/// The first axiom that was left out, by the reader or by the engines, in one line; nothing: there is none.
std::optional<std::string> first_unused(const ClassifiedFiles& classified) {
  const owl::Ontology& source = classified.loaded.source;
  if (auto unread = find_unread(source, {}, true)) return unread;
  const std::vector<taxonomy::UnusedAxiom>& unused = classified.classification.unused;
  if (unused.empty()) return std::nullopt;
  return reasoner::describe_unused(source, unused.front().axiom, unused.front().construct);
}

Exit classify(const ClassifyRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  auto classified = classify_or_say(request.files, {.threads = request.threads,
                                                    .as_json = request.as_json,
                                                    .leaves_out_refused = !request.is_strict,
                                                    .is_lenient = request.is_lenient,
                                                    .budget = &budget});
  if (!classified) return Exit::usage;
  if (!request.stats.empty() &&
      would_destroy_source(request.stats, request.files, classified->loaded.source, "--stats"))
    return Exit::usage;
  if (!write_taxonomies(*classified, request, budget) || !print("")) return say_unwritten();
  if (!request.stats.empty() && !write_stats(*classified, request.threads, request.stats))
    return say_error(request.stats + " cannot be written: name another file behind --stats");
  // Imports that no file answers may have more to say.
  std::string unresolved = unresolved_as_text(classified->loaded.unresolved);
  if (!unresolved.empty()) {
    unresolved.pop_back();  // say_error() adds the line end
    say_error(unresolved);
  }
  // exit_of() tells of a limit that was reached.
  auto open = classified->classification.is_cut_off ? std::nullopt : why_undecided(*classified);
  if (!open && !classified->classification.is_cut_off) open = first_unused(*classified);
  if (open) say_error("what is printed follows, and more may: " + *open);
  return exit_of(*classified, exit_of_list(classified->loaded, Exit::yes));
}

}  // namespace

void add_classify(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ClassifyRequest>();
  CLI::App* command = program.add_subcommand("classify", "Print the taxonomy of all named classes");
  add_files(*command, request->files);
  CLI::Option* closure = command->add_flag("--closure", request->as_closure,
                                           "print SUB<TAB>SUPER for every entailed subsumption, full IRIs, sorted");
  command->add_flag("--json", request->as_json, "print the taxonomy as one JSON document")->excludes(closure);
  add_strict(*command, request->is_strict);
  add_number(*command, "--threads", request->threads, 1, 256, "how many threads saturate; the result is the same");
  add_lenient(*command, request->is_lenient);
  add_work_limits(*command, choice.limits);
  command
      ->add_option("--stats", request->stats,
                   "write counts, times and memory of the run as JSON; left_out is 0 where the taxonomy is complete")
      ->type_name("FILE");
  command->add_flag("--properties", request->are_properties,
                    "print the taxonomies of object and of data properties instead (with --json: too)");
  command->footer(
      std::string(
          "\nThe closure has equivalents in both directions, owl:Thing never as SUPER, and as SUB only where a class\n"
          "is everything; a class that can have no instance has the one line CLASS<TAB>owl:Nothing. What is printed\n"
          "follows. Standard error says what was left out or could not be decided (`undecided` and `gaps` of the\n"
          "document of --json say the latter). Where that is for a limit of the command line, the exit status is "
          "4.\n") +
      refused_of_list + consistency_of_json +
      "\nExamples:\n  geminga-ontology classify team/ --closure --stats run.json\n"
      "  geminga-ontology classify team/ --properties");
  command->callback([request, &choice] {
    if (!request->stats.empty()) choice.outputs.push_back(request->stats);
    choice.run = [request, &choice] { return classify(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
