// Asks reasoning/explanation, and measures the way between two classes.
#include "reasoning/vocabulary/overlap.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "reasoning/explanation/overlap.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::vocabulary {
namespace {

/// `distance_of_other` gives the edges from the other one up to a class; nothing where that is not above it.
template <typename Distance>
std::uint32_t way_between(const compiled::Ontology& ontology, ClassNumber one, const Distance& distance_of_other) {
  auto least = std::numeric_limits<std::uint32_t>::max();
  for (const ClassNumber above : ontology.subsumers(one)) {
    const std::optional<std::uint32_t> down = distance_of_other(above);
    if (down) least = std::min(least, ontology.distance(one, above).value_or(0) + *down);
  }
  return least;
}

template <typename Distance>
Overlap overlap_of(explanation::Overlap found, const Distance& distance) {
  switch (found.common) {
    case explanation::Common::possible:
      return {.verdict = Overlap::Verdict::possible, .distance = distance()};
    case explanation::Common::impossible:
      return {.verdict = Overlap::Verdict::impossible};
    case explanation::Common::undecided:
      break;
  }
  return {.reason = std::move(found.reason)};
}

std::vector<std::string> texts(const std::vector<explanation::ExplainedAxiom>& axioms) {
  std::vector<std::string> lines;
  for (const auto& axiom : axioms) lines.push_back(axiom.text);
  return lines;
}

}  // namespace

Overlap Vocabulary::overlap(ClassNumber one, ClassNumber other) const {
  return overlap_of(explanation::find_overlap(*ontology_, one, other, explanation::Patience::of_a_daemon), [&] {
    return way_between(*ontology_, one, [&](ClassNumber above) { return ontology_->distance(other, above); });
  });
}

Overlap Vocabulary::overlap(ClassNumber one, const Expression& other, const Place& place) const {
  const explanation::WrittenClass written{other.parsed_.source, other.parsed_.term};
  return overlap_of(explanation::find_overlap(*ontology_, one, written, explanation::Patience::of_a_daemon), [&] {
    return way_between(*ontology_, one, [&](ClassNumber above) { return distance_up(place, above); });
  });
}

// Two expressions have a common instance if something is an instance of both together.
Overlap Vocabulary::overlap(const Expression& one, const Place& place, const Expression& other,
                            const Place& place_of_other) const {
  const auto together = both(one, other);
  if (!together) return {.reason = together.error().text};
  const explanation::WrittenClass written{together->parsed_.source, together->parsed_.term};
  return overlap_of(explanation::find_overlap(*ontology_, thing(), written, explanation::Patience::of_a_daemon), [&] {
    auto least = std::numeric_limits<std::uint32_t>::max();
    for (const ClassNumber above : subsumers(place)) {
      const auto down = distance_up(place_of_other, above);
      if (down) least = std::min(least, distance_up(place, above).value_or(0) + *down);
    }
    return least;
  });
}

std::vector<std::string> Vocabulary::exclusion(const Expression& one, const Expression& other) const {
  const auto together = both(one, other);
  if (!together) return {};
  const explanation::WrittenClass written{together->parsed_.source, together->parsed_.term};
  return texts(explanation::explain_exclusion(*ontology_, thing(), written, explanation::Patience::of_a_daemon));
}

std::vector<std::string> Vocabulary::exclusion(ClassNumber one, ClassNumber other) const {
  return texts(explanation::explain_exclusion(*ontology_, one, other, explanation::Patience::of_a_daemon));
}

std::vector<std::string> Vocabulary::exclusion(ClassNumber one, const Expression& other) const {
  const explanation::WrittenClass written{other.parsed_.source, other.parsed_.term};
  return texts(explanation::explain_exclusion(*ontology_, one, written, explanation::Patience::of_a_daemon));
}

// All of one are of another if nothing is one without being the other.
std::vector<explanation::ExplainedAxiom> Vocabulary::proof(const Expression& sub, const Expression& super) const {
  const std::string text = "not (" + super.canonical() + ")";
  const auto outside = read(text, text.size());
  const auto together = outside ? both(sub, *outside) : outside;
  if (!together) return {};
  const explanation::WrittenClass written{together->parsed_.source, together->parsed_.term};
  return explanation::explain_exclusion(*ontology_, thing(), written, explanation::Patience::of_a_daemon);
}

}  // namespace geminga::vocabulary
