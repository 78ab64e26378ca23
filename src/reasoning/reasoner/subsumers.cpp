#include "reasoning/reasoner/subsumers.hpp"

#include <algorithm>
#include <iterator>

namespace geminga::reasoner {
namespace {

bool contains(const ClassNumbers& sorted, std::uint32_t wanted) { return std::ranges::binary_search(sorted, wanted); }

void insert(ClassNumbers& sorted, std::uint32_t added) {
  const auto place = std::ranges::lower_bound(sorted, added);
  if (place == sorted.end() || *place != added) sorted.insert(place, added);
}

}  // namespace

Subsumers::Subsumers(const taxonomy::Classification& classification)
    : classification_(classification),
      top_(representative(static_cast<std::uint32_t>(classification.thing))),
      bottom_(representative(static_cast<std::uint32_t>(classification.nothing))),
      known_(find_ancestors(classification)),
      possible_(known_.size()),
      is_empty_(known_.size(), false) {}

bool Subsumers::is_closed(std::uint32_t of) const {
  return is_empty_[of] || (possible_[of] && possible_[of]->size() <= known_[of].size() + 1);
}

bool Subsumers::is_open(std::uint32_t of, std::uint32_t above) const {
  return above != of && !is_empty_[above] && contains(*possible_[of], above) && !contains(known_[of], above) &&
         !contains(known_[top_], above);
}

ClassNumbers Subsumers::open_above(std::uint32_t of) const {
  ClassNumbers open;
  if (!possible_[of] || is_empty_[of]) return open;
  std::ranges::copy_if(*possible_[of], std::back_inserter(open),
                       [&](std::uint32_t above) { return is_open(of, above); });
  std::ranges::stable_sort(open, [&](std::uint32_t a, std::uint32_t b) { return known_[a].size() > known_[b].size(); });
  return open;
}

ClassNumbers Subsumers::lowest_first() const {
  ClassNumbers order;
  for (std::uint32_t of = 0; of < known_.size(); ++of) {
    if (is_asked(of)) order.push_back(of);
  }
  std::ranges::stable_sort(order,
                           [&](std::uint32_t a, std::uint32_t b) { return known_[a].size() > known_[b].size(); });
  return order;
}

void Subsumers::learn(const ClassNumbers& label) {
  narrow(top_, label, known_[top_].size());
  for (const std::uint32_t of : label) narrow(of, label, known_[of].size() + 1);
}

void Subsumers::learn_plain(std::uint32_t of) {
  ClassNumbers label = known_[of];
  insert(label, of);
  learn(label);
}

/// Bounds the possible subsumers of a class by a label, unless no more than the `closed` known ones, itself included,
/// are possible.
void Subsumers::narrow(std::uint32_t of, const ClassNumbers& label, std::size_t closed) {
  if (!possible_[of]) {
    possible_[of] = label;
  } else if (possible_[of]->size() > closed) {
    std::erase_if(*possible_[of], [&](std::uint32_t above) { return !contains(label, above); });
  }
}

void Subsumers::add(std::uint32_t sub, std::uint32_t super) {
  found_.emplace_back(sub, super);
  insert(known_[sub], super);
  const ClassNumbers above = known_[super];
  for (const std::uint32_t higher : above) {
    if (higher != sub) insert(known_[sub], higher);
  }
}

void Subsumers::set_empty(std::uint32_t of) {
  is_empty_[of] = true;
  found_.emplace_back(of, static_cast<std::uint32_t>(classification_.nothing));
}

void Subsumers::inherit(std::uint32_t of) {
  if (found_.empty()) return;
  const ClassNumbers direct = known_[of];
  for (const std::uint32_t above : direct) {
    for (const std::uint32_t higher : known_[above]) {
      if (higher != of) insert(known_[of], higher);
    }
  }
}

}  // namespace geminga::reasoner
