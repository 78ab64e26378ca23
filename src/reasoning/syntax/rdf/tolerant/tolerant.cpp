#include "reasoning/syntax/rdf/tolerant/tolerant.hpp"

#include "base/text.hpp"
#include "reasoning/syntax/files.hpp"
#include "reasoning/syntax/inflate.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"
#include "reasoning/syntax/rdf/tolerant/repair.hpp"
#include "reasoning/syntax/rdf/triples/redland.hpp"

namespace geminga::rdf {
namespace {

using syntax::FileBytes;
using syntax::LoadError;
using syntax::Syntax;

/// One try at a text; an error that is_unreadable is one that no repair of names can help.
std::optional<LoadError> parse(const std::string& path, Syntax syntax, std::string_view text,
                               const syntax::FileLimits& limits, Graph& graph) {
  syntax::FileLimits in_one_piece = limits;
  in_one_piece.piece_bytes = std::numeric_limits<std::size_t>::max();
  const auto layout = scan(syntax, text, in_one_piece);
  if (!layout) return LoadError{base::printable(path, 4096), layout.error().line, layout.error().text, true};
  auto bytes = FileBytes::copy_of(text);
  if (!bytes) return LoadError{base::printable(path, 4096), 0, "needs more memory than there is", true};
  Redland redland(limits, 1);
  return redland.read(path, syntax, *bytes, *layout, graph);
}

}  // namespace

std::expected<Tolerated, LoadError> read_tolerantly(const std::string& path, const syntax::FileLimits& limits) {
  auto bytes = FileBytes::read(path, limits);
  if (bytes && syntax::is_gzip(bytes->view())) bytes = syntax::inflate(path, *bytes, limits);
  if (!bytes) return std::unexpected(std::move(bytes.error()));
  // OWL-S files are OWL files.
  std::string name = base::in_lower_case(syntax::name_without_gz(path));
  if (name.ends_with(".owls")) name.pop_back();
  const auto syntax = syntax::detect_syntax(name, bytes->view());
  if (!syntax) return std::unexpected(LoadError{base::printable(path, 4096), 0, syntax.error()});
  Tolerated read;
  read.syntax = *syntax;
  if (!has_triples(*syntax)) return read;
  const std::optional<std::string> recoded = is_xml(*syntax) ? in_utf8(bytes->view()) : std::nullopt;
  const std::string_view text = recoded ? std::string_view(*recoded) : bytes->view();
  read.broken_off = parse(path, *syntax, text, limits, read.graph);
  if (read.broken_off && is_xml(*syntax)) {
    Tolerated mended;
    mended.syntax = *syntax;
    mended.broken_off = parse(path, *syntax, with_legal_names(text), limits, mended.graph);
    if (!mended.broken_off || mended.graph.triple_count() > read.graph.triple_count()) read = std::move(mended);
  }
  if (read.broken_off && read.broken_off->is_unreadable) {
    read.broken_off->is_unreadable = false;
    return std::unexpected(std::move(*read.broken_off));
  }
  return read;
}

}  // namespace geminga::rdf
