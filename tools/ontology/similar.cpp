// Edit distances in bands, so that a wrong name costs nothing that one would notice in 350k classes.
#include "similar.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace geminga::ontology {
namespace {

/// Longer names are no slips of the keyboard, and would only cost time.
constexpr std::size_t max_name_bytes = 200;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// What stands behind the prefix.
std::string_view local_name(std::string_view name) {
  const auto colon = name.find_last_of(":/#");
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view without_brackets(std::string_view name) {
  if (name.size() > 2 && name.front() == '<' && name.back() == '>') return name.substr(1, name.size() - 2);
  return name;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > limit || b.size() > max_name_bytes) return limit + 1;
  std::vector<std::size_t> before(a.size() + 1);
  std::vector<std::size_t> last(a.size() + 1);
  std::vector<std::size_t> row(a.size() + 1);
  for (std::size_t at = 0; at <= a.size(); ++at) last[at] = at;
  for (std::size_t j = 1; j <= b.size(); ++j) {
    row[0] = j;
    std::size_t least = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
      const bool is_same = lower(a[i - 1]) == lower(b[j - 1]);
      row[i] = std::min({last[i] + 1, row[i - 1] + 1, last[i - 1] + (is_same ? 0U : 1U)});
      const bool is_swapped =
          i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (is_swapped) row[i] = std::min(row[i], before[i - 2] + 1);
      least = std::min(least, row[i]);
    }
    if (least > limit) return limit + 1;
    std::swap(before, last);
    std::swap(last, row);
  }
  return std::min(last[a.size()], limit + 1);
}

std::vector<std::string> find_similar(const el::Ontology& ontology, std::string_view name, std::size_t count) {
  name = without_brackets(name);
  const std::string_view local = local_name(name);
  // A third of the letters may be wrong, at most three.
  const std::size_t limit = std::min<std::size_t>(3, local.size() / 3);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (std::uint32_t number = 0; number < ontology.class_count(); ++number) {
    const el::ClassNumber of{number};
    const std::size_t by_name = edit_distance(local, local_name(ontology.iri(of)), limit);
    const std::size_t by_label =
        ontology.label(of).empty() ? limit + 1 : edit_distance(name, ontology.label(of), limit);
    const std::size_t nearest = std::min(by_name, by_label);
    if (nearest <= limit) found.emplace_back(nearest, ontology.short_name(of));
  }
  std::ranges::sort(found);
  std::vector<std::string> names;
  for (auto& [distance, similar] : found) {
    if (names.size() == count) break;
    names.push_back(std::move(similar));
  }
  return names;
}

}  // namespace geminga::ontology
