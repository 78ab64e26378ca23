#include "reasoning/syntax/graph/graph.hpp"

#include <algorithm>
#include <new>

#include "base/text.hpp"
#include "reasoning/owl/plain_literal.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/graph/rdf_xml.hpp"
#include "reasoning/syntax/graph/store.hpp"
#include "reasoning/syntax/graph/turtle.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::graph {
namespace {

constexpr std::size_t chunk_bytes = std::size_t{1} << 16;

/// Adds one file to a graph.
struct Reading {
  Graph::Store& graph;
  std::string blank_prefix;
  const rdf::Bases& bases;
  std::uint64_t generated = 0;

  static void on_statement(void* data, raptor_statement* statement) {
    auto& self = *static_cast<Reading*>(data);
    if (!self.graph.make_room(octets_of(*statement->subject) + octets_of(*statement->predicate) +
                              octets_of(*statement->object)))
      return;
    try {
      if (self.graph.keeps && !self.keeps(*statement)) return;
      if (!self.add(statement)) self.graph.fail("memory is short");
    } catch (const std::bad_alloc&) {  // nothing may pass through raptor
      self.graph.fail("memory is short");
    }
  }

  [[nodiscard]] bool keeps(const raptor_statement& statement) const {
    return graph.keeps(restored(*statement.subject), restored(*statement.predicate).text, restored(*statement.object));
  }

  [[nodiscard]] bool add(const raptor_statement* statement) const {
    if (bases.is_empty() && !is_plain_literal(*statement->object)) return graph.statements.add_copy(statement);
    return graph.statements.add(restored(*statement->subject), restored(*statement->predicate),
                                restored(*statement->object));
  }

  [[nodiscard]] static bool is_plain_literal(const raptor_term& term) {
    return term.type == RAPTOR_TERM_TYPE_LITERAL && term.value.literal.datatype != nullptr &&
           owl::plain_literal_datatype ==
               reinterpret_cast<const char*>(raptor_uri_as_string(term.value.literal.datatype));
  }

  /// A node with the IRIs that the file means. rdf:PlainLiteral has no place in triples (its specification, section 4):
  /// its literals are plain texts and texts with a language.
  [[nodiscard]] Node restored(const raptor_term& term) const {
    Node node = node_of(term);
    std::string& iri = node.kind == Node::Kind::iri ? node.text : node.datatype;
    std::string room;
    iri = std::string(bases.restored(iri, room));
    if (!is_plain_literal(term)) return node;
    owl::PlainLiteral plain = owl::split_plain_literal(node.text);
    node.datatype.clear();
    node.language = std::move(plain.language);
    node.text = std::string(plain.text);
    return node;
  }

  /// Renames blank nodes, both those of a file and those that raptor makes up. Raptor frees the name that it gives and
  /// the one that it gets.
  static unsigned char* on_blank(void* data, unsigned char* given) {
    auto& self = *static_cast<Reading*>(data);
    const std::string label = self.blank_prefix + (given == nullptr ? 'g' + std::to_string(++self.generated)
                                                                    : 'u' + label_of(reinterpret_cast<char*>(given)));
    if (given != nullptr) raptor_free_memory(given);
    auto* name = static_cast<unsigned char*>(raptor_alloc_memory(label.size() + 1));
    if (name != nullptr) std::copy_n(label.c_str(), label.size() + 1, reinterpret_cast<char*>(name));
    return name;
  }
};

const char* parser_of(syntax::Syntax syntax) {
  // N-Triples are read as Turtle, whose reader skips nothing in silence.
  return syntax == syntax::Syntax::rdf_xml ? "rdfxml" : "turtle";
}

}  // namespace

std::optional<Format> find_format(std::string_view name) {
  if (name == "turtle" || name == "ttl") return Format::turtle;
  if (name == "rdfxml" || name == "rdf" || name == "owl") return Format::rdf_xml;
  if (name == "ntriples" || name == "nt") return Format::n_triples;
  return std::nullopt;
}

std::optional<Format> format_of_file(std::string_view path) {
  if (path.ends_with(".ttl")) return Format::turtle;
  if (path.ends_with(".nt")) return Format::n_triples;
  if (path.ends_with(".rdf") || path.ends_with(".owl") || path.ends_with(".xml")) return Format::rdf_xml;
  return std::nullopt;
}

Graph::Graph(const GraphLimits& limits) : store_(std::make_unique<Store>(limits)) {
  if (!store_->world.is_open()) store_->fail("Redland does not start: memory is short");
}

Graph::~Graph() = default;

void Graph::set_filter(std::function<bool(const Node&, std::string_view, const Node&)> keeps) {
  store_->keeps = std::move(keeps);
}

void Graph::add(const Node& subject, const Node& predicate, const Node& object) {
  if (store_->keeps && !store_->keeps(subject, predicate.text, object)) return;
  if (!store_->make_room(subject.text.size() + predicate.text.size() + object.text.size())) return;
  if (!store_->statements.add(subject, predicate, object))
    store_->fail("a triple cannot be held: memory is short, or a language tag has more than 255 letters");
}

std::optional<syntax::LoadError> Graph::add_file(const std::string& path, std::size_t number) {
  const auto refuse = [&](std::string text) {
    return syntax::LoadError{base::printable(path, 4096), 0, std::move(text)};
  };
  if (store_->problem) return std::nullopt;
  const auto text = rdf::read_text(path);
  if (!text) return text.error();
  raptor_world* raptor = store_->world.raptor();
  Reading reading{*store_, 'f' + std::to_string(number), text->bases};
  raptor_world_set_generate_bnodeid_handler(raptor, &reading, Reading::on_blank);
  raptor_parser* parser = raptor_new_parser(raptor, parser_of(text->syntax));
  raptor_uri* base = raptor_new_uri(raptor, octets(text->base_iri));
  bool is_read = parser != nullptr && base != nullptr;
  if (is_read) {
    raptor_parser_set_statement_handler(parser, &reading, Reading::on_statement);
    raptor_parser_set_option(parser, RAPTOR_OPTION_NO_NET, nullptr, 1);
    raptor_parser_set_option(parser, RAPTOR_OPTION_NO_FILE, nullptr, 1);
    raptor_parser_set_option(parser, RAPTOR_OPTION_LOAD_EXTERNAL_ENTITIES, nullptr, 0);
    is_read = raptor_parser_parse_start(parser, base) == 0;
  }
  const std::string_view bytes = base::without_mark(text->bytes.view());
  for (std::size_t at = 0; at < bytes.size() && is_read; at += chunk_bytes) {
    const std::string_view chunk = bytes.substr(at, chunk_bytes);
    is_read =
        raptor_parser_parse_chunk(parser, reinterpret_cast<const unsigned char*>(chunk.data()), chunk.size(), 0) == 0;
  }
  is_read = is_read && raptor_parser_parse_chunk(parser, nullptr, 0, 1) == 0;
  if (parser != nullptr) raptor_free_parser(parser);
  if (base != nullptr) raptor_free_uri(base);
  raptor_world_set_generate_bnodeid_handler(raptor, nullptr, nullptr);
  if (is_read) return std::nullopt;
  const std::string error = store_->world.take_error();
  return refuse(error.empty() ? "cannot be parsed" : error);
}

const std::optional<std::string>& Graph::problem() const { return store_->problem; }

bool Graph::is_over_limit() const { return store_->is_over_limit; }

void Graph::sort() { store_->statements.sort(); }

void Graph::remove(const Graph& others) { store_->statements.remove(others.store_->statements); }

std::size_t Graph::size() const { return store_->statements.size(); }

void Graph::for_each(const TripleSink& sink) const { store_->statements.for_each(sink); }

std::expected<std::string, std::string> Graph::write(Format format, const Prefixes& prefixes) const {
  return graph::write(store_->statements, format, prefixes);
}

std::expected<std::string, std::string> write(const Statements& sorted, Format format, const Prefixes& prefixes) {
  switch (format) {
    case Format::turtle:
      return write_turtle(sorted.all(), prefixes);
    case Format::rdf_xml:
      return write_rdf_xml(sorted.all(), prefixes);
    case Format::n_triples:
      break;
  }
  return write_n_triples(sorted.all());
}

}  // namespace geminga::graph
