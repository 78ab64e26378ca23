#include "cases/taxonomy.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>

namespace geminga::cases {
namespace {

/// Names, and the direct superclasses of each.
class Graph {
 public:
  std::size_t node(const std::string& name) {
    const auto [entry, is_new] = numbers_.try_emplace(name, names_.size());
    if (is_new) {
      names_.push_back(name);
      above_.emplace_back();
    }
    return entry->second;
  }
  void link(std::size_t sub, std::size_t super) { above_[sub].insert(super); }

  [[nodiscard]] std::set<std::size_t> all_above(std::size_t from) const {
    std::set<std::size_t> seen{from};
    for (std::vector<std::size_t> open{from}; !open.empty();) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const std::size_t next : above_[at]) {
        if (seen.insert(next).second) open.push_back(next);
      }
    }
    return seen;
  }

  Closure closure() {
    const std::size_t thing = node("Thing");
    const std::size_t nothing = node("Nothing");
    const std::set<std::size_t> everywhere = all_above(thing);
    if (everywhere.contains(nothing)) return {"inconsistent"};
    Closure lines;
    for (std::size_t sub = 0; sub < names_.size(); ++sub) {
      if (sub == nothing) continue;
      std::set<std::size_t> supers = all_above(sub);
      supers.insert(everywhere.begin(), everywhere.end());
      if (supers.contains(nothing)) {
        lines.push_back(names_[sub] + " < Nothing");
        continue;
      }
      for (const std::size_t super : supers) {
        if (super != sub && super != thing) lines.push_back(names_[sub] + " < " + names_[super]);
      }
    }
    std::ranges::sort(lines);
    return lines;
  }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> names_;
  std::vector<std::set<std::size_t>> above_;
};

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(separator);
    parts.emplace_back(text.substr(0, end));
    if (end != std::string_view::npos) text.remove_prefix(end + separator.size());
  }
  return parts;
}

std::string short_name(std::string_view iri) { return std::string(iri.substr(iri.find_last_of("#/") + 1)); }

std::size_t index_of(taxonomy::ClassNumber number) { return static_cast<std::size_t>(number); }

/// The representatives above one, itself included, by the edges of the taxonomy; `skipped` is left out as a first step.
std::set<taxonomy::ClassNumber> above(const taxonomy::Classification& taxonomy, taxonomy::ClassNumber from,
                                      std::optional<taxonomy::ClassNumber> skipped = {}) {
  std::set<taxonomy::ClassNumber> seen{from};
  for (std::vector<taxonomy::ClassNumber> open{from}; !open.empty();) {
    const taxonomy::ClassNumber at = open.back();
    open.pop_back();
    for (const taxonomy::ClassNumber next : taxonomy.parents_of(at)) {
      if (at == from && next == skipped) continue;
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  return seen;
}

}  // namespace

std::expected<Closure, std::string> read_tree(std::string_view text) {
  Graph graph;
  std::vector<std::size_t> ancestors;
  std::size_t number = 0;
  for (const std::string& line : split(text, "\n")) {
    ++number;
    if (line.empty() || line.starts_with('#')) continue;
    if (line == "inconsistent") return Closure{"inconsistent"};
    const std::size_t indent = line.find_first_not_of(' ');
    const std::size_t level = indent / 2;
    if (indent == std::string::npos || indent % 2 != 0 || level > ancestors.size()) {
      return std::unexpected("line " + std::to_string(number) + ": not two spaces deeper than the line above it");
    }
    std::vector<std::size_t> nodes;
    for (const std::string& name : split(std::string_view(line).substr(indent), " = ")) {
      if (name.empty() || name.find(' ') != std::string::npos) {
        return std::unexpected("line " + std::to_string(number) + ": no names separated by ` = `");
      }
      nodes.push_back(graph.node(name));
    }
    for (const std::size_t one : nodes) {
      for (const std::size_t other : nodes) graph.link(one, other);
    }
    ancestors.resize(level);
    if (!ancestors.empty()) graph.link(nodes.front(), ancestors.back());
    ancestors.push_back(nodes.front());
  }
  return graph.closure();
}

Closure closure_of(const owl::Ontology& source, const taxonomy::Classification& classification, bool are_short) {
  if (!classification.is_consistent) return {"inconsistent"};
  const auto name = [&](std::size_t number) {
    const std::string_view iri = source.name(classification.classes[number]);
    if (iri == owl::owl_thing) return std::string("Thing");
    if (iri == owl::owl_nothing) return std::string("Nothing");
    return are_short ? short_name(iri) : std::string(iri);
  };
  std::vector<std::vector<std::size_t>> members(classification.class_count());
  for (std::size_t at = 0; at < classification.class_count(); ++at)
    members[index_of(classification.representative[at])].push_back(at);
  const std::size_t thing = index_of(classification.thing);
  const std::size_t nothing = index_of(classification.nothing);
  Closure lines;
  for (std::size_t sub = 0; sub < classification.class_count(); ++sub) {
    if (sub == nothing) continue;
    const taxonomy::ClassNumber node = classification.representative[sub];
    if (node == classification.representative[nothing]) {
      lines.push_back(name(sub) + " < Nothing");
      continue;
    }
    std::set<taxonomy::ClassNumber> supers = above(classification, node);
    supers.insert(classification.representative[thing]);
    for (const taxonomy::ClassNumber super : supers) {
      for (const std::size_t member : members[index_of(super)]) {
        if (member != sub && member != thing) lines.push_back(name(sub) + " < " + name(member));
      }
    }
  }
  std::ranges::sort(lines);
  return lines;
}

std::vector<std::string> superfluous_edges(const owl::Ontology& source,
                                           const taxonomy::Classification& classification) {
  std::vector<std::string> found;
  for (std::uint32_t sub = 0; sub < classification.class_count(); ++sub) {
    for (const taxonomy::ClassNumber parent : classification.parents_of(taxonomy::ClassNumber{sub})) {
      if (!above(classification, taxonomy::ClassNumber{sub}, parent).contains(parent)) continue;
      found.push_back(std::string(source.name(classification.classes[sub])) + " < " +
                      std::string(source.name(classification.classes[index_of(parent)])));
    }
  }
  return found;
}

Closure closure_of_pairs(const std::vector<std::pair<std::string, std::string>>& pairs) {
  Graph graph;
  for (const auto& [sub, super] : pairs) graph.link(graph.node(sub), graph.node(super));
  return graph.closure();
}

Closure without(const Closure& lines, const Closure& others) {
  Closure rest;
  std::ranges::set_difference(lines, others, std::back_inserter(rest));
  return rest;
}

Closure unsound(const Closure& found, const Closure& expected) {
  if (expected == Closure{"inconsistent"}) return {};
  Closure rest = without(found, expected);
  std::erase_if(rest, [&](const std::string& line) {
    return std::ranges::binary_search(expected, line.substr(0, line.find(" < ")) + " < Nothing");
  });
  return rest;
}

}  // namespace geminga::cases
