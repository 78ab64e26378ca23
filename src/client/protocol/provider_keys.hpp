// The keys that the daemon has told a subscriber, by the lives of its providers.
#ifndef GEMINGA_CLIENT_PROTOCOL_PROVIDER_KEYS_HPP
#define GEMINGA_CLIENT_PROTOCOL_PROVIDER_KEYS_HPP

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "client/protocol/channel_keys.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// The daemon tells the keys of a life once, also before it tells of the provider, and not again when the provider
/// comes back. So keys are kept without a provider: those of max_waiting_keys lives, the last ones. Pure. Lookups are
/// logarithmic, the rest is linear in the lives without a provider.
class ProviderKeys {
 public:
  /// Whether a life has a provider, whose keys are not forgotten.
  using HasProvider = std::function<bool(Life)>;

  explicit ProviderKeys(HasProvider has_provider) : has_provider_(std::move(has_provider)) {}

  /// The keys for a channel to this life; nothing: the daemon has not told them yet. Frames without a life are plain.
  [[nodiscard]] std::optional<ChannelKeys> of(Life publisher) const;
  void put(Life publisher, const ChannelKeys& keys);
  /// The provider goes. Its keys are kept until those of enough other lives have come.
  void leave(Life publisher);
  /// The daemon has no keys, so that all channels are plain; or it will tell those of each life.
  void on_daemon(bool has_keys);

 private:
  HasProvider has_provider_;
  bool has_plain_daemon_ = false;  ///< the daemon has no keys
  std::map<Life, ChannelKeys> keys_;
  std::deque<Life> waiting_;  ///< lives without a provider, in the order in which they came or were left
};

}  // namespace geminga::client

#endif
