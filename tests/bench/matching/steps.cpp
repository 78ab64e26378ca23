#include "bench/matching/steps.hpp"

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>

#include "bench/matching/teams.hpp"
#include "bench/matching/tree.hpp"
#include "bench/rows.hpp"
#include "bench/table.hpp"

namespace geminga::matching {
namespace {

constexpr double longest_turn_ms = 5;
constexpr std::uint32_t forger = 900'000;
/// Classes of the tree that are used as representations, none of them above another.
constexpr std::uint32_t camera = 341;
constexpr std::uint32_t field = 342;
constexpr std::uint32_t elsewhere = 343;

/// The processor time of this thread: a step's own work.
double processor_milliseconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

struct Work {
  double longest = 0;
  double all = 0;

  template <typename Step>
  auto take(const Step& step) {
    const double began = processor_milliseconds();
    const auto result = step();
    const double took = processor_milliseconds() - began;
    longest = std::max(longest, took);
    all += took;
    return result;
  }
};

/// Takes a change and all the steps that it leaves.
template <typename Change>
Work work_of(Matcher& matcher, const Change& change) {
  Work work;
  work.take([&] {
    change();
    return true;
  });
  const auto step = [&] {
    const bool is_left = matcher.take_step();
    (void)matcher.take_events();
    return is_left;
  };
  while (work.take(step)) {
  }
  return work;
}

void rows(const std::string& name, std::uint32_t size, const Work& work) {
  bench::row(name + ": longest step", std::to_string(size), work.longest, "ms", {.limit = longest_turn_ms});
  bench::row(name + ": all steps", std::to_string(size), work.all, "ms", {});
}

ServiceKey key_of(std::uint32_t participant, std::uint32_t number) {
  return {.participant = ParticipantId{participant}, .peer = PeerId{1}, .number = number};
}

SemanticIdentity in_representation(std::uint32_t concept_number, std::uint32_t representation) {
  return {.concept_iri = class_iri(concept_number), .representation_iri = class_iri(representation)};
}

registry::SubscriptionEntry converting(std::uint32_t number) {
  auto entry = wish(number, in_representation(1, field));
  entry.subscription.convert = any_cost;
  return entry;
}

registry::PublicationEntry converter(std::uint32_t participant, std::uint32_t number, std::uint32_t cost) {
  auto entry = service(number, TextIdentity{"converter"});
  entry.key = key_of(participant, number);
  entry.publication.attributes = {{"converts", "<" + class_iri(camera) + ">><" + class_iri(field) + ">"},
                                  {"cost", std::to_string(cost)}};
  return entry;
}

void measure_converters(std::uint32_t requests) {
  Matcher matcher(tree());
  for (std::uint32_t number = 1; number <= requests; ++number) matcher.put(converting(number));
  for (std::uint32_t number = 1; number <= 3; ++number) {
    matcher.put(service(number, in_representation(1, camera)));
  }
  for (std::uint32_t number = 1; number <= 1024; ++number) matcher.put(converter(forger, number, 7));
  Work changes;
  for (std::uint32_t round = 1; round <= 20; ++round) {
    for (std::uint32_t number = 1; number <= 5; ++number) {  // one after the other, as the participant takes them
      const Work one = work_of(matcher, [&] { matcher.put(converter(forger, number, 1 + round % 5)); });
      changes.longest = std::max(changes.longest, one.longest);
      changes.all += one.all / 20;
    }
  }
  rows("5 converters of a host change, N requests convert", requests, changes);
  rows("a host with 1024 converters goes, N requests convert", requests,
       work_of(matcher, [&] { matcher.begin_departure(ParticipantId{forger}, Reason::left); }));
}

void measure_publication(std::uint32_t requests) {
  Matcher matcher(tree());
  for (std::uint32_t number = 1; number <= requests; ++number) matcher.put(wish(number, identity(1)));
  auto offered = service(1, identity(1));
  rows("a publication comes that N requests ask for", requests, work_of(matcher, [&] { matcher.put(offered); }));
  offered.publication.port += 1;
  rows("a publication changes that N requests ask for", requests, work_of(matcher, [&] { matcher.put(offered); }));
  rows("a publication goes that N requests ask for", requests,
       work_of(matcher, [&] { matcher.begin_removal_of_publication(offered.key, Reason::withdrawn); }));
}

void measure_request(std::uint32_t offers) {
  Matcher matcher(tree());
  for (std::uint32_t number = 1; number <= offers; ++number) matcher.put(service(number, identity(1)));
  auto asked = wish(1, identity(0));
  asked.is_local = false;
  asked.key = key_of(forger, 1);
  asked.subscription.limit = 16;
  asked.subscription.mode = ChannelMode::one_to_one;
  rows("a request of another host comes that N services meet", offers, work_of(matcher, [&] { matcher.put(asked); }));
  asked.subscription.where = "rate>1";
  rows("a request of another host changes that N services meet", offers, work_of(matcher, [&] { matcher.put(asked); }));
}

void measure_used_up_choice(std::uint32_t offers) {
  Matcher matcher(tree());
  for (std::uint32_t number = 1; number <= offers; ++number) {
    auto entry = service(number, identity(1));
    entry.key = key_of(number % 40 == 0 ? forger : 2, number);
    entry.publication.priority = number % 40 == 0 ? 9 : 0;
    matcher.put(std::move(entry));
  }
  auto asked = wish(1, identity(0));
  asked.subscription.limit = 1;
  matcher.put(asked);
  rows("a choice among N services is used up", offers,
       work_of(matcher, [&] { matcher.begin_departure(ParticipantId{forger}, Reason::left); }));
}

}  // namespace

void measure_steps() {
  const std::uint32_t part = bench::sizes().back() < 100'000 ? 20 : 1;
  measure_converters(800 / part);
  measure_publication(33'000 / part);
  measure_request(40'000 / part);
  measure_used_up_choice(40'000 / part);
}

}  // namespace geminga::matching
