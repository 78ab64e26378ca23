// `geminga-ontology align`: the equivalences and subsumptions between the classes and properties of two ontologies,
// untrained and mended.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <boost/json.hpp>
#include <cstdio>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ontology/alignment/lexicon.hpp"
#include "ontology/alignment/matching.hpp"
#include "ontology/alignment/mending.hpp"
#include "ontology/alignment/thesaurus.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/format.hpp"
#include "ontology/graph/asserted.hpp"
#include "ontology/graph/excerpt_document.hpp"
#include "ontology/loading/classified_files.hpp"

namespace geminga::ontology {
namespace {

struct AlignRequest {
  std::string one;
  std::string other;
  std::string out;
  std::string format;
  bool is_conservative = false;
  bool wants_narrower = false;
  bool wants_reasons = false;
  bool as_json = false;
  bool is_lenient = false;
  std::string wordnet{wordnet_folder};
  bool is_wordnet_named = false;
};

std::string written(double confidence) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f", confidence);
  return text.data();
}

/// `ONE<TAB>SIGN<TAB>OTHER<TAB>CONFIDENCE`, and the reason behind another tabulator.
std::string links_as_text(const Mended& mended, bool wants_reasons) {
  std::string text;
  for (const Link& link : mended.links) {
    text.append(link.one).append("\t").append(1, sign_of(link.relation)).append("\t");
    text.append(link.other).append("\t").append(written(link.confidence));
    text += wants_reasons ? "\t" + link.reason + '\n' : "\n";
  }
  return text;
}

boost::json::object link_as_object(const Link& link) {
  return {{"one", link.one},
          {"other", link.other},
          {"relation", std::string(1, sign_of(link.relation))},
          {"confidence", link.confidence},
          {"reason", link.reason}};
}

std::string links_as_json(const Mended& mended) {
  boost::json::object document{{"certain", mended.is_certain}};
  boost::json::array& links = document["links"].emplace_array();
  for (const Link& link : mended.links) links.push_back(link_as_object(link));
  boost::json::array& rejected = document["rejected"].emplace_array();
  for (const Rejected& one : mended.rejected) {
    boost::json::object object = link_as_object(one.link);
    object["because"] = one.because;
    rejected.push_back(std::move(object));
  }
  return json_text(document) + '\n';
}

void say_rejected(const Mended& mended) {
  for (const Rejected& one : mended.rejected)
    say_error(one.link.one + ' ' + sign_of(one.link.relation) + ' ' + one.link.other + " (" +
              written(one.link.confidence) + ") was taken out: with it " + one.because);
  if (!mended.is_certain)
    say_error("whether the links make a class unsatisfiable is not decided: geminga-ontology check says more");
}

/// Writes the links as an ontology of equivalences and subsumptions.
Exit put_links(const AlignRequest& request, rdf::Loaded& both, const Mended& mended, const DocumentFormat& format) {
  std::set<std::pair<std::string_view, std::string_view>> kept;
  for (const Link& link : mended.links) {
    const bool is_turned = link.relation == Relation::broader;
    kept.emplace(is_turned ? link.other : link.one, is_turned ? link.one : link.other);
  }
  std::vector<std::uint32_t> axioms;
  for (std::uint32_t number = 0; number < both.source.axiom_count(); ++number) {
    const owl::Axiom axiom = both.source.axiom(number);
    if (axiom.line != 0 || axiom.arguments.size() != 2 || axiom.kind == owl::AxiomKind::declaration) continue;
    if (kept.contains({both.source.name_of(axiom.arguments[0]), both.source.name_of(axiom.arguments[1])}))
      axioms.push_back(number);
  }
  both.annotations.clear();  // what the files say of the names stands in them
  const ExcerptDocument excerpt(both, axioms, {});
  if (const auto* const syntax = std::get_if<syntax::Syntax>(&format))
    return put_document(request.out, excerpt.document(), *syntax);
  graph::Graph graph({.octets = std::numeric_limits<std::size_t>::max()});
  if (const auto problem = excerpt.add_to(graph)) return say_error(*problem);
  graph.sort();
  const auto text = graph.write(std::get<graph::Format>(format), prefixes_of(both.source));
  if (!text) return say_error(text.error());
  return put(request.out, std::as_bytes(std::span(*text)));
}

Exit align(const AlignRequest& request, const WorkLimits& limits) {
  std::optional<DocumentFormat> format;
  if (!request.out.empty()) {
    const auto chosen = chosen_document_format(request.format, request.out);
    if (!chosen) return say_error(chosen.error());
    format = *chosen;
  }
  Thesaurus thesaurus;
  if (auto read = Thesaurus::read(request.wordnet)) {
    thesaurus = std::move(*read);
  } else if (request.is_wordnet_named) {
    return say_failure(read.error(), request.as_json);
  }
  base::Budget budget = budget_of(limits);
  const LoadOptions options{.as_json = request.as_json,
                            .says_files = false,
                            .annotations = KeptAnnotations::all,
                            .is_lenient = request.is_lenient,
                            .budget = &budget};
  const auto one = classify_or_say({request.one}, options);
  const auto other = one ? classify_or_say({request.other}, options) : std::nullopt;
  if (!other) return Exit::usage;
  Progress progress(!request.as_json);
  auto both = load({request.one, request.other}, progress, options);
  if (!both) return say_failure(both.error().text, request.as_json);
  if (!request.out.empty() && would_destroy_source(request.out, {request.one, request.other}, both->source))
    return Exit::usage;
  progress.show("comparing names");
  const Lexicon first(one->loaded);
  const Lexicon second(other->loaded);
  std::vector<Link> links = match(first, second, thesaurus);
  if (request.wants_narrower) std::ranges::move(narrower_classes(first, second, links), std::back_inserter(links));
  drop_links_of_shared(first, second, links);
  progress.show("mending the alignment");
  const Mended mended = mend(*both, std::move(links), {*one, *other, request.is_conservative}, budget);
  progress.clear();
  if (!request.as_json) say_rejected(mended);
  if (format) {
    if (const Exit put = put_links(request, *both, mended, *format); put != Exit::yes) return put;
  }
  const std::string text = request.as_json ? links_as_json(mended)
                           : format        ? std::string()
                                           : links_as_text(mended, request.wants_reasons);
  if (!text.empty() && !print(text)) return say_unwritten();
  if (budget.is_spent())
    return say_error(*budget.reason() + ": links may be left that do harm: raise it", Exit::timed_out);
  return mended.links.empty() ? Exit::no : Exit::yes;
}

}  // namespace

void add_align(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<AlignRequest>();
  CLI::App* command = program.add_subcommand(
      "align", "Link the classes and properties of two ontologies that mean the same, by names and structure");
  command->add_option("A", request->one, "an ontology file, or a folder of them")->required()->type_name("");
  command->add_option("B", request->other, "another")->required()->type_name("");
  command->add_option("-o,--output", request->out, "write the links as an ontology; - is standard output")
      ->type_name("OUT");
  command->add_option("--to", request->format, std::string("the syntax of OUT: ") + document_format_names)
      ->type_name(document_format_choices);
  command->add_flag("--conservative", request->is_conservative,
                    "also take out links by which a new subsumption follows within A or within B");
  command->add_flag("--subsumptions", request->wants_narrower,
                    "also link classes that are narrower (<) or broader (>) than one of the other ontology");
  command->add_flag("--reasons", request->wants_reasons, "print the reason of each link behind it");
  command->add_flag("--json", request->as_json, "print one JSON document, with the links that were taken out");
  command
      ->add_option("--wordnet", request->wordnet,
                   "the folder of WordNet's index files, for synonyms in English; by default " +
                       std::string(wordnet_folder) + " where it is installed")
      ->type_name("FOLDER");
  add_lenient(*command, request->is_lenient);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nEach line is A<TAB>=<TAB>B<TAB>CONFIDENCE, best first. Names, labels and synonyms are compared word by\n"
      "word, where rare words count more, and then the classes around them. WordNet (the package wordnet-base)\n"
      "adds synonyms. Where links make a class unsatisfiable, the least confident of them are taken out, and\n"
      "standard error names them. Read the links before a robot relies on them: a wrong one sends it the wrong\n"
      "data.\n"
      "Exit status: 0 some links were found, 1 none, 2 a file cannot be loaded, 4 a limit was reached.\n"
      "\nExamples:\n"
      "  geminga-ontology align my-team.ttl team/ --reasons\n"
      "  geminga-ontology align my-team.ttl team/ -o alignment.ttl --conservative");
  command->callback([request, command, &choice] {
    if (!request->out.empty() && request->out != to_standard_output) choice.outputs.push_back(request->out);
    request->is_wordnet_named = command->count("--wordnet") > 0;
    choice.readable.emplace_back(request->wordnet);
    choice.run = [request, &choice] { return align(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
