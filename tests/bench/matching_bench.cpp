// What it costs the matcher that a service comes, stays, and is asked for, among many others.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/random.hpp"
#include "bench/rows.hpp"
#include "discovery/matching/matcher.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::matching {
namespace {

constexpr std::uint32_t branching = 4;
constexpr std::uint32_t class_count = 1365;  // a complete tree of branching 4 with 6 levels
constexpr std::uint32_t answers = 10;        // how many belong to the request or offer that is measured
constexpr std::uint32_t here = 1;
constexpr std::uint32_t rare = class_count - 1;  // the class that only those have

std::string class_iri(std::uint32_t number) { return "http://example.org/team#Concept" + std::to_string(number); }

vocabulary::Vocabulary tree() {
  owl::Ontology source;
  const owl::FileId file = source.add_file("tree.ttl");
  for (std::uint32_t number = 1; number < class_count; ++number) {
    source.add(owl::AxiomKind::sub_class_of,
               {source.named_class(class_iri(number)), source.named_class(class_iri((number - 1) / branching))}, file,
               number);
  }
  auto classification = el::classify(source);
  return vocabulary::Vocabulary(
      std::move(compiled::Ontology::from_bytes(compiled::compile(source, classification.value()))).value());
}

const vocabulary::Vocabulary& ontology() {
  static const vocabulary::Vocabulary loaded = tree();
  return loaded;
}

Identity identity(std::uint32_t number) { return SemanticIdentity{class_iri(number), "http://example.org/team#Frame"}; }

registry::PublicationEntry service(std::uint32_t number, std::uint32_t of_class) {
  registry::PublicationEntry entry;
  entry.key = {ParticipantId{2 + number / 100}, PeerId{1}, number};
  entry.publication.identity = identity(of_class);
  entry.publication.address = "192.0.2.1";
  entry.publication.port = 5000;
  return entry;
}

registry::SubscriptionEntry wish(std::uint32_t number, std::uint32_t of_class) {
  registry::SubscriptionEntry entry;
  entry.key = {ParticipantId{here}, PeerId{1}, number};
  entry.is_local = true;
  entry.subscription.identity = identity(of_class);
  return entry;
}

/// A class that is neither above nor below the rare one: any leaf but it.
std::uint32_t common_class(base::Random& random) {
  constexpr std::uint32_t leaves = 1024;
  return class_count - leaves + static_cast<std::uint32_t>(random.below(leaves - 1));
}

/// Many standing subscriptions of local peers, of which a few want the rare class, by whatever name above it.
struct Consumers {
  explicit Consumers(std::uint32_t size) : matcher(ontology()) {
    base::Random random(size);
    for (std::uint32_t number = 0; number < size - answers; ++number) matcher.put(wish(number, common_class(random)));
    std::uint32_t wider = rare;
    for (std::uint32_t i = 0; i < answers; ++i, wider = (wider - 1) / branching) {
      if (wider < branching) wider = rare;
      matcher.put(wish(size - answers + i, wider));
    }
  }
  Matcher matcher;
};

/// Many services of the team, of which a few are of the rare class.
struct Providers {
  explicit Providers(std::uint32_t size) : matcher(ontology()) {
    base::Random random(size);
    for (std::uint32_t number = 0; number < size; ++number) {
      entries.push_back(service(number, number < answers ? rare : common_class(random)));
      matcher.put(entries.back());
    }
  }
  Matcher matcher;
  std::vector<registry::PublicationEntry> entries;
};

template <typename Team>
Team& team(std::int64_t size) {
  static std::map<std::int64_t, std::unique_ptr<Team>> teams;
  auto& one = teams[size];
  if (!one) one = std::make_unique<Team>(static_cast<std::uint32_t>(size));
  return *one;
}

void tell(benchmark::State& state) {
  Matcher& matcher = team<Consumers>(state.range(0)).matcher;
  const auto entry = service(0, rare);
  for (auto _ : state) {
    matcher.put(entry);
    matcher.remove_publication(entry.key, Reason::withdrawn);
    const auto events = matcher.take_events();
    if (events.size() != std::size_t{2} * answers) state.SkipWithError("not told to all");
  }
}

void tell_nobody(benchmark::State& state) {
  Matcher& matcher = team<Consumers>(state.range(0)).matcher;
  auto entry = service(0, rare);
  entry.publication.mode = ChannelMode::one_to_many_stream;
  entry.publication.identity = TextIdentity{"nobody wants this"};
  for (auto _ : state) {
    matcher.put(entry);
    matcher.remove_publication(entry.key, Reason::withdrawn);
    if (!matcher.take_events().empty()) state.SkipWithError("told to somebody");
  }
}

void put_again(benchmark::State& state) {
  auto& providers = team<Providers>(state.range(0));
  std::size_t i = 0;
  base::Instant now;
  for (auto _ : state) {
    auto entry = providers.entries[i];
    now += std::chrono::microseconds(1);
    entry.updated = now;
    providers.matcher.put(std::move(entry));
    i = (i + 1) % providers.entries.size();
  }
}

void answer(benchmark::State& state) {
  auto& providers = team<Providers>(state.range(0));
  const registry::SubscriptionEntry request = wish(0, rare);
  for (auto _ : state) {
    const auto prepared = providers.matcher.prepare(request.subscription);
    const auto candidates = providers.matcher.candidates(request.subscription, *prepared, answers);
    const auto meets = [&](const ServiceKey& one) {
      return providers.matcher.meets(request, *prepared, *providers.matcher.find_publication(one)).has_value();
    };
    if (!candidates || !std::ranges::all_of(*candidates, meets) || candidates->size() != answers)
      state.SkipWithError("not all found");
  }
}

void change_ontology(benchmark::State& state) {
  auto& providers = team<Providers>(state.range(0));
  for (auto _ : state) {
    providers.matcher.begin_vocabulary(ontology());
    while (providers.matcher.file_next()) {
    }
    providers.matcher.put_in_force();
    while (providers.matcher.rematch_next()) {
    }
    if (!providers.matcher.take_events().empty()) state.SkipWithError("nothing changed, and yet something was told");
  }
}

void register_all() {
  for (const long size : bench::sizes()) {
    if (size > 100'000) continue;  // more than any team; the registry's own benchmarks go there
    const auto add = [size](const char* name, void (*function)(benchmark::State&)) {
      benchmark::RegisterBenchmark(name, function)->Arg(size);
    };
    add("new service and its end, told to 10 of N consumers", tell);
    add("new service and its end, told to nobody of N", tell_nobody);
    add("put again unchanged among N services", put_again);
    add("match with 10 answers among N services", answer);
    add("another ontology with N services", change_ontology);
  }
}

}  // namespace
}  // namespace geminga::matching

int main(int argc, char** argv) { return geminga::bench::run(argc, argv, {}, geminga::matching::register_all); }
