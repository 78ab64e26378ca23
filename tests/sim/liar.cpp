#include "sim/liar.hpp"

#include <span>

#include "discovery/announcement/codec.hpp"

namespace geminga::sim {

Liar::Liar(World& world) : world_(world) {
  world_.on_transmit = [this](const Host& sender, std::string_view datagram) {
    datagrams_[sender.name()].emplace_back(datagram);
    auto heard = announcement::decode(std::as_bytes(std::span(datagram)));
    if (!heard) return;
    if (heard->kind == announcement::Kind::presence) presences_.insert_or_assign(sender.name(), *heard);
    if (heard->kind == announcement::Kind::state) {
      states_.insert_or_assign(sender.name(), std::move(*heard));
    } else if (const auto state = states_.find(sender.name()); state != states_.end()) {
      state->second.sequence = heard->sequence;  // it lies with the numbers that come next
    }
  };
}

void Liar::say(const announcement::Announcement& announcement, const std::string& source) {
  for (const announcement::Datagram& datagram : announcement::encode(announcement)) {
    world_.inject(source, std::string_view(reinterpret_cast<const char*>(datagram.data()), datagram.size()));
  }
}

void Liar::replay(const Host& host, const std::string& source) {
  for (const std::string& datagram : datagrams_[host.name()]) world_.inject(source, datagram);
}

}  // namespace geminga::sim
