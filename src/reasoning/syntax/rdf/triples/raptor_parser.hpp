// Feeds the octets of a piece of a file to a raptor parser, and takes its triples. RDF.md says why it is raptor and not
// librdf.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_RAPTOR_PARSER_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_RAPTOR_PARSER_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"
#include "reasoning/syntax/rdf/triples/graph.hpp"
#include "reasoning/syntax/rdf/triples/passed.hpp"
#include "reasoning/syntax/syntax.hpp"

namespace geminga::rdf {

/// A file that is to be parsed piece by piece. Borrows everything while it is parsed.
struct FileText {
  syntax::FileBytes& bytes;
  syntax::Syntax syntax = syntax::Syntax::rdf_xml;
  const std::string& base_iri;
  const std::string& blank_prefix;  ///< a hash of the content, so that it is the same on every host
  const Layout& layout;
};

/// A raptor world for one thread at a time. It opens no file and no connection, whatever a file asks for.
class RaptorParser {
 public:
  /// For files in one syntax. No other parser may be at work, because raptor and libxml2 set up global state.
  RaptorParser(const syntax::FileLimits& limits, syntax::Syntax syntax);
  RaptorParser(const RaptorParser&) = delete;
  RaptorParser& operator=(const RaptorParser&) = delete;
  ~RaptorParser();

  /// Parses one piece into a graph, up to its end or the first error, and gives back its memory.
  [[nodiscard]] std::optional<syntax::LoadError> read(const FileText& text, std::size_t piece, Graph& graph);

  /// Prefixes and their IRIs, in the order of reading, of the piece that was read last; each once.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& prefixes() const;
  /// The faults of RDF/XML that cost the piece that was read last single statements; not more than 250 of them.
  [[nodiscard]] const std::vector<Passed>& passed() const;
  /// Triples of the piece that was read last, kept or not.
  [[nodiscard]] std::uint64_t triple_count() const;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace geminga::rdf

#endif
