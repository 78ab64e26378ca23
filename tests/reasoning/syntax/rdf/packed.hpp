// A text as gzip packs it.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_RDF_PACKED_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_RDF_PACKED_HPP

#include <zlib.h>

#include <string>
#include <string_view>

namespace geminga::rdf {

/// One member of a gzip file; empty where zlib has no memory.
[[nodiscard]] inline std::string packed(std::string_view text) {
  z_stream stream{};
  constexpr int gzip_only = 15 + 16;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_only, 9, Z_DEFAULT_STRATEGY) != Z_OK) return {};
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  std::string copy(text);
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

}  // namespace geminga::rdf

#endif
