// Reading, classifying and remembering.
#include "discovery/participant/expressions.hpp"

#include <algorithm>
#include <utility>

#include "discovery/announcement/limits.hpp"
#include "discovery/gcnp/limits.hpp"
#include "reasoning/syntax/manchester/canonical.hpp"
#include "reasoning/syntax/manchester/parse.hpp"

namespace geminga::participant {
namespace {

/// Counts one in a window of a second; false where it is one too many.
template <typename Window>
bool count(Window& window, std::size_t limit, base::Instant now) {
  if (now - window.begin >= std::chrono::seconds(1)) window = {.begin = now, .seen = 0};
  if (window.seen >= limit) return false;
  ++window.seen;
  return true;
}

}  // namespace

void Expressions::set_ontology(const compiled::Ontology* ontology, std::unique_ptr<const PreparedOntology> prepared) {
  ontology_ = ontology;
  is_wanted_ = false;
  prepared_.reset();
  remembered_.clear();
  waiting_since_.reset();
  give(std::move(prepared));
}

bool Expressions::give(std::unique_ptr<const PreparedOntology> prepared) {
  if (prepared == nullptr || prepared_ != nullptr || &prepared->ontology() != ontology_) return false;
  prepared_ = std::move(prepared);
  return true;
}

std::expected<const PreparedOntology::Parts*, Error> Expressions::parts() {
  is_wanted_ = true;
  if (prepared_ == nullptr) {
    return std::unexpected(
        Error{ErrorCode::not_ready, "not ready: the ontology is being prepared for class expressions"});
  }
  if (!prepared_->parts()) return std::unexpected(prepared_->parts().error());
  return &*prepared_->parts();
}

Expressions::Place Expressions::remember(const std::string& canonical, Place place) {
  if (remembered_.size() >= max_remembered_expressions) {
    remembered_.erase(std::ranges::min_element(remembered_, {}, [](const auto& entry) { return entry.second.used; }));
  }
  return remembered_.insert_or_assign(canonical, Remembered{std::move(place), ++uses_}).first->second.place;
}

std::expected<std::string, Error> Expressions::resolve(std::string_view text) {
  const auto ready = parts();
  if (!ready) return std::unexpected(ready.error());
  const auto& [classifier, names] = **ready;
  manchester::Limits limits;
  limits.text_bytes = gcnp::max_concept_bytes;
  const auto expression = manchester::parse(text, names, limits);
  if (!expression) {
    const bool is_large = expression.error().kind == manchester::ParseError::Kind::too_large;
    return std::unexpected(
        Error{is_large ? ErrorCode::too_large : ErrorCode::impossible, to_string(expression.error())});
  }
  std::string canonical = manchester::canonical(expression->source, expression->term);
  Place place;
  if (const auto known = remembered_.find(canonical); known != remembered_.end() && known->second.place) {
    known->second.used = ++uses_;
    place = known->second.place;
  } else {
    ++counts_.classified;
    auto found = classifier.classify(expression->source, expression->term);
    place = remember(canonical, std::make_shared<const placement::ExpressionPlace>(std::move(found)));
  }
  if (!place->is_satisfiable) {
    return std::unexpected(Error{ErrorCode::impossible, "the expression is unsatisfiable, nothing can be one"});
  }
  if (place->equivalent) return std::string(ontology_->iri(*place->equivalent));
  return canonical;
}

bool Expressions::take_waiting(base::Instant now) {
  if (!waiting_since_ || now - *waiting_since_ < second) return false;
  waiting_since_.reset();
  return true;
}

bool Expressions::take_turn(ParticipantId from, base::Instant now) {
  if (windows_.size() > announcement::max_participants) {
    std::erase_if(windows_, [&](const auto& entry) { return now - entry.second.begin >= second; });
  }
  if (count(windows_[from], max_expressions_of_participant, now) && count(air_, max_expressions_from_air, now)) {
    return true;
  }
  if (!waiting_since_) waiting_since_ = now;
  ++counts_.postponed;
  return false;
}

Expressions::Place Expressions::place(const std::string& canonical, std::optional<ParticipantId> from,
                                      base::Instant now) {
  if (ontology_ == nullptr) return nullptr;
  if (const auto known = remembered_.find(canonical); known != remembered_.end()) {
    known->second.used = ++uses_;
    return known->second.place;
  }
  const auto ready = parts();
  if (!ready) return nullptr;
  if (from && !take_turn(*from, now)) return nullptr;
  const auto& [classifier, names] = **ready;
  // A text in which only what it means counts: it may be none of ours, and is read as strictly as a peer's.
  const auto expression = manchester::parse(canonical, names);
  if (!expression) {
    if (from) ++counts_.unknown;
    return remember(canonical, nullptr);
  }
  ++counts_.classified;
  auto found = classifier.classify(expression->source, expression->term);
  if (!found.is_satisfiable) {
    if (from) ++counts_.unknown;
    return remember(canonical, nullptr);
  }
  return remember(canonical, std::make_shared<const placement::ExpressionPlace>(std::move(found)));
}

}  // namespace geminga::participant
