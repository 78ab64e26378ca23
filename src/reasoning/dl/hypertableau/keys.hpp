// Keys.
//
//   of(a), of(b), R(a,c), R(b,c), ..., U(a,v), U(b,v), ... -> a = b for named individuals a, b, c
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_KEYS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_KEYS_HPP

#include <vector>

#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"

namespace geminga::hypertableau {

/// Finds named individuals that are equal because a key says so.
class Keys {
 public:
  Keys(const owl::Ontology& source, const clauses::ClauseSet& set, const Graph& graph, Assertions& facts)
      : source_(source), set_(set), graph_(graph), facts_(facts) {}

  /// Lets the first two that are found be merged.
  void check();

 private:
  /// Whether the key says that they are equal; unites the reasons into `dependency`.
  bool agree(const clauses::Key& key, NodeId first, NodeId second, DependencySet& dependency);

  const owl::Ontology& source_;
  const clauses::ClauseSet& set_;
  const Graph& graph_;
  Assertions& facts_;
  std::vector<bool> is_named_;  ///< by node, as of the last check
};

}  // namespace geminga::hypertableau

#endif
