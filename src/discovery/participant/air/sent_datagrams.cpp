#include "discovery/participant/air/sent_datagrams.hpp"

#include <algorithm>

#include "base/hash.hpp"

namespace geminga::participant {

std::uint64_t SentDatagrams::hash(std::span<const std::byte> datagram) const {
  return base::hash64(base::octets_of(datagram), key_);
}

void SentDatagrams::add(std::span<const std::byte> datagram) {
  if (hashes_.size() < max_remembered_datagrams) {
    hashes_.push_back(hash(datagram));
    return;
  }
  hashes_[next_] = hash(datagram);
  next_ = (next_ + 1) % max_remembered_datagrams;
}

bool SentDatagrams::contains(std::span<const std::byte> datagram) const {
  return std::ranges::find(hashes_, hash(datagram)) != hashes_.end();
}

}  // namespace geminga::participant
