#include "discovery/membership/lacks_and_doubts.hpp"

#include <algorithm>
#include <ranges>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

/// The places of `lacks` that are for strangers.
constexpr std::size_t stranger_places = 4;

void keep(std::set<ParticipantId>& set, ParticipantId id, bool is_in) {
  if (is_in) {
    set.insert(id);
  } else if (!set.empty()) {
    set.erase(id);
  }
}

}  // namespace

void LacksAndDoubts::update(ParticipantId id, const NeighbourRecord& record, base::Instant now) {
  keep(missed_, id, record.is_missed(now));
  keep(doubted_, id, record.signs().is_doubted());
  keep(named_, id, record.is_lacking() || record.signs().is_doubted());
}

void LacksAndDoubts::forget(ParticipantId id) {
  missed_.erase(id);
  doubted_.erase(id);
  named_.erase(id);
}

void LacksAndDoubts::name(Records& records, base::Instant now, Report& report) {
  strangers_.prune(now);
  for (const auto& stranger : strangers_.all() | std::views::reverse | std::views::take(stranger_places)) {
    report.lacks.push_back(stranger.id);
  }
  auto one = named_.lower_bound(next_);
  for (std::size_t visited = 0; visited < named_.size(); ++visited, ++one) {
    if (one == named_.end()) one = named_.begin();
    auto& record = *records.find(*one)->second.record;
    if (std::max(report.lacks.size(), report.doubts.size()) == announcement::max_named) {
      next_ = *one;
      return;
    }
    if (record.is_lacking()) report.lacks.push_back(*one);
    if (record.signs().is_doubted()) {
      report.doubts.push_back(*one);
      record.ask(now);
    }
  }
}

}  // namespace geminga::membership
