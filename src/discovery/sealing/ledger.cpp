#include "discovery/sealing/ledger.hpp"

#include <algorithm>
#include <utility>

#include "base/hash.hpp"

namespace geminga::sealing {
namespace {

/// The cause and the remedy, for the log.
std::string_view remedy(Rejection rejection) {
  switch (rejection) {
    case Rejection::plain:
      return "not sealed, and only sealed announcements are heard: give that host a key, or find out who it is";
    case Rejection::unknown_key:
      return "sealed with a key that is not among ours: give both the same --key-file";
    case Rejection::forged:
      return "not sealed with the key that it names: a program there forges announcements, or they are damaged on the "
             "way";
    case Rejection::replayed:
      return "said for a second time: a program there replays announcements, or a bridge doubles them";
    case Rejection::unproved:
      return "of a session that has not answered us yet: a participant that has just come, or one that does not hear "
             "us; if it goes on, a recording";
    case Rejection::downgraded:
      return "not sealed, in the name of a participant that seals: a program there forges announcements";
    case Rejection::unreadable:
      return "no announcement of this version: another program says something there, or it is damaged on the way";
    case Rejection::other_version:
      return "sealed in a way that this version does not know: have the same version on all hosts";
    case Rejection::too_large:
    case Rejection::too_short:
    case Rejection::malformed:
    case Rejection::own:
    case Rejection::copied:
      break;
  }
  return "no sealed announcement of this version";
}

/// A recording looks like a newcomer at first, and newcomers are not logged.
constexpr std::uint64_t unproved_before_told = 100;

}  // namespace

Ledger::Ledger() { recent_.reserve(remembered_datagrams); }

void Ledger::enter(const Outcome& outcome, const Arrival& arrival) {
  if (recent_.size() < remembered_datagrams) {
    recent_.push_back(outcome);
  } else {
    recent_[next_] = outcome;
    next_ = (next_ + 1) % remembered_datagrams;
  }
  if (!outcome.rejection) return;
  ++rejected_.at(static_cast<std::size_t>(*outcome.rejection));
  note_source(outcome, arrival);
  complain(outcome, arrival);
}

void Ledger::note_source(const Outcome& outcome, const Arrival& arrival) {
  const std::array<std::uint32_t, 4> rest{static_cast<std::uint32_t>(arrival.interface),
                                          static_cast<std::uint32_t>(outcome.protection),
                                          outcome.key ? 0x10000U | static_cast<std::uint32_t>(*outcome.key) : 0U,
                                          static_cast<std::uint32_t>(*outcome.rejection)};
  const std::uint64_t hash = base::hash64(arrival.source, base::hash64(base::octets_of(std::span(rest))));
  auto found = std::ranges::find(sources_, hash, &Source::hash);
  if (found == sources_.end()) {
    if (sources_.size() < max_sources) {
      found = sources_.insert(sources_.end(), Source{});
    } else {
      found = std::ranges::min_element(sources_, {}, [](const Source& one) { return one.rejected.last; });
    }
    found->hash = hash;
    found->rejected = {std::string(arrival.source) + " on " + std::string(arrival.interface_name), outcome, 0, {}};
  }
  ++found->rejected.count;
  found->rejected.last = arrival.now;
}

void Ledger::complain(const Outcome& outcome, const Arrival& arrival) {
  Told& told = told_.at(static_cast<std::size_t>(*outcome.rejection));
  ++told.since;
  if (told.at != base::Instant::min() && arrival.now - told.at < complaint_spacing) return;
  if (outcome.rejection == Rejection::unproved && told.since < unproved_before_told) return;
  const std::string key = outcome.key ? " (key " + to_string(*outcome.key) + ')' : "";
  complaint_ = std::to_string(told.since) + (told.since == 1 ? " datagram was" : " datagrams were") + " rejected as " +
               std::string(to_string(*outcome.rejection)) + ", the last from " + std::string(arrival.source) + " on " +
               std::string(arrival.interface_name) + key + ": " + std::string(remedy(*outcome.rejection));
  told = {arrival.now, 0};
}

std::optional<std::string> Ledger::take_complaint() { return std::exchange(complaint_, std::nullopt); }

std::map<Outcome, std::size_t> Ledger::recent() const {
  std::map<Outcome, std::size_t> counts;
  for (const Outcome& outcome : recent_) ++counts[outcome];
  return counts;
}

std::vector<Rejected> Ledger::sources() const {
  std::vector<Rejected> all;
  for (const Source& source : sources_) all.push_back(source.rejected);
  std::ranges::stable_sort(all, std::ranges::greater(), &Rejected::last);
  return all;
}

}  // namespace geminga::sealing
