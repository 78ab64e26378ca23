#include "discovery/membership/records.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geminga::membership {

std::size_t Records::index_of(ParticipantId id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(ids_, id) - ids_.begin());
}

Records::iterator Records::find(ParticipantId id) {
  const auto index = index_of(id);
  return index < ids_.size() && ids_[index] == id ? found_[index] : map_.end();
}

const NeighbourRecord* Records::record(ParticipantId id) const {
  const auto index = index_of(id);
  return index < ids_.size() && ids_[index] == id ? found_[index]->second.record.get() : nullptr;
}

Records::iterator Records::add(ParticipantId id, Known known) {
  const auto one = map_.emplace(id, std::move(known)).first;
  const auto index = static_cast<std::ptrdiff_t>(index_of(id));
  ids_.insert(ids_.begin() + index, id);
  found_.insert(found_.begin() + index, one);
  ++roster_;
  return one;
}

void Records::erase(iterator one) {
  heard_ -= one->second.heard;
  span_ -= one->second.span;
  const auto index = static_cast<std::ptrdiff_t>(index_of(one->first));
  ids_.erase(ids_.begin() + index);
  found_.erase(found_.begin() + index);
  map_.erase(one);
  ++roster_;
}

void Records::count(Known& known) {
  int heard = 0;
  int span = 0;
  for (const auto& way : known.record->ways().all()) {
    if (way.is_relayed()) {  // A relay has said the loss, and counts as much as a full window.
      heard += static_cast<int>(std::lround(LossWindow::full_span * (1 - way.loss())));
      span += LossWindow::full_span;
      continue;
    }
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
