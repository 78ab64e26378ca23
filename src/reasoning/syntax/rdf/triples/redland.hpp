// From the bytes of a scanned file to triples in a graph, by as many of Redland's parsers at once as there are threads.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_REDLAND_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_REDLAND_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "reasoning/owl/document.hpp"
#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"
#include "reasoning/syntax/rdf/triples/raptor_parser.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {

class PieceQueue;

/// Redland, opened once for all files of a load. It opens no file and no connection of its own, whatever a file asks.
class Redland {
 public:
  Redland(const syntax::FileLimits& limits, unsigned threads);

  /// Parses one file, which has this layout (scan/scan.hpp), into the graph. Stops at the first error. Triples whose
  /// predicate can only be a comment are counted and not kept. Triples without a line in the layout have raptor's.
  /// Neither the triples nor an error depend on the number of threads.
  [[nodiscard]] std::optional<syntax::LoadError> read(const std::string& path, syntax::Syntax syntax,
                                                      syntax::FileBytes& bytes, const Layout& layout, Graph& graph);

  /// The prefixes of the file that was read last, each pair of a prefix and an IRI once, in the order of reading.
  [[nodiscard]] const std::vector<owl::DeclaredPrefix>& prefixes() const { return prefixes_; }
  /// The faults of the file that was read last that cost single statements, in the order of reading.
  [[nodiscard]] const std::vector<Passed>& passed() const { return passed_; }
  /// Triples of all files so far, kept or not.
  [[nodiscard]] std::uint64_t triple_count() const { return triples_; }

 private:
  /// As many parsers as are asked for, at least.
  std::vector<std::unique_ptr<RaptorParser>>& parsers_for(syntax::Syntax syntax, std::size_t count);
  std::optional<syntax::LoadError> read_pieces(const FileText& text, Graph& graph);
  std::optional<syntax::LoadError> read_in_turn(const FileText& text, Graph& graph);
  std::optional<syntax::LoadError> read_at_once(const FileText& text, Graph& graph);
  std::optional<syntax::LoadError> join_pieces(PieceQueue& queue, std::size_t count, Graph& graph);
  /// Counts what a piece held, against the limits of its file and of all files.
  std::optional<syntax::LoadError> take_over(const std::vector<std::pair<std::string, std::string>>& prefixes,
                                             const std::vector<Passed>& passed, std::uint64_t triples);

  const syntax::FileLimits& limits_;
  /// By syntax, one a thread; opened when they are first needed.
  std::map<syntax::Syntax, std::vector<std::unique_ptr<RaptorParser>>> parsers_;
  unsigned threads_;
  std::vector<owl::DeclaredPrefix> prefixes_;       ///< of the file that is being read
  std::unordered_set<std::string> known_prefixes_;  ///< the same, to find them
  std::vector<Passed> passed_;                      ///< of the file that is being read
  std::uint64_t triples_ = 0;
};

}  // namespace geminga::rdf

#endif
