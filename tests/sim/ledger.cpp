#include "sim/ledger.hpp"

#include <algorithm>

#include "sim/host.hpp"

namespace geminga::sim {
namespace {

/// Entries that have ended are remembered for this time, to tell a late word from an invented one.
constexpr base::Duration memory = std::chrono::minutes(5);

}  // namespace

std::string to_string(const Place& place) { return std::to_string(place.host) + ":" + std::to_string(place.port); }

Ledger::Ledger(World& world, Bounds bounds) : world_(world), bounds_(bounds) {}

void Ledger::begin(const Place& place, const Topic& topic, bool is_change) {
  things_[place] = {.topic = topic, .begun = world_.now(), .is_change = is_change};
  places_[topic].insert(place);
  compare_all(topic, place);
}

void Ledger::end(const Place& place, End why) {
  const auto found = things_.find(place);
  if (found == things_.end() || found->second.has_ended) return;
  Thing& thing = found->second;
  thing.has_ended = true;
  thing.why = why;
  thing.ended = world_.now();
  ended_.emplace_back(thing.ended, place);
  places_[thing.topic].erase(place);
  compare_all(thing.topic, place);
}

void Ledger::look(const Viewer& viewer, std::uint32_t host, const std::string& name, const Topic& topic) {
  Eye& eye = eyes_[viewer];
  eye = {.host = host, .name = name, .topic = topic, .seen = {}, .words = {}};
  viewers_[topic].insert(viewer);
  for (const Place& place : places_[topic]) compare(viewer, eye, place);
}

void Ledger::look_away(const Viewer& viewer) {
  const auto found = eyes_.find(viewer);
  if (found == eyes_.end()) return;
  viewers_[found->second.topic].erase(viewer);
  eyes_.erase(found);
  wrong_.erase(wrong_.lower_bound({viewer, {}}), wrong_.lower_bound({{viewer.module, viewer.number + 1}, {}}));
}

void Ledger::reach_changed() {
  reach_changed_ = world_.now();
  for (const auto& [viewer, eye] : eyes_) {
    for (const Place& place : places_[eye.topic]) compare(viewer, eye, place);
    for (const auto& [place, seen] : eye.seen) compare(viewer, eye, place);
  }
}

void Ledger::told(const Viewer& viewer, std::string_view word, const Place& place, std::string_view line) {
  const auto found = eyes_.find(viewer);
  if (found == eyes_.end()) return;
  Eye& eye = found->second;
  if (const auto known = eye.words.find(word); known != eye.words.end()) {
    if (known->second == place) return;
    told_off(viewer, word);  // a change that moves it
  }
  Seen& seen = eye.seen[place];
  // Datagrams that waited for a stopped process are told in their order, old words and old lies first.
  const bool is_catching_up = world_.hosts()[eye.host - 1]->is_catching_up();
  const bool was_lied_to = world_.now() < tampered_until_ || (is_catching_up && tampered_until_ != base::Instant{});
  const auto complain = [&](const std::string& what) {
    if (!was_lied_to) world_.complain(what + " " + eye.name + ": " + std::string(line) + ",");
  };
  const auto thing = things_.find(place);
  if (thing == things_.end() || thing->second.topic != eye.topic) {
    complain("false match: nobody there says what is told to");
  } else if (thing->second.has_ended && seen.was_told_off && seen.told_off > thing->second.ended) {
    if (!is_catching_up) complain("returned: what is gone, and was told off, is told again to");
  }
  eye.words.emplace(word, place);
  ++seen.words;
  compare(viewer, eye, place);
}

void Ledger::told_off(const Viewer& viewer, std::string_view word) {
  const auto found = eyes_.find(viewer);
  if (found == eyes_.end()) return;
  Eye& eye = found->second;
  const auto known = eye.words.find(word);
  if (known == eye.words.end()) return;
  const Place place = known->second;
  eye.words.erase(known);
  Seen& seen = eye.seen[place];
  --seen.words;
  seen.was_told_off = true;
  seen.told_off = world_.now();
  compare(viewer, eye, place);
}

Ledger::Wrongness Ledger::judge(const Eye& eye, const Place& place) const {
  const auto seen = eye.seen.find(place);
  const std::size_t words = seen == eye.seen.end() ? 0 : seen->second.words;
  const Host& here = *world_.hosts()[eye.host - 1];
  if (here.pause() != Host::Pause::none) return Wrongness::none;  // who sleeps learns nothing
  const auto found = things_.find(place);
  const bool is_there = found != things_.end() && !found->second.has_ended && found->second.topic == eye.topic;
  if (!is_there) {
    // Whoever does not hear a host, but hears others who do, learns that it lives and not what it has taken back.
    const bool is_cut = found != things_.end() && found->second.why != End::crashed &&
                        !world_.is_reached(*world_.hosts()[place.host - 1], here);
    return words == 0 || is_cut ? Wrongness::none : Wrongness::surplus;
  }
  const Host& there = *world_.hosts()[place.host - 1];
  if (there.island() != here.island() || there.pause() != Host::Pause::none) {
    return words == 0 ? Wrongness::none : Wrongness::surplus;
  }
  // Where only the one way is cut, others may go on to witness for it.
  if (!world_.is_reached(there, here) || !world_.is_reached(here, there)) return Wrongness::none;
  if (words == 0) return Wrongness::missing;
  return words == 1 ? Wrongness::none : Wrongness::surplus;
}

void Ledger::compare(const Viewer& viewer, const Eye& eye, const Place& place) {
  const Wrongness what = judge(eye, place);
  const auto known = wrong_.find({viewer, place});
  if (known != wrong_.end()) {
    if (known->second.what == what) return;
    resolve(eye, place, known->second);
    wrong_.erase(known);
  }
  if (what == Wrongness::none) return;
  const auto thing = things_.find(place);
  const bool is_fresh =
      thing != things_.end() && world_.now() == (thing->second.has_ended ? thing->second.ended : thing->second.begun);
  wrong_.emplace(std::pair(viewer, place),
                 Wrong{.what = what, .since = world_.now(), .is_fresh = is_fresh, .is_complained = false});
}

void Ledger::compare_all(const Topic& topic, const Place& place) {
  const auto found = viewers_.find(topic);
  if (found == viewers_.end()) return;
  for (const Viewer& viewer : found->second) compare(viewer, eyes_.at(viewer), place);
}

/// A view has become right, or wrong in another way: how long it took.
void Ledger::resolve(const Eye& eye, const Place& place, const Wrong& wrong) {
  const auto thing = things_.find(place);
  if (thing == things_.end() || eye.host == place.host) return;
  const base::Duration took = world_.now() - wrong.since;
  if (wrong.what == Wrongness::missing) {
    if (thing->second.has_ended) {
      never_told_ += took > bounds_.missing ? 1 : 0;
    } else if (judge(eye, place) == Wrongness::none) {
      (thing->second.is_change && wrong.is_fresh ? delays_.told : delays_.joined).push_back(took);
    }
  } else if (wrong.is_fresh && thing->second.has_ended) {
    (thing->second.why == End::crashed ? delays_.crashed : delays_.withdrawn).push_back(took);
  }
}

void Ledger::check() {
  forget_old();
  for (auto& [where, wrong] : wrong_) {
    if (wrong.is_complained) continue;
    const bool is_missing = wrong.what == Wrongness::missing;
    base::Instant since =
        std::max({wrong.since, excused_until_, is_missing ? missing_excused_until_ : world_.old_words_read});
    // A host that joins us may have heard later than we of one that we lose, and is a witness of it.
    if (!is_missing) since = std::max(since, reach_changed_);
    // Whoever does not hear the victim believes the liar for as long as he goes on, also as a witness.
    if (!is_missing) since = std::max(since, tampered_until_);
    if (world_.now() - since <= (is_missing ? bounds_.missing : bounds_.surplus)) continue;
    wrong.is_complained = true;
    world_.complain(describe(where.first, where.second, wrong) + " for too long,");
  }
}

/// Whether an entry has ended long ago, and is in nobody's view.
void Ledger::forget_old() {
  std::size_t old = 0;
  for (; old < ended_.size() && ended_[old].first + memory < world_.now(); ++old) {
    const Place& place = ended_[old].second;
    const auto thing = things_.find(place);
    if (thing == things_.end() || !thing->second.has_ended || thing->second.ended != ended_[old].first) continue;
    const auto viewers = viewers_.find(thing->second.topic);
    if (viewers != viewers_.end()) {
      for (const Viewer& viewer : viewers->second) {
        Eye& eye = eyes_.at(viewer);
        const auto seen = eye.seen.find(place);
        if (seen != eye.seen.end() && seen->second.words == 0) eye.seen.erase(seen);
      }
    }
    things_.erase(thing);
  }
  ended_.erase(ended_.begin(), ended_.begin() + static_cast<std::ptrdiff_t>(old));
}

std::string Ledger::describe(const Viewer& viewer, const Place& place, const Wrong& wrong) const {
  const Eye& eye = eyes_.at(viewer);
  const std::string word = wrong.what == Wrongness::missing ? "missing: " : "surplus: ";
  return word + eye.name + (wrong.what == Wrongness::missing ? " misses " : " has surplus ") + eye.topic.text + " of " +
         to_string(place);
}

std::string Ledger::complaints() const {
  std::string text;
  for (const auto& [where, wrong] : wrong_) text += describe(where.first, where.second, wrong) + "\n";
  return text;
}

}  // namespace geminga::sim
