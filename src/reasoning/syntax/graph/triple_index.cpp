#include "reasoning/syntax/graph/triple_index.hpp"

#include <malloc.h>
#include <rdf_storage_module.h>

#include <algorithm>
#include <memory>

namespace geminga::graph {
namespace {

using Statement = raptor_statement*;
using Part = raptor_term* raptor_statement::*;

/// The steps between two looks at the memory.
constexpr std::uint64_t between_looks = 4096;
constexpr const char* storage_name = "geminga-triples";

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

bool fits(const raptor_statement& statement, const raptor_statement& pattern) {
  return std::ranges::all_of(
      std::initializer_list<Part>{&raptor_statement::subject, &raptor_statement::predicate, &raptor_statement::object},
      [&](Part part) { return pattern.*part == nullptr || raptor_term_equals(statement.*part, pattern.*part) != 0; });
}

/// The parts of a pattern, which librdf frees before the search ends.
class Pattern {
 public:
  explicit Pattern(const raptor_statement* pattern) {
    if (pattern == nullptr) return;
    for (const Part part : parts) terms_.*part = pattern->*part == nullptr ? nullptr : raptor_term_copy(pattern->*part);
  }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;
  ~Pattern() {
    for (const Part part : parts) {
      if (terms_.*part != nullptr) raptor_free_term(terms_.*part);
    }
  }
  [[nodiscard]] const raptor_statement& get() const { return terms_; }

 private:
  static constexpr Part parts[]{&raptor_statement::subject, &raptor_statement::predicate, &raptor_statement::object};
  raptor_statement terms_{};
};

/// One search: the functions that librdf calls for a stream.
class Search {
 public:
  Search(TripleIndex& index, const raptor_statement* pattern)
      : index_(index), pattern_(pattern), candidates_(index.candidates(pattern_.get())) {
    settle();
  }

  static int is_end(void* search) { return static_cast<Search*>(search)->is_over() ? 1 : 0; }
  static int next(void* search) {
    auto& self = *static_cast<Search*>(search);
    ++self.place_;
    self.settle();
    return is_end(search);
  }
  static void* get(void* search, int flags) {
    const auto& self = *static_cast<Search*>(search);
    const bool is_object = flags == LIBRDF_STREAM_GET_METHOD_GET_OBJECT;
    return is_object && !self.is_over() ? self.candidates_[self.place_] : nullptr;
  }
  static void finish(void* search) { delete static_cast<Search*>(search); }

  [[nodiscard]] bool is_over() const { return place_ >= candidates_.size(); }

 private:
  /// Goes on to the next triple that fits.
  void settle() {
    if (!index_.step()) place_ = candidates_.size();
    while (!is_over() && !fits(*candidates_[place_], pattern_.get()))
      place_ = index_.step() ? place_ + 1 : candidates_.size();
  }

  TripleIndex& index_;
  Pattern pattern_;
  std::span<const Statement> candidates_;
  std::size_t place_ = 0;
};

TripleIndex& index_of(librdf_storage* storage) {
  return *static_cast<TripleIndex*>(librdf_storage_get_instance(storage));
}

librdf_stream* find(librdf_storage* storage, librdf_statement* pattern) {
  auto search = std::make_unique<Search>(index_of(storage), pattern);
  librdf_stream* stream = librdf_new_stream(librdf_storage_get_world(storage), search.get(), Search::is_end,
                                            Search::next, Search::get, Search::finish);
  if (stream != nullptr) (void)search.release();
  return stream;
}

int contains(librdf_storage* storage, librdf_statement* statement) {
  return Search(index_of(storage), statement).is_over() ? 0 : 1;
}

/// The functions of the storage; librdf has no others for what is not set here.
void fill(librdf_storage_factory* factory) {
  factory->version = LIBRDF_STORAGE_INTERFACE_VERSION;
  factory->init = [](librdf_storage*, const char*, librdf_hash* options) {
    if (options != nullptr) librdf_free_hash(options);
    return 0;
  };
  factory->terminate = [](librdf_storage*) {};
  factory->open = [](librdf_storage*, librdf_model*) { return 0; };
  factory->close = [](librdf_storage*) { return 0; };
  factory->size = [](librdf_storage*) { return -1; };
  factory->contains_statement = contains;
  factory->serialise = [](librdf_storage* storage) { return find(storage, nullptr); };
  factory->find_statements = find;
}

}  // namespace

TripleIndex::TripleIndex(std::span<const Statement> sorted, const GraphLimits& limits, base::Budget* budget)
    : by_subject_(sorted),
      by_predicate_(sorted_by(sorted, predicates)),
      by_object_(sorted_by(sorted, objects)),
      most_octets_(limits.query_octets),
      octets_at_begin_(taken_octets()),
      budget_(budget) {}

librdf_storage* TripleIndex::storage(World& world) {
  librdf_storage_register_factory(world.redland(), storage_name, "the triples of a graph", fill);
  librdf_storage* storage = librdf_new_storage(world.redland(), storage_name, "asked", nullptr);
  if (storage != nullptr) librdf_storage_set_instance(storage, this);
  return storage;
}

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

}  // namespace geminga::graph
