// The cost of a datagram that is sealed, opened, or rejected, by the step that rejects it and by size.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "base/random.hpp"
#include "bench/rows.hpp"
#include "discovery/sealing/seal.hpp"

namespace geminga::sealing {
namespace {

constexpr env::InterfaceIndex interface{1};
constexpr base::Instant now{std::chrono::hours(1)};
constexpr Arrival arrival{.interface = interface, .interface_name = "eth0", .source = "10.0.0.66", .now = now};
/// A time after which no challenge is open.
constexpr base::Instant later = now + std::chrono::hours(1);

using Octets = std::vector<std::byte>;

Policy policy_of(int secret) {
  Key::Secret octets{};
  octets.fill(static_cast<unsigned char>(secret));
  Policy policy{.mode = Mode::encrypted};
  (void)policy.keys.add(Key(octets));
  return policy;
}

/// A text that compression cannot shorten.
Octets noise(std::size_t size) {
  base::Random random(size);
  Octets text(size);
  for (std::byte& octet : text) octet = static_cast<std::byte>(random.next());
  return text;
}

/// A text like a state: names with equal beginnings, and numbers.
Octets names(std::size_t size) {
  base::Random random(size);
  Octets text;
  while (text.size() < size) {
    for (const char c : "Sensor" + std::to_string(random.below(1000)) + "State")
      text.push_back(static_cast<std::byte>(c));
  }
  text.resize(size);
  return text;
}

struct Member {
  Member(std::uint64_t seed, int secret) : random(seed), seal([this] { return random.next(); }) {
    seal.adopt(policy_of(secret), now);
  }
  Octets say(std::size_t size, base::Instant at = now) {
    const Octets text = noise(size);
    const auto datagram = seal.seal(text, interface, at);
    return {datagram.begin(), datagram.end()};
  }
  base::Random random;
  Seal seal;
};

/// A team of thirty participants, seen from one of them.
struct Team {
  Team() {
    for (std::uint64_t i = 2; i <= 30; ++i) others.push_back(std::make_unique<Member>(i, 1));
    for (const auto& other : others) (void)one.seal.open(other->say(20), arrival);
    const Octets echoes = one.say(20);
    for (const auto& other : others) (void)other->seal.open(echoes, arrival);
    for (const auto& other : others) (void)one.seal.open(other->say(20), arrival);
  }
  Member one{1, 1};
  std::vector<std::unique_ptr<Member>> others;
};

void hear(benchmark::State& state, const Octets& datagram) {
  Team team;
  for (auto _ : state) benchmark::DoNotOptimize(team.one.seal.open(datagram, arrival).has_value());
}

std::size_t text_size(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

/// Opens a datagram with a wrong tag: the most expensive forgery, since the whole datagram is authenticated.
void forged(benchmark::State& state) {
  Octets datagram = Member(99, 1).say(text_size(state), later);
  datagram.back() ^= std::byte{1};
  hear(state, datagram);
}

void unknown_key(benchmark::State& state) { hear(state, Member(99, 2).say(text_size(state), later)); }

void plain(benchmark::State& state) { hear(state, Octets(text_size(state), std::byte{0x0d})); }

void replayed(benchmark::State& state) {
  Team team;
  const Octets datagram = team.others.front()->say(text_size(state), later);
  (void)team.one.seal.open(datagram, arrival);
  for (auto _ : state) benchmark::DoNotOptimize(team.one.seal.open(datagram, arrival).has_value());
}

/// Opens an old recording, which looks like a newcomer.
void unproved(benchmark::State& state) { hear(state, Member(99, 1).say(text_size(state), later)); }

void seal_and_open(benchmark::State& state, const Octets& text) {
  Team team;
  Member& other = *team.others.front();
  for (auto _ : state) {
    benchmark::DoNotOptimize(team.one.seal.open(other.seal.seal(text, interface, later), arrival).has_value());
  }
}

void seal_and_open_noise(benchmark::State& state) { seal_and_open(state, noise(text_size(state))); }
void seal_and_open_names(benchmark::State& state) { seal_and_open(state, names(text_size(state))); }

void copied(benchmark::State& state) {
  const Octets text(text_size(state), std::byte{'x'});
  std::array<std::byte, env::max_datagram_bytes> to{};
  for (auto _ : state) {
    std::copy_n(text.data(), text.size(), to.data());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
}

void add(const char* name, void (*measure)(benchmark::State&)) {
  for (const long size : {36L, 100L, 600L, 1200L}) benchmark::RegisterBenchmark(name, measure)->Arg(size);
}

void register_all() {
  add("a datagram is copied", copied);
  add("sealed, and opened", seal_and_open_noise);
  add("compressed and sealed, opened and expanded", seal_and_open_names);
  add("rejected: plain", plain);
  add("rejected: unknown key", unknown_key);
  add("rejected: replayed", replayed);
  add("rejected: forged", forged);
  add("rejected: unproved", unproved);
}

}  // namespace
}  // namespace geminga::sealing

int main(int argc, char** argv) { return geminga::bench::run(argc, argv, {}, geminga::sealing::register_all); }
