// The order of the passes, and the small look-ups that all of them share.
#include "reasoning/syntax/rdf/mapping.hpp"

#include <utility>

namespace geminga::rdf {
namespace {

/// Different constructs that are left out by name. A file can make up as many names of OWL's as it likes.
constexpr std::size_t max_constructs = 250;

}  // namespace

Mapping::Mapping(const Graph& graph, owl::Ontology& source, std::vector<owl::FileId> files)
    : graph_(graph),
      source_(source),
      files_(std::move(files)),
      roles_(graph.node_count(), 0),
      used_(graph.triple_count(), true),
      declared_(graph.node_count() * 6, false),
      classes_(graph.node_count()),
      range_marks_(graph.node_count(), 0),
      list_steps_left_(graph.triple_count() * 4 + 1024) {}

void Mapping::run() {
  // Repeated triples are in no index and count as used from the start.
  for (std::uint32_t node = 0; node < graph_.node_count(); ++node) {
    for (const std::uint32_t number : graph_.about(NodeId{node})) used_[number] = false;
  }
  find_roles();
  for (std::uint32_t number = 0; number < graph_.triple_count(); ++number) {
    if (!used_[number]) map_triple(number);
  }
  map_labels();
  report_leftovers();
}

syntax::Word Mapping::word(NodeId node) {
  return static_cast<std::uint32_t>(node) < static_cast<std::uint32_t>(syntax::Word::count)
             ? static_cast<syntax::Word>(node)
             : syntax::Word::none;
}

bool Mapping::use(std::uint32_t triple) {
  const bool was_used = used_[triple];
  used_[triple] = true;
  return !was_used;
}

NodeId Mapping::object_of(NodeId subject, syntax::Word predicate) {
  NodeId found{};
  for (const std::uint32_t number : graph_.about(subject, predicate)) {
    if (found != NodeId{}) return NodeId{};
    found = graph_.triple(number).object;
    used_[number] = true;
  }
  return found;
}

std::optional<std::vector<NodeId>> Mapping::list(NodeId head) {
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

std::expected<std::vector<owl::TermId>, const char*> Mapping::terms(NodeId head, Mapped (Mapping::*map)(NodeId)) {
  const auto members = list(head);
  if (!members) return std::unexpected("a broken rdf:List");
  std::vector<owl::TermId> mapped;
  mapped.reserve(members->size());
  for (const NodeId member : *members) {
    const Mapped term = (this->*map)(member);
    if (!term) return std::unexpected(term.error());
    mapped.push_back(*term);
  }
  return mapped;
}

owl::FileId Mapping::file_of(std::uint32_t triple) const { return files_[graph_.file_of(triple)]; }

void Mapping::leave_out(std::uint32_t triple, std::string_view construct) {
  if (constructs_.size() < max_constructs) {
    constructs_.emplace(construct);
  } else if (!constructs_.contains(construct)) {
    construct = "other names that OWL 2 does not have";
  }
  source_.leave_out(construct, file_of(triple), graph_.triple(triple).line);
}

void Mapping::add(std::uint32_t triple, owl::AxiomKind kind, std::initializer_list<Mapped> arguments) {
  std::vector<owl::TermId> terms;
  for (const Mapped& argument : arguments) {
    if (!argument) return leave_out(triple, argument.error());
    terms.push_back(*argument);
  }
  add(triple, kind, terms);
}

void Mapping::add(std::uint32_t triple, owl::AxiomKind kind, const std::vector<owl::TermId>& arguments) {
  source_.add(kind, arguments, file_of(triple), graph_.triple(triple).line);
}

void Mapping::add_list_axiom(std::uint32_t number, owl::AxiomKind kind, NodeId head, Mapped (Mapping::*map)(NodeId)) {
  const auto members = terms(head, map);
  if (!members) return leave_out(number, members.error());
  if (members->size() >= 2) add(number, kind, *members);  // of fewer, nothing is said
}

void Mapping::declare(std::uint32_t number, owl::TermKind kind) {
  const NodeId node = graph_.triple(number).subject;
  // Entities are the kinds 0 to 5 of el::TermKind.
  const std::size_t slot = static_cast<std::size_t>(node) * 6 + static_cast<std::size_t>(kind);
  if (!graph_.is_iri(node) || declared_[slot]) return;
  declared_[slot] = true;
  add(number, owl::AxiomKind::declaration, {source_.entity(kind, graph_.text(node))});
}

}  // namespace geminga::rdf
