// The one place that names Redland: a file's bytes go through its raptor parsers as a stream, triples come out.
//
// Only raptor is used. librdf's own world would load every storage plug-in that it finds in a system folder, and its
// storages cost 500 bytes a triple and more; a stream needs neither.
#ifndef GEMINGA_RDF_REDLAND_HPP
#define GEMINGA_RDF_REDLAND_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rdf/error.hpp"
#include "rdf/files.hpp"
#include "rdf/graph.hpp"
#include "rdf/limits.hpp"
#include "rdf/syntax.hpp"

namespace geminga::rdf {

/// One `@prefix` or `xmlns` as a file declares it.
struct DeclaredPrefix {
  std::string prefix;  ///< without the colon; empty: the default one
  std::string iri;
  std::uint32_t file = 0;
};

/// Redland, opened once for all files of a load. It opens no file and no connection of its own, whatever a file asks.
class Redland {
 public:
  explicit Redland(const Limits& limits);
  Redland(const Redland&) = delete;
  Redland& operator=(const Redland&) = delete;
  ~Redland();

  /// Parses one file that was scanned (rdf/scan.hpp) into the graph. `base_iri` is what relative IRIs are relative to.
  /// `lines` are those of the file's triples in their order (rdf/turtle_lines.hpp); beyond them
  /// raptor's own are taken. Stops at the first error. Triples whose predicate can only be a comment are counted and
  /// not kept.
  [[nodiscard]] std::optional<LoadError> read(const std::string& path, Syntax syntax, FileBytes& bytes,
                                              const std::string& base_iri, std::vector<std::uint32_t> lines,
                                              Graph& graph);

  /// The prefixes of all files so far, in the order of reading.
  [[nodiscard]] const std::vector<DeclaredPrefix>& prefixes() const;
  /// Triples of all files so far, kept or not.
  [[nodiscard]] std::uint64_t triple_count() const;

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace geminga::rdf

#endif
