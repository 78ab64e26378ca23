// How nodes come to be, what is above them, and how they hear of each other; what rules conclude is in
// inheritance_rules.cpp.
#include "reasoning/el/inheritance.hpp"

#include <algorithm>
#include <cstring>
#include <thread>

#include "base/parallel/claim.hpp"
#include "base/parallel/threads.hpp"
#include "reasoning/el/inheritance_worker.hpp"

namespace geminga::el {
namespace {

constexpr std::uint32_t any_number = std::numeric_limits<std::uint32_t>::max();

constexpr std::size_t first_round = 512;  // seeds

std::size_t bytes_of(std::size_t item_count) { return sizeof(QueuedNodeMessage) + item_count * sizeof(std::uint32_t); }

}  // namespace

Inheriting::Inheriting(const IndexedOntology& of, const SaturationLimits& within, std::span<const ExprId> asked)
    : index(of),
      limits(within),
      first_link(static_cast<std::uint32_t>(of.size() + of.disjointness_count())),
      node_of(of.size()),
      expected(of.size(), 0),
      seeds(asked) {
  const auto expect = [&](ExprId atom) {
    if (expected[number(atom)] != any_number) ++expected[number(atom)];
  };
  for (std::uint32_t id = 0; id < of.size(); ++id) {
    const ExprId expr{id};
    for (const LinkRule& link : of.links(expr)) expect(link.root);
    // What is defined may turn out to be above anything.
    if (!of.is_atom(expr)) {
      for (const ExprId above : of.told_atoms(expr)) expected[number(above)] = any_number;
    }
    if (!of.is_atom(expr) || of.representative(expr) != expr || of.needs_no_context(expr)) continue;
    for (const ExprId above : of.frontier(expr)) expect(above);
  }
  expected[number(top_expr)] = any_number;
}

Inheritance::Inheritance(const IndexedOntology& index, const SaturationLimits& limits, std::span<const ExprId> asked)
    : shared_(index, limits, asked) {
  workers_.push_back(std::make_unique<InheritanceWorker>(shared_, std::uint8_t{1}));
  shared_.contexts[workers_.front()->require(top_expr)].is_nonempty = true;
}

Inheritance::~Inheritance() = default;

bool Inheritance::run(unsigned threads) {
  if (threads <= 1) {
    workers_.front()->run_alone();
  } else {
    parallel::run_together(shared_, workers_, std::min(threads, parallel::max_threads));
  }
  return !shared_.is_over_limit;
}

std::size_t Inheritance::conclusion_count() const {
  std::size_t count = 0;
  for (const auto& worker : workers_) count += worker->conclusion_count();
  return count;
}

std::size_t Inheritance::link_count() const {
  std::size_t count = 0;
  for (const auto& worker : workers_) count += worker->link_count();
  return count;
}

std::uint32_t InheritanceWorker::require(ExprId atom) {
  std::atomic<std::uint32_t>& entry = shared_.node_of[number(atom)];
  std::uint32_t known = entry.load(std::memory_order_acquire);
  while (known <= Inheriting::claimed_node) {
    if (known == Inheriting::claimed_node) {
      std::this_thread::yield();  // another thread is making it
      known = entry.load(std::memory_order_acquire);
    } else if (entry.compare_exchange_weak(known, Inheriting::claimed_node, std::memory_order_acq_rel)) {
      parallel::Claim claim(entry, Inheriting::no_node_yet);
      const std::uint32_t created = nodes_.add();
      Node& node = nodes_[created];
      node.root = number(atom);
      node.is_nonempty = index_.is_nominal(atom);
      node.expected = shared_.expected[number(atom)];
      take_in_hand(created);
      claim.settle(created + 2);
      return created;
    }
  }
  return known - 2;
}

std::uint32_t InheritanceWorker::require_existential(RoleId role, std::uint32_t filler) {
  const std::uint64_t hash = base::mixed(base::mixed(0, static_cast<std::uint32_t>(role)), filler);
  Inheriting::Part& part = shared_.existentials[hash % Inheriting::part_count];
  std::uint32_t created = no_node;
  {
    const auto lock = is_parallel_ ? std::unique_lock(part.mutex) : std::unique_lock<std::mutex>();
    const std::uint32_t known = part.table.find(hash, [&](std::uint32_t candidate) {
      return nodes_[candidate].root == static_cast<std::uint32_t>(role) && nodes_[candidate].filler == filler;
    });
    if (known != base::NumberTable::none) return known;
    created = nodes_.add();
    Node& node = nodes_[created];
    node.root = static_cast<std::uint32_t>(role);
    node.filler = filler;
    take_in_hand(created);
    part.table.insert(hash, created);
  }
  ++links_;
  return created;
}

/// The node is new, and this worker has it in hand.
void InheritanceWorker::take_in_hand(std::uint32_t node) {
  if (is_parallel_) {
    nodes_[node].mailbox.hold();
    nodes_[node].owner.store(rank_, std::memory_order_relaxed);
  } else {
    nodes_[node].is_queued = true;
  }
  queue_.push_back(node);
}

//  ----- (init)   -----
//  N < N          N < T
void InheritanceWorker::start(std::uint32_t node) {
  Node& self = nodes_[node];
  self.has_begun = true;
  if (self.is_existential()) {
    // What the link says together with others is an item, too.
    if (index_.roles().is_second(RoleId{self.root})) self.items.insert(shared_.first_link + node, arena_);
    ++self.pending;
    return tell(self.filler, {NodeMessage::Kind::source, node, 0});
  }
  const ExprId atom{self.root};
  for (const ExprId above : index_.frontier(atom)) inherit(node, require(above));
  // Whoever is above has it from there, too.
  const bool says_top_something = index_.is_active(top_expr) || !index_.frontier(top_expr).empty();
  if (index_.frontier(atom).empty() && atom != top_expr && says_top_something) inherit(node, require(top_expr));
  if (index_.is_active(atom)) add_subsumer(node, atom);
}

void InheritanceWorker::inherit(std::uint32_t node, std::uint32_t from) {
  if (node == from) return;
  ++nodes_[node].pending;
  tell(from, {NodeMessage::Kind::child, node, 0});
}

void InheritanceWorker::add_link(std::uint32_t node, RoleId role, std::uint32_t filler) {
  const std::uint32_t from = require_existential(role, filler);
  Node& self = nodes_[node];
  if (from == node || self.is_unsatisfiable || self.items.contains(shared_.first_link + from)) return;
  self.above.push_back(static_cast<std::uint32_t>(index_.size()) + from, arena_);
  inherit(node, from);
}

void InheritanceWorker::add_atom(std::uint32_t node, ExprId atom) {
  Node& self = nodes_[node];
  if (self.is_unsatisfiable || (!self.is_existential() && number(atom) == self.root)) return;
  // Most have few; where there are many, hearing of one twice does no harm.
  constexpr std::uint32_t max_scanned = 32;
  const auto recent = std::span<const std::uint32_t>(self.above.data(), self.above.size())
                          .last(std::min(self.above.size(), max_scanned));
  if (std::ranges::find(recent, number(atom)) != recent.end()) return;
  self.above.push_back(number(atom), arena_);
  if (!index_.needs_no_context(atom)) return inherit(node, require(atom));
  for (const ExprId only : index_.frontier(atom)) inherit(node, require(only));
}

void InheritanceWorker::run_alone() {
  do {
    while (!queue_.empty() && !shared_.has_ended()) {
      const std::uint32_t node = queue_.back();
      queue_.pop_back();
      nodes_[node].is_queued = false;
      process(node);
    }
  } while (!shared_.has_ended() && (release_one() || begin_round()));
}

bool InheritanceWorker::begin_round() {
  // Nobody waits, and nothing is to be done: what has begun is closed, circles and all.
  for (; shared_.closed < nodes_.size(); ++shared_.closed) {
    Node& node = nodes_[shared_.closed];
    if (node.is_final || node.is_unsatisfiable) continue;
    node.is_final = true;
    node.is_open = false;
    let_go(static_cast<std::uint32_t>(shared_.closed));
  }
  // One thread follows each seed to its end. Of many threads each needs some, but the first rounds are to be short: in
  // them the upper classes are closed, on which all others wait.
  while (shared_.seeds_let_in < shared_.seeds.size()) {
    const std::size_t more = is_parallel_ ? std::max(first_round, shared_.seeds_let_in.load()) : 1;
    shared_.seeds_let_in = std::min(shared_.seeds.size(), shared_.seeds_let_in + more);
    if (begin_more()) return true;
  }
  return false;
}

bool InheritanceWorker::begin_more() {
  // Few at once, so that what one leads to is soon closed.
  const std::size_t count = is_parallel_ ? 16 : 1;
  while (queue_.empty()) {
    std::size_t first = shared_.next_seed.load();
    std::size_t last = 0;
    do {
      last = std::min(first + count, shared_.seeds_let_in.load());
      if (first >= last) return false;
    } while (!shared_.next_seed.compare_exchange_weak(first, last));
    for (const ExprId seed : shared_.seeds.subspan(first, last - first)) require(seed);
  }
  return true;
}

bool InheritanceWorker::release_one() {
  while (queue_.empty() && !stalled_.empty()) {
    const std::uint32_t node = stalled_.back();
    stalled_.pop_back();
    tell(node, {NodeMessage::Kind::release, 0, 0});
  }
  return !queue_.empty();
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
  tell_sources(node);
  serve_children(node);
  self.items_told = self.items.size();
  self.selfs_told = self.selfs.size();
  if (self.is_final) let_go(node);
  work_.add(1);
  if (conclusions_ > shared_.limits.conclusions) shared_.is_over_limit = true;
}

void InheritanceWorker::let_go(std::uint32_t node) {
  // Whoever was told knows all there will ever be, and nothing will be looked up any more.
  Node& self = nodes_[node];
  const std::uint32_t asked = self.children.size() + self.sources.size();
  self.children.clear(arena_);
  self.sources.clear(arena_);
  self.children_served = self.sources_told = 0;
  self.todo.clear(arena_);
  if (self.expected != any_number) self.expected -= std::min(asked, self.expected);
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
  self.above.clear(arena_);
}

void InheritanceWorker::set_parallel(bool is_parallel) {
  is_parallel_ = is_parallel;
  if (!is_parallel) return;
  for (const std::uint32_t node : queue_) {
    nodes_[node].mailbox.hold();
    nodes_[node].owner = rank_;
    nodes_[node].is_queued = false;
  }
}

void InheritanceWorker::work_on(std::uint32_t node) {
  Node& self = nodes_[node];
  for (;;) {
    QueuedNodeMessage* waiting = self.mailbox.empty();
    while (waiting != nullptr) {
      QueuedNodeMessage* next = waiting->next;
      receive(node, waiting->message, {reinterpret_cast<const std::uint32_t*>(waiting + 1), waiting->item_count});
      arena_.release(waiting, bytes_of(waiting->item_count));
      waiting = next;
    }
    process(node);
    self.owner.store(0, std::memory_order_relaxed);
    if (shared_.has_ended() || self.mailbox.rest()) break;
    self.owner.store(rank_, std::memory_order_relaxed);  // a message has come
  }
}

void InheritanceWorker::tell(std::uint32_t node, const NodeMessage& message, Items items) {
  if (is_elsewhere(node)) return post(node, message, items);
  receive(node, message, items);
}

void InheritanceWorker::post(std::uint32_t node, const NodeMessage& message, Items items) {
  Node& there = nodes_[node];
  if (there.mailbox.take()) {
    there.owner.store(rank_, std::memory_order_relaxed);
    queue_.push_back(node);
    return receive(node, message, items);
  }
  auto* waiting = ::new (arena_.allocate(bytes_of(items.size())))
      QueuedNodeMessage{nullptr, message, static_cast<std::uint32_t>(items.size())};
  if (!items.empty()) std::memcpy(static_cast<void*>(waiting + 1), items.data(), items.size_bytes());
  if (!there.mailbox.put(waiting)) return;
  there.owner.store(rank_, std::memory_order_relaxed);  // it has come to rest meanwhile
  queue_.push_back(node);
}

void InheritanceWorker::receive(std::uint32_t node, const NodeMessage& message, Items items) {
  Node& self = nodes_[node];
  switch (message.kind) {
    case NodeMessage::Kind::child:
    case NodeMessage::Kind::source:
      if (self.is_unsatisfiable) return tell(message.first, {NodeMessage::Kind::bottom, 0, 0});
      (message.kind == NodeMessage::Kind::child ? self.children : self.sources).push_back(message.first, arena_);
      if (self.is_dropped) begin_anew(node);
      return enqueue(node);
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
  if (self.pending == 0 || self.is_released) enqueue(node);
}

void InheritanceWorker::enqueue(std::uint32_t node) {
  if (is_parallel_ || nodes_[node].is_queued) return;
  nodes_[node].is_queued = true;
  queue_.push_back(node);
}

}  // namespace geminga::el
