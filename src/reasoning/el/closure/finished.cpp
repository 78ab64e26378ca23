// A node that is not final makes the nodes below it open.
#include "reasoning/el/closure/finished.hpp"

#include <cstdint>
#include <utility>

#include "base/rows.hpp"

namespace geminga::el {
namespace {

class Finished {
 public:
  Finished(const IndexedOntology& index, const Inheritance& inheritance)
      : index_(index), inheritance_(inheritance), is_open_(inheritance.nodes().size(), false) {
    for (std::uint32_t at = 0; at < is_open_.size(); ++at) look_above(at);
    spread();
  }

  [[nodiscard]] bool has(ExprId expr) const { return !is_open(top_expr) && !is_open(expr); }

 private:
  /// Visits the node of an atom, or the nodes that stand for it (IndexedOntology::needs_no_context()).
  template <typename Visit>
  void visit_nodes(ExprId atom, Visit&& visit) const {
    if (!index_.needs_no_context(atom)) return visit(inheritance_.find(atom));
    for (const ExprId only : index_.frontier(atom)) visit(inheritance_.find(only));
  }

  [[nodiscard]] bool is_open(ExprId atom) const {
    bool is_one_open = false;
    visit_nodes(atom, [&](std::uint32_t node) { is_one_open = is_one_open || node == no_node || is_open_[node]; });
    return is_one_open;
  }

  void look_above(std::uint32_t at) {
    const Node& node = inheritance_.nodes()[at];
    if (node.is_unsatisfiable) return;
    if (!node.is_final) return open(at);
    const auto depend = [&](std::uint32_t above) {
      if (above == no_node) return open(at);
      below_.emplace_back(above, at);
    };
    if (node.is_existential()) {
      depend(node.filler);
    } else {
      for (const ExprId above : index_.frontier(ExprId{node.root})) depend(inheritance_.find(above));
    }
    const auto size = static_cast<std::uint32_t>(index_.size());
    for (const std::uint32_t above : node.above) {
      if (above >= size) {
        depend(above - size);
      } else {
        visit_nodes(ExprId{above}, depend);
      }
    }
  }

  void open(std::uint32_t node) {
    if (is_open_[node]) return;
    is_open_[node] = true;
    newly_open_.push_back(node);
  }

  void spread() {
    const base::Rows<std::uint32_t> below(is_open_.size(), below_);
    while (!newly_open_.empty()) {
      const std::uint32_t node = newly_open_.back();
      newly_open_.pop_back();
      for (const std::uint32_t one : below[node]) open(one);
    }
  }

  const IndexedOntology& index_;
  const Inheritance& inheritance_;
  std::vector<bool> is_open_;  ///< by node
  std::vector<std::uint32_t> newly_open_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> below_;  ///< a node, and a node that depends on it
};

}  // namespace

std::vector<bool> find_finished(const IndexedOntology& index, const Inheritance& inheritance,
                                std::span<const ExprId> exprs) {
  const Finished finished(index, inheritance);
  std::vector<bool> result;
  result.reserve(exprs.size());
  for (const ExprId expr : exprs) result.push_back(finished.has(expr));
  return result;
}

}  // namespace geminga::el
