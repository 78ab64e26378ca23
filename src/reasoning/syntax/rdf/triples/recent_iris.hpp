// The IRIs that a piece of a file has named last, with their nodes.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_RECENT_IRIS_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_RECENT_IRIS_HPP

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "reasoning/syntax/rdf/triples/graph.hpp"

namespace geminga::rdf {

/// Spares a search in the graph for most IRIs: the predicate, the type, and the subject of the triple before. Each IRI
/// has one place, which it shares with many others, and the last one is there.
class RecentIris {
 public:
  /// The node of an IRI; none where another one took its place.
  [[nodiscard]] NodeId find(std::string_view iri) const {
    const Entry& entry = entries_[place_of(iri)];
    return entry.text == iri ? entry.node : NodeId{};
  }
  /// Keeps the node of an IRI. Its text must live until forget().
  void keep(std::string_view iri, NodeId node) { entries_[place_of(iri)] = {iri, node}; }
  void forget() { entries_.fill({}); }

 private:
  struct Entry {
    std::string_view text;
    NodeId node{};
  };
  static constexpr std::size_t places = 256;

  /// By the last octets, in which the IRIs of one file differ most.
  [[nodiscard]] static std::size_t place_of(std::string_view iri) {
    std::uint64_t tail = 0;
    if (iri.size() >= sizeof(tail)) std::memcpy(&tail, iri.data() + iri.size() - sizeof(tail), sizeof(tail));
    constexpr std::uint64_t spread = 0x9e3779b97f4a7c15;  // 2^64 by the golden ratio (Knuth, volume 3, section 6.4)
    return ((tail + iri.size()) * spread >> 32U) % places;
  }

  std::array<Entry, places> entries_;
};

}  // namespace geminga::rdf

#endif
