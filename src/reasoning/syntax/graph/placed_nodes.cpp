#include "reasoning/syntax/graph/placed_nodes.hpp"

#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::graph {
namespace {

bool is_of_rdf(const raptor_term& term, std::string_view word) {
  const std::string_view text = text_of(term);
  return is_iri(term) && text.starts_with(syntax::rdf_namespace) && text.substr(syntax::rdf_namespace.size()) == word;
}

/// The end of the triples that begin at `begin` and have its subject.
std::size_t end_of_subject(Triples all, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < all.size() && raptor_term_equals(all[end]->subject, all[begin]->subject) != 0) ++end;
  return end;
}

}  // namespace

std::string_view text_of(const raptor_term& term) {
  const unsigned char* text = term.type == RAPTOR_TERM_TYPE_BLANK ? term.value.blank.string : term.value.literal.string;
  std::size_t size = octets_of(term);
  if (is_iri(term)) text = raptor_uri_as_counted_string(term.value.uri, &size);
  return text == nullptr ? std::string_view() : std::string_view(reinterpret_cast<const char*>(text), size);
}

PlacedNodes::PlacedNodes(Triples sorted, bool lists_literals) : all_(sorted), lists_literals_(lists_literals) {
  for (std::size_t begin = 0; begin < all_.size();) {
    const std::size_t end = end_of_subject(all_, begin);
    if (is_blank(*all_[begin]->subject)) {
      Node& subject = nodes_[text_of(*all_[begin]->subject)];
      subject.begin = begin;
      subject.end = end;
    }
    for (; begin < end; ++begin) {
      if (is_blank(*all_[begin]->object)) ++nodes_[text_of(*all_[begin]->object)].references;
    }
  }
  for (auto& [label, node] : nodes_) node.is_labelled = node.references != 1;
}

PlacedNodes::Node& PlacedNodes::node(const raptor_term& blank) { return nodes_.find(text_of(blank))->second; }

const PlacedNodes::Node& PlacedNodes::node(const raptor_term& blank) const {
  return nodes_.find(text_of(blank))->second;
}

Triples PlacedNodes::take(Node& node) {
  node.is_written = true;
  return all_.subspan(node.begin, node.end - node.begin);
}

Triples PlacedNodes::next_root() {
  while (!cut_off_.empty()) {
    Node& first = *cut_off_.front();
    cut_off_.pop_front();
    if (first.begin != first.end && !first.is_written) return take(first);
  }
  for (; next_ < all_.size() || !is_rest_;) {
    if (next_ >= all_.size()) {
      is_rest_ = true;
      next_ = 0;
      continue;
    }
    const std::size_t begin = next_;
    next_ = end_of_subject(all_, begin);
    if (!is_blank(*all_[begin]->subject)) {
      if (!is_rest_) return all_.subspan(begin, next_ - begin);
      continue;
    }
    Node& subject = node(*all_[begin]->subject);
    subject.is_labelled = subject.is_labelled || is_rest_;
    if (subject.is_labelled && !subject.is_written) return take(subject);
  }
  return {};
}

PlacedNodes::Place PlacedNodes::place(const raptor_term& blank, std::size_t depth, bool may_be_list) {
  Node& object = node(blank);
  if (object.is_labelled) return Place::labelled;
  if (depth >= max_nesting) {
    object.is_labelled = true;
    cut_off_.push_back(&object);
    return Place::labelled;
  }
  if (may_be_list && take_list(object)) return Place::list;
  object.is_written = true;
  return Place::nested;
}

Triples PlacedNodes::triples(const raptor_term& blank) const {
  const Node& subject = node(blank);
  return all_.subspan(subject.begin, subject.end - subject.begin);
}

const raptor_statement* PlacedNodes::rest_of(const Node& cell) const {
  if (cell.is_labelled || cell.is_no_list || cell.end - cell.begin != 2) return nullptr;
  const raptor_statement& first = *all_[cell.begin];
  const raptor_statement& rest = *all_[cell.begin + 1];
  const bool is_cell = is_of_rdf(*first.predicate, "first") && is_of_rdf(*rest.predicate, "rest") &&
                       (lists_literals_ || !is_literal(*first.object));
  return is_cell ? &rest : nullptr;
}

bool PlacedNodes::take_list(Node& head) {
  std::vector<Node*> cells;
  for (Node* cell = &head;;) {
    const raptor_statement* rest = rest_of(*cell);
    cells.push_back(cell);
    const bool is_end = rest != nullptr && is_of_rdf(*rest->object, "nil");
    if (!is_end && rest != nullptr && is_blank(*rest->object)) {
      cell = &node(*rest->object);
      continue;
    }
    for (Node* passed : cells) (is_end ? passed->is_written : passed->is_no_list) = true;
    return is_end;
  }
}

std::vector<const raptor_term*> PlacedNodes::members(const raptor_term& list) const {
  std::vector<const raptor_term*> members;
  for (const raptor_term* cell = &list; is_blank(*cell);) {
    const Triples pair = triples(*cell);
    members.push_back(pair[0]->object);
    cell = pair[1]->object;
  }
  return members;
}

bool PlacedNodes::is_referred_to(const raptor_term& blank) const { return node(blank).references != 0; }

}  // namespace geminga::graph
