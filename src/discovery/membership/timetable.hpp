// The timetable of all participants: when something is to be done for which of them.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_TIMETABLE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_TIMETABLE_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/time.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// An entry of a timetable, until it is given back.
enum class Slot : std::uint32_t {};

/// Nearly every datagram moves a deadline to later, which costs one word: an entry in the heap is no later than the
/// deadline that holds, and is corrected when it comes to the top.
class Timetable {
 public:
  [[nodiscard]] Slot take(ParticipantId id) {
    if (free_.empty()) {
      free_.push_back(Slot(dues_.size()));
      dues_.emplace_back();
    }
    const auto slot = free_.back();
    free_.pop_back();
    at(slot).id = id;
    return slot;
  }
  void give(Slot slot) {
    at(slot) = {};
    free_.push_back(slot);
    settle();
  }

  void set(Slot slot, base::Instant due) {
    auto& known = at(slot);
    known.due = due;
    if (due < known.listed) list(slot);
    settle();
  }
  /// The earliest time; base::never: none is set.
  [[nodiscard]] base::Instant next() const { return heap_.empty() ? base::never : heap_.front().due; }
  /// The participants for which something is due at `now` or before, in ascending order.
  [[nodiscard]] std::vector<ParticipantId> due(base::Instant now) const {
    std::vector<ParticipantId> ids;
    if (next() > now) return ids;
    for (const auto& one : dues_) {
      if (one.due <= now) ids.push_back(one.id);
    }
    std::ranges::sort(ids);
    return ids;
  }
  /// Entries of the heap, stale ones included.
  [[nodiscard]] std::size_t entries() const { return heap_.size(); }

 private:
  struct Due {
    ParticipantId id{};
    base::Instant due = base::never;
    base::Instant listed = base::never;  ///< the entry in the heap that counts; no later than `due`
  };
  struct Entry {
    base::Instant due;
    Slot slot{};
    friend bool operator>(const Entry& left, const Entry& right) { return left.due > right.due; }
  };

  static constexpr std::size_t most_entries = 4;  ///< for each slot

  [[nodiscard]] Due& at(Slot slot) { return dues_[static_cast<std::size_t>(slot)]; }

  void list(Slot slot) {
    if (heap_.size() >= most_entries * dues_.size()) drop_stale();
    at(slot).listed = at(slot).due;
    heap_.push_back({at(slot).due, slot});
    std::ranges::push_heap(heap_, std::greater<>());
  }
  /// Deadlines that come nearer again and again leave stale entries.
  void drop_stale() {
    std::erase_if(heap_, [this](const Entry& entry) { return at(entry.slot).listed != entry.due; });
    std::ranges::make_heap(heap_, std::greater<>());
  }
  /// Corrects the heap until its first entry holds. Each stale entry is listed again once at most.
  void settle() {
    while (!heap_.empty()) {
      const auto first = heap_.front();
      auto& known = at(first.slot);
      const bool counts = known.listed == first.due;
      if (counts && known.due == first.due) return;
      std::ranges::pop_heap(heap_, std::greater<>());
      heap_.pop_back();
      if (!counts) continue;
      known.listed = base::never;
      if (known.due != base::never) list(first.slot);
    }
  }

  std::vector<Due> dues_;
  std::vector<Slot> free_;
  std::vector<Entry> heap_;
};

}  // namespace geminga::membership

#endif
