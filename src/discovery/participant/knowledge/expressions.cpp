// Reading, classifying and remembering.
#include "discovery/participant/knowledge/expressions.hpp"

#include <algorithm>
#include <utility>

#include "discovery/gcnp/limits.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {
namespace {

constexpr std::string_view unsatisfiable = "the expression is unsatisfiable: it can have no instance";

}  // namespace

Expressions::Memory& Expressions::memory_of(const Vocabulary& vocabulary) {
  if (!memories_[last_].ontology.is_of(vocabulary)) {
    last_ = 1 - last_;
    if (!memories_[last_].ontology.is_of(vocabulary)) {
      memories_[last_] = {.ontology = vocabulary::OntologyMark(vocabulary)};
      waiting_since_.reset();
    }
  }
  return memories_[last_];
}

const Expressions::Memory* Expressions::find_memory(const Vocabulary& vocabulary) const {
  const auto found =
      std::ranges::find_if(memories_, [&](const Memory& memory) { return memory.ontology.is_of(vocabulary); });
  return found == memories_.end() ? nullptr : &*found;
}

bool Expressions::is_used(const Vocabulary& vocabulary) const {
  const Memory* memory = find_memory(vocabulary);
  return memory != nullptr && memory->is_used;
}

bool Expressions::is_known_elsewhere(const Memory& memory, const std::string& canonical) const {
  return std::ranges::any_of(
      memories_, [&](const Memory& other) { return &other != &memory && other.remembered.contains(canonical); });
}

Expressions::Place Expressions::remember(Memory& memory, const std::string& canonical, Place place,
                                         std::string problem) {
  auto& remembered = memory.remembered;
  if (remembered.size() >= max_remembered_expressions && !remembered.contains(canonical)) {
    remembered.erase(std::ranges::min_element(remembered, {}, [](const auto& entry) { return entry.second.used; }));
  }
  return remembered.insert_or_assign(canonical, Remembered{std::move(place), std::move(problem), ++uses_})
      .first->second.place;
}

std::expected<void, Error> Expressions::require(const Vocabulary& vocabulary) {
  memory_of(vocabulary).is_used = true;
  return vocabulary.check_expressions();
}

std::expected<std::string, Error> Expressions::resolve(const Vocabulary& vocabulary, std::string_view text) {
  if (const auto ready = require(vocabulary); !ready) return std::unexpected(ready.error());
  Memory& memory = memory_of(vocabulary);
  const auto expression = vocabulary.read(text, gcnp::max_concept_bytes);
  if (!expression) return std::unexpected(expression.error());
  std::string canonical = expression->canonical();
  Place place;
  if (const auto known = memory.remembered.find(canonical); known != memory.remembered.end() && known->second.place) {
    known->second.used = ++uses_;
    place = known->second.place;
  } else {
    ++counts_.classified;
    place = remember(memory, canonical, std::make_shared<const vocabulary::Place>(vocabulary.place(*expression)));
  }
  if (!place->is_satisfiable) {
    return std::unexpected(Error{ErrorCode::impossible, std::string(unsatisfiable)});
  }
  if (place->equivalent) return std::string(vocabulary.iri(*place->equivalent));
  return canonical;
}

bool Expressions::take_waiting(const Vocabulary& vocabulary, base::Instant now) {
  static_cast<void>(memory_of(vocabulary));  // what waited for another ontology waits no more
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
  Memory& memory = memory_of(vocabulary);
  if (const auto known = memory.remembered.find(canonical); known != memory.remembered.end()) {
    known->second.used = ++uses_;
    return known->second.place && known->second.place->is_satisfiable ? known->second.place : nullptr;
  }
  memory.is_used = true;
  if (!vocabulary.check_expressions()) return nullptr;
  if (from && !is_known_elsewhere(memory, canonical) && !take_quota(*from, now)) return nullptr;
  // A text in which only what it means counts: it may be none of ours, and is read as strictly as a peer's.
  const auto expression = vocabulary.read(canonical, vocabulary::max_expression_bytes);
  if (!expression) {
    if (from) ++counts_.unknown;
    return remember(memory, canonical, nullptr, expression.error().text);
  }
  ++counts_.classified;
  auto found = vocabulary.place(*expression);
  if (!found.is_satisfiable) {
    if (from) ++counts_.unknown;
    return remember(memory, canonical, nullptr, std::string(unsatisfiable));
  }
  return remember(memory, canonical, std::make_shared<const vocabulary::Place>(std::move(found)));
}

Expressions::Place Expressions::known_place(const Vocabulary& vocabulary, const std::string& canonical) const {
  const Memory* memory = find_memory(vocabulary);
  if (memory == nullptr) return nullptr;
  const auto known = memory->remembered.find(canonical);
  const bool is_known = known != memory->remembered.end() && known->second.place;
  return is_known && known->second.place->is_satisfiable ? known->second.place : nullptr;
}

std::string Expressions::problem(const Vocabulary& vocabulary, const std::string& canonical) const {
  if (!vocabulary.is_loaded()) return "no ontology is loaded here";
  if (known_place(vocabulary, canonical)) return "";
  if (const auto ready = vocabulary.check_expressions(); !ready) return ready.error().text;
  const Memory* memory = find_memory(vocabulary);
  if (memory == nullptr) return "it waits to be classified";
  const auto known = memory->remembered.find(canonical);
  if (known == memory->remembered.end()) return "it waits to be classified";
  return known->second.place ? std::string(unsatisfiable) : known->second.problem;
}

}  // namespace geminga::participant
