#include "sim/world.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "base/hash.hpp"
#include "base/text.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"

namespace geminga::sim {

World::World(std::uint64_t seed, Air the_air, Complain complain)
    : air(the_air), complain_(std::move(complain)), seed_(seed), random_(seed) {}

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

std::vector<std::string> World::ask(Host& host, const std::string& query) {
  Client& client = add_client("asker");
  client.connect(host);
  client.say("1 query " + query);
  run_for(std::chrono::milliseconds(1));
  client.hang_up();
  run_for(std::chrono::milliseconds(1));
  return client.lines;
}

void World::at(base::Instant instant, std::function<void()> what) {
  if (free_calls_.empty()) {
    free_calls_.push_back(static_cast<std::uint32_t>(calls_.size()));
    calls_.emplace_back();
  }
  const std::uint32_t index = free_calls_.back();
  free_calls_.pop_back();
  calls_[index] = std::move(what);
  agenda_.add(std::max(instant, now_), {.kind = Due::Kind::call, .index = index});
}

void World::every(base::Duration period, std::function<void()> what) {
  after(period, [this, period, what = std::move(what)] {
    what();
    every(period, what);
  });
}

void World::ring_at(base::Instant instant, const Host& host) {
  agenda_.add(std::max(instant, now_), {.kind = Due::Kind::ring, .index = host.number() - 1});
}

void World::call(std::uint32_t index) {
  const std::function<void()> what = std::exchange(calls_[index], nullptr);
  free_calls_.push_back(index);
  what();
}

void World::run_for(base::Duration duration) {
  const base::Instant end = now_ + duration;
  while (!agenda_.is_empty() && agenda_.next() <= end) {
    now_ = agenda_.next();
    const Due due = agenda_.take();
    switch (due.kind) {
      case Due::Kind::call:
        call(due.index);
        break;
      case Due::Kind::flight:
        fly(due.index, end);
        break;
      case Due::Kind::ring:
        hosts_[due.index]->ring();
        break;
    }
  }
  now_ = end;
}

bool World::is_reached(const Host& from, const Host& to) const {
  return from.island() == to.island() && !links_.is_cut(from.number(), to.number());
}

void World::cut(const Host& from, const Host& to) {
  links_.cut(from.number(), to.number());
  if (on_reach_changed) on_reach_changed();
}

void World::mend(const Host& from, const Host& to) {
  links_.mend(from.number(), to.number());
  if (on_reach_changed) on_reach_changed();
}

namespace {

const std::string& seen_from(const Host& sender, const Host::Port& port) {
  return sender.seen_as.empty() ? port.address : sender.seen_as;
}

}  // namespace

void World::transmit(const Host& sender, env::InterfaceIndex interface, std::string_view datagram) {
  const Host::Port* from = sender.port(interface);
  if (from == nullptr) return;
  trace(sender.name(), datagram);
  ++datagrams_;
  datagram_bytes_ += datagram.size();
  if (on_transmit) on_transmit(sender, datagram);
  const std::uint32_t flight = take_off(seen_from(sender, *from), datagram);
  for (const auto& receiver : hosts_) {
    const bool is_sender = receiver.get() == &sender;
    if (!is_sender && !(is_reached(sender, *receiver) && receiver->hears_multicasts)) continue;
    if (receiver->multicasts_kept_from.contains(sender.name())) continue;
    for (const Host::Port& to : receiver->ports()) {
      if (to.segment != from->segment) continue;
      if (!is_sender && random_.chance(air.loss)) continue;
      if (!is_sender && air.burst > 0 && links_.is_in_burst(receiver->number(), now_, air, random_)) continue;
      if (!is_sender && air.flip > 0 && random_.chance(air.flip)) {
        const std::uint32_t other = take_off(seen_from(sender, *from), bent(datagram));
        add_arrival(other, *receiver, to.index);
        depart(other);
        continue;
      }
      add_arrival(flight, *receiver, to.index);
      if (random_.chance(air.duplicate)) add_arrival(flight, *receiver, to.index);
    }
  }
  depart(flight);
}

void World::transmit_alone(const Host& sender, env::InterfaceIndex interface, std::string_view address,
                           std::string_view datagram) {
  const Host::Port* from = sender.port(interface);
  if (from == nullptr) return;
  const std::uint32_t flight = take_off(seen_from(sender, *from), datagram);
  flights_[flight]->is_alone = true;
  for (const auto& receiver : hosts_) {
    if (!receiver->hears_datagrams_alone || !is_reached(sender, *receiver)) continue;
    for (const Host::Port& to : receiver->ports()) {
      if (to.segment == from->segment && to.address == address && !random_.chance(air.loss))
        add_arrival(flight, *receiver, to.index);
    }
  }
  depart(flight);
}

void World::inject(const std::string& source, std::string_view datagram, std::uint32_t segment) {
  const std::uint32_t flight = take_off(source, datagram);
  for (const auto& receiver : hosts_) {
    for (const Host::Port& to : receiver->ports()) {
      if (to.segment == segment) add_arrival(flight, *receiver, to.index);
    }
  }
  depart(flight);
}

std::string World::bent(std::string_view datagram) {
  std::string bytes(datagram);
  for (std::uint64_t left = 1 + random_.below(8); left > 0 && !bytes.empty(); --left) {
    char& one = bytes[random_.below(bytes.size())];
    one = static_cast<char>(static_cast<unsigned char>(one) ^ (1U << random_.below(8)));
  }
  return bytes;
}

std::uint32_t World::take_off(std::string_view source, std::string_view datagram) {
  if (free_flights_.empty()) {
    free_flights_.push_back(static_cast<std::uint32_t>(flights_.size()));
    flights_.push_back(std::make_unique<Flight>());
  }
  const std::uint32_t index = free_flights_.back();
  free_flights_.pop_back();
  flights_[index]->source = source;
  flights_[index]->datagram = datagram;
  flights_[index]->is_alone = false;
  return index;
}

void World::add_arrival(std::uint32_t flight, const Host& receiver, env::InterfaceIndex interface) {
  base::Instant instant = now_ + random_.between(air.shortest_delay, air.longest_delay);
  if (air.late > 0 && random_.chance(air.late)) instant += random_.between(base::Duration(0), air.lateness);
  flights_[flight]->arrivals.push_back({.instant = instant,
                                        .host = receiver.number() - 1,
                                        .interface = interface,
                                        .incarnation = receiver.incarnation()});
}

void World::depart(std::uint32_t flight) {
  auto& arrivals = flights_[flight]->arrivals;
  if (arrivals.empty()) return free_flights_.push_back(flight);
  // The last one is next. At one instant they come in the order in which they were drawn.
  std::ranges::reverse(arrivals);
  std::ranges::stable_sort(arrivals, std::greater<>(), &Arrival::instant);
  agenda_.add(arrivals.back().instant, {.kind = Due::Kind::flight, .index = flight});
}

/// Goes on with one datagram until something else comes first, so that most arrivals never see the agenda.
void World::fly(std::uint32_t flight, base::Instant end) {
  Flight& one = *flights_[flight];
  while (!one.arrivals.empty()) {
    const Arrival arrival = one.arrivals.back();
    if (arrival.instant > end || (arrival.instant > now_ && arrival.instant >= agenda_.next())) {
      agenda_.add(arrival.instant, {.kind = Due::Kind::flight, .index = flight});
      return;
    }
    now_ = arrival.instant;
    one.arrivals.pop_back();
    Host& receiver = *hosts_[arrival.host];
    if (receiver.incarnation() == arrival.incarnation)
      receiver.receive(arrival.interface, one.source, one.datagram, one.is_alone);
  }
  free_flights_.push_back(flight);
}

void World::trace(std::string_view who, std::string_view what) {
  auto time = static_cast<std::uint64_t>(now_.time_since_epoch().count());
  if constexpr (std::endian::native == std::endian::big) time = std::byteswap(time);
  trace_ = base::hash64(base::octets_of(std::span<const std::uint64_t>(&time, 1)), trace_);
  trace_ = base::hash64(who, trace_);
  trace_ = base::hash64(what, trace_);
}

}  // namespace geminga::sim
