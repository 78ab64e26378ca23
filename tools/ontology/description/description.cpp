#include "ontology/description/description.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/manchester/canonical.hpp"

namespace geminga::ontology {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

/// The largest parts of an expression that is too large, as many as its error names.
constexpr std::size_t named_parts = 3;
/// Octets of a part that are shown.
constexpr std::size_t max_part_bytes = 100;

/// The individual that a fact is about; nothing for an axiom that is no positive fact.
std::optional<TermId> subject_of(const owl::Axiom& axiom) {
  switch (axiom.kind) {
    case AxiomKind::class_assertion:
    case AxiomKind::object_property_assertion:
    case AxiomKind::data_property_assertion:
      return axiom.arguments[1];
    default:
      return std::nullopt;
  }
}

/// Walks from individual to individual along the facts.
class Reduction {
 public:
  Reduction(owl::Ontology& source, owl::FileId file, const owl::ShortName& short_name)
      : source_(source), file_(file), short_name_(short_name) {
    for (std::size_t index = 0; index < source.axiom_count(); ++index) {
      if (const auto subject = subject_of(source.axiom(index))) facts_[*subject].push_back(index);
    }
  }

  std::expected<Description, std::string> run() {
    const TermId self = source_.individual(self_iri);
    if (!facts_.contains(self)) {
      return std::unexpected("says nothing of <" + std::string(self_iri) + ">: state facts about geminga:self");
    }
    const std::vector<TermId> parts = conjuncts(self);
    if (is_over_) {
      return std::unexpected("its chains of facts take more than " + std::to_string(max_described_facts) +
                             " steps: state fewer of them");
    }
    if (parts.empty()) return std::unexpected("says of geminga:self nothing that describes it: state its class");
    Description found{.expression = manchester::canonical(source_, conjunction(parts)), .dropped = {}};
    if (found.expression.size() > max_described_bytes) return std::unexpected(too_large(found.expression, parts));
    name_the_rest();
    std::ranges::stable_sort(dropped_, {}, &Dropped::line);
    found.dropped = std::move(dropped_);
    return found;
  }

 private:
  TermId conjunction(std::span<const TermId> parts) {
    if (parts.empty()) return owl::thing_term;
    return parts.size() == 1 ? parts.front() : source_.term(TermKind::object_intersection_of, parts);
  }

  /// The class expressions that the facts say of an individual, each once.
  std::vector<TermId> conjuncts(TermId individual) {
    path_.push_back(individual);
    std::vector<TermId> parts;
    if (const auto facts = facts_.find(individual); facts != facts_.end()) {
      for (const std::size_t index : facts->second) {
        if (++steps_ > max_described_facts) {
          is_over_ = true;
          break;
        }
        if (const auto part = part_of(index)) parts.push_back(*part);
      }
    }
    path_.pop_back();
    std::ranges::sort(parts);
    parts.erase(std::ranges::unique(parts).begin(), parts.end());
    return parts;
  }

  std::optional<TermId> part_of(std::size_t index) {
    const owl::Axiom axiom = source_.axiom(index);
    taken_.insert(index);
    const TermId predicate = axiom.arguments[0];
    if (axiom.kind == AxiomKind::class_assertion) {
      return predicate == owl::thing_term ? std::nullopt : std::optional(predicate);
    }
    const TermId object = axiom.arguments[2];
    if (axiom.kind == AxiomKind::data_property_assertion) {
      return source_.term(TermKind::data_has_value, {predicate, object});
    }
    if (std::ranges::find(path_, object) != path_.end()) return drop(index, "it leads back to where it came from");
    if (path_.size() > max_described_depth) {
      return drop(index, "it is behind more than " + std::to_string(max_described_depth) + " others");
    }
    const TermId filler = conjunction(conjuncts(object));
    return source_.term(TermKind::object_some_values_from, {predicate, filler});
  }

  std::nullopt_t drop(std::size_t index, const std::string& why) {
    const owl::Axiom axiom = source_.axiom(index);
    if (axiom.file == file_ && named_.insert(index).second) {
      dropped_.push_back({axiom.line, owl::print(source_, axiom, short_name_) + ": " + why});
    }
    return std::nullopt;
  }

  /// Names the axioms of the file that no part of the description came from, and what no axiom says.
  void name_the_rest() {
    for (std::size_t index = 0; index < source_.axiom_count(); ++index) {
      const owl::Axiom axiom = source_.axiom(index);
      if (axiom.file != file_ || axiom.kind == AxiomKind::declaration || taken_.contains(index)) continue;
      const bool is_fact = axiom.kind >= AxiomKind::same_individual && axiom.kind != AxiomKind::dl_safe_rule;
      if (!is_fact) {
        drop(index, "it is no fact: state it in the ontology of the team");
      } else if (subject_of(axiom)) {
        drop(index, "it is not about geminga:self or what that has");
      } else {
        drop(index, "an expression cannot say it");
      }
    }
    for (const owl::Ontology::Omission& lost : source_.omissions()) {
      if (lost.file == file_) dropped_.push_back({lost.line, std::string(source_.name(lost.construct))});
    }
  }

  std::string too_large(const std::string& expression, const std::vector<TermId>& parts) {
    std::vector<std::pair<std::size_t, std::string>> sized;
    for (const TermId part : parts) {
      std::string shown = base::printable(owl::print(source_, part, short_name_), max_part_bytes);
      sized.emplace_back(manchester::canonical(source_, part).size(), std::move(shown));
    }
    std::ranges::sort(sized, std::ranges::greater());
    std::string text = "the facts make an expression of " + std::to_string(expression.size()) +
                       " octets with full IRIs, and " + std::to_string(max_described_bytes) +
                       " can be announced: leave out what nobody asks for, the largest are";
    for (std::size_t at = 0; at < std::min(sized.size(), named_parts); ++at) {
      text += (at == 0 ? " " : ", ") + sized[at].second + " (" + std::to_string(sized[at].first) + ")";
    }
    return text;
  }

  owl::Ontology& source_;
  owl::FileId file_;
  const owl::ShortName& short_name_;
  std::map<TermId, std::vector<std::size_t>> facts_;  ///< axioms by the individual that they are about
  std::vector<TermId> path_;                          ///< the individuals from geminga:self to the present one
  std::size_t steps_ = 0;
  bool is_over_ = false;
  std::set<std::size_t> taken_;  ///< axioms that were met
  std::set<std::size_t> named_;
  std::vector<Dropped> dropped_;
};

}  // namespace

std::expected<Description, std::string> describe_self(owl::Ontology& source, owl::FileId file,
                                                      const owl::ShortName& short_name) {
  return Reduction(source, file, short_name).run();
}

}  // namespace geminga::ontology
