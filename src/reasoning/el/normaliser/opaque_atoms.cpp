// Expressions without rules, interned by kind, count and operands.
#include "reasoning/el/normaliser/opaque_atoms.hpp"

#include <algorithm>
#include <span>

#include "base/hash.hpp"

namespace geminga::el {

ExprId OpaqueAtoms::find(owl::TermKind kind, std::uint32_t count, std::vector<std::uint32_t> key) {
  key.push_back(count);
  key.push_back(static_cast<std::uint32_t>(kind));
  const auto key_of = [&](std::uint32_t entry) {
    return std::span(keys_).subspan(spans_[entry].first, spans_[entry].second);
  };
  const std::uint64_t hash = base::hash64(base::octets_of(std::span(key)));
  const std::uint32_t found =
      table_.find(hash, [&](std::uint32_t entry) { return std::ranges::equal(key_of(entry), key); });
  if (found != base::NumberTable::none) return atoms_[found];
  const auto entry = static_cast<std::uint32_t>(atoms_.size());
  spans_.emplace_back(static_cast<std::uint32_t>(keys_.size()), static_cast<std::uint32_t>(key.size()));
  keys_.insert(keys_.end(), key.begin(), key.end());
  atoms_.push_back(index_.add_atom());
  table_.insert(hash, entry);
  return atoms_.back();
}

}  // namespace geminga::el
