// The part of a record that others tell: relays that lead to the participant, and witnesses that have heard it.
#include <algorithm>
#include <utility>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/neighbour/neighbour_record.hpp"

namespace geminga::membership {

using base::Duration;
using base::Instant;

bool NeighbourRecord::is_heard_directly(Instant now) const {
  return heard_directly_ && now - *heard_directly_ < announcement::hold_intervals * lasting_interval(now);
}

void NeighbourRecord::take_passage(const Passage& passage, Instant now) {
  // A longer way counts when the shorter one is no longer used.
  const bool is_in_use = passage_ && now - passed_ < announcement::hold_intervals * passage_->interval;
  if (is_in_use && passage.hops > passage_->hops) return;
  const bool is_same = passage_ && passage_->through.back() == passage.through.back() && passage_->hops == passage.hops;
  const auto former = std::exchange(passage_, passage);
  passed_ = now;
  if (!is_same || passage.through.size() >= former->through.size()) return;
  // Testimony names the last relay alone. The others are those of the last word.
  passage_->through = former->through;
  passage_->delay = former->delay - former->interval + passage.interval;
}

Duration NeighbourRecord::delay(Duration interval) const {
  if (!passage_) return Duration(0);
  const std::size_t unknown = passage_->hops - std::min(passage_->hops, passage_->through.size());
  return passage_->delay + static_cast<Duration::rep>(unknown) * std::max(interval, passage_->interval);
}

void NeighbourRecord::hear_of(const Passage& passage, std::uint64_t revision, Instant now) {
  if (is_contested_ || is_heard_directly(now)) return;
  take_passage(passage, now);
  for (auto& way : ways_.all()) {
    if (way.is_relayed()) way.set_loss(passage.loss);
  }
  if (revision > revision_) suspect();
  const auto seen = now - passage.age;
  const auto succeeded = signs_.succeeded();
  if (seen <= signs_.heard() || (succeeded && seen <= *succeeded)) return;
  standing_.hear(now);
  signs_.hear(seen);
  signs_.renew(lasting_interval(now), reception(now));
  if (is_complete_ && revision == revision_) affirmed_ = seen;
  for (auto& way : ways_.all()) way.deadline = std::max(way.deadline, signs_.deadline());
}

Reach NeighbourRecord::reach() const {
  return {.id = id_,
          .revision = held_revision(),
          .heard = is_contested_ ? signs_.heard() : std::max(signs_.heard(), witnesses_.seen(id_)),
          .interval = interval(),
          .loss = ways_.loss(),
          .hops = passage_ ? passage_->hops : 0,
          .beyond = passage_ ? passage_->interface : env::InterfaceIndex{},
          .ways = ways_.all(),
          .reachability = reachability_};
}

void NeighbourRecord::judge_reach(const JudgeReach& judge, std::vector<Change>& changes) {
  if (ways_.all().empty()) return;  // Without a way nothing is known that is new.
  const std::string& address = services_.owner().address;
  const bool is_afar = passage_ || std::ranges::all_of(ways_.all(), &NeighbourWay::is_heard_alone);
  const bool is_judged = is_afar && !address.empty();
  const auto reachability = is_judged ? judge(address, observed_address(reach())) : Reachability::reachable;
  if (reachability == reachability_) return;
  reachability_ = reachability;
  services_.set_reachable(reachability == Reachability::reachable);
  services_.tell(moment(signs_.heard(), false), changes);
}

void NeighbourRecord::ask_witnesses(Instant now) {
  // For a contested participant only its own datagrams count. Without a way we may not reach it, though others do.
  if (is_contested_ || ways_.all().empty()) return;
  if (!signs_.witness(witnesses_.seen(id_), now, lasting_interval(now), reception(now))) return;
  // The way on which it was heard last is the best guess of how it can be reached.
  const auto last = std::ranges::max_element(ways_.all(), {}, &NeighbourWay::heard);
  if (last != ways_.all().end()) last->deadline = std::max(last->deadline, signs_.deadline());
}

}  // namespace geminga::membership
