#include "ontology/loading/hierarchy.hpp"

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <utility>

namespace geminga::ontology {
namespace {

/// Collects text into large pieces.
class Writer {
 public:
  explicit Writer(const Sink& sink) : sink_(sink) {}
  bool line(std::string_view a, std::string_view separator, std::string_view b) {
    buffer_.append(a).append(separator).append(b) += '\n';
    return buffer_.size() < 65536 || flush();
  }
  /// The next octets of a line that line() ends.
  std::string& open_line() { return buffer_; }
  bool flush() {
    const bool is_written = sink_(buffer_);
    buffer_.clear();
    return is_written;
  }

 private:
  const Sink& sink_;
  std::string buffer_;
};

template <typename Number>
std::vector<std::uint32_t> plain(const std::vector<Number>& numbers) {
  std::vector<std::uint32_t> result;
  result.reserve(numbers.size());
  for (const Number number : numbers) result.push_back(static_cast<std::uint32_t>(number));
  return result;
}

/// `names`, `top` and `bottom` are those of the taxonomy, of classes or of properties.
template <typename Taxonomy, typename Number>
Hierarchy hierarchy_of(const owl::Ontology& source, const Taxonomy& taxonomy, const std::vector<owl::NameId>& names,
                       Number top, Number bottom, bool is_consistent) {
  Hierarchy hierarchy;
  for (const owl::NameId name : names) hierarchy.iris.push_back(source.name(name));
  hierarchy.representative = plain(taxonomy.representative);
  hierarchy.parent_begin = taxonomy.parent_begin;
  hierarchy.parents = plain(taxonomy.parents);
  hierarchy.top = static_cast<std::uint32_t>(top);
  hierarchy.bottom = static_cast<std::uint32_t>(bottom);
  hierarchy.is_consistent = is_consistent;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members;
  members.reserve(hierarchy.iris.size());
  for (std::uint32_t number = 0; number < hierarchy.iris.size(); ++number)
    members.emplace_back(hierarchy.representative[number], number);
  hierarchy.members = base::Rows<std::uint32_t>(hierarchy.iris.size(), members);
  return hierarchy;
}

}  // namespace

Hierarchy class_hierarchy(const owl::Ontology& source, const taxonomy::Classification& classification) {
  return hierarchy_of(source, classification, classification.classes, classification.thing, classification.nothing,
                      classification.is_consistent);
}

Hierarchy property_hierarchy(const owl::Ontology& source, const taxonomy::PropertyTaxonomy& taxonomy,
                             bool is_consistent) {
  return hierarchy_of(source, taxonomy, taxonomy.properties, taxonomy.top, taxonomy.bottom, is_consistent);
}

base::Rows<std::uint32_t> children_of(const Hierarchy& hierarchy) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(hierarchy.parents.size());
  for (std::uint32_t number = 0; number < hierarchy.iris.size(); ++number) {
    for (const std::uint32_t parent : hierarchy.parents_of(number)) edges.emplace_back(parent, number);
  }
  return {hierarchy.iris.size(), edges};
}

// Both walks keep a stack of their own instead of recursing: a taxonomy can be deep.
bool write_closure(const Hierarchy& hierarchy, const Sink& sink) {
  Writer writer(sink);
  std::vector<std::uint32_t> seen(hierarchy.iris.size(), 0);
  std::vector<std::uint32_t> stack;
  std::vector<std::uint32_t> supers;
  for (std::uint32_t sub = 0; sub < hierarchy.iris.size(); ++sub) {
    if (sub == hierarchy.bottom) continue;
    if (hierarchy.is_empty(sub)) {
      if (!writer.line(hierarchy.iris[sub], "\t", hierarchy.iris[hierarchy.bottom])) return false;
      continue;
    }
    supers.clear();
    const auto visit = [&](std::uint32_t node) {
      if (std::exchange(seen[node], sub + 1) != sub + 1) stack.push_back(node);
    };
    visit(hierarchy.representative[sub]);
    visit(hierarchy.representative[hierarchy.top]);
    while (!stack.empty()) {
      const std::uint32_t node = stack.back();
      stack.pop_back();
      for (const std::uint32_t member : hierarchy.members[node]) {
        if (member != sub && member != hierarchy.top) supers.push_back(member);
      }
      for (const std::uint32_t parent : hierarchy.parents_of(node)) visit(parent);
    }
    std::ranges::sort(supers);  // numbers ascend with the IRIs
    for (const std::uint32_t super : supers) {
      if (!writer.line(hierarchy.iris[sub], "\t", hierarchy.iris[super])) return false;
    }
  }
  return writer.flush();
}

bool write_tree(const Hierarchy& hierarchy, const std::function<std::string(std::string_view)>& short_name,
                const Sink& sink) {
  Writer writer(sink);
  const base::Rows<std::uint32_t> children = children_of(hierarchy);
  const auto add_names = [&](std::uint32_t node) {
    std::string_view separator;
    for (const std::uint32_t member : hierarchy.members[node]) {
      writer.open_line().append(separator).append(short_name(hierarchy.iris[member]));
      separator = " = ";
    }
  };
  const std::uint32_t bottom = hierarchy.representative[hierarchy.bottom];
  std::vector<bool> is_written(hierarchy.iris.size(), false);
  std::vector<std::pair<std::uint32_t, std::size_t>> stack{{hierarchy.representative[hierarchy.top], 0}};
  while (!stack.empty()) {
    const auto [node, level] = stack.back();
    stack.pop_back();
    const bool is_repeated = is_written[node] && !children[node].empty();
    is_written[node] = true;
    writer.open_line().append(level * 2, ' ');
    add_names(node);
    if (!writer.line(is_repeated ? " ..." : "", "", "")) return false;
    if (is_repeated) continue;
    for (const std::uint32_t child : children[node] | std::views::reverse) {
      if (child == bottom) continue;
      __builtin_prefetch(hierarchy.iris[child].data());  // the names lie all over the memory
      stack.emplace_back(child, level + 1);
    }
  }
  // Where everything is empty, the node of the bottom is that of the top.
  const bool is_left = hierarchy.members[bottom].size() > 1 && !is_written[bottom];
  if (is_left) {
    add_names(bottom);
    if (!writer.line("", "", "")) return false;
  }
  return writer.flush();
}

}  // namespace geminga::ontology
