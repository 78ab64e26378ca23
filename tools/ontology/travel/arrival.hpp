// An ontology that arrives piece by piece, from one provider or from several after each other (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_ARRIVAL_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_ARRIVAL_HPP

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/travel/manifest.hpp"

namespace geminga::ontology {

/// Believes nothing but what the announced digest covers: the manifest by the digest, each piece by the manifest. It
/// takes memory for what has come, at most max_travelling_octets.
class Arrival {
 public:
  explicit Arrival(std::string digest) : digest_(std::move(digest)) {}

  /// Takes a message. True: it brought something new. The error, words behind the name of a provider, says that the
  /// provider lies or floods; what others have brought stays.
  [[nodiscard]] std::expected<bool, std::string> take(std::string_view message);
  /// Another provider follows, of which nothing has come yet.
  void begin_provider() { useless_octets_ = 0; }

  [[nodiscard]] bool is_whole() const;
  [[nodiscard]] const std::optional<Manifest>& manifest() const { return manifest_; }
  [[nodiscard]] std::size_t arrived_pieces() const { return arrived_; }
  /// The contents of all files, one behind the other. Requires is_whole().
  [[nodiscard]] const std::string& content() const { return content_; }

 private:
  std::expected<bool, std::string> take_manifest(std::string_view text);
  std::expected<bool, std::string> take_piece(std::string_view message);
  std::expected<bool, std::string> count_useless(std::size_t octets);

  std::string digest_;
  std::optional<Manifest> manifest_;
  std::string content_;
  std::vector<bool> has_;  ///< by number of a piece
  std::size_t arrived_ = 0;
  std::size_t useless_octets_ = 0;  ///< of this provider
};

}  // namespace geminga::ontology

#endif
