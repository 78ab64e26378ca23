// The graph of property inclusions. Legend: P Q properties, P- the inverse, P < Q "P SubPropertyOf Q", P o Q a chain.
#include "reasoning/taxonomy/property_taxonomy.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/interner.hpp"
#include "base/rows.hpp"
#include "reasoning/taxonomy/reduction.hpp"

namespace geminga::taxonomy {
namespace {

/// The limit of steps down from members of disjointness axioms. Beyond it the search for empty properties ends.
constexpr std::size_t max_disjointness_steps = std::size_t{1} << 26;

/// One classification of properties. A node is a property (2 * number) or its inverse (2 * number + 1). Data properties
/// do not use the odd numbers.
class PropertyGraph {
 public:
  PropertyGraph(const owl::Ontology& source, PropertyKind kind, bool is_consistent)
      : source_(source), is_object_(kind == PropertyKind::object), number_of_term_(source.term_count(), none) {
    graph_.is_consistent = is_consistent;
  }

  PropertyTaxonomy run() {
    find_properties();
    up_.resize(graph_.node_count);
    graph_.is_empty.assign(graph_.node_count, false);
    graph_.is_empty[node(bottom_)] = true;
    graph_.is_empty[node(bottom_) + 1] = true;
    graph_.top = node(top_);
    include(graph_.top, graph_.top + 1);
    is_reflexive_.assign(graph_.node_count, false);
    for (std::uint32_t axiom = 0; axiom < source_.axiom_count(); ++axiom) read(source_.axiom(axiom));
    if (is_object_) spread_reflexivity();
    for (std::uint32_t sub = 0; sub < graph_.node_count; ++sub) {
      for (const std::uint32_t super : up_[sub]) graph_.edges.emplace_back(sub, super);
    }
    find_disjoint();
    return finish();
  }

 private:
  static constexpr std::uint32_t none = base::NumberTable::none;
  struct Chain {
    std::vector<std::uint32_t> links;
    std::uint32_t result = 0;
    std::size_t waiting = 0;  ///< how many links are not known to be reflexive
  };

  void find_properties();
  void read(const owl::Axiom& axiom);
  void read_inclusion(owl::TermId sub, owl::TermId super);
  void include(std::uint32_t sub, std::uint32_t super);
  void set_reflexive(std::uint32_t at);
  void shorten(const Chain& chain);
  void spread_reflexivity();
  void find_disjoint();
  PropertyTaxonomy finish();

  [[nodiscard]] static std::uint32_t node(std::uint32_t property) { return 2 * property; }
  [[nodiscard]] std::uint32_t node(owl::TermId term) const {
    if (source_.kind(term) == owl::TermKind::object_inverse_of) return node(source_.term(term).arguments[0]) ^ 1;
    return node(number_of_term_[static_cast<std::size_t>(term)]);
  }

  const owl::Ontology& source_;
  bool is_object_;
  std::vector<std::uint32_t> number_of_term_;
  std::vector<owl::NameId> properties_;
  std::uint32_t top_ = 0;
  std::uint32_t bottom_ = 0;
  Inclusions graph_;
  std::vector<std::vector<std::uint32_t>> up_;
  std::vector<bool> is_reflexive_;
  std::vector<std::uint32_t> newly_reflexive_;
  std::vector<Chain> chains_;
  std::vector<std::vector<std::uint32_t>> disjoint_;
};

void PropertyGraph::find_properties() {
  std::vector<bool> is_used(source_.term_count(), false);
  for (std::size_t axiom = 0; axiom < source_.axiom_count(); ++axiom) {
    for (const owl::TermId argument : source_.axiom(axiom).arguments)
      is_used[static_cast<std::size_t>(argument)] = true;
  }
  const owl::TermKind wanted = is_object_ ? owl::TermKind::object_property : owl::TermKind::data_property;
  const std::string_view top = is_object_ ? owl::owl_top_object_property : owl::owl_top_data_property;
  const std::string_view bottom = is_object_ ? owl::owl_bottom_object_property : owl::owl_bottom_data_property;
  std::vector<std::pair<std::string_view, std::uint32_t>> named;
  bool has_top = false;
  bool has_bottom = false;
  // A term has a greater number than its arguments, so that one pass downwards finds all terms that are used.
  for (auto id = static_cast<std::uint32_t>(source_.term_count()); id-- > 0;) {
    if (!is_used[id]) continue;
    const owl::Term term = source_.term(owl::TermId{id});
    for (const owl::TermId argument : term.arguments) is_used[static_cast<std::size_t>(argument)] = true;
    if (term.kind != wanted) continue;
    named.emplace_back(source_.name(term.name), id);
    has_top |= named.back().first == top;
    has_bottom |= named.back().first == bottom;
  }
  if (!has_top) named.emplace_back(top, none);
  if (!has_bottom) named.emplace_back(bottom, none);
  std::ranges::sort(named);
  for (const auto& [iri, term] : named) {
    const auto number = static_cast<std::uint32_t>(properties_.size());
    if (iri == top) top_ = number;
    if (iri == bottom) bottom_ = number;
    properties_.push_back(*source_.find_name(iri));  // every source knows the names of top and bottom
    if (term != none) number_of_term_[term] = number;
  }
  graph_.node_count = static_cast<std::uint32_t>(2 * properties_.size());
}

//  P < Q
//  -------
//  P- < Q-
void PropertyGraph::include(std::uint32_t sub, std::uint32_t super) {
  up_[sub].push_back(super);
  if (is_object_) up_[sub ^ 1].push_back(super ^ 1);
}

void PropertyGraph::read_inclusion(owl::TermId sub, owl::TermId super) {
  if (source_.kind(sub) != owl::TermKind::object_property_chain) return include(node(sub), node(super));
  Chain chain;
  for (const owl::TermId link : source_.term(sub).arguments) chain.links.push_back(node(link));
  chain.result = node(super);
  chain.waiting = chain.links.size();
  if (chain.waiting == 1) return include(chain.links.front(), chain.result);
  chains_.push_back(std::move(chain));
}

void PropertyGraph::read(const owl::Axiom& axiom) {
  const auto arguments = axiom.arguments;
  const auto is_nothing = [&](owl::TermId term) {
    return source_.kind(term) == owl::TermKind::named_class && source_.name_of(term) == owl::owl_nothing;
  };
  switch (axiom.kind) {
    case owl::AxiomKind::sub_object_property_of:
      if (is_object_) read_inclusion(arguments[0], arguments[1]);
      return;
    case owl::AxiomKind::sub_data_property_of:
      if (!is_object_) include(node(arguments[0]), node(arguments[1]));
      return;
    case owl::AxiomKind::equivalent_object_properties:
    case owl::AxiomKind::equivalent_data_properties:
      if (is_object_ != (axiom.kind == owl::AxiomKind::equivalent_object_properties)) return;
      for (const owl::TermId other : arguments.subspan(1)) {
        include(node(arguments[0]), node(other));
        include(node(other), node(arguments[0]));
      }
      return;
    case owl::AxiomKind::inverse_object_properties:
      //  P and Q inverse of each other: P < Q-, Q- < P
      if (!is_object_) return;
      include(node(arguments[0]), node(arguments[1]) ^ 1);
      include(node(arguments[1]) ^ 1, node(arguments[0]));
      return;
    case owl::AxiomKind::symmetric_object_property:
      if (is_object_) include(node(arguments[0]), node(arguments[0]) ^ 1);
      return;
    case owl::AxiomKind::reflexive_object_property:
      if (is_object_) set_reflexive(node(arguments[0]));
      return;
    case owl::AxiomKind::asymmetric_object_property:
      if (is_object_) disjoint_.push_back({node(arguments[0]), node(arguments[0]) ^ 1});
      return;
    case owl::AxiomKind::disjoint_object_properties:
    case owl::AxiomKind::disjoint_data_properties: {
      if (is_object_ != (axiom.kind == owl::AxiomKind::disjoint_object_properties)) return;
      std::vector<std::uint32_t>& members = disjoint_.emplace_back();
      for (const owl::TermId member : arguments) members.push_back(node(member));
      return;
    }
    case owl::AxiomKind::object_property_domain:
    case owl::AxiomKind::object_property_range:
    case owl::AxiomKind::data_property_domain: {
      if (is_object_ == (axiom.kind == owl::AxiomKind::data_property_domain) || !is_nothing(arguments[1])) return;
      graph_.is_empty[node(arguments[0])] = true;
      graph_.is_empty[node(arguments[0]) ^ 1] = true;
      return;
    }
    default:
      return;
  }
}

void PropertyGraph::set_reflexive(std::uint32_t at) {
  for (const std::uint32_t one : {at, at ^ 1}) {
    if (is_reflexive_[one]) continue;
    is_reflexive_[one] = true;
    newly_reflexive_.push_back(one);
  }
}

//  P1 o ... o Pn < Q   all but Pi reflexive      P1 o ... o Pn < Q   all reflexive
//  ----------------------------------------      ---------------------------------
//  Pi < Q                                        Q reflexive
void PropertyGraph::shorten(const Chain& chain) {
  for (const std::uint32_t link : chain.links) {
    if (chain.waiting == 0 || !is_reflexive_[link]) include(link, chain.result);
  }
  if (chain.waiting == 0) set_reflexive(chain.result);
}

//  P reflexive   P < Q
//  -------------------
//  Q reflexive
void PropertyGraph::spread_reflexivity() {
  set_reflexive(graph_.top);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> uses;
  for (std::uint32_t chain = 0; chain < chains_.size(); ++chain) {
    for (const std::uint32_t link : chains_[chain].links) {
      uses.emplace_back(link, chain);
      uses.emplace_back(link ^ 1, chain);
    }
  }
  const base::Rows<std::uint32_t> chains_of(graph_.node_count, uses);
  while (!newly_reflexive_.empty()) {
    const std::uint32_t at = newly_reflexive_.back();
    newly_reflexive_.pop_back();
    for (const std::uint32_t super : up_[at]) set_reflexive(super);
    if (at % 2 != 0) continue;  // a property and its inverse come together: each link of a chain is counted once
    for (const std::uint32_t chain : chains_of[at]) {
      if (--chains_[chain].waiting > 1) continue;
      shorten(chains_[chain]);
    }
    // Edges that shorten() adds below properties that are known to be reflexive.
  }
}

//  P < Q   P < Q'
//  -------------- [Q and Q' are different members of a disjointness axiom]
//  P is empty
void PropertyGraph::find_disjoint() {
  if (disjoint_.empty()) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> turned;
  for (const auto& [sub, super] : graph_.edges) turned.emplace_back(super, sub);
  const base::Rows<std::uint32_t> down(graph_.node_count, turned);
  std::vector<std::uint32_t> axiom_of(graph_.node_count, none);   // the last axiom that reached it
  std::vector<std::uint32_t> member_of(graph_.node_count, none);  // by way of this member
  std::size_t steps = 0;
  std::vector<std::uint32_t> stack;
  for (std::uint32_t axiom = 0; axiom < disjoint_.size(); ++axiom) {
    for (std::uint32_t member = 0; member < disjoint_[axiom].size(); ++member) {
      stack.assign(1, disjoint_[axiom][member]);
      while (!stack.empty()) {
        const std::uint32_t at = stack.back();
        stack.pop_back();
        if (++steps > max_disjointness_steps) return;
        if (axiom_of[at] == axiom && member_of[at] == member) continue;
        if (axiom_of[at] == axiom) {
          graph_.is_empty[at] = true;
          graph_.is_empty[at ^ 1] = true;
          continue;  // everything below is empty with it
        }
        axiom_of[at] = axiom;
        member_of[at] = member;
        for (const std::uint32_t below : down[at]) stack.push_back(below);
      }
    }
  }
}

PropertyTaxonomy PropertyGraph::finish() {
  PropertyTaxonomy taxonomy;
  taxonomy.properties = properties_;
  taxonomy.top = PropertyNumber{top_};
  taxonomy.bottom = PropertyNumber{bottom_};
  for (std::uint32_t number = 0; number < properties_.size(); ++number) graph_.node_of.push_back(node(number));
  graph_.top_entity = top_;
  graph_.bottom_entity = bottom_;
  Reduced reduced = reduce(std::move(graph_));
  taxonomy.parent_begin = std::move(reduced.parent_begin);
  for (const std::uint32_t number : reduced.representative) taxonomy.representative.push_back(PropertyNumber{number});
  for (const std::uint32_t number : reduced.parents) taxonomy.parents.push_back(PropertyNumber{number});
  return taxonomy;
}

}  // namespace

PropertyTaxonomy classify_properties(const owl::Ontology& source, PropertyKind kind, bool is_consistent) {
  return PropertyGraph(source, kind, is_consistent).run();
}

}  // namespace geminga::taxonomy
