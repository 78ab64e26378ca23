// Names, and what is known of the ontology.
#include "reasoning/vocabulary/vocabulary.hpp"

#include <algorithm>
#include <ranges>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/manchester/parse.hpp"
#include "reasoning/taxonomy/classified_view.hpp"
#include "reasoning/vocabulary/conversions.hpp"

namespace geminga::vocabulary {

Vocabulary::Vocabulary(std::shared_ptr<const compiled::Ontology> ontology) : ontology_(std::move(ontology)) {
  if (ontology_ != nullptr) conversions_ = std::make_shared<const Conversions>(ontology_);
  units_ = Units(ontology_);
}

Vocabulary::Vocabulary(compiled::Ontology ontology)
    : Vocabulary(std::make_shared<const compiled::Ontology>(std::move(ontology))) {}

std::expected<ClassNumber, std::string> Vocabulary::find(std::string_view name) const {
  const auto found = ontology_->find(name);
  if (found) return *found;
  if (found.error().kind != compiled::NameError::Kind::unknown) return std::unexpected(found.error().text);
  const compiled::SimilarLimits limits{.classes = compiled::max_compared_classes};
  return std::unexpected(found.error().text + compiled::did_you_mean(compiled::find_similar(*ontology_, name, limits)));
}

std::optional<ClassNumber> Vocabulary::find_iri(std::string_view iri) const {
  return is_loaded() ? ontology_->find_iri(iri) : std::nullopt;
}

std::optional<ClassNumber> Vocabulary::find_term(std::string_view name) const {
  if (!is_loaded()) return std::nullopt;
  if (name.starts_with('<')) return name.ends_with('>') ? find_iri(name.substr(1, name.size() - 2)) : std::nullopt;
  const std::size_t colon = name.find(':');
  if (colon != std::string_view::npos) {
    const auto prefixes = ontology_->prefixes();
    const std::string_view word = name.substr(0, colon);
    auto prefix = std::ranges::lower_bound(prefixes, word, {}, [](const auto& one) { return one.first; });
    for (; prefix != prefixes.end() && prefix->first == word; ++prefix) {
      if (const auto found = find_iri(std::string(prefix->second) + std::string(name.substr(colon + 1)))) return found;
    }
  }
  return find_iri(name);
}

bool Vocabulary::is_expression(std::string_view name) const {
  return is_loaded() && manchester::is_compound(name) && !ontology_->find(name);
}

std::string_view Vocabulary::iri(ClassNumber number) const { return ontology_->iri(number); }

std::string Vocabulary::short_name(ClassNumber number) const { return ontology_->short_name(number); }

std::vector<std::string> Vocabulary::short_names_with(std::string_view beginning, std::size_t most) const {
  std::vector<std::string> names;
  if (!is_loaded()) return names;
  std::size_t left = most * 16;
  // Classes are numbered by their IRIs, so that those with one beginning stand together.
  const auto take = [&](std::string_view iri_beginning, const std::string& prefix, std::size_t namespace_size) {
    const auto all = std::views::iota(std::uint32_t{0}, class_count());
    const auto by_iri = [&](std::uint32_t number) { return iri(ClassNumber{number}); };
    for (auto at = std::ranges::lower_bound(all, iri_beginning, {}, by_iri); at != all.end(); ++at) {
      const std::string_view found = iri(ClassNumber{*at});
      if (!found.starts_with(iri_beginning) || names.size() == most || left == 0) return;
      --left;
      std::string name = short_name(ClassNumber{*at});
      // A class with several prefixes has one short name.
      if (namespace_size == 0 ? name.starts_with('<') : name == prefix + std::string(found.substr(namespace_size))) {
        names.push_back(std::move(name));
      }
    }
  };
  for (const auto& [word, space] : ontology_->prefixes()) {
    const std::string prefix = std::string(word) + ':';
    if (prefix.starts_with(beginning)) {
      take(space, prefix, space.size());
    } else if (beginning.starts_with(prefix)) {
      take(std::string(space) + std::string(beginning.substr(prefix.size())), prefix, space.size());
    }
  }
  if (beginning.empty() || beginning.starts_with('<')) take(beginning.substr(beginning.empty() ? 0 : 1), "", 0);
  return names;
}

std::string Vocabulary::short_name(std::string_view iri) const {
  return is_loaded() ? ontology_->short_name(iri) : "<" + std::string(iri) + ">";
}

// In canonical text, angle brackets enclose IRIs. They also stand in comparisons, behind a blank, and within quotation
// marks, where a backslash escapes the next character.
std::string Vocabulary::short_expression(std::string_view canonical) const {
  std::string text;
  bool is_quoted = false;
  for (std::size_t at = 0; at < canonical.size(); ++at) {
    const std::size_t end = canonical.find('>', at);
    const bool is_iri = !is_quoted && canonical[at] == '<' && end != std::string_view::npos &&
                        canonical.substr(at, end - at).find(' ') == std::string_view::npos;
    if (is_iri) {
      text += short_name(canonical.substr(at + 1, end - at - 1));
      at = end;
      continue;
    }
    if (canonical[at] == '"') is_quoted = !is_quoted;
    text += canonical[at];
    if (is_quoted && canonical[at] == '\\' && at + 1 < canonical.size()) text += canonical[++at];
  }
  return text;
}

std::uint32_t Vocabulary::class_count() const { return is_loaded() ? ontology_->class_count() : 0; }

ClassNumber Vocabulary::thing() const { return ClassNumber{ontology_->view().thing}; }

bool Vocabulary::is_satisfiable(ClassNumber number) const { return ontology_->is_satisfiable(number); }

bool Vocabulary::is_subsumed(ClassNumber sub, ClassNumber super) const { return ontology_->is_subsumed(sub, super); }

std::optional<std::uint32_t> Vocabulary::distance(ClassNumber sub, ClassNumber super) const {
  return ontology_->distance(sub, super);
}

std::vector<ClassNumber> Vocabulary::subsumers(ClassNumber number) const { return ontology_->subsumers(number); }

std::vector<ClassNumber> Vocabulary::subsumers(const Place& place) const {
  return placement::subsumers(place, *ontology_);
}

std::vector<ClassNumber> Vocabulary::parents(ClassNumber number) const { return ontology_->parents(number); }

std::vector<ClassNumber> Vocabulary::children(ClassNumber number) const { return ontology_->children(number); }

bool Vocabulary::is_above(const Place& place, ClassNumber sub) const {
  return placement::is_above(place, sub, *ontology_);
}

std::optional<std::uint32_t> Vocabulary::distance_up(const Place& place, ClassNumber super) const {
  return placement::distance_up(place, super, *ontology_);
}

std::optional<std::uint32_t> Vocabulary::distance_down(const Place& place, ClassNumber sub) const {
  return placement::distance_down(place, sub, *ontology_);
}

std::shared_ptr<const Chain> Vocabulary::conversion(ClassNumber offered, ClassNumber requested) const {
  return conversions_->cheapest(offered, requested);
}

const StepGraph& Vocabulary::conversions() const { return conversions_->graph(); }

std::uint64_t Vocabulary::digest() const { return is_loaded() ? ontology_->digest() : 0; }

bool Vocabulary::is_consistent() const { return !is_loaded() || ontology_->is_consistent(); }

std::vector<owl::LoadedFile> Vocabulary::files() const {
  return is_loaded() ? ontology_->files() : std::vector<owl::LoadedFile>();
}

std::vector<owl::LeftOut> Vocabulary::left_out() const {
  return is_loaded() ? ontology_->left_out() : std::vector<owl::LeftOut>();
}

std::vector<std::string> Vocabulary::gaps() const {
  return is_loaded() ? ontology_->gaps() : std::vector<std::string>();
}

std::optional<std::string> Vocabulary::undecided() const {
  const auto all = gaps();
  const auto open =
      std::ranges::find_if(all, [](const std::string& gap) { return gap.starts_with(compiled::undecided_words); });
  return open == all.end() ? std::nullopt : std::optional(open->substr(compiled::undecided_words.size()));
}

}  // namespace geminga::vocabulary
