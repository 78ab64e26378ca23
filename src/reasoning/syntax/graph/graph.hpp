// A set of triples that is filled from files and axioms, and then written or asked.
//
//   graph::Graph all;
//   if (auto error = all.add_file("team.ttl", 0)) return refuse(*error);
//   all.add(graph::iri(a), graph::iri(graph::rdfs_sub_class_of), graph::iri(b));
//   if (const auto& problem = all.problem()) return refuse(*problem);
//   const auto text = all.write(graph::Format::turtle, prefixes);
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_GRAPH_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_GRAPH_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/graph/axioms/node.hpp"
#include "reasoning/syntax/graph/limits.hpp"

namespace geminga::graph {

/// The syntaxes of triples.
enum class Format : std::uint8_t { turtle, rdf_xml, n_triples };

/// "turtle", "rdfxml", "ntriples"; nothing for other names.
[[nodiscard]] std::optional<Format> find_format(std::string_view name);
/// The format by the end of a file's name: .ttl, .nt; .rdf, .owl and .xml are RDF/XML.
[[nodiscard]] std::optional<Format> format_of_file(std::string_view path);

using Prefixes = std::vector<std::pair<std::string, std::string>>;  ///< without the colon; the IRI

class Graph {
 public:
  explicit Graph(const GraphLimits& limits = {});
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;
  ~Graph();

  /// From now on drops triples for which this returns false.
  void set_filter(std::function<bool(const Node& subject, std::string_view predicate, const Node& object)> keeps);
  void add(const Node& subject, const Node& predicate, const Node& object);
  /// Adds all triples of a file that rdf::load() has read, including comments. The file's number distinguishes its
  /// blank nodes from those of other files. Opens nothing else, whatever the file says.
  [[nodiscard]] std::optional<syntax::LoadError> add_file(const std::string& path, std::size_t number);

  /// Why the graph is incomplete, in one line: a limit was exceeded, or memory is short.
  [[nodiscard]] const std::optional<std::string>& problem() const;
  /// Whether that is a limit.
  [[nodiscard]] bool is_over_limit() const;

  /// Sorts the triples by what they say and drops repeats. To be called before the functions below.
  void sort();
  /// Removes what another sorted graph has.
  void remove(const Graph& others);
  [[nodiscard]] std::size_t size() const;
  /// Calls the sink with each triple in their order.
  void for_each(const TripleSink& sink) const;
  /// The whole sorted graph as one text, or why that is impossible.
  [[nodiscard]] std::expected<std::string, std::string> write(Format format, const Prefixes& prefixes) const;

  struct Store;
  [[nodiscard]] Store& store() const { return *store_; }

 private:
  std::unique_ptr<Store> store_;
};

}  // namespace geminga::graph

#endif
