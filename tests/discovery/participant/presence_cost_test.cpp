// The cost of hearing an unchanged presence: it allocates no memory.
#include <gtest/gtest.h>

#include <new>

#include "discovery/announcement/codec.hpp"
#include "sim/robots.hpp"
#include "support/allocations.hpp"

namespace geminga::participant {
namespace {

constexpr env::InterfaceIndex eth0{2};

/// Lets the first of a team hear each presence of the others before the air brings it, and counts.
class Listener {
 public:
  explicit Listener(sim::Robots& robots) : host_(*robots.world.hosts().front()) {
    robots.world.on_transmit = [this](const sim::Host& sender, std::string_view datagram) { hear(sender, datagram); };
  }
  [[nodiscard]] int heard() const { return heard_; }
  [[nodiscard]] std::uint64_t most() const { return most_; }

 private:
  void hear(const sim::Host& sender, std::string_view datagram) {
    const auto octets = std::as_bytes(std::span(datagram));
    const auto announcement = announcement::decode(octets);
    if (&sender == &host_ || announcement->kind != announcement::Kind::presence) return;
    const auto sent = host_.datagrams_sent();
    std::uint64_t taken = 0;
    const std::string& source = sender.ports().front().address;
    host_.event([&](Participant& participant) {
      const auto before = tests::allocations();
      participant.on_datagram(eth0, source, octets);
      taken = tests::allocations() - before;
    });
    if (host_.datagrams_sent() != sent) return;  // something else was due
    ++heard_;
    most_ = std::max(most_, taken);
  }

  sim::Host& host_;
  int heard_ = 0;
  std::uint64_t most_ = 0;
};

TEST(Presence, CostsNoMemoryWhereNothingHasChanged) {
  const std::uint64_t before = tests::allocations();
  ::operator delete(::operator new(1));
  ASSERT_EQ(tests::allocations(), before + 1) << "they are counted";
  sim::Robots robots(sim::World::seed_or(41), 10, {});
  for (const auto& host : robots.world.hosts()) {  // as a daemon, which shares with nobody
    host->settings.shared = nullptr;
    host->settings.shared_entries = nullptr;
  }
  robots.start();
  robots.team.settle(std::chrono::seconds(5));
  robots.world.run_for(std::chrono::minutes(2));
  const Listener listener(robots);
  robots.world.run_for(std::chrono::minutes(1));
  EXPECT_GE(listener.heard(), 200);
  EXPECT_EQ(listener.most(), 0U) << "allocations for one of them";
}

}  // namespace
}  // namespace geminga::participant
