// The deliveries of a node: its items go to its children, and what they show of its sources goes to these.
#ifndef GEMINGA_REASONING_EL_CLOSURE_NODE_DELIVERIES_HPP
#define GEMINGA_REASONING_EL_CLOSURE_NODE_DELIVERIES_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/el/closure/node.hpp"
#include "reasoning/el/closure/nodes.hpp"
#include "reasoning/el/closure/rules.hpp"

namespace geminga::el {

/// Sends each item once to each child and source. Worker has tell(node, message, items), which sends a message, and
/// count_work(n), which counts n items that were looked at. The legend is in inheritance.hpp.
template <typename Worker>
class NodeDeliveries {
 public:
  NodeDeliveries(SharedNodes& shared, Worker& worker)
      : shared_(shared), index_(shared.index), nodes_(shared.contexts), worker_(worker) {}

  /// Sends what is new to the sources and the children of a node, and everything to those that are new themselves.
  void deliver(std::uint32_t node) {
    tell_sources(node);
    serve_children(node);
    nodes_[node].items_told = nodes_[node].items.size();
    nodes_[node].selfs_told = nodes_[node].selfs.size();
  }

 private:
  using Items = std::span<const std::uint32_t>;
  static constexpr std::uint8_t bit(RuleBits rules) { return static_cast<std::uint8_t>(rules); }

  template <typename IsWanted>
  void gather(const Node& self, std::uint32_t from, IsWanted&& is_wanted, std::vector<std::uint32_t>& gathered) {
    gathered.clear();
    for (std::uint32_t at = from; at < self.items.size(); ++at) {
      if (is_wanted(self.items[at])) gathered.push_back(self.items[at]);
    }
  }

  void tell_sources(std::uint32_t node) {
    Node& self = nodes_[node];
    if (self.sources.empty()) return;
    const auto is_wanted = [&](std::uint32_t item) {
      if (item >= shared_.first_link) return true;
      return item < index_.size() && index_.has_rules(ExprId{item}, RuleBits::existentials);
    };
    if (self.sources_told != 0) gather(self, self.items_told, is_wanted, new_items_);
    if (self.sources_told < self.sources.size()) gather(self, 0, is_wanted, all_items_);
    for (std::uint32_t at = 0; at < self.sources.size() && !shared_.has_ended(); ++at) {
      const bool is_new = at >= self.sources_told;
      tell_source(node, self.sources[at], is_new, is_new ? all_items_ : new_items_);
    }
    self.sources_told = self.sources.size();
  }

  void tell_source(std::uint32_t node, std::uint32_t source, bool is_new, Items items) {
    const Node& self = nodes_[node];
    const RoleId role{nodes_[source].root};
    found_.clear();
    worker_.count_work(items.size());
    for (const std::uint32_t item : items) {
      //  N < D
      //  --------------------- [S some D occurs negatively, R <* S]
      //  R some N < S some D
      if (item < shared_.first_link) {
        for_each_existential(index_, role, ExprId{item},
                             [&](ExprId existential) { found_.push_back(number(existential)); });
        continue;
      }

      //  N < S some M
      //  ------------------------ [R o S SubPropertyOf R']
      //  R some N < R' some M
      const Node& second = nodes_[item - shared_.first_link];
      for (const RoleId result : index_.roles().composed(role, RoleId{second.root})) {
        worker_.tell(source, {NodeMessage::Kind::composed, static_cast<std::uint32_t>(result), second.filler}, {});
      }
    }

    //  N < S Self
    //  ------------------------ [R o S SubPropertyOf R']
    //  R some N < R' some N
    for (std::uint32_t next = is_new ? 0 : self.selfs_told; next < self.selfs.size(); ++next) {
      for (const RoleId result : index_.roles().composed(role, self.selfs[next])) {
        worker_.tell(source, {NodeMessage::Kind::composed, static_cast<std::uint32_t>(result), node}, {});
      }
    }
    if (is_new || !found_.empty())
      worker_.tell(source, {NodeMessage::Kind::found, delivery_of(node, is_new), 0}, found_);
  }

  [[nodiscard]] std::uint32_t delivery_of(std::uint32_t node, bool is_new) const {
    if (!is_new) return further_delivery;
    return nodes_[node].is_final ? first_delivery | final_delivery : first_delivery;
  }

  //  M < X
  //  ----- [N is a child of M, which is N < M]; only items that may be a premise together with another one
  //  N < X
  void serve_children(std::uint32_t node) {
    constexpr std::uint8_t with_others =
        bit(RuleBits::selfs) | bit(RuleBits::conjunctions) | bit(RuleBits::existentials) | bit(RuleBits::disjointness);
    Node& self = nodes_[node];
    if (self.children.empty()) return;
    const auto is_wanted = [&](std::uint32_t item) {
      return item < index_.size() ? (index_.rule_bits(ExprId{item}) & with_others) != 0 : item >= shared_.first_link;
    };
    if (self.children_served != 0 && self.items_told < self.items.size()) {
      gather(self, self.items_told, is_wanted, new_items_);
      for (std::uint32_t at = 0; at < self.children_served && !new_items_.empty() && !shared_.has_ended(); ++at) {
        worker_.tell(self.children[at], {NodeMessage::Kind::inherited, further_delivery, 0}, new_items_);
      }
    }
    if (self.children_served < self.children.size()) {
      gather(self, 0, is_wanted, all_items_);
      for (std::uint32_t at = self.children_served; at < self.children.size() && !shared_.has_ended(); ++at) {
        worker_.tell(self.children[at], {NodeMessage::Kind::inherited, delivery_of(node, true), 0}, all_items_);
      }
    }
    self.children_served = self.children.size();
  }

  SharedNodes& shared_;
  const IndexedOntology& index_;
  NodeStore& nodes_;
  Worker& worker_;
  std::vector<std::uint32_t> all_items_;
  std::vector<std::uint32_t> new_items_;
  std::vector<std::uint32_t> found_;
};

}  // namespace geminga::el

#endif
