// The classes above and below one expression are found, and then its place between them.
#include "reasoning/placement/expression_classifier.hpp"

#include <algorithm>

#include "reasoning/el/classify.hpp"
#include "reasoning/placement/expression_members.hpp"
#include "reasoning/placement/expression_overlay.hpp"
#include "reasoning/placement/expression_scratch.hpp"

namespace geminga::placement {
namespace {

/// Classes by number, for marking.
using Marks = std::vector<bool>;

/// One expression over a base.
class Question {
 public:
  Question(const ExpressionBase& base, const owl::Ontology& query)
      : base_(base), query_(query), shapes_(base, query), overlay_(base, shapes_) {}

  ExpressionPlace place(owl::TermId expression) {
    const ShapeId shape = shapes_.read(expression);
    const std::vector<std::uint32_t> alternatives = saturate(shape);
    // If individuals matter, the expression must be classified where it has an instance.
    if (overlay_.is_conditional() || base_.has_conditional()) {
      if (auto exact = place_by_scratch(base_, query_, expression)) return std::move(*exact);
      shapes_.add_gap("individuals");
    }
    ExpressionPlace place;
    Marks above(base_.view().class_count(), true);
    place.is_satisfiable = false;
    for (const std::uint32_t alternative : alternatives) {
      if (overlay_.is_unsatisfiable(alternative)) continue;
      place.is_satisfiable = true;
      const Marks found = classes_above(alternative);
      for (std::size_t at = 0; at < above.size(); ++at) above[at] = above[at] && found[at];
    }
    if (place.is_satisfiable) {
      fill(place, above, classes_below(shape));
      // An expression that is equivalent to a class has the place of that class.
      if (!place.equivalent) {
        note_gaps();
        place.gaps = gaps();
      }
    }
    return place;
  }

  bool is_subsumed(owl::TermId sub, owl::TermId super) {
    const ShapeId below = shapes_.read(sub);
    const ShapeId above = shapes_.read(super);
    const std::vector<std::uint32_t> alternatives = saturate(below);
    ExpressionMembers members(overlay_, shapes_, ExpressionMembers::Wanted::every_context);
    const Contexts& found = members.contexts_of(above);
    const bool holds = std::ranges::all_of(
        alternatives, [&](std::uint32_t alternative) { return std::ranges::binary_search(found, alternative); });
    if (!holds) note_gaps();
    if (!holds && overlay_.is_conditional()) shapes_.add_gap("individuals");
    return holds;
  }

  [[nodiscard]] std::vector<std::string> gaps() const { return {shapes_.gaps().begin(), shapes_.gaps().end()}; }

 private:
  /// The contexts of a shape's alternatives after all rules, including those of complements.
  std::vector<std::uint32_t> saturate(ShapeId shape) {
    std::vector<std::uint32_t> alternatives;
    for (const ShapeId alternative : shapes_.alternatives_of(shape)) {
      alternatives.push_back(overlay_.require(std::span(&alternative, 1)));
    }
    if (!overlay_.run()) shapes_.add_gap("too much work");
    while (refute()) {
    }
    return alternatives;
  }

  //  X < not C   X < C
  //  -----------------
  //  X < F
  bool refute() {
    const auto has_negations = [](const OverlayContext& context) {
      return !context.negations.empty() && !context.is_unsatisfiable;
    };
    if (std::ranges::none_of(overlay_.own(), has_negations)) return false;
    ExpressionMembers members(overlay_, shapes_, ExpressionMembers::Wanted::every_context);
    std::vector<std::uint32_t> refuted;
    for (std::uint32_t at = overlay_.base_count(); at < overlay_.context_count(); ++at) {
      const OverlayContext& context = overlay_.own()[at - overlay_.base_count()];
      if (!has_negations(context)) continue;
      const auto is_in = [&](ShapeId shape) { return std::ranges::binary_search(members.contexts_of(shape), at); };
      if (std::ranges::any_of(context.negations, is_in)) refuted.push_back(at);
    }
    for (const std::uint32_t context : refuted) overlay_.add_bottom(context);
    return !refuted.empty();
  }

  Marks classes_above(std::uint32_t context) const {
    Marks marks(base_.view().class_count(), false);
    for (const el::ExprId atom : overlay_.atoms_above(context)) {
      for (const taxonomy::ClassNumber number : base_.classes_of(atom)) marks[static_cast<std::size_t>(number)] = true;
    }
    return marks;
  }

  Marks classes_below(ShapeId shape) {
    Marks marks(base_.view().class_count(), false);
    ExpressionMembers members(overlay_, shapes_, ExpressionMembers::Wanted::named_classes);
    for (const std::uint32_t context : members.contexts_of(shape)) {
      if (context >= base_.context_count()) break;
      if (overlay_.is_unsatisfiable(context) || !base_.together_of(context).empty()) continue;
      for (const taxonomy::ClassNumber number : base_.classes_of(base_.context(context).root)) {
        marks[static_cast<std::size_t>(number)] = true;
      }
    }
    return marks;
  }

  /// Takes the lowest classes above, which reach up to owl:Thing, and the highest classes below.
  void fill(ExpressionPlace& place, const Marks& above, const Marks& below) const {
    const taxonomy::ClassifiedView& view = base_.view();
    for (std::uint32_t number = 0; number < view.class_count() && !place.equivalent; ++number) {
      if (view.representative[number] == number && above[number] && below[number]) {
        place.equivalent = taxonomy::ClassNumber{number};
      }
    }
    Marks has_lower(view.class_count(), false);
    for (std::uint32_t number = 0; number < view.class_count(); ++number) {
      if (view.representative[number] != number || !above[number]) continue;
      for (const std::uint32_t parent : view.parents_of(number)) has_lower[parent] = true;
    }
    const auto is_under_one = [&](std::uint32_t number) {
      return std::ranges::any_of(view.parents_of(number), [&](std::uint32_t parent) { return below[parent]; });
    };
    for (std::uint32_t number = 0; number < view.class_count(); ++number) {
      if (view.representative[number] != number) continue;
      if (above[number] && !has_lower[number] && !place.equivalent)
        place.parents.push_back(taxonomy::ClassNumber{number});
      if (below[number] && !is_under_one(number) && !place.equivalent)
        place.children.push_back(taxonomy::ClassNumber{number});
    }
    if (!place.equivalent) return;
    const auto node = static_cast<std::uint32_t>(*place.equivalent);
    for (const std::uint32_t parent : view.parents_of(node)) place.parents.push_back(taxonomy::ClassNumber{parent});
    for (const std::uint32_t child : view.children_of(node)) place.children.push_back(taxonomy::ClassNumber{child});
  }

  /// Notes the parts of shapes that the rules do not use in full.
  void note_gaps() {
    for (const std::string& gap : base_.gaps()) shapes_.add_gap(gap);
    const bool has_universals =
        std::ranges::any_of(overlay_.own(), [](const OverlayContext& one) { return !one.universals.empty(); });
    if (has_universals && base_.index().roles().has_compositions()) {
      shapes_.add_gap("owl:allValuesFrom in the expression, over a chain");
    }
    for (ShapeId id = 0; id < shapes_.count(); ++id) {
      const Shape shape = shapes_.shape(id);
      if (shape.kind == ShapeKind::at_most) shapes_.add_gap("a maximum cardinality in the expression");
      // not (C and not D) is C -> D, which is more than a negation.
      if (shape.kind == ShapeKind::negation && shapes_.has_negation(shape.parts[0])) {
        shapes_.add_gap("a complement inside of a complement");
      }
      // C < D or not E holds if C and E < D, which no operand shows.
      const bool has_complement =
          shape.kind == ShapeKind::any_of &&
          std::ranges::any_of(shape.parts, [&](ShapeId part) { return shapes_.has_negation(part); });
      if (has_complement) shapes_.add_gap("a complement inside of a union");
      const bool is_union = shape.kind == ShapeKind::only && shapes_.alternatives_of(shape.parts[0]).size() > 1;
      if (is_union) shapes_.add_gap("a union inside of owl:allValuesFrom");
    }
  }

  const ExpressionBase& base_;
  const owl::Ontology& query_;
  ShapeReader shapes_;
  ExpressionOverlay overlay_;
};

}  // namespace

std::expected<ExpressionClassifier, ExpressionError> ExpressionClassifier::build(const compiled::Ontology& ontology,
                                                                                 const ExpressionLimits& limits) {
  auto base = ExpressionBase::build(ontology, limits);
  if (!base) return std::unexpected(base.error());
  return ExpressionClassifier(std::move(*base));
}

ExpressionPlace ExpressionClassifier::classify(const owl::Ontology& query, owl::TermId expression) const {
  return Question(*base_, query).place(expression);
}

ExpressionClassifier::Subsumption ExpressionClassifier::is_subsumed(const owl::Ontology& query, owl::TermId sub,
                                                                    owl::TermId super) const {
  Question question(*base_, query);
  const bool holds = question.is_subsumed(sub, super);
  return {.holds = holds, .gaps = holds ? std::vector<std::string>() : question.gaps()};
}

std::optional<owl::TermId> ExpressionClassifier::definition(owl::Ontology& query, owl::TermId named_class) const {
  const owl::Ontology& source = base_->source();
  const auto name = source.find_name(query.name_of(named_class));
  if (!name) return std::nullopt;
  for (std::size_t at = 0; at < source.axiom_count(); ++at) {
    const owl::Axiom axiom = source.axiom(at);
    if (axiom.kind != owl::AxiomKind::equivalent_classes) continue;
    const auto is_it = [&](owl::TermId side) {
      return source.kind(side) == owl::TermKind::named_class && source.term(side).name == *name;
    };
    if (std::ranges::none_of(axiom.arguments, is_it)) continue;
    const auto is_compound = [&](owl::TermId side) { return source.kind(side) != owl::TermKind::named_class; };
    const auto side = std::ranges::find_if(axiom.arguments, is_compound);
    if (side != axiom.arguments.end()) return query.copy(source, *side);
  }
  return std::nullopt;
}

}  // namespace geminga::placement
