// A thread claims the entry of an atom, makes its node, and lets the other threads read it.
#include "reasoning/el/closure/nodes.hpp"

#include <algorithm>
#include <thread>

#include "base/parallel/claim.hpp"

namespace geminga::el {
namespace {

constexpr std::size_t first_round = 512;  // seeds

}  // namespace

SharedNodes::SharedNodes(const IndexedOntology& of, const SaturationLimits& within, std::span<const ExprId> asked)
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
    // A defined class may turn out to be above any class.
    if (!of.is_atom(expr)) {
      for (const ExprId above : of.told_atoms(expr)) expected[number(above)] = any_number;
    }
    if (!of.is_atom(expr) || of.representative(expr) != expr || of.needs_no_context(expr)) continue;
    for (const ExprId above : of.frontier(expr)) expect(above);
  }
  expected[number(top_expr)] = any_number;
}

std::uint32_t Nodes::require(ExprId atom) {
  std::atomic<std::uint32_t>& entry = shared_.node_of[number(atom)];
  std::uint32_t known = entry.load(std::memory_order_acquire);
  while (known <= SharedNodes::claimed_node) {
    if (known == SharedNodes::claimed_node) {
      std::this_thread::yield();  // another thread makes it
      known = entry.load(std::memory_order_acquire);
    } else if (entry.compare_exchange_weak(known, SharedNodes::claimed_node, std::memory_order_acq_rel)) {
      parallel::Claim claim(entry, SharedNodes::no_node_yet);
      const std::uint32_t created = nodes_.add();
      Node& node = nodes_[created];
      node.root = number(atom);
      node.is_nonempty = shared_.index.is_nominal(atom);
      node.expected = shared_.expected[number(atom)];
      queue_.add(created);
      claim.settle(created + 2);
      return created;
    }
  }
  return known - 2;
}

std::uint32_t Nodes::require_existential(RoleId role, std::uint32_t filler) {
  const std::uint64_t hash = base::mixed(base::mixed(0, static_cast<std::uint32_t>(role)), filler);
  SharedNodes::Part& part = shared_.existentials[hash % SharedNodes::part_count];
  const auto lock = queue_.is_parallel() ? std::unique_lock(part.mutex) : std::unique_lock<std::mutex>();
  const std::uint32_t known = part.table.find(hash, [&](std::uint32_t candidate) {
    return nodes_[candidate].root == static_cast<std::uint32_t>(role) && nodes_[candidate].filler == filler;
  });
  if (known != base::NumberTable::none) return known;
  const std::uint32_t created = nodes_.add();
  Node& node = nodes_[created];
  node.root = static_cast<std::uint32_t>(role);
  node.filler = filler;
  queue_.add(created);
  part.table.insert(hash, created);
  ++links_;
  return created;
}

std::uint32_t Nodes::add_nameless() {
  const std::uint32_t created = nodes_.add();
  nodes_[created].root = no_node;
  nodes_[created].is_kept = true;
  queue_.add(created);
  return created;
}

bool Nodes::begin_next_seeds() {
  // One thread follows each seed to its end. Each of many threads needs some seeds, but the first rounds are short,
  // because they close the upper classes, on which all others wait.
  while (shared_.seeds_let_in < shared_.seeds.size()) {
    const std::size_t more = queue_.is_parallel() ? std::max(first_round, shared_.seeds_let_in.load()) : 1;
    shared_.seeds_let_in = std::min(shared_.seeds.size(), shared_.seeds_let_in + more);
    if (begin_more()) return true;
  }
  return false;
}

bool Nodes::begin_more() {
  // Few seeds at once, so that the nodes that one leads to are soon closed.
  const std::size_t count = queue_.is_parallel() ? 16 : 1;
  while (queue_.numbers().empty()) {
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

}  // namespace geminga::el
