#include "discovery/membership/greediest.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

std::size_t beyond_reserve(const NeighbourRecord& record) {
  return record.services().size() - std::min(record.services().size(), announcement::reserved_services);
}

}  // namespace

NeighbourRecord* find_greediest(Records& records, const Admission& admission, const NeighbourRecord& asks) {
  std::map<std::string_view, std::size_t> shares;
  for (const auto& [id, known] : records) shares[known.record->origin().source] += beyond_reserve(*known.record);
  const auto& source = asks.origin().source;
  const auto own = beyond_reserve(asks);
  const bool asks_seasoned = admission.is_seasoned(asks.origin().id);
  std::tuple<bool, bool, std::size_t, std::size_t> most{};
  NeighbourRecord* greediest = nullptr;
  for (auto& [id, known] : records) {
    const auto count = beyond_reserve(*known.record);
    const bool is_seasoned = admission.is_seasoned(id);
    const bool is_same = known.record->origin().source == source;
    const auto share = shares[known.record->origin().source];
    if (count == 0 || (is_seasoned && !asks_seasoned)) continue;
    if (is_same ? count <= own + 1 : share <= shares[source] + 1) continue;
    const std::tuple order{!is_seasoned, !is_same, share, count};
    if (greediest != nullptr && order <= most) continue;
    most = order;
    greediest = known.record.get();
  }
  return greediest;
}

}  // namespace geminga::membership
