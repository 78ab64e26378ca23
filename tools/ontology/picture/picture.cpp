#include "ontology/picture/picture.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "base/sorted.hpp"
#include "base/text.hpp"

namespace geminga::ontology {
namespace {

using taxonomy::ClassNumber;

std::size_t index(ClassNumber number) { return static_cast<std::size_t>(number); }
std::string id_of(ClassNumber number) { return "c" + std::to_string(static_cast<std::uint32_t>(number)); }

/// The named classes that axioms state right above each class, alone or in a conjunction.
std::multimap<std::string_view, std::string_view> told_parents(const owl::Ontology& source) {
  std::multimap<std::string_view, std::string_view> parents;
  const auto tell = [&](owl::TermId sub, owl::TermId super) {
    if (source.kind(sub) != owl::TermKind::named_class) return;
    const owl::Term above = source.term(super);
    if (above.kind == owl::TermKind::named_class) parents.emplace(source.name_of(sub), source.name_of(super));
    if (above.kind != owl::TermKind::object_intersection_of) return;
    for (const owl::TermId part : above.arguments) {
      if (source.kind(part) == owl::TermKind::named_class) parents.emplace(source.name_of(sub), source.name_of(part));
    }
  };
  for (std::size_t at = 0; at < source.axiom_count(); ++at) {
    const owl::Axiom axiom = source.axiom(at);
    if (axiom.kind == owl::AxiomKind::sub_class_of) tell(axiom.arguments[0], axiom.arguments[1]);
    if (axiom.kind != owl::AxiomKind::equivalent_classes) continue;
    for (const owl::TermId one : axiom.arguments) {
      for (const owl::TermId other : axiom.arguments) {
        if (one != other) tell(one, other);
      }
    }
  }
  return parents;
}

class Drawing {
 public:
  Drawing(const owl::Ontology& source, const taxonomy::Classification& classification,
          const compiled::Ontology& ontology)
      : source_(source),
        classification_(classification),
        ontology_(ontology),
        members_(classification.class_count()),
        children_(classification.class_count()) {
    for (std::uint32_t number = 0; number < classification.class_count(); ++number) {
      const ClassNumber named{number};
      members_[index(node(named))].push_back(named);
      if (node(named) != named) continue;
      for (const ClassNumber parent : classification.parents_of(named)) children_[index(parent)].push_back(named);
    }
  }

  Picture draw(std::optional<ClassNumber> root, std::optional<unsigned> depth) {
    const ClassNumber thing = node(classification_.thing);
    choose(root ? node(*root) : thing, root.has_value() || members_[index(thing)].size() > 1, depth);
    Picture picture;
    for (const auto& [shown, level] : level_) {
      if (!drawn_.contains(shown)) continue;
      picture.push_back(box_of(shown));
      if (depth && level == *depth) hide_below(shown, picture);
    }
    add_unsatisfiable(root, picture);
    return picture;
  }

 private:
  [[nodiscard]] ClassNumber node(ClassNumber number) const { return classification_.representative[index(number)]; }
  [[nodiscard]] bool is_empty(ClassNumber number) const { return node(number) == node(classification_.nothing); }

  /// Finds the nodes to draw, breadth first, so that each node has the level of its shortest path.
  void choose(ClassNumber root, bool draws_root, std::optional<unsigned> depth) {
    if (is_empty(root)) return;
    std::vector<ClassNumber> layer = {root};
    level_[root] = 0;
    for (unsigned level = 0; !layer.empty(); ++level) {
      std::vector<ClassNumber> next;
      for (const ClassNumber at : layer) {
        if (level > 0 || draws_root) drawn_.insert(at);
        if (depth && level >= *depth) continue;
        for (const ClassNumber child : children_[index(at)]) {
          if (level_.emplace(child, level + 1).second) next.push_back(child);
        }
      }
      layer = std::move(next);
    }
  }

  [[nodiscard]] std::string name_of(ClassNumber number) const {
    const std::string_view label = ontology_.label(number);
    const std::string name = ontology_.short_name(number);
    return name.starts_with('<') && !label.empty() ? std::string(label) : name;
  }

  Box box_of(ClassNumber shown) {
    Box box;
    box.id = id_of(shown);
    for (const ClassNumber member : members_[index(shown)]) box.names.push_back(name_of(member));
    box.kind = box.names.size() > 1 ? BoxKind::several : BoxKind::one;
    for (const ClassNumber parent : classification_.parents_of(shown)) {
      if (drawn_.contains(parent)) box.parents.push_back(id_of(parent));
    }
    return box;
  }

  /// Adds a box that stands for all classes below this one that are not shown.
  void hide_below(ClassNumber shown, Picture& picture) {
    std::vector<bool> seen(classification_.class_count(), false);
    std::vector<ClassNumber> stack = {shown};
    std::size_t count = 0;
    while (!stack.empty()) {
      const ClassNumber at = stack.back();
      stack.pop_back();
      for (const ClassNumber child : children_[index(at)]) {
        if (seen[index(child)] || level_.contains(child)) continue;
        seen[index(child)] = true;
        count += members_[index(child)].size();
        stack.push_back(child);
      }
    }
    if (count > 0) picture.push_back({"below_" + id_of(shown), BoxKind::hidden, {}, count, {id_of(shown)}});
  }

  void add_unsatisfiable(std::optional<ClassNumber> root, Picture& picture) {
    if (!classification_.is_consistent) return;  // every class is unsatisfiable
    const auto told = told_parents(source_);
    std::vector<Box> boxes;
    for (const ClassNumber number : members_[index(node(classification_.nothing))]) {
      if (number == classification_.nothing) continue;
      Box box{id_of(number), BoxKind::unsatisfiable, {name_of(number)}, 0, {}};
      const auto [first, last] = told.equal_range(ontology_.iri(number));
      for (auto above = first; above != last; ++above) {
        const auto parent = ontology_.find_iri(above->second);
        if (!parent || *parent == number) continue;
        const ClassNumber drawn_as = is_empty(*parent) ? *parent : node(*parent);
        box.parents.push_back(id_of(drawn_as));
      }
      base::sort_unique(box.parents);
      boxes.push_back(std::move(box));
    }
    // One may stand below another. With a root, a box is shown only where one of its parents is.
    std::vector<bool> is_added(boxes.size(), false);
    const auto is_shown = [&](const std::string& id) {
      return std::ranges::find(picture, id, &Box::id) != picture.end();
    };
    for (bool has_grown = true; has_grown;) {
      has_grown = false;
      for (std::size_t at = 0; at < boxes.size(); ++at) {
        const bool is_root = root && boxes[at].id == id_of(*root);
        if (is_added[at] || (root && !is_root && std::ranges::none_of(boxes[at].parents, is_shown))) continue;
        is_added[at] = has_grown = true;
        picture.push_back(boxes[at]);
      }
    }
    for (Box& box : picture) std::erase_if(box.parents, [&](const std::string& id) { return !is_shown(id); });
  }

  const owl::Ontology& source_;
  const taxonomy::Classification& classification_;
  const compiled::Ontology& ontology_;
  std::vector<std::vector<ClassNumber>> members_;
  std::vector<std::vector<ClassNumber>> children_;
  std::map<ClassNumber, unsigned> level_;
  std::set<ClassNumber> drawn_;
};

}  // namespace

Picture make_picture(const owl::Ontology& source, const taxonomy::Classification& classification,
                     const compiled::Ontology& ontology, std::optional<ClassNumber> root,
                     std::optional<unsigned> depth) {
  return Drawing(source, classification, ontology).draw(root, depth);
}

Picture with_lists_of_leaves(Picture picture) {
  constexpr std::size_t least = 3;
  std::map<std::string, std::size_t> children;
  for (const Box& box : picture) {
    for (const std::string& parent : box.parents) ++children[parent];
  }
  const auto is_leaf = [&](const Box& box) {
    const bool is_plain = box.kind == BoxKind::one || box.kind == BoxKind::several;
    return is_plain && !box.parents.empty() && !children.contains(box.id);
  };
  std::map<std::string, std::size_t> leaves;  // by parent: the leaves in its list
  std::vector<bool> is_listed;
  for (const Box& box : picture) {
    is_listed.push_back(is_leaf(box));
    for (std::size_t at = 0; is_listed.back() && at < box.parents.size(); ++at) ++leaves[box.parents[at]];
  }
  // A leaf stands in the lists of all its parents or in none. Removing it from one list may make another too short.
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t at = 0; at < picture.size(); ++at) {
      const auto& parents = picture[at].parents;
      const auto is_short = [&](const std::string& parent) { return leaves[parent] < least; };
      if (!is_listed[at] || std::ranges::none_of(parents, is_short)) continue;
      is_listed[at] = false;
      has_changed = true;
      for (const std::string& parent : parents) --leaves[parent];
    }
  }
  std::map<std::string, std::size_t> lists;  // by parent: the index of its list
  Picture listed;
  for (std::size_t at = 0; at < picture.size(); ++at) {
    Box& box = picture[at];
    if (!is_listed[at]) {
      listed.push_back(std::move(box));
      continue;
    }
    const std::string name = base::joined(box.names, " = ");
    for (const std::string& parent : box.parents) {
      const auto [place, is_new] = lists.try_emplace(parent, listed.size());
      if (is_new) listed.push_back({"leaves_" + parent, BoxKind::leaves, {}, 0, {parent}});
      listed[place->second].names.push_back(name);
    }
  }
  return listed;
}

}  // namespace geminga::ontology
