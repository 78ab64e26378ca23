#include "ontology/travel/arrival.hpp"

#include <zlib.h>

#include "ontology/travel/digest.hpp"
#include "ontology/travel/parcel.hpp"

namespace geminga::ontology {
namespace {

constexpr std::size_t number_octets = 4;

/// The octets that were compressed; nothing where they are not exactly so many.
std::optional<std::string> inflated(std::string_view packed, std::size_t octets) {
  std::string plain(octets, '\0');
  uLongf size = octets;
  uLong used = packed.size();
  if (::uncompress2(reinterpret_cast<Bytef*>(plain.data()), &size, reinterpret_cast<const Bytef*>(packed.data()),
                    &used) != Z_OK ||
      size != octets || used != packed.size())
    return std::nullopt;
  return plain;
}

}  // namespace

bool Arrival::is_whole() const { return manifest_ && arrived_ == manifest_->pieces.size(); }

std::expected<bool, std::string> Arrival::take(std::string_view message) {
  if (message.size() > max_travelling_message) return std::unexpected("sends messages that are too long");
  if (message.starts_with(manifest_mark)) return take_manifest(message.substr(manifest_mark.size()));
  if (message.starts_with(piece_mark)) return take_piece(message.substr(piece_mark.size()));
  return std::unexpected("sends something that is no part of an ontology");
}

std::expected<bool, std::string> Arrival::take_manifest(std::string_view text) {
  if (blake2b(text) != digest_) return std::unexpected("sends another ontology than it announces");
  if (manifest_) return count_useless(text.size());
  auto manifest = Manifest::read(text);
  if (!manifest) return std::unexpected("offers what cannot be taken: " + manifest.error());
  content_.resize(manifest->octets());
  has_.assign(manifest->pieces.size(), false);
  manifest_ = std::move(*manifest);
  return true;
}

std::expected<bool, std::string> Arrival::take_piece(std::string_view message) {
  if (!manifest_) return count_useless(message.size());  // it was sent to others; the manifest is on its way
  if (message.size() < number_octets) return std::unexpected("sends a piece without a number");
  std::size_t number = 0;
  for (const char octet : message.substr(0, number_octets)) number = number << 8U | static_cast<unsigned char>(octet);
  if (number >= has_.size()) return std::unexpected("sends a piece that the ontology does not have");
  if (has_[number]) return count_useless(message.size());
  const auto piece = inflated(message.substr(number_octets), manifest_->octets_of(number));
  if (!piece || blake2b(*piece) != manifest_->pieces[number])
    return std::unexpected("sends a piece that is not the one that it announces");
  content_.replace(number * piece_octets, piece->size(), *piece);
  has_[number] = true;
  ++arrived_;
  return true;
}

std::expected<bool, std::string> Arrival::count_useless(std::size_t octets) {
  useless_octets_ += octets;
  const std::size_t most = max_useless_octets + max_useless_rounds * (content_.size() + max_manifest_octets);
  if (useless_octets_ > most) return std::unexpected("sends the same again and again");
  return false;
}

}  // namespace geminga::ontology
