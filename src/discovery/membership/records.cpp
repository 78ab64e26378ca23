#include "discovery/membership/records.hpp"

namespace geminga::membership {

std::optional<double> loss_of(const Records& records) {
  int heard = 0;
  int span = 0;
  for (const auto& [id, known] : records) {
    for (const auto& way : known.record->ways()) {
      heard += way.losses().heard();
      span += way.losses().span();
    }
  }
  if (span < LossWindow::least_span) return std::nullopt;
  return 1 - static_cast<double>(heard) / static_cast<double>(span);
}

}  // namespace geminga::membership
