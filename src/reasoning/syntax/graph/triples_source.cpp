#include "reasoning/syntax/graph/triples_source.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "reasoning/syntax/graph/literals.hpp"

namespace geminga::graph {
namespace {

using Bindings = std::array<rasqal_variable*, 3>;
using Part = raptor_term* raptor_statement::*;

constexpr std::array<Part, 3> all_parts{&raptor_statement::subject, &raptor_statement::predicate,
                                        &raptor_statement::object};
constexpr std::array<rasqal_triple_parts, 3> part_bits{RASQAL_TRIPLE_SUBJECT, RASQAL_TRIPLE_PREDICATE,
                                                       RASQAL_TRIPLE_OBJECT};

std::array<rasqal_literal*, 3> literals_in(const rasqal_triple& pattern) {
  return {pattern.subject, pattern.predicate, pattern.object};
}

/// The matches of one pattern, one after another: the functions that rasqal calls.
class Matches {
 public:
  Matches(World& world, TripleIndex& index, TriplesSource::Asked asked)
      : world_(world), index_(index), asked_(std::move(asked)) {
    settle();
  }

  [[nodiscard]] bool is_over() const { return place_ >= asked_.candidates.size(); }

  /// Sets the variables of the pattern to the parts of the match. Returns the parts that were set; none where a
  /// variable that stands twice in the pattern would have two values.
  rasqal_triple_parts bind(const Bindings& variables, rasqal_triple_parts wanted) {
    const raptor_statement& found = *asked_.candidates[place_];
    unsigned bound = 0;
    for (std::size_t at = 0; at < all_parts.size(); ++at) {
      if (variables[at] == nullptr || (wanted & part_bits[at]) == 0) continue;
      const auto first = static_cast<std::size_t>(std::ranges::find(variables, variables[at]) - variables.begin());
      if (first < at) {
        if (raptor_term_equals(found.*all_parts[first], found.*all_parts[at]) == 0) return RASQAL_TRIPLE_NONE;
      } else {
        rasqal_variable_set_value(variables[at], literal_of(world_, *(found.*all_parts[at])));
      }
      bound |= part_bits[at];
    }
    return static_cast<rasqal_triple_parts>(bound);
  }
  void next() {
    ++place_;
    settle();
  }

 private:
  /// Goes on to the next triple that fits.
  void settle() {
    if (!index_.step()) place_ = asked_.candidates.size();
    while (!is_over() && !fits(*asked_.candidates[place_], *asked_.pattern))
      place_ = index_.step() ? place_ + 1 : asked_.candidates.size();
  }

  World& world_;
  TripleIndex& index_;
  TriplesSource::Asked asked_;
  std::size_t place_ = 0;
};

Matches& matches_of(void* matches) { return *static_cast<Matches*>(matches); }
/// The source of a query, of which rasqal keeps the address.
TriplesSource& source_of(void* kept) { return **static_cast<TriplesSource**>(kept); }

int begin(rasqal_triples_match* match, rasqal_triples_source*, void* kept, rasqal_triple_meta* meta,
          rasqal_triple* pattern) {
  const TriplesSource& source = source_of(kept);
  auto asked = source.asked(*pattern);
  if (asked.pattern == nullptr) return 1;
  const auto literals = literals_in(*pattern);
  for (std::size_t at = 0; at < literals.size(); ++at) meta->bindings[at] = rasqal_literal_as_variable(literals[at]);
  match->bind_match = [](rasqal_triples_match*, void* matches, rasqal_variable* variables[4],
                         rasqal_triple_parts wanted) {
    return matches_of(matches).bind({variables[0], variables[1], variables[2]}, wanted);
  };
  match->next_match = [](rasqal_triples_match*, void* matches) { matches_of(matches).next(); };
  match->is_end = [](rasqal_triples_match*, void* matches) { return matches_of(matches).is_over() ? 1 : 0; };
  match->finish = [](rasqal_triples_match*, void* matches) { delete static_cast<Matches*>(matches); };
  match->user_data = std::make_unique<Matches>(source.world(), source.index(), std::move(asked)).release();
  return 0;
}

int is_present(rasqal_triples_source*, void* kept, rasqal_triple* pattern) {
  const TriplesSource& source = source_of(kept);
  auto asked = source.asked(*pattern);
  return asked.pattern != nullptr && !Matches(source.world(), source.index(), std::move(asked)).is_over() ? 1 : 0;
}

int open_source(rasqal_query* query, void*, void* kept, rasqal_triples_source* opened) {
  *static_cast<void**>(kept) = rasqal_query_get_user_data(query);
  opened->version = 1;
  opened->init_triples_match = begin;
  opened->triple_present = is_present;
  opened->free_triples_source = [](void*) {};
  return 0;
}

/// The functions of a source that is no file.
int register_source(rasqal_triples_source_factory* factory) {
  factory->version = 1;
  factory->user_data_size = sizeof(TriplesSource*);
  factory->new_triples_source = open_source;
  factory->init_triples_source = nullptr;
  factory->init_triples_source2 = nullptr;
  return 0;
}

}  // namespace

bool TriplesSource::serve(rasqal_query* query) {
  rasqal_query_set_user_data(query, this);
  return rasqal_set_triples_source_factory(world_.rasqal(), register_source, nullptr) == 0;
}

TriplesSource::Asked TriplesSource::asked(const rasqal_triple& pattern) const {
  Asked asked{OwnedStatement(raptor_new_statement(world_.raptor())), {}};
  if (asked.pattern == nullptr) return asked;
  const auto literals = literals_in(pattern);
  const bool is_of_expression = expressions_.answers(pattern);
  for (std::size_t at = 0; at < literals.size(); ++at) {
    const std::string_view label = blank_name(literals[at]);
    const rasqal_variable* variable = rasqal_literal_as_variable(literals[at]);
    rasqal_literal* known = variable == nullptr ? literals[at] : variable->value;
    (*asked.pattern).*all_parts[at] =
        is_of_expression && expressions_.has_node(label)
            ? raptor_new_term_from_counted_blank(world_.raptor(), reinterpret_cast<const unsigned char*>(label.data()),
                                                 label.size())
            : term_of(world_, known).release();
  }
  asked.candidates = is_of_expression ? TripleIndex::candidates(expressions_.triples().all(), *asked.pattern)
                                      : index_.candidates(*asked.pattern);
  return asked;
}

}  // namespace geminga::graph
