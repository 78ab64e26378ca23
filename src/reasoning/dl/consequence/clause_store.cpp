#include "reasoning/dl/consequence/clause_store.hpp"

#include <algorithm>

namespace geminga::consequence {
namespace {

/// A bit for each literal. Most sets that are not part of another are recognised by it, without a look at their
/// members.
[[nodiscard]] std::uint64_t signature_of(std::span<const Literal> literals) {
  std::uint64_t signature = 0;
  for (const Literal literal : literals) signature |= std::uint64_t{1} << (hash_of(literal) & 63);
  return signature;
}

[[nodiscard]] bool is_subset(std::span<const Literal> part, std::span<const Literal> whole, auto compare) {
  return part.size() <= whole.size() && std::ranges::includes(whole, part, compare);
}

}  // namespace

void ClauseStore::grow() {
  Pooled<Slot> old(slots_.empty() ? 32 : slots_.size() * 2);
  old.swap(slots_);
  const std::size_t mask = slots_.size() - 1;
  for (const Slot& slot : old) {
    if (slot.key == no_literal) continue;
    std::size_t at = static_cast<std::size_t>(hash_of(slot.key)) & mask;
    while (slots_[at].key != no_literal) at = (at + 1) & mask;
    slots_[at] = slot;
  }
}

ClauseStore::Slot& ClauseStore::slot_of(Literal key) {
  if ((used_slots_ + 1) * 4 > slots_.size() * 3) grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = static_cast<std::size_t>(hash_of(key)) & mask;
  while (slots_[at].key != key && slots_[at].key != no_literal) at = (at + 1) & mask;
  if (slots_[at].key == no_literal) {
    slots_[at].key = key;
    ++used_slots_;
  }
  return slots_[at];
}

ClauseStore::Lists& ClauseStore::lists_of(Literal literal) {
  Slot& slot = slot_of(literal);
  if (slot.lists == 0) {
    lists_.emplace_back();
    slot.lists = static_cast<std::uint32_t>(lists_.size());
  }
  return lists_[slot.lists - 1];
}

bool ClauseStore::insert_unit(Literal literal) {
  Slot& slot = slot_of(literal);
  if ((slot.flags & unit) != 0) return false;
  slot.flags |= unit;
  if (slot.lists == 0) return true;
  Lists& filed = lists_[slot.lists - 1];
  for (auto* list : {&filed.maximal, &filed.others}) {
    for (const ClauseNumber clause : *list) clauses_[clause].state = State::redundant;
    list->clear();
  }
  return true;
}

bool ClauseStore::is_part(const Record& record, std::uint64_t body_signature, std::uint64_t head_signature,
                          std::span<const Literal> body, std::span<const Literal> head) const {
  if ((record.body_signature & ~body_signature) != 0 || (record.head_signature & ~head_signature) != 0) return false;
  const auto first = std::span(literals_).subspan(record.begin);
  return is_subset(first.first(record.body), body, std::less<>()) &&
         is_subset(first.subspan(record.body, record.head), head, std::greater<>());
}

bool ClauseStore::is_redundant(std::span<const Literal> body, std::span<const Literal> head) const {
  const std::uint64_t body_signature = signature_of(body);
  const std::uint64_t head_signature = signature_of(head);
  const auto implies = [&](ClauseNumber number) {
    ++compared_;
    const Record& record = clauses_[number];
    return record.state != State::redundant && is_part(record, body_signature, head_signature, body, head);
  };
  if (std::ranges::any_of(headless_, implies)) return true;
  return std::ranges::any_of(head, [&](Literal literal) {
    const Lists* const filed = lists(literal);
    return filed != nullptr && std::ranges::any_of(filed->maximal, implies);
  });
}

ClauseNumber ClauseStore::insert(std::span<const Literal> body, std::span<const Literal> head, std::size_t maximal) {
  const auto number = static_cast<ClauseNumber>(clauses_.size());
  clauses_.push_back({static_cast<std::uint32_t>(literals_.size()), static_cast<std::uint16_t>(body.size()),
                      static_cast<std::uint16_t>(head.size()), State::waiting, signature_of(body), signature_of(head)});
  literals_.insert(literals_.end(), body.begin(), body.end());
  literals_.insert(literals_.end(), head.begin(), head.end());
  drop_implied(number);
  for (std::size_t at = 0; at < head.size(); ++at) {
    Lists& filed = lists_of(head[at]);
    (at < maximal ? filed.maximal : filed.others).push_back(number);
  }
  if (head.empty()) headless_.push_back(number);
  for (const Literal literal : body) lists_of(in_body(literal)).others.push_back(number);
  return number;
}

void ClauseStore::drop_implied(ClauseNumber clause) {
  const Record by = clauses_[clause];
  const auto size_of = [this](Literal literal) {
    const Lists* const filed = lists(literal);
    return filed == nullptr ? 0 : filed->maximal.size() + filed->others.size();
  };
  if (by.head == 0) {
    if (by.body == 0) return;
    const Lists* const filed = lists(in_body(
        *std::ranges::min_element(body(clause), {}, [&](Literal literal) { return size_of(in_body(literal)); })));
    if (filed != nullptr) drop_implied(by, filed->others);
    return;
  }
  const Lists* const filed = lists(*std::ranges::min_element(head(clause), {}, size_of));
  if (filed == nullptr) return;
  drop_implied(by, filed->maximal);
  drop_implied(by, filed->others);
}

void ClauseStore::drop_implied(const Record& by, const Pooled<std::uint32_t>& candidates) {
  compared_ += candidates.size();
  for (const ClauseNumber candidate : candidates) {
    Record& record = clauses_[candidate];
    if (record.state == State::redundant) continue;
    if (is_part(by, record.body_signature, record.head_signature, body(candidate), head(candidate))) {
      record.state = State::redundant;
    }
  }
}

bool ClauseStore::has_alternatives() const {
  return std::ranges::any_of(clauses_,
                             [](const Record& record) { return record.head > 1 && record.state != State::redundant; });
}

bool ClauseStore::count_alternative(std::uint32_t most) {
  if (is_cut_) return false;
  if (++alternatives_ <= most) return true;
  cut();
  return false;
}

bool ClauseStore::count_match(std::size_t most) {
  if (++matches_ <= most) return true;
  if (!is_cut_) cut();
  return false;
}

void ClauseStore::cut() {
  is_cut_ = true;
  for (Record& record : clauses_) {
    if (record.head > 1) record.state = State::redundant;
  }
}

void ClauseStore::clear() { *this = {}; }

}  // namespace geminga::consequence
