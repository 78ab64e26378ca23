// A parcel: the files of an ontology as the messages that bring them (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_PARCEL_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_PARCEL_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/travel/manifest.hpp"

namespace geminga::ontology {

/// The first octets of the messages.
inline constexpr std::string_view manifest_mark = "GOM1";
inline constexpr std::string_view piece_mark = "GOP1";

class Parcel {
 public:
  /// Packs contents by name. The error, one line, names the limit that they are over or the name that cannot travel.
  [[nodiscard]] static std::expected<Parcel, std::string> pack(const std::map<std::string, std::string>& files,
                                                               std::uint64_t version);

  [[nodiscard]] const Manifest& manifest() const { return manifest_; }
  /// BLAKE2b-256 of the manifest, and so of everything.
  [[nodiscard]] const std::string& digest() const { return digest_; }
  [[nodiscard]] const std::string& manifest_message() const { return manifest_message_; }
  /// The message of each piece, compressed.
  [[nodiscard]] std::span<const std::string> pieces() const { return pieces_; }

 private:
  Manifest manifest_;
  std::string digest_;
  std::string manifest_message_;
  std::vector<std::string> pieces_;
};

/// Reads the files with these paths, each once. They are named by the last part of their paths. The error, one line, is
/// that two have the same name, one cannot be read, or they are too large together.
[[nodiscard]] std::expected<std::map<std::string, std::string>, std::string> read_files(
    std::span<const std::string> paths);

}  // namespace geminga::ontology

#endif
