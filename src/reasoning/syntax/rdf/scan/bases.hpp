// The bases that a file of triples names (xml:base, @base), resolved against as RFC 3986 has it.
//
// Raptor resolves a name against `http://cmt` as if the base were `http://cmt/`, drops the query of an xml:base, and
// keeps the fragment of an @base. A base of such a kind is given a last segment that stands for it before raptor reads
// the file. What raptor then makes of it is right but for this segment, and restored() puts the base back.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_BASES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_BASES_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/rdf/scan/rewrite.hpp"

namespace geminga::rdf {

/// The place of a base in a file, and the base.
struct BaseText {
  std::size_t begin = 0;
  std::size_t size = 0;
  std::string iri;
};

class Bases {
 public:
  /// Other bases in place of those that raptor would resolve against in another way, among the bases of a text.
  [[nodiscard]] std::vector<Rewrite> mark(std::string_view text, const std::vector<BaseText>& bases, bool is_xml);
  [[nodiscard]] bool is_empty() const { return marks_.empty(); }
  /// The IRI that a marked one stands for; any other as it is. Valid while `room` is not changed.
  [[nodiscard]] std::string_view restored(std::string_view iri, std::string& room) const;

 private:
  struct Mark {
    std::string marked;
    std::string base;           ///< without its fragment
    std::string without_query;  ///< and without its query
  };
  std::vector<Mark> marks_;
};

}  // namespace geminga::rdf

#endif
