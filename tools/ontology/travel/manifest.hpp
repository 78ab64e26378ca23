// The manifest: the files of an ontology that travels, its version, and the digest of each piece (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_MANIFEST_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_MANIFEST_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/travel/limits.hpp"

namespace geminga::ontology {

/// One file. Its octets follow those of the file before it.
struct TravellingFile {
  std::string name;
  std::size_t octets = 0;
  friend bool operator==(const TravellingFile&, const TravellingFile&) = default;
};

struct Manifest {
  std::uint64_t version = 0;          ///< 0: unstated
  std::vector<TravellingFile> files;  ///< by name
  std::vector<std::string> pieces;    ///< BLAKE2b-256 of each

  [[nodiscard]] std::size_t octets() const;
  /// The octets of a piece that there is.
  [[nodiscard]] std::size_t octets_of(std::size_t piece) const;
  /// As it is sent and hashed.
  [[nodiscard]] std::string text() const;
  /// Reads nothing but what text() writes. The error is why it is not believed, in one line.
  [[nodiscard]] static std::expected<Manifest, std::string> read(std::string_view text);
  friend bool operator==(const Manifest&, const Manifest&) = default;
};

/// The number of pieces of so many octets.
[[nodiscard]] constexpr std::size_t piece_count(std::size_t octets) {
  return (octets + piece_octets - 1) / piece_octets;
}

/// The words, behind a name, for why no file that travels has it; nothing where one may. A name ends as an ontology
/// file does, has no separator of paths and nothing that a terminal could obey, and is not hidden.
[[nodiscard]] std::optional<std::string> fault_of_name(std::string_view name);

}  // namespace geminga::ontology

#endif
