#include "client/protocol/provider_keys.hpp"

#include "client/protocol/limits.hpp"

namespace geminga::client {

std::optional<ChannelKeys> ProviderKeys::of(Life publisher) const {
  if (publisher == no_life) return ChannelKeys();
  if (const auto found = keys_.find(publisher); found != keys_.end()) return found->second;
  return has_plain_daemon_ ? std::optional(ChannelKeys()) : std::nullopt;
}

void ProviderKeys::put(Life publisher, const ChannelKeys& keys) {
  const bool is_new = keys_.insert_or_assign(publisher, keys).second;
  if (is_new && !has_provider_(publisher)) leave(publisher);
}

void ProviderKeys::leave(Life publisher) {
  if (!keys_.contains(publisher)) return;
  std::erase(waiting_, publisher);
  waiting_.push_back(publisher);
  if (waiting_.size() <= max_waiting_keys) return;
  const Life eldest = waiting_.front();
  waiting_.pop_front();
  if (!has_provider_(eldest)) keys_.erase(eldest);
}

void ProviderKeys::on_daemon(bool has_keys) {
  has_plain_daemon_ = !has_keys;
  if (has_keys) return;
  keys_.clear();
  waiting_.clear();
}

}  // namespace geminga::client
