// `geminga-ontology classify`: the taxonomy, or the whole closure, and numbers about the run.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <cstdio>
#include <fstream>
#include <memory>

#include "closure.hpp"
#include "command.hpp"
#include "knowledge.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

struct Request {
  std::vector<std::string> files;
  bool as_closure = false;
  bool as_json = false;
  unsigned threads = 1;
  std::string stats;
};

bool to_output(std::string_view text) { return std::fwrite(text.data(), 1, text.size(), stdout) == text.size(); }

bool write_stats(const Knowledge& knowledge, unsigned threads, const std::string& path) {
  std::uint64_t left_out = 0;
  for (const el::LeftOut& entry : el::left_out(knowledge.loaded.source, knowledge.classification))
    left_out += entry.count;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const boost::json::object document{{"triples", knowledge.loaded.triples},
                                     {"classes", class_count(knowledge)},
                                     {"axioms", knowledge.classification.counts.axioms},
                                     {"left_out", left_out},
                                     {"load_ms", knowledge.load_ms},
                                     {"classify_ms", knowledge.classify_ms},
                                     {"peak_rss_kib", usage.ru_maxrss},
                                     {"threads", threads}};
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << boost::json::serialize(document) << '\n';
  file.close();
  return file.good();
}

/// One object a node of equivalent classes: {"classes": [...], "parents": [...]}, a parent by its first class.
bool write_json(const Knowledge& knowledge) {
  const el::Classification& classification = knowledge.classification;
  const auto iri = [&](el::ClassNumber number) {
    return knowledge.loaded.source.name(classification.classes[static_cast<std::size_t>(number)]);
  };
  boost::json::array nodes;
  const auto members = equivalents(classification);
  for (std::size_t node = 0; node < members.size(); ++node) {
    if (members[node].empty()) continue;
    boost::json::array classes;
    for (const el::ClassNumber member : members[node]) classes.emplace_back(iri(member));
    boost::json::array parents;
    for (const el::ClassNumber parent : classification.parents_of(el::ClassNumber{static_cast<std::uint32_t>(node)}))
      parents.emplace_back(iri(parent));
    nodes.push_back(boost::json::object{{"classes", std::move(classes)}, {"parents", std::move(parents)}});
  }
  return to_output(boost::json::serialize(
                       boost::json::object{{"consistent", classification.is_consistent}, {"nodes", std::move(nodes)}}) +
                   "\n");
}

Exit classify(const Request& request) {
  const auto knowledge = learn_or_say(request.files, request.threads);
  if (!knowledge) return Exit::usage;
  bool is_written = false;
  if (request.as_closure) {
    is_written = write_closure(knowledge->loaded.source, knowledge->classification, to_output);
  } else if (request.as_json) {
    is_written = write_json(*knowledge);
  } else {
    const auto ontology = open_or_say(*knowledge);
    if (!ontology) return Exit::usage;
    if (!knowledge->classification.is_consistent)
      say_error("the ontology contradicts itself, so that everything follows from it: see geminga-ontology check");
    is_written = write_tree(*ontology, knowledge->classification, to_output);
  }
  if (!is_written || std::fflush(stdout) != 0) return say_error("standard output cannot be written");
  if (!request.stats.empty() && !write_stats(*knowledge, request.threads, request.stats))
    return say_error(request.stats + " cannot be written: name another file behind --stats");
  return Exit::yes;
}

}  // namespace

void add_classify(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<Request>();
  CLI::App* command = program.add_subcommand("classify", "Print the taxonomy of all named classes");
  add_files(*command, request->files);
  CLI::Option* closure = command->add_flag("--closure", request->as_closure,
                                           "print SUB<TAB>SUPER for every entailed subsumption, full IRIs, sorted");
  command->add_flag("--json", request->as_json, "print the taxonomy as one JSON document")->excludes(closure);
  add_number(*command, "--threads", request->threads, 1, 256, "how many threads saturate; the result is the same");
  command->add_option("--stats", request->stats, "write counts, times and memory of the run as JSON")
      ->type_name("FILE");
  command->footer("\nExample:\n  geminga-ontology classify team/ --closure --stats run.json");
  command->callback([request, &choice] { choice.run = [request] { return classify(*request); }; });
}

}  // namespace geminga::ontology
