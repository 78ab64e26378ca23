// Memory is counted by what the allocator has given out.
#include "bench/matching/whole.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

#include "bench/matching/teams.hpp"
#include "bench/table.hpp"
#include "bench/times.hpp"
#include "support/allocations.hpp"

namespace geminga::matching {
namespace {

constexpr std::uint32_t best = 10;          // how many providers the consumer asks for that measures the best of many
constexpr std::uint32_t departures = 1000;  // how many of the best go after each other

/// The memory in use; 0 where the allocator does not tell, as under a sanitizer.
double given_out() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// The octets of the texts of a publication.
double text_octets(const registry::PublicationEntry& entry) {
  const auto& semantic = std::get<SemanticIdentity>(entry.publication.identity);
  return static_cast<double>(semantic.concept_iri.size() + semantic.representation_iri.size() +
                             entry.publication.address.size() + entry.publication.protocol.size());
}

/// Services of random classes with random priorities, all of which are below the root.
registry::PublicationEntry some_service(std::uint32_t number, base::Random& random) {
  auto entry = service(number, identity(common_class(random)));
  entry.publication.priority = static_cast<std::int32_t>(random.below(1'000'000));
  return entry;
}

void fill(Matcher& matcher, std::uint32_t size) {
  base::Random random(size);
  double texts = 0;
  const double before = given_out();
  for (std::uint32_t number = 0; number < size; ++number) {
    auto entry = some_service(number, random);
    texts += text_octets(entry);
    matcher.put(std::move(entry));
  }
  const std::string name = "memory of a publication beside its texts";
  const double taken = given_out() - before;
  if (taken <= 0) {
    bench::row_without(name, std::to_string(size), "not told by this allocator");
  } else {
    bench::row(name, std::to_string(size), (taken - texts) / size, "B", {.limit = 200});
  }
}

void measure_unchanged(Matcher& matcher, std::uint32_t size) {
  base::Random random(size);
  std::uint64_t most = 0;
  for (std::uint32_t number = 0; number < size; ++number) {
    auto entry = some_service(number, random);
    const std::uint64_t before = tests::allocations();
    matcher.put(std::move(entry));
    most = std::max(most, tests::allocations() - before);
  }
  // A limit of 0 means none, and half an allocation is none as well.
  bench::row("allocations of an unchanged publication", std::to_string(size), static_cast<double>(most), "at most",
             {.limit = 0.5});
}

/// The time from a change to its events.
template <typename Change>
double time_of(Matcher& matcher, const Change& change) {
  const auto began = bench::Clock::now();
  change();
  while (matcher.take_step()) {
  }
  const auto events = matcher.take_events();
  const double took = bench::milliseconds_since(began) * 1e3;
  if (events.empty()) std::abort();
  return took;
}

void measure_best(Matcher& matcher, std::uint32_t size) {
  const bench::Goal goal{.limit = 1000};
  auto consumer = wish(0, identity(0));
  consumer.subscription.limit = best;
  const std::string of_all = std::to_string(size);
  const auto name = [](const std::string& what) { return "best " + std::to_string(best) + " of N: " + what; };
  bench::row(name("a new request"), of_all, time_of(matcher, [&] { matcher.put(consumer); }), "us", goal);
  std::vector<double> went;
  std::vector<registry::PublicationEntry> gone;
  for (std::uint32_t i = 0; i < std::min(departures, size / 2); ++i) {
    gone.push_back(*matcher.publications().find_entry(matcher.choices().chosen(consumer.key).front()));
    went.push_back(time_of(matcher, [&] { matcher.remove_publication(gone.back().key, Reason::withdrawn); }));
  }
  bench::row(name("the best goes"), of_all, bench::quantile(went, 0.5), "us", goal);
  bench::row(name("the best goes, slowest of many"), of_all, bench::quantile(went, 1), "us", goal);
  std::vector<double> came;
  for (; !gone.empty(); gone.pop_back()) came.push_back(time_of(matcher, [&] { matcher.put(std::move(gone.back())); }));
  bench::row(name("a better one comes"), of_all, bench::quantile(came, 0.5), "us", goal);
}

}  // namespace

void measure_whole(std::uint32_t size) {
  Matcher matcher(tree());
  fill(matcher, size);
  measure_unchanged(matcher, size);
  measure_best(matcher, size);
}

}  // namespace geminga::matching
