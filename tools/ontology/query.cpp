// `geminga-ontology query`: SPARQL over the triples that the files assert and those that follow.

#include "reasoning/syntax/graph/query.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <boost/json.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/harmless.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/format.hpp"
#include "ontology/graph/asked_names.hpp"
#include "ontology/graph/asserted.hpp"
#include "ontology/graph/inferred.hpp"
#include "ontology/individuals/realized_files.hpp"
#include "ontology/loading/refused.hpp"
#include "reasoning/syntax/files.hpp"

namespace geminga::ontology {
namespace {

using graph::Node;

struct QueryRequest {
  std::vector<std::string> words;  ///< the files, and last the query
  std::string rows = "table";
  std::string format;
  bool as_json = false;
  bool only_asserted = false;
  bool is_lenient = false;
  bool is_strict = false;
  unsigned most_rows = 100'000;
  unsigned most_steps = 50'000'000;  ///< some ten seconds
};

/// The query itself, or that in the file that the word names.
std::expected<std::string, std::string> query_of(const std::string& word) {
  if (!word.ends_with(".rq") && !word.ends_with(".sparql")) return word;
  syntax::FileLimits limits;
  limits.file_bytes = graph::GraphLimits{}.query_bytes;
  const auto bytes = syntax::FileBytes::read(word, limits);
  if (!bytes) return std::unexpected(syntax::to_string(bytes.error()));
  return std::string(bytes->view());
}

enum class Rows : std::uint8_t {
  table,  ///< for people: aligned, with short names
  json,   ///< SPARQL 1.1 Query Results JSON Format
  csv,    ///< SPARQL 1.1 Query Results CSV and TSV Formats
  tsv,
};

constexpr std::string_view xsd_string = "http://www.w3.org/2001/XMLSchema#string";
/// The greatest width of a column that is aligned.
constexpr std::size_t max_column_width = 80;

/// Writes a node as N-Triples do.
std::string raw_ntriples(const Node& node) {
  if (node.kind == Node::Kind::iri) return '<' + node.text + '>';
  if (node.kind == Node::Kind::blank) return "_:" + node.text;
  std::string text = "\"";
  for (const char c : node.text) {
    switch (c) {
      case '"':
      case '\\':
        text += '\\';
        text += c;
        break;
      case '\n':
        text += "\\n";
        break;
      case '\r':
        text += "\\r";
        break;
      case '\t':
        text += "\\t";
        break;
      default:
        text += c;
    }
  }
  text += '"';
  if (!node.language.empty()) return text + '@' + node.language;
  return node.datatype.empty() || node.datatype == xsd_string ? text : text + "^^<" + node.datatype + '>';
}

/// Writes a node as N-Triples and TSV do, with escapes (RDF 1.1 N-Triples, section 4) for what a terminal could obey.
std::string as_ntriples(const Node& node) { return base::harmless_json(raw_ntriples(node)); }

/// Quotes a text with a comma, a quotation mark or a line end (RFC 4180).
std::string as_csv(const Node& node) {
  std::string text = node.kind == Node::Kind::blank ? "_:" + node.text : node.text;
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

boost::json::object as_json(const Node& node) {
  boost::json::object object{{"type", node.kind == Node::Kind::iri     ? "uri"
                                      : node.kind == Node::Kind::blank ? "bnode"
                                                                       : "literal"},
                             {"value", node.text}};
  if (!node.language.empty()) object["xml:lang"] = node.language;
  if (!node.datatype.empty()) object["datatype"] = node.datatype;
  return object;
}

std::string json(const graph::Answer& answer) {
  boost::json::object head;
  boost::json::object document;
  if (answer.kind == graph::Answer::Kind::truth) {
    document["head"] = head;
    document["boolean"] = answer.is_true;
    return json_text(document) + '\n';
  }
  head["vars"] = boost::json::value_from(answer.variables);
  document["head"] = head;
  boost::json::array bindings;
  for (const auto& row : answer.rows) {
    boost::json::object binding;
    for (std::size_t at = 0; at < row.size(); ++at) {
      if (row[at]) binding[answer.variables[at]] = as_json(*row[at]);
    }
    bindings.push_back(std::move(binding));
  }
  document["results"] = boost::json::object{{"bindings", std::move(bindings)}};
  return json_text(document) + '\n';
}

std::string separated(const graph::Answer& answer, bool by_commas) {
  const std::string_view separator = by_commas ? "," : "\t";
  const std::string_view end = by_commas ? "\r\n" : "\n";
  std::string text;
  for (std::size_t at = 0; at < answer.variables.size(); ++at)
    text.append(at == 0 ? "" : separator).append(by_commas ? "" : "?").append(answer.variables[at]);
  text += end;
  for (const auto& row : answer.rows) {
    for (std::size_t at = 0; at < row.size(); ++at) {
      text.append(at == 0 ? "" : separator);
      if (row[at]) text.append(by_commas ? as_csv(*row[at]) : as_ntriples(*row[at]));
    }
    text += end;
  }
  return text;
}

std::string table(const graph::Answer& answer, const std::function<std::string(std::string_view)>& short_name) {
  std::vector<std::vector<std::string>> cells{{}};
  for (const std::string& name : answer.variables) cells.front().push_back('?' + name);
  for (const auto& row : answer.rows) {
    auto& line = cells.emplace_back();
    for (const auto& node : row) {
      const std::string text = !node                           ? std::string()
                               : node->kind == Node::Kind::iri ? short_name(node->text)
                                                               : as_csv(*node);
      line.push_back(base::printable(text, 1000));
    }
  }
  std::vector<std::size_t> widths(answer.variables.size(), 0);
  for (const auto& line : cells) {
    for (std::size_t at = 0; at < line.size(); ++at)
      widths[at] = std::max(widths[at], std::min(base::count_characters(line[at]), max_column_width));
  }
  std::string text;
  for (const auto& line : cells) {
    std::string written;
    for (std::size_t at = 0; at < line.size(); ++at) {
      written += line[at];
      const std::size_t width = base::count_characters(line[at]);
      if (at + 1 < line.size()) written.append(width < widths[at] ? widths[at] - width + 2 : 2, ' ');
    }
    while (written.ends_with(' ')) written.pop_back();
    text += written + '\n';
  }
  return text;
}

std::optional<Rows> find_rows(std::string_view name) {
  if (name == "table") return Rows::table;
  if (name == "json") return Rows::json;
  if (name == "csv") return Rows::csv;
  if (name == "tsv") return Rows::tsv;
  return std::nullopt;
}

/// Writes the rows, or the truth, of an answer.
std::string written(const graph::Answer& answer, Rows rows,
                    const std::function<std::string(std::string_view)>& short_name) {
  if (rows == Rows::json) return json(answer);
  if (answer.kind == graph::Answer::Kind::truth) return answer.is_true ? "yes\n" : "no\n";
  return rows == Rows::table ? table(answer, short_name) : separated(answer, rows == Rows::csv);
}

/// The graph that is asked, and the short forms of its names.
struct Asked {
  explicit Asked(const graph::GraphLimits& limits) : graph(limits) {}

  graph::Graph graph;
  graph::Prefixes prefixes;
  std::function<std::string(std::string_view)> short_name;
};

/// Fills the graph, or says what is wrong.
Exit fill(const std::vector<std::string>& files, const QueryRequest& request, const WorkLimits& limits,
          base::Budget& budget, Asked& asked, std::optional<ClassifiedFiles>& classified) {
  Progress progress(!request.as_json);
  auto loaded = load(files, progress,
                     {.annotations = KeptAnnotations::of_owl_syntaxes,
                      .leaves_out_refused = !request.is_strict,
                      .is_lenient = request.is_lenient});
  if (!loaded) return say_failure(loaded.error().text, request.as_json);
  if (const auto problem = add_asserted(*loaded, asked.graph))
    return say_failure(*problem, request.as_json, exit_of(asked.graph));
  asked.prefixes = found_prefixes_of(loaded->source);
  if (request.only_asserted) {
    classified.emplace(std::move(*loaded), reasoner::Classified{}, 0, 0);
  } else {
    base::Budget classifying = budget_of(first_half(limits));
    auto learned = classify_files(std::move(*loaded), 0, progress, {.budget = &classifying});
    if (!learned) return say_failure(learned.error().text, request.as_json);
    classified.emplace(std::move(*learned));
    const auto realization = realize_files(*classified, budget, progress, graph_octets(limits));
    if (!realization.is_consistent)
      return say_failure(
          "the ontology contradicts itself, so that everything follows from it: ask --asserted only, or "
          "see geminga-ontology check",
          request.as_json, Exit::no);
    if (realization.has_too_many_facts)
      return say_failure(graph::too_many_octets(graph_octets(limits)), request.as_json, Exit::timed_out);
    base::Budget writing(WorkLimits::default_steps);
    progress.show("collecting what follows");
    const auto problem = add_inferred(*classified, realization, true, writing, asked.graph);
    progress.clear();
    if (problem) return say_failure(*problem, request.as_json, Exit::timed_out);
    // exit_of() tells of a limit that was reached.
    auto why = why_incomplete(*classified);
    if (!why) why = describe_open(classified->loaded.source, undecided_individuals(realization), realization.gaps);
    if (why && !classified->classification.is_cut_off) say_error("more may follow: " + *why);
  }
  progress.clear();
  if (asked.graph.problem()) return say_failure(*asked.graph.problem(), request.as_json, exit_of(asked.graph));
  asked.graph.sort();
  asked.short_name = short_names(classified->loaded.source);
  return Exit::yes;
}

/// Writes the answer. The exit status says whether there are rows, or whether the answer is yes.
Exit write(const graph::Answer& answer, const QueryRequest& request, Rows rows, const Asked& asked) {
  const bool are_triples = answer.kind == graph::Answer::Kind::triples;
  const std::string text = are_triples ? answer.text : written(answer, rows, asked.short_name);
  const bool is_data = are_triples || rows == Rows::csv || rows == Rows::tsv;
  if (!(is_data ? print_data(text) : print(text))) return say_unwritten();
  if (answer.is_cut)
    return say_error("there are more than " + std::to_string(request.most_rows) +
                         " rows, or more octets than a query may take; the first were written: raise --rows or "
                         "--graph-limit, or write LIMIT",
                     Exit::timed_out);
  if (answer.kind == graph::Answer::Kind::truth) return answer.is_true ? Exit::yes : Exit::no;
  return are_triples || !answer.rows.empty() ? Exit::yes : Exit::no;
}

Exit query(const QueryRequest& request, const WorkLimits& limits) {
  const auto rows = find_rows(request.as_json ? "json" : request.rows);
  if (!rows) return say_error(base::printable(request.rows) + " is no format: write --format table, json, csv or tsv");
  const auto format = chosen_format(request.format, std::string(to_standard_output));
  if (!format) return say_error(format.error());
  if (request.words.size() < 2) return say_failure("name the files, and behind them the query", request.as_json);
  const auto text = query_of(request.words.back());
  if (!text) return say_failure(text.error(), request.as_json);
  const graph::GraphLimits graph_limits{
      .octets = graph_octets(limits), .query_octets = graph_octets(limits), .rows = request.most_rows};
  Asked asked(graph_limits);
  std::optional<ClassifiedFiles> classified;
  const std::vector<std::string> files(request.words.begin(), request.words.end() - 1);
  base::Budget budget = budget_of(three_quarters(limits));
  if (const Exit exit = fill(files, request, limits, budget, asked, classified); exit != Exit::yes) return exit;
  base::Budget asking = budget_of(limits, request.most_steps);
  limit_asking(limits);
  Progress progress(!request.as_json);
  AskedNames names(*classified, budget, progress);
  graph::FindNames find_names;
  if (!request.only_asserted)
    find_names = [&](const graph::AskedExpression& asked_for) {
      auto found = names.find(asked_for);
      progress.show("asking");
      return found;
    };
  progress.show("asking");
  const auto answer = graph::ask(asked.graph, *text,
                                 {.prefixes = asked.prefixes,
                                  .format = *format,
                                  .limits = graph_limits,
                                  .budget = &asking,
                                  .find_names = find_names});
  progress.clear();
  if (names.open() && !classified->classification.is_cut_off) say_error("more may follow: " + *names.open());
  if (!answer)
    return say_failure(answer.error().text, request.as_json, answer.error().is_limit ? Exit::timed_out : Exit::usage);
  if (answer->has_asserted_expressions)
    say_error(
        "a class expression with a variable, or beside another word than rdf:type, rdfs:subClassOf and "
        "owl:equivalentClass, asks for the triples that the files state, and not for what follows");
  Exit exit = write(*answer, request, *rows, asked);
  if (exit == Exit::usage) return exit;
  exit = exit_of_answer(classified->loaded, exit);
  return budget.is_spent() && !classified->classification.is_cut_off ? Exit::timed_out : exit_of(*classified, exit);
}

}  // namespace

void add_query(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<QueryRequest>();
  CLI::App* command = program.add_subcommand("query", "Ask in SPARQL over what the files say and what follows from it");
  command->add_option("FILES SPARQL", request->words, "ontology files, or folders of them, and a query behind them")
      ->required()
      ->type_name("");
  command->add_option("--format", request->rows, "how rows are written: table, json, csv, tsv")
      ->type_name("table|json|csv|tsv");
  command->add_flag("--json", request->as_json, "the same as --format json");
  command->add_option("--to", request->format, std::string("the syntax for CONSTRUCT and DESCRIBE: ") + format_names)
      ->type_name(format_choices);
  command->add_flag("--asserted", request->only_asserted, "ask over what the files say alone");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_number(*command, "--rows", request->most_rows, 1, 10'000'000, "most rows to write; 100000 where it is not given");
  add_number(*command, "--query-steps", request->most_steps, 1, 4'000'000'000,
             "most triples that the query looks at; 50000000 where it is not given");
  add_memory_limit(*command, choice);
  add_graph_limit(*command, choice.limits);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nSELECT, ASK, CONSTRUCT and DESCRIBE (the statements about a resource, with those of its blank nodes) are\n"
      "answered; a query may stand in a file whose name ends in .rq. Prefixes of the files, and those of the names\n"
      "that are printed, need no declaration. Nothing is fetched from a network. FROM, SERVICE, property paths\n"
      "(write a triple for each step) and EXISTS within an expression (write it as a filter of its own) are refused.\n"
      "The inferred graph has what the files state; which named classes and properties are below or equal to\n"
      "which, but for what holds of each (itself, owl:Thing, owl:Nothing); and all types and facts of named\n"
      "individuals. A class expression as OWL writes it in RDF (?x a [ a owl:Restriction ; owl:onProperty\n"
      "... ]) finds the named individuals that are in it in every model, as geminga-ontology instances does;\n"
      "beside rdfs:subClassOf and owl:equivalentClass it finds the named classes below, above and equal to it. It\n"
      "uses names of the files; a query has at most 16 of them. With --asserted, or with a variable in it beside\n"
      "rdfs:subClassOf and its like, it finds what the files state in these triples.\n"
      "Exit status: 0 there are rows, or the answer is yes; 1 there are none, the answer is no, or the ontology\n"
      "contradicts itself; 2 wrong usage, or a file or the query cannot be read; 4 a limit was reached. A limit\n"
      "of the search, which takes at most three quarters of --time-limit: the answer uses what is decided by\n"
      "then. The limit of --rows: the first rows are written. A limit of the query (--query-steps, --graph-limit,\n"
      "--time-limit, or 300 s of processor time without --time-limit): there is no answer.\n"
      "A file of a folder that cannot be read is left out and named, and the answer is that of the others; where it\n"
      "is no, or there are no rows, the exit status is 2.\n"
      "\nExamples:\n"
      "  geminga-ontology query team/ 'SELECT ?class WHERE { ?class rdfs:subClassOf soccer:BallInfo }'\n"
      "  geminga-ontology query team/ 'SELECT ?x WHERE { ?x a [ owl:complementOf soccer:BallInfo ] }'\n"
      "  geminga-ontology query team/ 'SELECT ?t (COUNT(?x) AS ?n) WHERE { ?x a ?t } GROUP BY ?t ORDER BY DESC(?n)'\n"
      "  geminga-ontology query team/ 'ASK { soccer:SharedBallInfo rdfs:subClassOf soccer:BallInfo }'\n"
      "  geminga-ontology query pizza.owl unnamed.rq --format csv");
  run_when_named(*command, choice, request, query);
}

}  // namespace geminga::ontology
