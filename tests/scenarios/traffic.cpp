#include "scenarios/traffic.hpp"

#include <string>

#include "sim/host.hpp"

namespace geminga::scenarios {

Traffic::Traffic(sim::World& world, std::uint64_t most) : world_(world), most_(most) {
  world_.every(traffic_window, [this] { check(); });
}

void Traffic::check() {
  sent_.resize(world_.hosts().size());
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    const sim::Host& host = *world_.hosts()[i];
    const std::uint64_t sent = host.datagrams_sent() - sent_[i];
    sent_[i] = host.datagrams_sent();
    if (sent <= most_) continue;
    world_.complain("traffic: " + host.name() + " sent " + std::to_string(sent) + " datagrams in 10 s, and " +
                    std::to_string(most_) + " are the most,");
  }
}

}  // namespace geminga::scenarios
