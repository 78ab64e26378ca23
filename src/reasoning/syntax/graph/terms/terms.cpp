#include "reasoning/syntax/graph/terms/terms.hpp"

namespace geminga::graph {
namespace {

/// A text that only equal nodes have.
std::string key_of(const Node& node) {
  std::string key(1, static_cast<char>('0' + static_cast<int>(node.kind)));
  return key.append(node.language).append(1, '\n').append(node.datatype).append(1, '\n').append(node.text);
}

}  // namespace

TermNumber Terms::number_of(const raptor_term& term) {
  const auto [place, is_new] = by_address_.try_emplace(&term, unbound);
  if (!is_new) return place->second;
  const TermNumber number = number_of(std::optional(node_of(term)));
  by_address_[&term] = number;
  return number;
}

TermNumber Terms::number_of(const std::optional<Node>& node) {
  if (!node) return unbound;
  Node plain = *node;
  if (plain.datatype == xsd_string) plain.datatype.clear();
  const auto [place, is_new] = by_text_.try_emplace(key_of(plain), static_cast<TermNumber>(entries_.size()));
  if (is_new) entries_.push_back({std::move(plain), nullptr});
  return place->second;
}

raptor_term* Terms::term(TermNumber number) {
  if (number == unbound) return nullptr;
  Entry& entry = entries_[number];
  if (entry.term != nullptr) return entry.term.get();
  entry.term.reset(new_term(world_, entry.node));
  return entry.term.get();
}

std::size_t Variables::number_of(const rasqal_variable& variable) {
  const std::string name = reinterpret_cast<const char*>(variable.name);
  return number_of(variable.type == RASQAL_VARIABLE_TYPE_ANONYMOUS ? "_:" + name : name);
}

std::size_t Variables::number_of(const std::string& name) {
  return numbers_.try_emplace(name, numbers_.size()).first->second;
}

}  // namespace geminga::graph
