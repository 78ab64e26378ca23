// Places of a file that are read as another text.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_REWRITE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_REWRITE_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::rdf {

/// A stretch of a text, and what takes its place. Neither has an end of a line.
struct Rewrite {
  std::size_t begin = 0;
  std::size_t size = 0;
  std::string text;
};

/// The text with all of them, which do not overlap.
[[nodiscard]] std::string rewritten(std::string_view text, std::vector<Rewrite> rewrites);

}  // namespace geminga::rdf

#endif
