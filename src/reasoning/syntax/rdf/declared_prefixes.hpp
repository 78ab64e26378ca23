// The prefixes that the files of a load declare, and the IRI that each of them stands for in the end.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_DECLARED_PREFIXES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_DECLARED_PREFIXES_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "reasoning/owl/document.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::rdf {

/// A prefix that files declare for different IRIs; the other IRIs have no short names.
struct PrefixConflict {
  std::string prefix;
  std::string chosen;
  std::vector<std::string> others;  ///< sorted
};

class DeclaredPrefixes {
 public:
  /// Adds what one file declares, each pair of a prefix and an IRI once.
  void add(std::span<const owl::DeclaredPrefix> prefixes);
  /// Different pairs of a prefix and an IRI, however many files declare them.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Gives every prefix one IRI: the one that most files declare, and the smallest of these, so that neither the order
  /// of files nor that of lines matters; rdf, rdfs, owl and xsd have their own. The empty prefix has another meaning in
  /// every file, so it counts only if all files agree.
  [[nodiscard]] std::vector<PrefixConflict> choose(owl::Ontology& source) const;

 private:
  /// How many files declare a prefix for an IRI, by prefix and IRI.
  std::map<std::string, std::map<std::string, std::uint32_t>> files_;
  std::size_t size_ = 0;
};

}  // namespace geminga::rdf

#endif
