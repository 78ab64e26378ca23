#include "client/protocol/channel_keys.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "discovery/gcnp/channel_keyring.hpp"

namespace geminga::client {
namespace {

constexpr std::array<std::pair<std::string_view, SealingMode>, 5> modes{{
    {"plain", SealingMode::plain},
    {"prepared", SealingMode::prepared},
    {"mixed", SealingMode::mixed},
    {"authenticated", SealingMode::authenticated},
    {"encrypted", SealingMode::encrypted},
}};

Secret secret_of(const gcnp::ChannelKey::Secret& octets) {
  return Secret(std::as_bytes(std::span<const unsigned char, secret_bytes>(octets)));
}

}  // namespace

FrameForm ChannelKeys::form() const {
  switch (mode_) {
    case SealingMode::plain:
    case SealingMode::prepared:
      return FrameForm::plain;
    case SealingMode::authenticated:
      return FrameForm::authenticated;
    case SealingMode::mixed:
    case SealingMode::encrypted:
      break;
  }
  return FrameForm::encrypted;
}

std::optional<SealingMode> sealing_mode(std::string_view word) {
  const auto* const found = std::ranges::find(modes, word, &decltype(modes)::value_type::first);
  return found == modes.end() ? std::nullopt : std::optional(found->second);
}

std::optional<StatedKeys> read_keys(const gcnp::Statement& statement) {
  const auto keyring = gcnp::read_channel_keyring(statement);
  if (!keyring) return std::nullopt;
  const auto mode = sealing_mode(keyring->mode);
  if (!mode || keyring->ring.empty() != (*mode == SealingMode::plain)) return std::nullopt;
  std::vector<ChannelKeys::Key> ring;
  for (const auto& key : keyring->ring) ring.push_back({key.id, secret_of(key.forward), secret_of(key.back)});
  return StatedKeys{keyring->life, ChannelKeys(*mode, std::move(ring))};
}

}  // namespace geminga::client
