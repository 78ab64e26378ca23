// Values that several owners in one process know, each kept once.
#ifndef GEMINGA_BASE_SHARED_VALUES_HPP
#define GEMINGA_BASE_SHARED_VALUES_HPP

#include <cstddef>
#include <map>
#include <memory>
#include <utility>

namespace geminga::base {

/// Gives equal values of one key as one. For a thousand simulated hosts that all know the same things. It keeps no
/// value alive. Not thread-safe.
template <typename Key, typename Value>
class SharedValues {
 public:
  /// The last value of this key where `is_same` holds for it and somebody still has it; otherwise what `make` gives.
  /// O(log n).
  template <typename Is, typename Make>
  [[nodiscard]] std::shared_ptr<const Value> share(const Key& key, const Is& is_same, const Make& make) {
    std::weak_ptr<const Value>& last = last_[key];
    std::shared_ptr<const Value> value = last.lock();
    if (value == nullptr || !is_same(*value)) {
      value = std::make_shared<const Value>(make());
      last = value;
    }
    if (last_.size() > 2 * alive_ + least_sweep) sweep();
    return value;
  }
  /// Keys that are remembered; some of their values may be gone.
  [[nodiscard]] std::size_t size() const { return last_.size(); }

 private:
  static constexpr std::size_t least_sweep = 1024;

  void sweep() {
    std::erase_if(last_, [](const auto& one) { return one.second.expired(); });
    alive_ = last_.size();
  }

  std::map<Key, std::weak_ptr<const Value>> last_;
  std::size_t alive_ = 0;  ///< so many were left by the last sweep
};

}  // namespace geminga::base

#endif
