#include "discovery/participant/queries/missing.hpp"

#include <string>
#include <variant>
#include <vector>

#include "base/text.hpp"
#include "discovery/gcnp/parameters.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {
namespace {

using gcnp::append;
using gcnp::append_stated;
using vocabulary::NearMiss;

/// Texts one behind the other, as many as there is room for.
std::string joined(const std::vector<std::string>& texts, std::string_view between) {
  std::string all;
  for (const std::string& text : texts) {
    const std::string one = base::printable(text, max_missing_bytes);
    if (all.size() + between.size() + one.size() > max_missing_bytes) break;
    all.append(all.empty() ? "" : between).append(one);
  }
  return all;
}

/// "not known: A; B; contradicts: C".
std::string sentence(const NearMiss& way) {
  std::string text;
  if (!way.lacking.empty()) text = "not known: " + joined(way.lacking, "; ");
  if (way.contradicting.empty()) return text;
  return text + (text.empty() ? "" : "; ") + "contradicts: " + joined(way.contradicting, "; ");
}

}  // namespace

std::optional<vocabulary::NearMisses> missing_between(const vocabulary::Vocabulary& vocabulary,
                                                      const Identity& requested, const Identity& offered) {
  if (!vocabulary.is_loaded() || !vocabulary.check_expressions()) return std::nullopt;
  const auto* request = std::get_if<SemanticIdentity>(&requested);
  const auto* offer = std::get_if<SemanticIdentity>(&offered);
  if (request == nullptr || offer == nullptr) return std::nullopt;
  const auto read = [&](const SemanticIdentity& identity) {
    const bool is_expression = has_expression(identity);
    const std::string& name = identity.concept_iri;
    return vocabulary.read(is_expression ? name : "<" + name + ">", vocabulary::max_expression_bytes);
  };
  const auto asked = read(*request);
  const auto candidate = read(*offer);
  if (!asked || !candidate) return std::nullopt;
  return vocabulary.near_misses(*asked, *candidate, max_missing_questions);
}

void append_missing(Line& line, const vocabulary::NearMisses& near_misses) {
  if (near_misses.ranked.empty()) return;
  const NearMiss& first = near_misses.ranked.front();
  append(line, "missing_count", first.lacking_count);
  append_stated(line, "missing", joined(first.lacking, "\n"));
  append(line, "contradicting_count", first.contradicting_count);
  append_stated(line, "contradicting", joined(first.contradicting, "\n"));
  std::vector<std::string> others;
  for (std::size_t at = 1; at < near_misses.ranked.size(); ++at) others.push_back(sentence(near_misses.ranked[at]));
  append_stated(line, "ways", joined(others, "\n"));
  append_stated(line, "reservation", near_misses.reservation);
}

}  // namespace geminga::participant
