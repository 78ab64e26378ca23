#include "discovery/membership/records.hpp"

#include <algorithm>
#include <utility>

namespace geminga::membership {

std::size_t Records::place_of(ParticipantId id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(ids_, id) - ids_.begin());
}

Records::iterator Records::find(ParticipantId id) {
  const auto place = place_of(id);
  return place < ids_.size() && ids_[place] == id ? found_[place] : map_.end();
}

const NeighbourRecord* Records::record(ParticipantId id) const {
  const auto place = place_of(id);
  return place < ids_.size() && ids_[place] == id ? found_[place]->second.record.get() : nullptr;
}

Records::iterator Records::add(ParticipantId id, Known known) {
  const auto one = map_.emplace(id, std::move(known)).first;
  const auto place = static_cast<std::ptrdiff_t>(place_of(id));
  ids_.insert(ids_.begin() + place, id);
  found_.insert(found_.begin() + place, one);
  return one;
}

void Records::erase(iterator one) {
  heard_ -= one->second.heard;
  span_ -= one->second.span;
  const auto place = static_cast<std::ptrdiff_t>(place_of(one->first));
  ids_.erase(ids_.begin() + place);
  found_.erase(found_.begin() + place);
  map_.erase(one);
}

void Records::count(Known& known) {
  int heard = 0;
  int span = 0;
  for (const auto& way : known.record->ways()) {
    heard += way.losses().heard();
    span += way.losses().span();
  }
  heard_ += heard - std::exchange(known.heard, heard);
  span_ += span - std::exchange(known.span, span);
}

std::optional<double> Records::loss() const {
  if (span_ < LossWindow::least_span) return std::nullopt;
  return 1 - static_cast<double>(heard_) / static_cast<double>(span_);
}

}  // namespace geminga::membership
