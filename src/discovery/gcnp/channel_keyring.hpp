// The line by which a daemon gives its client the keys of one channel: `N pub keys life=LIFE mode=MODE [ring=...]`
// (src/client/CHANNELS.md, "Sealed channels").
#ifndef GEMINGA_DISCOVERY_GCNP_CHANNEL_KEYRING_HPP
#define GEMINGA_DISCOVERY_GCNP_CHANNEL_KEYRING_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "geminga/error.hpp"
#include "geminga/life.hpp"

namespace geminga::gcnp {

/// Keys of one channel at most: those that a daemon holds.
inline constexpr std::size_t max_channel_keys = 8;

/// The keys of a channel under one key of the team.
struct ChannelKey {
  using Secret = std::array<unsigned char, 32>;
  std::uint16_t id = 0;  ///< that of the team key
  Secret forward{};      ///< seals what the publisher sends
  Secret back{};         ///< seals what its consumers send
  friend bool operator==(const ChannelKey&, const ChannelKey&) = default;
};

/// The keys of one channel, as a daemon says them. It is no event: nobody shows it, and nobody writes it to a log.
struct ChannelKeyring {
  Life life = no_life;           ///< of the publication
  std::string mode = "plain";    ///< the word of the host's mode (SEALING.md, "Modes")
  std::vector<ChannelKey> ring;  ///< the first one seals, all of them open; empty if the mode is `plain`
  friend bool operator==(const ChannelKeyring&, const ChannelKeyring&) = default;
};

/// The subcommand of the line.
inline constexpr std::string_view keys_subcommand = "keys";

/// Writes the line. `request` is the publication, or the subscription that is told of it.
[[nodiscard]] Statement to_statement(std::uint32_t request, const ChannelKeyring& keyring);

/// Reads the parameters of such a line. The error names the key that cannot be read, and shows no value.
[[nodiscard]] std::expected<ChannelKeyring, Error> read_channel_keyring(const Statement& statement);

}  // namespace geminga::gcnp

#endif
