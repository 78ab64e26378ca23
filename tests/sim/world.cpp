#include "sim/world.hpp"

#include <cstdlib>

#include "base/hash.hpp"
#include "base/text.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"

namespace geminga::sim {

World::World(std::uint64_t seed, Air the_air) : air(the_air), seed_(seed), random_(seed) {}

World::~World() = default;

std::uint64_t World::seed_or(std::uint64_t otherwise) {
  const char* given = std::getenv("GEMINGA_SEED");
  return given == nullptr ? otherwise : base::parse_number<std::uint64_t>(given).value_or(otherwise);
}

std::string World::when() const {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now_.time_since_epoch()).count();
  return "GEMINGA_SEED=" + std::to_string(seed_) + ", at " + std::to_string(ms) + " ms";
}

Host& World::add_host(const std::string& name, std::uint32_t segment) {
  hosts_.push_back(std::make_unique<Host>(*this, name, static_cast<std::uint32_t>(hosts_.size() + 1), random_.next()));
  hosts_.back()->attach("eth0", segment);
  return *hosts_.back();
}

Client& World::add_client(const std::string& name) {
  clients_.push_back(std::make_unique<Client>(*this, name));
  return *clients_.back();
}

void World::at(base::Instant instant, std::function<void()> what) {
  due_.push(Due{.instant = std::max(instant, now_), .sequence = sequence_++, .what = std::move(what)});
}

void World::every(base::Duration period, std::function<void()> what) {
  after(period, [this, period, what = std::move(what)] {
    what();
    every(period, what);
  });
}

void World::run_for(base::Duration duration) {
  const base::Instant end = now_ + duration;
  while (!due_.empty() && due_.top().instant <= end) {
    now_ = due_.top().instant;
    const std::function<void()> what = std::move(const_cast<Due&>(due_.top()).what);
    due_.pop();
    what();
  }
  now_ = end;
}

void World::transmit(const Host& sender, env::InterfaceIndex interface, std::string_view datagram) {
  const Host::Port* from = sender.port(interface);
  if (from == nullptr) return;
  trace(sender.name(), datagram);
  ++datagrams_;
  datagram_bytes_ += datagram.size();
  if (on_transmit) on_transmit(sender, datagram);
  const auto bytes = std::make_shared<const std::string>(datagram);
  for (const auto& receiver : hosts_) {
    for (const Host::Port& to : receiver->ports()) {
      if (to.segment != from->segment || receiver->island() != sender.island()) continue;
      if (receiver.get() != &sender && random_.chance(air.loss)) continue;
      deliver(*receiver, to.index, from->address, bytes);
      if (random_.chance(air.duplicate)) deliver(*receiver, to.index, from->address, bytes);
    }
  }
}

void World::inject(const std::string& source, std::string_view datagram) {
  const auto bytes = std::make_shared<const std::string>(datagram);
  for (const auto& receiver : hosts_) {
    for (const Host::Port& to : receiver->ports()) {
      if (to.segment == 0) deliver(*receiver, to.index, source, bytes);
    }
  }
}

void World::deliver(Host& receiver, env::InterfaceIndex interface, const std::string& source,
                    const std::shared_ptr<const std::string>& datagram) {
  after(random_.between(air.shortest_delay, air.longest_delay),
        [&receiver, interface, source, datagram, life = receiver.life()] {
          if (receiver.life() == life) receiver.receive(interface, source, *datagram);
        });
}

void World::trace(std::string_view who, std::string_view what) {
  const auto time = now_.time_since_epoch().count();
  trace_ = base::hash64(base::octets_of(std::span(&time, 1)), trace_);
  trace_ = base::hash64(who, trace_);
  trace_ = base::hash64(what, trace_);
}

}  // namespace geminga::sim
