// The cost of a service that comes, stays and is asked for, among many others.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "bench/matching/steps.hpp"
#include "bench/matching/teams.hpp"
#include "bench/matching/whole.hpp"
#include "bench/rows.hpp"

namespace geminga::matching {
namespace {

void tell(benchmark::State& state) {
  Matcher& matcher = team<Consumers>(state.range(0)).matcher;
  const auto entry = service(0, identity(rare_class()));
  for (auto _ : state) {
    matcher.put(entry);
    matcher.remove_publication(entry.key, Reason::withdrawn);
    const auto events = matcher.take_events();
    if (events.size() != std::size_t{2} * answers) state.SkipWithError("not told to all");
  }
}

/// The service is of the rare class, and no consumer asks for anything above it.
void tell_nobody(benchmark::State& state) {
  Matcher& matcher = team<Strangers>(state.range(0)).matcher;
  const auto entry = service(0, identity(rare_class()));
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

void answer(benchmark::State& state, Identity wanted) {
  auto& providers = team<Providers>(state.range(0));
  const registry::SubscriptionEntry request = wish(0, std::move(wanted));
  for (auto _ : state) {
    const auto prepared = providers.matcher.examination().prepare(request.subscription);
    const auto candidates = providers.matcher.search().candidates(request.subscription, *prepared, answers);
    const auto meets = [&](const ServiceKey& one) {
      return providers.matcher.examination()
          .meets(request, *prepared, *providers.matcher.publications().find_entry(one))
          .has_value();
    };
    if (!candidates || !std::ranges::all_of(*candidates, meets) || candidates->size() != answers)
      state.SkipWithError("not all found");
  }
}

void answer_exact(benchmark::State& state) { answer(state, rare_text()); }

void answer_semantic(benchmark::State& state) { answer(state, identity(class_above(rare_class()))); }

void change_ontology(benchmark::State& state) {
  auto& providers = team<Providers>(state.range(0));
  for (auto _ : state) {
    providers.matcher.vocabulary_change().begin(tree());
    while (providers.matcher.vocabulary_change().file_next()) {
    }
    providers.matcher.vocabulary_change().put_in_force();
    while (providers.matcher.vocabulary_change().rematch_next()) {
    }
    if (!providers.matcher.take_events().empty()) state.SkipWithError("nothing changed, and yet something was told");
  }
}

void register_all() {
  for (const long size : bench::sizes()) {
    const auto add = [size](const char* name, void (*function)(benchmark::State&)) {
      benchmark::RegisterBenchmark(name, function)->Arg(size);
    };
    add("exact request with 10 answers among N services", answer_exact);
    add("semantic request with 10 answers among N services", answer_semantic);
    if (size > 100'000) continue;
    add("service comes and goes, told to nobody of N consumers", tell_nobody);
    add("service comes and goes, told to 10 of N consumers", tell);
    add("put again unchanged among N services", put_again);
    add("another ontology with N services", change_ontology);
  }
}

}  // namespace
}  // namespace geminga::matching

int main(int argc, char** argv) {
  using namespace geminga;
  const int status = bench::run(
      argc, argv,
      {{"semantic request with 10 answers among N services", {"exact request with 10 answers among N services", 2.0}},
       {"service comes and goes, told to nobody of N consumers", {.limit = 2000}}},
      matching::register_all);
  if (status != 0) return status;
  for (const long size : bench::sizes()) matching::measure_whole(static_cast<std::uint32_t>(size));
  matching::measure_steps();
  return 0;
}
