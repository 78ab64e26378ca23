#include "reasoning/dl/consequence/context_table.hpp"

#include <mutex>

namespace geminga::consequence {

ContextTable::ContextTable(const Rules& rules, std::span<const std::uint32_t> wanted)
    : is_wanted_(rules.vocabulary().predicate_count) {
  for (const std::uint32_t predicate : wanted) is_wanted_[predicate] = true;
}

std::uint64_t ContextTable::hash_of(const ContextKey& key) {
  std::uint64_t hash = (key.function * std::uint64_t{2} + (key.is_value ? 1 : 0)) * 0x9e3779b97f4a7c15ULL;
  for (const Literal literal : key.core) {
    hash = (hash ^ consequence::hash_of(literal)) * 0xff51afd7ed558ccdULL;
  }
  return hash ^ (hash >> 33);
}

void ContextTable::Part::grow() {
  slots.assign(slots.empty() ? 16 : slots.size() * 2, 0);
  for (std::uint32_t position = 1; position <= contexts.size(); ++position) {
    std::size_t at = (hash_of(contexts[position - 1]->key) / parts) & (slots.size() - 1);
    while (slots[at] != 0) at = (at + 1) & (slots.size() - 1);
    slots[at] = position;
  }
}

std::size_t ContextTable::Part::slot_of(const ContextKey& key, std::uint64_t hash) const {
  std::size_t at = (hash / parts) & (slots.size() - 1);
  while (slots[at] != 0 && contexts[slots[at] - 1]->key != key) at = (at + 1) & (slots.size() - 1);
  return at;
}

ContextTable::Entry ContextTable::find_or_make(ContextKey&& key) {
  const std::uint64_t hash = hash_of(key);
  Part& part = parts_[hash % parts];
  const std::lock_guard guard(part.lock);
  if ((part.contexts.size() + 1) * 4 > part.slots.size() * 3) part.grow();
  std::uint32_t& position = part.slots[part.slot_of(key, hash)];
  if (position != 0) return {*part.contexts[position - 1], false};
  Context& made = *part.contexts.emplace_back(std::make_unique<Context>());
  position = static_cast<std::uint32_t>(part.contexts.size());
  made.number = static_cast<std::uint32_t>(size_.fetch_add(1, std::memory_order_relaxed));
  made.key = std::move(key);
  made.answers_queries = answers_queries(made.key);
  return {made, true};
}

const Context* ContextTable::find(const ContextKey& key) const {
  const std::uint64_t hash = hash_of(key);
  const Part& part = parts_[hash % parts];
  if (part.slots.empty()) return nullptr;
  const std::uint32_t position = part.slots[part.slot_of(key, hash)];
  return position == 0 ? nullptr : part.contexts[position - 1].get();
}

bool ContextTable::answers_queries(const ContextKey& key) const {
  if (key.function != ContextKey{}.function || key.is_value) return false;
  if (key.core.empty()) return true;
  return key.core.size() == 1 && key.core[0].kind() == LiteralKind::unary && is_wanted_[key.core[0].predicate()];
}

}  // namespace geminga::consequence
