// Reading, classifying and remembering.
#include "discovery/participant/knowledge/expressions.hpp"

#include <algorithm>
#include <utility>

#include "discovery/gcnp/limits.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {

void Expressions::attend_to(const Vocabulary& vocabulary) {
  if (ontology_.is_of(vocabulary)) return;
  ontology_ = vocabulary::OntologyMark(vocabulary);
  is_used_ = false;
  remembered_.clear();
  waiting_since_.reset();
}

Expressions::Place Expressions::remember(const std::string& canonical, Place place) {
  if (remembered_.size() >= max_remembered_expressions) {
    remembered_.erase(std::ranges::min_element(remembered_, {}, [](const auto& entry) { return entry.second.used; }));
  }
  return remembered_.insert_or_assign(canonical, Remembered{std::move(place), ++uses_}).first->second.place;
}

std::expected<std::string, Error> Expressions::resolve(const Vocabulary& vocabulary, std::string_view text) {
  attend_to(vocabulary);
  is_used_ = true;
  if (const auto ready = vocabulary.check_expressions(); !ready) return std::unexpected(ready.error());
  const auto expression = vocabulary.read(text, gcnp::max_concept_bytes);
  if (!expression) return std::unexpected(expression.error());
  std::string canonical = expression->canonical();
  Place place;
  if (const auto known = remembered_.find(canonical); known != remembered_.end() && known->second.place) {
    known->second.used = ++uses_;
    place = known->second.place;
  } else {
    ++counts_.classified;
    place = remember(canonical, std::make_shared<const vocabulary::Place>(vocabulary.place(*expression)));
  }
  if (!place->is_satisfiable) {
    return std::unexpected(Error{ErrorCode::impossible, "the expression is unsatisfiable, nothing can be one"});
  }
  if (place->equivalent) return std::string(vocabulary.iri(*place->equivalent));
  return canonical;
}

bool Expressions::take_waiting(const Vocabulary& vocabulary, base::Instant now) {
  attend_to(vocabulary);
  if (!waiting_since_ || now - *waiting_since_ < RemoteQuota::second) return false;
  waiting_since_.reset();
  return true;
}

bool Expressions::take_quota(ParticipantId from, base::Instant now) {
  if (quota_.take(from, now)) return true;
  if (!waiting_since_) waiting_since_ = now;
  ++counts_.postponed;
  return false;
}

Expressions::Place Expressions::place(const Vocabulary& vocabulary, const std::string& canonical,
                                      std::optional<ParticipantId> from, base::Instant now) {
  if (!vocabulary.is_loaded()) return nullptr;
  attend_to(vocabulary);
  if (const auto known = remembered_.find(canonical); known != remembered_.end()) {
    known->second.used = ++uses_;
    return known->second.place;
  }
  is_used_ = true;
  if (!vocabulary.check_expressions()) return nullptr;
  if (from && !take_quota(*from, now)) return nullptr;
  // A text in which only what it means counts: it may be none of ours, and is read as strictly as a peer's.
  const auto expression = vocabulary.read(canonical, vocabulary::max_expression_bytes);
  if (!expression) {
    if (from) ++counts_.unknown;
    return remember(canonical, nullptr);
  }
  ++counts_.classified;
  auto found = vocabulary.place(*expression);
  if (!found.is_satisfiable) {
    if (from) ++counts_.unknown;
    return remember(canonical, nullptr);
  }
  return remember(canonical, std::make_shared<const vocabulary::Place>(std::move(found)));
}

}  // namespace geminga::participant
