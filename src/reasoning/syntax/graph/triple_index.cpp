#include "reasoning/syntax/graph/triple_index.hpp"

#include <malloc.h>

#include <algorithm>
#include <initializer_list>

namespace geminga::graph {
namespace {

using Statement = raptor_statement*;
using Part = raptor_term* raptor_statement::*;

/// The steps between two looks at the memory.
constexpr std::uint64_t between_looks = 4096;

/// The octets that this process has taken from malloc(). Always 0 with a sanitizer.
std::size_t taken_octets() {
  const auto figures = ::mallinfo2();
  return figures.uordblks + figures.hblkhd;
}

/// Orders statements by two parts, the more important one first.
struct By {
  Part first;
  Part second;
  bool operator()(const raptor_statement* a, const raptor_statement* b) const {
    const int order = raptor_term_compare(a->*first, b->*first);
    return order != 0 ? order < 0 : raptor_term_compare(a->*second, b->*second) < 0;
  }
};

constexpr By subjects{&raptor_statement::subject, &raptor_statement::predicate};
constexpr By predicates{&raptor_statement::predicate, &raptor_statement::object};
constexpr By objects{&raptor_statement::object, &raptor_statement::predicate};

std::vector<Statement> sorted_by(std::span<const Statement> all, By order) {
  std::vector<Statement> sorted(all.begin(), all.end());
  std::ranges::stable_sort(sorted, order);
  return sorted;
}

/// Those of the sorted statements whose first part, and second part where the pattern has one, are the pattern's.
std::span<const Statement> range_of(std::span<const Statement> sorted, By order, const raptor_statement& pattern) {
  if (pattern.*order.second != nullptr) {
    const auto range = std::ranges::equal_range(sorted, &pattern, order);
    return {range.begin(), range.end()};
  }
  const auto by_first = [&](const raptor_statement* a, const raptor_statement* b) {
    return raptor_term_compare(a->*order.first, b->*order.first) < 0;
  };
  const auto range = std::ranges::equal_range(sorted, &pattern, by_first);
  return {range.begin(), range.end()};
}

}  // namespace

TripleIndex::TripleIndex(std::span<const Statement> sorted, const GraphLimits& limits, base::Budget* budget)
    : by_subject_(sorted),
      by_predicate_(sorted_by(sorted, predicates)),
      by_object_(sorted_by(sorted, objects)),
      most_octets_(limits.query_octets),
      octets_at_begin_(taken_octets()),
      budget_(budget) {}

bool TripleIndex::step() {
  if (problem_) return false;
  if (budget_ != nullptr && !budget_->spend(1)) {
    problem_ = "the query has no answer, because " + *budget_->reason() +
               ": ask for less at once, or raise --query-steps or --time-limit";
  } else if (++steps_ % between_looks == 0 && taken_octets() > octets_at_begin_ + most_octets_) {
    problem_ = "the query takes more than " + std::to_string(most_octets_ >> 20U) +
               " MiB: ask for less at once, or raise --graph-limit";
  }
  return !problem_;
}

std::span<raptor_statement* const> TripleIndex::candidates(const raptor_statement& pattern) const {
  if (pattern.subject != nullptr) return range_of(by_subject_, subjects, pattern);
  if (pattern.object != nullptr) return range_of(by_object_, objects, pattern);
  if (pattern.predicate != nullptr) return range_of(by_predicate_, predicates, pattern);
  return by_subject_;
}

std::span<raptor_statement* const> TripleIndex::candidates(std::span<raptor_statement* const> sorted,
                                                           const raptor_statement& pattern) {
  return pattern.subject == nullptr ? sorted : range_of(sorted, subjects, pattern);
}

bool fits(const raptor_statement& statement, const raptor_statement& pattern) {
  return std::ranges::all_of(
      std::initializer_list<Part>{&raptor_statement::subject, &raptor_statement::predicate, &raptor_statement::object},
      [&](Part part) { return pattern.*part == nullptr || raptor_term_equals(statement.*part, pattern.*part) != 0; });
}

}  // namespace geminga::graph
