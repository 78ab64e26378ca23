// The stack of blockers with its table.
#include "reasoning/dl/hypertableau/graph/blockers.hpp"

namespace geminga::hypertableau {

void Blockers::push(NodeId node, std::uint64_t key) {
  if (entries_.size() >= heads_.size()) grow();
  std::uint32_t& head = heads_[slot_of(key)];
  entries_.push_back({key, node, head});
  head = static_cast<std::uint32_t>(entries_.size() - 1);
}

void Blockers::cut(NodeId first) {
  while (!entries_.empty() && entries_.back().node >= first) {
    heads_[slot_of(entries_.back().key)] = entries_.back().older;
    entries_.pop_back();
  }
}

void Blockers::grow() {
  heads_.assign(heads_.empty() ? 256 : heads_.size() * 2, none);
  for (std::uint32_t at = 0; at < entries_.size(); ++at) {
    std::uint32_t& head = heads_[slot_of(entries_[at].key)];
    entries_[at].older = head;
    head = at;
  }
}

}  // namespace geminga::hypertableau
