// Look-ups and changes in the registry, beside std::unordered_map over the same services.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/random.hpp"
#include "bench/rows.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::registry {
namespace {

constexpr ClassIndex branching = 4;
constexpr ClassIndex class_count = 1365;  // a complete tree of branching 4 with 6 levels
constexpr std::uint32_t peers_a_participant = 10;

std::vector<ClassIndex> subsumers(ClassIndex number) {
  std::vector<ClassIndex> all{number};
  while (all.back() != 0) all.push_back((all.back() - 1) / branching);
  return all;
}

constexpr std::size_t digits = 7;
constexpr std::string_view concept_prefix = "http://example.org/team#Concept";

using Digits = std::array<char, digits>;

Digits digits_of(std::uint32_t number) {
  Digits text;
  for (std::size_t i = digits; i-- > 0; number /= 10) text[i] = static_cast<char>('0' + number % 10);
  return text;
}

Identity identity(std::uint32_t number) {
  const Digits text = digits_of(number);
  return SemanticIdentity{std::string(concept_prefix) + std::string(text.data(), digits),
                          "http://example.org/team#Frame"};
}

PublicationEntry service(std::uint32_t number, base::Instant updated) {
  PublicationEntry entry;
  entry.key = {ParticipantId{1 + number / 100}, PeerId{1 + number % peers_a_participant}, number};
  entry.publication.identity = identity(number);
  entry.publication.mode = ChannelMode::one_to_many_stream;
  entry.publication.address = "192.0.2.1";
  entry.publication.port = 5000;
  entry.updated = updated;
  return entry;
}

/// A number of services, each with its own identity and class, in the registry and in plain hash maps.
struct Team {
  explicit Team(std::size_t size) : random(size) {
    table.set_class_count(class_count);
    for (std::uint32_t number = 0; number < size; ++number) {
      const auto of_class = static_cast<ClassIndex>(random.below(class_count));
      const auto& stored = table.insert(service(number, base::Instant()), {of_class, subsumers(of_class)});
      by_number.emplace(stored.identity, &stored.entry);
      by_name.emplace(canonical_form(stored.entry.publication.identity), &stored.entry);
    }
    // Look-ups use separate requests, in an order unrelated to the order of arrival.
    for (std::uint32_t i = 0; i < 65'536; ++i) {
      const auto number = static_cast<std::uint32_t>(random.below(size));
      keys.push_back(service(number, base::Instant()).key);
      numbers.push_back(id32(identity(number)));
      names.push_back(digits_of(number));
      classes.push_back(static_cast<ClassIndex>(random.below(class_count)));
    }
  }

  base::Random random;
  Publications table;
  std::unordered_map<Id32, const PublicationEntry*> by_number;
  std::unordered_map<std::string, const PublicationEntry*> by_name;
  std::vector<ServiceKey> keys;
  std::vector<Id32> numbers;
  std::vector<Digits> names;
  std::vector<ClassIndex> classes;
};

/// Returns the team of this size; builds it at the first call.
Team& team(std::int64_t size) {
  static std::map<std::int64_t, std::unique_ptr<Team>> teams;
  auto& one = teams[size];
  if (!one) one = std::make_unique<Team>(static_cast<std::size_t>(size));
  return *one;
}

/// A request that has just been read: its name is in the cache, and only its digits differ from the previous one. All
/// look-ups, the baseline too, pay for writing these digits.
struct Request {
  Identity identity = registry::identity(0);
  std::string canonical = canonical_form(identity);

  void become(const Digits& name) {
    auto& iri = std::get<SemanticIdentity>(identity).concept_iri;
    std::ranges::copy(name, iri.begin() + concept_prefix.size());
    std::ranges::copy(name, canonical.begin() + 1 + concept_prefix.size());
    benchmark::ClobberMemory();
  }
};

template <typename LookUp>
void look_up(benchmark::State& state, const LookUp& look_up) {
  Team& services = team(state.range(0));
  Request request;
  std::size_t i = 0;
  for (auto _ : state) {
    request.become(services.names[i]);
    benchmark::DoNotOptimize(look_up(services, request, i));
    i = (i + 1) % services.keys.size();
  }
}

int port_of(const PublicationEntry* entry) { return entry->publication.port; }

void hash_map_by_number(benchmark::State& state) {
  look_up(state, [](Team& services, const Request&, std::size_t i) {
    return port_of(services.by_number.find(services.numbers[i])->second);
  });
}

void hash_map_by_name(benchmark::State& state) {
  look_up(state, [](Team& services, const Request& request, std::size_t) {
    return port_of(services.by_name.find(request.canonical)->second);
  });
}

void exact(benchmark::State& state) {
  look_up(state, [](Team& services, const Request& request, std::size_t i) {
    return port_of(&services.table.with_identity(request.identity, services.numbers[i]).front().stored->entry);
  });
}

void exact_hashing_the_name(benchmark::State& state) {
  look_up(state, [](Team& services, const Request& request, std::size_t) {
    return port_of(&services.table.with_identity(request.identity, id32(request.identity)).front().stored->entry);
  });
}

void semantic(benchmark::State& state) {
  look_up(state, [](Team& services, const Request&, std::size_t i) {
    const auto found = services.table.below(services.classes[i]);
    return found.empty() ? 0 : port_of(&found.front().stored->entry);
  });
}

void by_key(benchmark::State& state) {
  look_up(state, [](Team& services, const Request&, std::size_t i) {
    return port_of(&services.table.find(services.keys[i])->entry);
  });
}

void refresh(benchmark::State& state) {
  Team& services = team(state.range(0));
  std::size_t i = 0;
  base::Instant now;
  for (auto _ : state) {
    now += std::chrono::microseconds(1);
    services.table.refresh(*services.table.find(services.keys[i]), now);
    i = (i + 1) % services.keys.size();
  }
}

void insert_and_erase(benchmark::State& state) {
  Team& services = team(state.range(0));
  const auto size = static_cast<std::uint32_t>(state.range(0));
  const auto classes = subsumers(class_count - 1);
  for (auto _ : state) {
    services.table.erase(services.table.insert(service(size, base::Instant()), {class_count - 1, classes}));
  }
}

/// Removes a participant with a hundred services, as its deadline does, and adds it again.
void remove_a_hundred(benchmark::State& state) {
  Team& services = team(state.range(0));
  const auto size = static_cast<std::uint32_t>(state.range(0));
  const auto classes = subsumers(class_count - 1);
  const ParticipantId leaving{0xffffffff};
  for (auto _ : state) {
    state.PauseTiming();
    for (std::uint32_t i = 0; i < 100; ++i) {
      auto entry = service(size + i, base::Instant());
      entry.key.participant = leaving;
      services.table.insert(std::move(entry), {class_count - 1, classes});
    }
    state.ResumeTiming();
    for (const auto* stored : services.table.of_participant(leaving)) services.table.erase(*stored);
  }
}

void register_all() {
  for (const long size : bench::sizes()) {
    const auto add = [size](const char* name, void (*function)(benchmark::State&)) {
      benchmark::RegisterBenchmark(name, function)->Arg(size);
    };
    add("std::unordered_map by number", hash_map_by_number);
    add("std::unordered_map by name", hash_map_by_name);
    add("exact look-up", exact);
    add("exact look-up, hashing the name", exact_hashing_the_name);
    add("semantic look-up", semantic);
    add("look-up by key", by_key);
    add("refresh", refresh);
    add("insert and erase", insert_and_erase);
    add("remove a participant of 100", remove_a_hundred);
  }
}

}  // namespace
}  // namespace geminga::registry

int main(int argc, char** argv) {
  const char* baseline = "std::unordered_map by number";
  return geminga::bench::run(argc, argv,
                             {{"exact look-up", {baseline, 1.3}},
                              {"semantic look-up", {baseline, 3.0}},
                              {"std::unordered_map by name", {baseline, 0}},
                              {"exact look-up, hashing the name", {"std::unordered_map by name", 0}},
                              {"look-up by key", {baseline, 0}}},
                             geminga::registry::register_all);
}
