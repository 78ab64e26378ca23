#include "reasoning/explanation/abduction/conjuncts.hpp"

#include <algorithm>
#include <bit>

namespace geminga::abduction {
namespace {

using owl::TermId;
using owl::TermKind;

std::vector<TermId> arguments_of(const owl::Ontology& source, TermId id) {
  const auto arguments = source.term(id).arguments;
  return {arguments.begin(), arguments.end()};
}

/// A restriction that gets more general with its filler.
bool is_existential(const owl::Term& term) {
  const bool is_minimum =
      term.kind == TermKind::object_min_cardinality && term.number > 0 && term.arguments.size() == 2;
  return term.kind == TermKind::object_some_values_from || is_minimum;
}

/// Takes conjunctions apart, without what is nested in restrictions.
class Splitter {
 public:
  Splitter(owl::Ontology& source, const Definition& definition) : source_(source), definition_(definition) {}

  /// Each once, in the order in which they are written; without owl:Thing.
  std::vector<TermId> split(TermId id) {
    std::vector<TermId> parts;
    split(id, 0, parts);
    return parts;
  }

 private:
  void split(TermId id, int depth, std::vector<TermId>& parts) {
    const TermKind kind = source_.kind(id);
    if (kind == TermKind::object_intersection_of) {
      for (const TermId part : arguments_of(source_, id)) split(part, depth, parts);
      return;
    }
    if (kind == TermKind::object_all_values_from) {
      const auto arguments = arguments_of(source_, id);
      for (const TermId part : split(arguments[1])) add(source_.term(kind, {arguments[0], part}), parts);
      return;
    }
    if (kind == TermKind::object_complement_of) {
      const TermId of = arguments_of(source_, id)[0];
      if (source_.kind(of) == TermKind::object_union_of) {
        for (const TermId part : arguments_of(source_, of)) add(source_.term(kind, {part}), parts);
        return;
      }
    }
    if (kind == TermKind::named_class && definition_ && depth < Conjuncts::max_depth_of_definitions) {
      if (const auto defined = definition_(source_, id)) return split(*defined, depth + 1, parts);
    }
    if (id != owl::thing_term) add(id, parts);
  }

  static void add(TermId id, std::vector<TermId>& parts) {
    if (std::ranges::find(parts, id) == parts.end()) parts.push_back(id);
  }

  owl::Ontology& source_;
  const Definition& definition_;
};

}  // namespace

Conjuncts::Conjuncts(owl::Ontology& source, TermId expression, const Definition& definition) {
  Splitter splitter(source, definition);
  std::vector<TermId> parts = splitter.split(expression);
  if (parts.size() > max_conjuncts) {  // the rest is one conjunct
    is_whole_ = false;
    const std::vector<TermId> rest(parts.begin() + max_conjuncts - 1, parts.end());
    parts.resize(max_conjuncts - 1);
    parts.push_back(source.term(TermKind::object_intersection_of, rest));
  }
  for (const TermId part : parts) {
    const Members own = only(all_.size());
    all_.push_back({.whole = part, .inside = own, .around = own});
    top_ |= own;
  }
  for (std::size_t outer = 0; outer < all_.size(); ++outer) {
    const owl::Term term = source.term(all_[outer].whole);
    if (!is_existential(term)) continue;
    const std::vector<TermId> fillers = splitter.split(term.arguments[1]);
    if (fillers.size() < 2) continue;
    if (all_.size() + fillers.size() > max_conjuncts) {
      is_whole_ = false;
      continue;
    }
    for (const TermId filler : fillers) {
      const std::size_t inner = all_.size();
      all_[outer].nested.push_back(inner);
      all_.push_back({.whole = filler, .inside = only(inner), .around = only(inner) | all_[outer].around});
      for (const std::size_t around : numbers_of(all_[outer].around)) all_[around].inside |= only(inner);
    }
  }
}

Members Conjuncts::all() const {
  Members members = 0;
  for (std::size_t at = 0; at < all_.size(); ++at) members |= only(at);
  return members;
}

std::size_t Conjuncts::top_of(std::size_t conjunct) const {
  return static_cast<std::size_t>(std::countr_zero(all_[conjunct].around & top_));
}

Members Conjuncts::outermost(Members members) const {
  Members outer = 0;
  for (const std::size_t at : numbers_of(members)) {
    if ((all_[at].around & members) == only(at)) outer |= only(at);
  }
  return outer;
}

std::size_t Conjuncts::count(Members members) const {
  const auto numbers = numbers_of(members);
  return static_cast<std::size_t>(
      std::ranges::count_if(numbers, [&](std::size_t at) { return (all_[at].inside & members) == only(at); }));
}

TermId Conjuncts::term(owl::Ontology& source, Members kept) const { return together(source, numbers_of(top_), kept); }

TermId Conjuncts::term(owl::Ontology& source, std::size_t conjunct, Members kept) const {
  const Conjunct& one = all_[conjunct];
  if (one.nested.empty()) return one.whole;
  const owl::Term written = source.term(one.whole);
  const TermKind kind = written.kind;
  const std::uint32_t number = written.number;
  const TermId property = written.arguments[0];
  return source.term(kind, {property, together(source, one.nested, kept)}, number);
}

TermId Conjuncts::together(owl::Ontology& source, const std::vector<std::size_t>& conjuncts, Members kept) const {
  std::vector<TermId> parts;
  for (const std::size_t at : conjuncts) {
    if ((kept & only(at)) != 0) parts.push_back(term(source, at, kept));
  }
  if (parts.empty()) return owl::thing_term;
  return parts.size() == 1 ? parts.front() : source.term(TermKind::object_intersection_of, parts);
}

}  // namespace geminga::abduction
