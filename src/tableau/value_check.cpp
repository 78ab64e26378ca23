// Values: what is not looked at yet is not known.
#include "tableau/value_check.hpp"

namespace geminga::tableau {

ValueCheck::ValueCheck(const el::OntologySource& source, const clauses::ClauseSet& set) : source_(source), set_(set) {}

bool ValueCheck::is_ill_formed(el::TermId) const { return false; }

std::optional<bool> ValueCheck::is_in(el::TermId literal, std::uint32_t range) {
  const clauses::DataRange& one = set_.data_ranges[range];
  if (one.term == literal) return !one.is_complement;
  return std::nullopt;
}

bool ValueCheck::are_different(el::TermId, el::TermId) { return false; }

el::TermId ValueCheck::representative(el::TermId literal) { return literal; }

std::optional<DependencySet> ValueCheck::clash(const Graph& graph, DependencySets&, std::string& unknown) {
  for (NodeId node = 0; node < graph.node_count(); ++node) {
    for (FactId id = graph.node(node).others; id != none; id = graph.next_other(id, node)) {
      if (graph.fact(id).kind == FactKind::data_range) unknown = "data ranges are not looked at";
    }
  }
  return std::nullopt;
}

}  // namespace geminga::tableau
