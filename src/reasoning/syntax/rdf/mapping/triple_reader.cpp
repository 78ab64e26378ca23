// Walks lists with a mark on each node, so that a list that contains itself ends.
#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"

namespace geminga::rdf {

TripleReader::TripleReader(const Graph& graph)
    : graph_(graph), used_(graph.triple_count(), true), list_steps_left_(graph.triple_count() * 4 + 1024) {
  // Repeated triples are in no index.
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    for (const std::uint32_t number : graph.about(NodeId{node})) used_[number] = false;
  }
}

NodeId TripleReader::object_of(NodeId subject, syntax::Word predicate) {
  NodeId found{};
  for (const std::uint32_t number : graph_.about(subject, predicate)) {
    if (found != NodeId{}) return NodeId{};
    found = graph_.triple(number).object;
    use(number);
  }
  return found;
}

std::optional<std::vector<NodeId>> TripleReader::list(NodeId head) {
  if (list_marks_.empty()) list_marks_.resize(graph_.node_count(), 0);
  ++list_walk_;
  std::vector<NodeId> members;
  for (NodeId node = head; node != node_of(syntax::Word::rdf_nil);) {
    std::uint32_t& mark = list_marks_[static_cast<std::size_t>(node)];
    if (node == NodeId{} || graph_.is_literal(node) || mark == list_walk_ || list_steps_left_ == 0) return std::nullopt;
    mark = list_walk_;
    --list_steps_left_;
    const NodeId first = object_of(node, syntax::Word::rdf_first);
    if (first == NodeId{}) return std::nullopt;
    members.push_back(first);
    node = object_of(node, syntax::Word::rdf_rest);
  }
  return members;
}

}  // namespace geminga::rdf
