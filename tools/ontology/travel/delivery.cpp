#include "ontology/travel/delivery.hpp"

#include <algorithm>

#include "ontology/travel/limits.hpp"

namespace geminga::ontology {

void Delivery::add(Life consumer) {
  lacking_[consumer] = {.messages = pieces_};
  is_manifest_wanted_ = true;
}

void Delivery::note_left_out() {
  for (auto& [consumer, lacking] : lacking_) lacking.has_gap = true;
}

std::optional<Delivery::Next> Delivery::next() {
  // A round that has ended with a gap is followed by another, also for the sake of a manifest that was left out.
  for (auto& [consumer, lacking] : lacking_) {
    if (lacking.messages > 0 || !lacking.has_gap || lacking.laps == max_laps) continue;
    lacking = {.messages = pieces_, .laps = lacking.laps + 1};
    is_manifest_wanted_ = true;
  }
  if (is_manifest_wanted_) {
    is_manifest_wanted_ = false;
    return Next{};
  }
  if (std::ranges::none_of(lacking_, [](const auto& each) { return each.second.messages > 0; })) return std::nullopt;
  for (auto& [consumer, lacking] : lacking_) {
    if (lacking.messages > 0) --lacking.messages;
  }
  const std::size_t piece = at_;
  at_ = (at_ + 1) % pieces_;
  return Next{piece};
}

bool Delivery::is_repeating() const {
  return std::ranges::none_of(lacking_,
                              [](const auto& each) { return each.second.messages > 0 && each.second.laps == 1; });
}

}  // namespace geminga::ontology
