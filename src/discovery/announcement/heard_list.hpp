// The list of how lately many participants were heard, two bits for each, as it stands in a datagram.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_HEARD_LIST_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_HEARD_LIST_HPP

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace geminga::announcement {

/// The age of the last sign of life of a participant, in shares of the interval that it announces.
enum class HeardWithin : std::uint8_t {
  longer,    ///< not within one interval
  interval,  ///< within one
  half,      ///< within half of one
  quarter,   ///< within a quarter of one
};

/// A list of these, four in an octet, so that testimony about a thousand participants is copied and not unpacked.
class HeardList {
 public:
  static constexpr std::size_t per_octet = 4;

  class const_iterator {
   public:
    using value_type = HeardWithin;
    using difference_type = std::ptrdiff_t;
    using pointer = const HeardWithin*;
    using reference = HeardWithin;
    using iterator_category = std::input_iterator_tag;
    const_iterator() = default;
    const_iterator(const HeardList& list, std::size_t at) : list_(&list), at_(at) {}
    HeardWithin operator*() const { return (*list_)[at_]; }
    const_iterator& operator++() {
      ++at_;
      return *this;
    }
    const_iterator operator++(int) { return {*list_, at_++}; }
    friend bool operator==(const const_iterator&, const const_iterator&) = default;

   private:
    const HeardList* list_ = nullptr;
    std::size_t at_ = 0;
  };
  using value_type = HeardWithin;
  using iterator = const_iterator;

  HeardList() = default;
  HeardList(std::initializer_list<HeardWithin> list) {
    for (const auto one : list) push_back(one);
  }
  HeardList(const std::vector<HeardWithin>& list) {  // NOLINT(google-explicit-constructor): one is the other
    for (const auto one : list) push_back(one);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] HeardWithin operator[](std::size_t i) const {
    return static_cast<HeardWithin>((octets_[i / per_octet] >> shift_of(i)) & 3);
  }
  [[nodiscard]] const_iterator begin() const { return {*this, 0}; }
  [[nodiscard]] const_iterator end() const { return {*this, size_}; }
  /// The first is in the lowest bits of the first octet; the rest of the last octet is `longer`.
  [[nodiscard]] std::span<const std::uint8_t> octets() const { return octets_; }

  void reserve(std::size_t size) { octets_.reserve((size + per_octet - 1) / per_octet); }
  void clear() {
    octets_.clear();
    size_ = 0;
  }
  void push_back(HeardWithin one) {
    if (size_ % per_octet == 0) octets_.push_back(0);
    octets_.back() = static_cast<std::uint8_t>(octets_.back() | std::to_underlying(one) << shift_of(size_));
    ++size_;
  }
  void assign(std::size_t count, HeardWithin one) {
    clear();
    for (std::size_t i = 0; i < count; ++i) push_back(one);
  }
  void assign_octets(std::span<const std::uint8_t> octets) {
    octets_.assign(octets.begin(), octets.end());
    size_ = octets_.size() * per_octet;
  }
  friend bool operator==(const HeardList&, const HeardList&) = default;

 private:
  static unsigned shift_of(std::size_t i) { return static_cast<unsigned>(i % per_octet * 2); }

  std::vector<std::uint8_t> octets_;
  std::size_t size_ = 0;
};

}  // namespace geminga::announcement

#endif
