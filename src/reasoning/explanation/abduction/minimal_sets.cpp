#include "reasoning/explanation/abduction/minimal_sets.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <tuple>

namespace geminga::abduction {
namespace {

class TreeSearch {
 public:
  TreeSearch(const SearchSpace& space, const std::function<bool(Members)>& holds) : space_(space), ask_(holds) {}

  std::vector<Members> run(std::size_t most) {
    std::vector<Members> found;
    push(space_.begin);
    while (!open_.empty() && found.size() < most) {
      const Members members = std::get<2>(*open_.begin());
      open_.erase(open_.begin());
      if (std::ranges::any_of(found, [&](Members known) { return (known & members) == known; })) continue;
      if (holds(members)) {
        found.push_back(members);
        continue;
      }
      const Members failed = enlarged(members);
      for (const std::size_t member : numbers_of(space_.all & ~failed)) push(members | space_.with[member]);
    }
    return found;
  }

 private:
  void push(Members members) {
    if (seen_.insert(members).second) open_.emplace(space_.size(members), std::popcount(members), members);
  }

  bool holds(Members members) {
    const auto at = known_.find(members);
    if (at != known_.end()) return at->second;
    return known_.emplace(members, ask_(members)).first->second;
  }

  /// A set for which it does not hold, and to which nothing can be added without that it holds.
  Members enlarged(Members members) {
    const std::vector<std::size_t> others = numbers_of(space_.all & ~members);
    enlarge(members, others);
    return members;
  }

  void enlarge(Members& members, std::span<const std::size_t> others) {
    Members more = members;
    for (const std::size_t other : others) more |= space_.with[other];
    if (more == members) return;
    if (!holds(more)) {
      members = more;
      return;
    }
    if (others.size() == 1) return;
    enlarge(members, others.first(others.size() / 2));
    enlarge(members, others.subspan(others.size() / 2));
  }

  const SearchSpace& space_;
  const std::function<bool(Members)>& ask_;
  std::map<Members, bool> known_;
  std::set<Members> seen_;
  std::set<std::tuple<std::size_t, int, Members>> open_;
};

}  // namespace

std::vector<std::size_t> numbers_of(Members members) {
  std::vector<std::size_t> numbers;
  for (; members != 0; members &= members - 1) numbers.push_back(static_cast<std::size_t>(std::countr_zero(members)));
  return numbers;
}

std::vector<Members> minimal_sets(const SearchSpace& space, const std::function<bool(Members)>& holds,
                                  std::size_t most) {
  return TreeSearch(space, holds).run(most);
}

}  // namespace geminga::abduction
