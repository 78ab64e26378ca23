#include "discovery/keeping/frame.hpp"

#include <utility>

#include "base/assert.hpp"

namespace geminga::keeping {
namespace {

constexpr std::byte magic{0x4b};        // K
constexpr std::uint8_t version = 0x10;  // 1, in the upper four bits
constexpr std::size_t head_bytes = 2;

/// The lower four bits of the second octet; the order of Frame.
enum class Word : std::uint8_t { hello = 1, keep, drop, kept };

std::uint64_t number_of(std::span<const std::byte> octets) {
  std::uint64_t number = 0;
  for (const std::byte octet : octets) number = number << 8U | static_cast<std::uint8_t>(octet);
  return number;
}

void append(std::vector<std::byte>& octets, std::uint64_t number, std::size_t size) {
  while (size-- > 0) octets.push_back(static_cast<std::byte>(number >> (8 * size) & 0xff));
}

std::optional<ParticipantId> participant_of(std::span<const std::byte> octets) {
  const auto id = static_cast<std::uint32_t>(number_of(octets));
  return id == 0 ? std::nullopt : std::optional(ParticipantId{id});
}

bool is_envelope(std::span<const std::byte> octets) { return !octets.empty() && octets.size() <= max_kept_bytes; }

std::optional<Frame> read_keep(std::span<const std::byte> rest) {
  if (rest.size() < 6) return std::nullopt;
  const auto participant = participant_of(rest.first(4));
  const Keep keep{.participant = participant.value_or(ParticipantId{}),
                  .index = static_cast<std::uint8_t>(rest[4]),
                  .count = static_cast<std::uint8_t>(rest[5]),
                  .envelope = rest.subspan(6)};
  const bool is_whole =
      participant && keep.index < keep.count && keep.count <= max_kept_words && is_envelope(keep.envelope);
  return is_whole ? std::optional<Frame>(keep) : std::nullopt;
}

}  // namespace

bool is_frame(std::span<const std::byte> datagram) { return !datagram.empty() && datagram[0] == magic; }

std::optional<Frame> read(std::span<const std::byte> datagram) {
  if (!is_frame(datagram) || datagram.size() < head_bytes || datagram.size() > max_frame_bytes) return std::nullopt;
  const auto second = static_cast<std::uint8_t>(datagram[1]);
  if ((second & 0xf0U) != version) return std::nullopt;
  const auto rest = datagram.subspan(head_bytes);
  switch (static_cast<Word>(second & 0x0fU)) {
    case Word::hello:
      return rest.size() == 8 ? std::optional<Frame>(Hello{number_of(rest)}) : std::nullopt;
    case Word::keep:
      return read_keep(rest);
    case Word::drop:
      if (const auto participant = participant_of(rest); rest.size() == 4 && participant) return Drop{*participant};
      return std::nullopt;
    case Word::kept:
      return is_envelope(rest) ? std::optional<Frame>(Kept{rest}) : std::nullopt;
  }
  return std::nullopt;
}

std::vector<std::byte> write(const Frame& frame) {
  std::vector<std::byte> octets{magic, static_cast<std::byte>(version + 1U + frame.index())};
  if (const auto* hello = std::get_if<Hello>(&frame)) append(octets, hello->life, 8);
  if (const auto* keep = std::get_if<Keep>(&frame)) {
    append(octets, std::to_underlying(keep->participant), 4);
    append(octets, keep->index, 1);
    append(octets, keep->count, 1);
    octets.insert(octets.end(), keep->envelope.begin(), keep->envelope.end());
  }
  if (const auto* drop = std::get_if<Drop>(&frame)) append(octets, std::to_underlying(drop->participant), 4);
  if (const auto* kept = std::get_if<Kept>(&frame)) {
    octets.insert(octets.end(), kept->envelope.begin(), kept->envelope.end());
  }
  GEMINGA_ASSERT(octets.size() <= max_frame_bytes);
  return octets;
}

}  // namespace geminga::keeping
