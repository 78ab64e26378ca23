// The life of a node, and the conclusions in it; the rules are in rules.hpp, the legend is in inheritance.hpp.
#include "reasoning/el/closure/inheritance_worker.hpp"

#include <algorithm>
#include <cstring>
#include <new>

namespace geminga::el {
namespace {

std::size_t bytes_of(std::size_t item_count) { return sizeof(QueuedNodeMessage) + item_count * sizeof(std::uint32_t); }

}  // namespace

void InheritanceWorker::run_alone() {
  do {
    queue_.run_alone([this](std::uint32_t node) { process(node); }, [this] { return shared_.has_ended(); });
  } while (!shared_.has_ended() && (release_one() || begin_round()));
}

std::uint32_t InheritanceWorker::add_below(std::uint32_t node) {
  const std::uint32_t created = made_.add_nameless();
  nodes_[created].above.push_back(nodes_[node].root, arena_);
  inherit(created, node);
  return created;
}

void InheritanceWorker::lead_to(std::uint32_t existential, std::uint32_t node) {
  ++nodes_[existential].pending;
  tell(node, {NodeMessage::Kind::source, existential, 0});
}

void InheritanceWorker::work_on(std::uint32_t node) {
  const auto read = [&](QueuedNodeMessage* waiting) {
    receive(node, waiting->message, {reinterpret_cast<const std::uint32_t*>(waiting + 1), waiting->item_count});
    arena_.release(waiting, bytes_of(waiting->item_count));
  };
  queue_.work_on(node, read, [this](std::uint32_t held) { process(held); }, [this] { return shared_.has_ended(); });
}

bool InheritanceWorker::begin_round() {
  // No node waits and nothing is to be done: the nodes that have begun are closed, with all circles.
  for (; shared_.closed < nodes_.size(); ++shared_.closed) {
    Node& node = nodes_[shared_.closed];
    if (node.is_final || node.is_unsatisfiable) continue;
    node.is_final = true;
    node.is_open = false;
    let_go(static_cast<std::uint32_t>(shared_.closed));
  }
  return made_.begin_next_seeds();
}

bool InheritanceWorker::release_one() {
  while (queue().empty() && !stalled_.empty()) {
    const std::uint32_t node = stalled_.back();
    stalled_.pop_back();
    tell(node, {NodeMessage::Kind::release, 0, 0});
  }
  return !queue().empty();
}

void InheritanceWorker::stall(std::uint32_t node) {
  if (nodes_[node].is_stalled) return;
  nodes_[node].is_stalled = true;
  stalled_.push_back(node);
}

void InheritanceWorker::process(std::uint32_t node) {
  Node& self = nodes_[node];
  if (!self.has_begun) start(node);
  while (!self.is_unsatisfiable && !shared_.has_ended()) {
    if (self.pending != 0 && !self.is_released) return stall(node);
    if (self.todo.empty()) break;
    apply(node, ExprId{self.todo.pop_back()});
    work_.add(1);
  }
  if (self.is_unsatisfiable) return tell_bottom(node);
  self.is_released = true;
  self.is_final = self.pending == 0 && !self.is_open && !shared_.has_ended();
  deliveries_.deliver(node);
  if (self.is_final) let_go(node);
  work_.add(1);
  if (conclusions_ > shared_.limits.conclusions) shared_.is_over_limit = true;
}

//  ----- (init)   -----
//  N < N          N < T
void InheritanceWorker::start(std::uint32_t node) {
  Node& self = nodes_[node];
  self.has_begun = true;
  if (self.root == no_node) return;
  if (self.is_existential()) {
    // A chain may compose the link with another one, so it is an item, too.
    if (index_.roles().is_second(RoleId{self.root})) self.items.insert(shared_.first_link + node, arena_);
    ++self.pending;
    return tell(self.filler, {NodeMessage::Kind::source, node, 0});
  }
  // Of a node that begins anew. In a circle, a node above may have an item only because this one had it.
  for (std::uint32_t at = 0; at < self.above.size(); ++at) inherit_above(node, self.above[at]);
  const ExprId atom{self.root};
  for (const ExprId above : index_.frontier(atom)) inherit(node, require(above));
  // Nodes above hand on what T has.
  const bool says_top_something = index_.is_active(top_expr) || !index_.frontier(top_expr).empty();
  if (index_.frontier(atom).empty() && atom != top_expr && says_top_something) inherit(node, require(top_expr));
  if (index_.is_active(atom)) add_subsumer(node, atom);
}

void InheritanceWorker::inherit(std::uint32_t node, std::uint32_t from) {
  if (node == from) return;
  ++nodes_[node].pending;
  tell(from, {NodeMessage::Kind::child, node, 0});
}

/// Asks the nodes of an entry of Node::above.
void InheritanceWorker::inherit_above(std::uint32_t node, std::uint32_t above) {
  const auto size = static_cast<std::uint32_t>(index_.size());
  if (above >= size) return inherit(node, above - size);
  const ExprId atom{above};
  if (!index_.needs_no_context(atom)) return inherit(node, require(atom));
  for (const ExprId only : index_.frontier(atom)) inherit(node, require(only));
}

void InheritanceWorker::let_go(std::uint32_t node) {
  // All receivers know everything, and nothing will be looked up again.
  Node& self = nodes_[node];
  const std::uint32_t asked = self.children.size() + self.sources.size();
  self.children.clear(arena_);
  self.sources.clear(arena_);
  self.children_served = self.sources_told = 0;
  self.todo.clear(arena_);
  if (self.expected != SharedNodes::any_number) self.expected -= std::min(asked, self.expected);
  if (self.expected == 0 && !self.is_kept && !self.is_existential()) {
    self.is_dropped = true;
    self.items.clear(arena_);
    self.selfs.clear(arena_);
  } else {
    self.items.forget_table(arena_);
  }
}

void InheritanceWorker::begin_anew(std::uint32_t node) {
  Node& self = nodes_[node];
  self.is_dropped = self.is_final = self.has_begun = self.is_released = false;
  self.is_kept = true;
  self.items_told = self.selfs_told = 0;
}

void InheritanceWorker::tell(std::uint32_t node, const NodeMessage& message, Items items) {
  if (!queue_.is_elsewhere(node) || queue_.take(node)) return receive(node, message, items);
  auto* waiting = ::new (arena_.allocate(bytes_of(items.size())))
      QueuedNodeMessage{nullptr, message, static_cast<std::uint32_t>(items.size())};
  if (!items.empty()) std::memcpy(static_cast<void*>(waiting + 1), items.data(), items.size_bytes());
  queue_.post(node, waiting);
}

void InheritanceWorker::receive(std::uint32_t node, const NodeMessage& message, Items items) {
  Node& self = nodes_[node];
  switch (message.kind) {
    case NodeMessage::Kind::child:
    case NodeMessage::Kind::source:
      if (self.is_unsatisfiable) return tell(message.first, {NodeMessage::Kind::bottom, 0, 0});
      (message.kind == NodeMessage::Kind::child ? self.children : self.sources).push_back(message.first, arena_);
      if (self.is_dropped) begin_anew(node);
      return queue_.enqueue(node);
    case NodeMessage::Kind::inherited:
    case NodeMessage::Kind::found:
      if ((message.first & first_delivery) != 0) {
        --self.pending;
        if ((message.first & final_delivery) == 0) self.is_open = true;
      }
      if (self.is_unsatisfiable) return;
      if (message.kind == NodeMessage::Kind::inherited) {
        add_inherited(node, items);
      } else {
        for (const std::uint32_t item : items) add_subsumer(node, ExprId{item});
      }
      break;
    case NodeMessage::Kind::composed:
      add_link(node, RoleId{message.first}, message.second);
      break;
    case NodeMessage::Kind::bottom:
      return add_bottom(node);
    case NodeMessage::Kind::release:
      self.is_stalled = false;
      if (self.pending == 0 || self.is_released) return;
      self.is_released = true;
      break;
  }
  if (self.pending == 0 || self.is_released) queue_.enqueue(node);
}

void InheritanceWorker::add_subsumer(std::uint32_t node, ExprId item) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || !self.items.insert(number(item), arena_)) return;
  ++conclusions_;
  self.todo.push_back(number(item), arena_);
}

void InheritanceWorker::add_link(std::uint32_t node, RoleId role, std::uint32_t filler) {
  const std::uint32_t from = made_.require_existential(role, filler);
  Node& self = nodes_[node];
  if (from == node || self.is_unsatisfiable || self.items.contains(shared_.first_link + from)) return;
  const std::uint32_t above = static_cast<std::uint32_t>(index_.size()) + from;
  self.above.push_back(above, arena_);
  inherit_above(node, above);
}

void InheritanceWorker::add_atom(std::uint32_t node, ExprId atom) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || (!self.is_existential() && number(atom) == self.root)) return;
  // Most nodes have few atoms above; in longer lists a second copy does no harm.
  constexpr std::uint32_t max_scanned = 32;
  const auto recent = std::span<const std::uint32_t>(self.above.data(), self.above.size())
                          .last(std::min(self.above.size(), max_scanned));
  if (std::ranges::find(recent, number(atom)) != recent.end()) return;
  self.above.push_back(number(atom), arena_);
  inherit_above(node, number(atom));
}

// Only links that R Self makes are looked at; the other links are nodes, which hear of fillers by NodeDeliveries.
void InheritanceWorker::add_filler(std::uint32_t node, ExprId item) {
  const Node& self = nodes_[node];
  for (std::uint32_t at = 0; at < self.selfs.size(); ++at) propagate({self.selfs[at], node}, item);
}

void InheritanceWorker::add_self(std::uint32_t node, RoleId role) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.push_back(role, arena_);
  ++conclusions_;
  apply_self(node, role);
}

// A node R some N could tell N only what follows from the items of N itself. It is not made; the items are read here.
void InheritanceWorker::add_loop(std::uint32_t node, RoleId role) {
  const Node& self = nodes_[node];
  std::vector<ExprId> found;
  for (std::uint32_t at = 0; at < self.items.size(); ++at) {
    const std::uint32_t item = self.items[at];
    if (item >= shared_.first_link) {
      compose_with_link(node, role, item);
    } else if (item < index_.size()) {
      for_each_existential(index_, role, ExprId{item}, [&](ExprId existential) { found.push_back(existential); });
    }
  }
  for (const ExprId existential : found) add_subsumer(node, existential);
}

//  N < R Self   N < S some M
//  ------------------------- [R o S SubPropertyOf R']
//  N < R' some M
void InheritanceWorker::compose_with_link(std::uint32_t node, RoleId first, std::uint32_t item) {
  const Node& link = nodes_[item - shared_.first_link];
  compose(node, first, RoleId{link.root}, link.filler);
}

void InheritanceWorker::add_inherited(std::uint32_t node, Items items) {
  Node& self = nodes_[node];
  const std::uint32_t begin = self.items.size();
  self.items.insert_all(items, arena_);
  const std::uint32_t end = self.items.size();
  conclusions_ += end - begin;
  work_.add(items.size());
  for (std::uint32_t at = begin; at < end && !self.is_unsatisfiable; ++at) process_inherited(node, self.items[at]);
  // Items that came together have met above. The shorter part is compared with the longer one.
  const auto has_conjunctions = [&](std::uint32_t item) {
    return item < index_.size() && index_.has_rules(ExprId{item}, RuleBits::conjunctions);
  };
  const bool are_old_fewer = begin < end - begin;
  const std::uint32_t first = are_old_fewer ? 0 : begin;
  const std::uint32_t last = are_old_fewer ? begin : end;
  for (std::uint32_t at = first; at < last && begin != 0 && !self.is_unsatisfiable; ++at) {
    if (has_conjunctions(self.items[at])) apply_conjunctions(node, ExprId{self.items[at]});
  }
}

void InheritanceWorker::process_inherited(std::uint32_t node, std::uint32_t item) {
  if (item >= shared_.first_link) {
    const Node& self = nodes_[node];
    for (std::uint32_t at = 0; at < self.selfs.size(); ++at) compose_with_link(node, self.selfs[at], item);
  } else {
    apply_to_inherited(node, ExprId{item}, index_.rule_bits(ExprId{item}));
  }
}

//  M < F
//  ----- [N is a child of M, or R some M]; tell_bottom() tells the other nodes
//  N < F
void InheritanceWorker::add_bottom(std::uint32_t node) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable) return;
  self.is_unsatisfiable = true;
  ++conclusions_;
  if (self.is_nonempty) shared_.is_inconsistent = true;
  self.items.clear(arena_);
  self.todo.clear(arena_);
  self.above.clear(arena_);
  self.selfs.clear(arena_);
  self.selfs_told = self.items_told = 0;
  queue_.enqueue(node);
}

void InheritanceWorker::tell_bottom(std::uint32_t node) {
  Node& self = nodes_[node];
  for (const auto* receivers : {&self.children, &self.sources}) {
    for (std::uint32_t at = 0; at < receivers->size(); ++at) {
      tell((*receivers)[at], {NodeMessage::Kind::bottom, 0, 0});
    }
  }
  self.children.clear(arena_);
  self.sources.clear(arena_);
  self.children_served = self.sources_told = 0;
}

}  // namespace geminga::el
