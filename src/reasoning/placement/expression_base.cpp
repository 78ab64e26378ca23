// Axioms and taxonomy are saturated once; then come the tables that lead downwards.
#include "reasoning/placement/expression_base.hpp"

#include <algorithm>

#include "base/hash.hpp"
#include "base/sorted.hpp"
#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/normaliser/rule_normaliser.hpp"
#include "reasoning/owl/construct.hpp"
#include "reasoning/owl/literal_value.hpp"

namespace geminga::placement {
namespace {

constexpr std::size_t max_pairs = std::size_t{1} << 26;  // of one closure before saturation

bool has_expression(owl::TermKind kind) {
  return is_class_expression(kind) || is_data_range(kind) || is_individual(kind) || kind == owl::TermKind::literal;
}

}  // namespace

std::expected<std::unique_ptr<const ExpressionBase>, ExpressionError> ExpressionBase::build(
    const compiled::Ontology& ontology, const ExpressionLimits& limits) {
  const taxonomy::ClassifiedView& view = ontology.axioms();
  if (const auto whole = ontology.check_axioms(); !whole) return std::unexpected(ExpressionError{whole.error().text});
  if (!view.is_consistent) {
    return std::unexpected(ExpressionError{"the ontology is inconsistent: every class is below every other"});
  }
  if (view.axiom_count() > limits.axioms) {
    return std::unexpected(ExpressionError{"the ontology has " + std::to_string(view.axiom_count()) +
                                           " axioms, and class expressions are " + "possible with at most " +
                                           std::to_string(limits.axioms) + ": name a class instead"});
  }
  std::unique_ptr<ExpressionBase> base(new ExpressionBase(view, limits));
  base->copy_axioms();
  base->add_taxonomy();
  base->name_properties();
  if (base->source_.problem()) return std::unexpected(ExpressionError{*base->source_.problem()});
  base->index_terms();
  if (auto error = base->saturate()) return std::unexpected(std::move(*error));
  base->find_classes();
  base->find_edges_down();
  base->find_conditional();
  base->find_data();
  return base;
}

// The arguments of a term stand before it, so that one pass copies all terms.
void ExpressionBase::copy_axioms() {
  const owl::FileId file = source_.add_file("");
  std::vector<owl::TermId> terms;
  std::vector<owl::TermId> arguments;
  const auto take = [&](taxonomy::ClassifiedView::Numbers numbers) {
    arguments.clear();
    for (const std::uint32_t argument : numbers) arguments.push_back(terms[argument]);
  };
  for (std::uint32_t term = 0; term < view_.term_count(); ++term) {
    take(view_.arguments_of_term(term));
    terms.push_back(
        source_.copy(view_.kind_of_term(term), view_.name_of_term(term), view_.number_of_term(term), arguments));
  }
  for (std::uint32_t axiom = 0; axiom < view_.axiom_count(); ++axiom) {
    take(view_.arguments_of_axiom(axiom));
    source_.add(view_.kind_of_axiom(axiom), arguments, file, 0);
  }
}

void ExpressionBase::add_taxonomy() {
  const auto term_of = [&](std::uint32_t number) { return source_.named_class(view_.class_iri(number)); };
  for (std::uint32_t number = 0; number < view_.class_count(); ++number) {
    const std::uint32_t node = view_.representative[number];
    const owl::TermId term = term_of(number);
    if (node == view_.representative[view_.nothing]) {
      if (number != view_.nothing)
        source_.add(owl::AxiomKind::sub_class_of, {term, owl::nothing_term}, owl::FileId{0}, 0);
    } else if (node != number) {
      source_.add(owl::AxiomKind::equivalent_classes, {term, term_of(node)}, owl::FileId{0}, 0);
    } else {
      for (const std::uint32_t parent : view_.parents_of(number)) {
        if (parent != view_.thing)
          source_.add(owl::AxiomKind::sub_class_of, {term, term_of(parent)}, owl::FileId{0}, 0);
      }
    }
  }
}

// The role of a property is read off the expression of `property some everything`.
void ExpressionBase::name_properties() {
  const owl::TermId literal = source_.datatype("http://www.w3.org/2000/01/rdf-schema#Literal");
  const std::size_t count = source_.term_count();
  for (std::uint32_t id = 0; id < count; ++id) {
    const owl::TermId term{id};
    if (source_.kind(term) == owl::TermKind::object_property) {
      properties_.emplace_back(term, source_.term(owl::TermKind::object_some_values_from, {term, owl::thing_term}));
    } else if (source_.kind(term) == owl::TermKind::data_property) {
      properties_.emplace_back(term, source_.term(owl::TermKind::data_some_values_from, {term, literal}));
    }
  }
}

std::uint64_t ExpressionBase::hash_of(owl::TermKind kind, owl::NameId name, std::uint32_t number_of_term,
                                      std::span<const owl::TermId> arguments) const {
  std::uint64_t hash = base::hash64(base::octets_of(arguments), static_cast<std::uint64_t>(kind));
  hash = (hash ^ static_cast<std::uint64_t>(name)) * 0x9e3779b97f4a7c15ULL;
  return (hash ^ number_of_term) * 0x9e3779b97f4a7c15ULL >> 7;
}

void ExpressionBase::index_terms() {
  const auto hash = [&](std::uint32_t id) {
    const owl::Term term = source_.term(owl::TermId{id});
    return hash_of(term.kind, term.name, term.number, term.arguments);
  };
  for (std::uint32_t id = 0; id < source_.term_count(); ++id) term_table_.insert(hash(id), id);
}

std::optional<owl::TermId> ExpressionBase::find_term(owl::TermKind kind, std::string_view name,
                                                     std::uint32_t number_of_term,
                                                     std::span<const owl::TermId> arguments) const {
  const std::optional<owl::NameId> name_id = source_.find_name(name);
  if (!name_id) return std::nullopt;
  const std::uint32_t found =
      term_table_.find(hash_of(kind, *name_id, number_of_term, arguments), [&](std::uint32_t id) {
        const owl::Term term = source_.term(owl::TermId{id});
        return term.kind == kind && term.name == *name_id && term.number == number_of_term &&
               std::ranges::equal(term.arguments, arguments);
      });
  if (found == base::NumberTable::none) return std::nullopt;
  return owl::TermId{found};
}

std::optional<ExpressionError> ExpressionBase::saturate() {
  el::IndexBuilder builder;
  el::RuleNormaliser normaliser(source_, builder);
  std::vector<std::string> unused;
  const auto note = [&](owl::Construct construct) {
    if (construct != owl::Construct::none) unused.emplace_back(to_string(construct));
  };
  for (std::uint32_t axiom = 0; axiom < source_.axiom_count(); ++axiom) note(normaliser.add(axiom));
  exprs_.assign(source_.term_count(), el::top_expr);
  for (std::uint32_t id = 0; id < source_.term_count(); ++id) {
    if (has_expression(source_.kind(owl::TermId{id}))) exprs_[id] = normaliser.expression(owl::TermId{id});
  }
  for (const auto& [axiom, construct] : normaliser.finish()) note(construct);
  base::sort_unique(unused);
  gaps_ = std::move(unused);
  builder.keep_link_targets();
  auto index = builder.finish(max_pairs);
  if (!index) return ExpressionError{"the ontology is too large for class expressions"};
  index_ = std::move(*index);
  for (const auto& [property, some] : properties_) {
    // `bottom property some everything` is an existential, too, and an axiom says that it is empty.
    exprs_[static_cast<std::size_t>(property)] = el::ExprId{index_.expr(exprs_[static_cast<std::size_t>(some)]).first};
  }
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    if (has_expression(source_.kind(owl::TermId{id}))) exprs_[id] = index_.representative(exprs_[id]);
  }
  saturation_ = std::make_unique<el::Saturation>(index_, limits_.conclusions);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    const owl::TermKind kind = source_.kind(owl::TermId{id});
    if (kind == owl::TermKind::named_class || is_individual(kind)) saturation_->require(exprs_[id]);
  }
  for (std::uint32_t role = 0; role < index_.roles().count(); ++role) {
    saturation_->require(index_.representative(index_.range_of(el::RoleId{role})));
  }
  if (!saturation_->run()) return ExpressionError{"too much follows from the ontology for class expressions"};
  if (!saturation_->is_consistent()) return ExpressionError{"the ontology is inconsistent"};
  return std::nullopt;
}

void ExpressionBase::find_classes() {
  std::vector<std::pair<std::uint32_t, taxonomy::ClassNumber>> pairs;
  for (std::uint32_t number_of_class = 0; number_of_class < view_.class_count(); ++number_of_class) {
    if (view_.representative[number_of_class] != number_of_class) continue;
    const auto term = find_term(owl::TermKind::named_class, view_.class_iri(number_of_class), 0, {});
    const el::ExprId class_expr = term ? expr(*term) : el::top_expr;  // add_taxonomy() has named each
    pairs.emplace_back(number(class_expr), taxonomy::ClassNumber{number_of_class});
  }
  classes_of_ = base::Rows<taxonomy::ClassNumber>(index_.size(), pairs);
}

void ExpressionBase::find_edges_down() {
  const auto size = static_cast<std::uint32_t>(index_.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t id = 0; id < size; ++id) {
    if (!index_.is_atom(el::ExprId{id}) || index_.representative(el::ExprId{id}) != el::ExprId{id}) continue;
    for (const el::ExprId above : index_.told_atoms(el::ExprId{id})) edges.emplace_back(number(above), id);
  }
  for (std::uint32_t at = 0; at < context_count(); ++at) {
    const el::Context& here = context(at);
    if (here.is_unsatisfiable) unsatisfiable_.push_back(at);
    // The conclusions about an atom's context hold for the atom and for all atoms below it.
    const bool is_of_one = together_of(at).empty();
    const std::uint32_t sub = is_of_one ? number(here.root) : size + at;
    for (const el::ExprId above : derived_of(at)) edges.emplace_back(number(above), sub);
    if (is_of_one) edges.emplace_back(sub, size + at);
    for (const el::ExprId atom : together_of(at)) edges.emplace_back(number(atom), size + at);
  }
  down_ = base::Rows<std::uint32_t>(size, edges);
  down_.sort_unique();
}

// Walks backwards from the contexts that are below an individual and may be empty.
void ExpressionBase::find_conditional() {
  is_conditional_.assign(context_count(), false);
  if (!index_.has_nominals()) return;
  std::vector<std::uint32_t> stack;
  for (std::uint32_t at = 0; at < context_count(); ++at) {
    const el::Context& here = context(at);
    if (!here.is_nonempty && !here.is_unsatisfiable && !here.nominals.empty()) stack.push_back(at);
  }
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    stack.pop_back();
    if (is_conditional_[at] || context(at).is_nonempty) continue;
    is_conditional_[at] = true;
    has_conditional_ = true;
    for (const el::Link link : backward_of(at)) stack.push_back(link.context);
  }
}

void ExpressionBase::find_data() {
  for (std::uint32_t id = 0; id < source_.term_count(); ++id) {
    const owl::Term term = source_.term(owl::TermId{id});
    if (term.kind == owl::TermKind::datatype) {
      if (const auto type = owl::Datatype::find(source_.name(term.name))) datatypes_.emplace_back(*type, exprs_[id]);
    } else if (term.kind == owl::TermKind::literal) {
      auto value = value_of(source_, term);
      if (!value) continue;
      expr_of_value_.emplace(std::pair(value->family, value->canonical), exprs_[id]);
      values_.emplace_back(std::move(*value), exprs_[id]);
    }
  }
}

std::optional<el::ExprId> ExpressionBase::find_value(const owl::DataValue& value) const {
  const auto found = expr_of_value_.find({value.family, value.canonical});
  if (found == expr_of_value_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::uint32_t> ExpressionBase::contexts_below(el::ExprId atom) const {
  const auto size = static_cast<std::uint32_t>(index_.size());
  std::vector<std::uint32_t> found;
  std::vector<bool> seen(size, false);
  std::vector<std::uint32_t> stack = {number(atom)};
  seen[number(atom)] = true;
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    stack.pop_back();
    for (const std::uint32_t below : down_[at]) {
      if (below >= size) {
        found.push_back(below - size);
      } else if (!seen[below]) {
        seen[below] = true;
        stack.push_back(below);
      }
    }
  }
  // A subsumer of owl:Thing is above everything, but no edge says so.
  if (seen[number(index_.representative(el::top_expr))]) {
    found.resize(context_count());
    for (std::uint32_t at = 0; at < found.size(); ++at) found[at] = at;
    return found;
  }
  found.insert(found.end(), unsatisfiable_.begin(), unsatisfiable_.end());
  base::sort_unique(found);
  return found;
}

}  // namespace geminga::placement
