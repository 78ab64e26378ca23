// Walks up for the closure and down for the tree, with stacks of its own: a taxonomy can be deep.
#include "closure.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "knowledge.hpp"

namespace geminga::ontology {
namespace {

std::size_t index_of(el::ClassNumber number) { return static_cast<std::size_t>(number); }

/// Collects text into large pieces.
class Writer {
 public:
  explicit Writer(const Sink& sink) : sink_(sink) {}
  bool line(std::string_view a, std::string_view separator, std::string_view b) {
    buffer_.append(a).append(separator).append(b) += '\n';
    return buffer_.size() < 65536 || flush();
  }
  bool flush() {
    const bool is_written = sink_(buffer_);
    buffer_.clear();
    return is_written;
  }

 private:
  const Sink& sink_;
  std::string buffer_;
};

}  // namespace

std::vector<std::vector<el::ClassNumber>> equivalents(const el::Classification& classification) {
  std::vector<std::vector<el::ClassNumber>> members(classification.class_count());
  for (std::uint32_t number = 0; number < classification.class_count(); ++number)
    members[index_of(classification.representative[number])].push_back(el::ClassNumber{number});
  return members;
}

bool write_closure(const el::OntologySource& source, const el::Classification& classification, const Sink& sink) {
  Writer writer(sink);
  const auto members = equivalents(classification);
  const auto iri = [&](el::ClassNumber number) { return source.name(classification.classes[index_of(number)]); };
  std::vector<std::uint32_t> seen(classification.class_count(), 0);
  std::vector<el::ClassNumber> stack;
  std::vector<el::ClassNumber> supers;
  for (std::uint32_t sub = 0; sub < classification.class_count(); ++sub) {
    const el::ClassNumber number{sub};
    if (number == classification.nothing) continue;
    if (is_unsatisfiable(classification, number)) {
      if (!writer.line(iri(number), "\t", el::owl_nothing)) return false;
      continue;
    }
    supers.clear();
    const auto visit = [&](el::ClassNumber node) {
      if (std::exchange(seen[index_of(node)], sub + 1) != sub + 1) stack.push_back(node);
    };
    visit(classification.representative[sub]);
    visit(classification.representative[index_of(classification.thing)]);
    while (!stack.empty()) {
      const el::ClassNumber node = stack.back();
      stack.pop_back();
      for (const el::ClassNumber member : members[index_of(node)]) {
        if (member != number && member != classification.thing) supers.push_back(member);
      }
      for (const el::ClassNumber parent : classification.parents_of(node)) visit(parent);
    }
    std::ranges::sort(supers);  // numbers ascend with the IRIs
    for (const el::ClassNumber super : supers) {
      if (!writer.line(iri(number), "\t", iri(super))) return false;
    }
  }
  return writer.flush();
}

bool write_tree(const el::Ontology& ontology, const el::Classification& classification, const Sink& sink) {
  Writer writer(sink);
  const auto members = equivalents(classification);
  std::vector<std::vector<el::ClassNumber>> children(classification.class_count());
  for (std::uint32_t number = 0; number < classification.class_count(); ++number) {
    for (const el::ClassNumber parent : classification.parents_of(el::ClassNumber{number}))
      children[index_of(parent)].push_back(el::ClassNumber{number});
  }
  const auto name_of = [&](el::ClassNumber node) {
    std::string name;
    for (const el::ClassNumber member : members[index_of(node)])
      name += (name.empty() ? "" : " = ") + ontology.short_name(member);
    return name;
  };
  const el::ClassNumber nothing = classification.representative[index_of(classification.nothing)];
  std::vector<bool> is_written(classification.class_count(), false);
  std::vector<std::pair<el::ClassNumber, std::size_t>> stack{
      {classification.representative[index_of(classification.thing)], 0}};
  while (!stack.empty()) {
    const auto [node, level] = stack.back();
    stack.pop_back();
    const bool is_repeated = is_written[index_of(node)] && !children[index_of(node)].empty();
    is_written[index_of(node)] = true;
    if (!writer.line(std::string(level * 2, ' ') + name_of(node), is_repeated ? " ..." : "", "")) return false;
    if (is_repeated) continue;
    const auto& below = children[index_of(node)];
    for (auto child = below.rbegin(); child != below.rend(); ++child) {
      if (*child != nothing) stack.emplace_back(*child, level + 1);
    }
  }
  if (members[index_of(nothing)].size() > 1 && !writer.line(name_of(nothing), "", "")) return false;
  return writer.flush();
}

}  // namespace geminga::ontology
