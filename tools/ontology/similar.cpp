// Every class is compared by its local name and by its label.
#include "similar.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/edit_distance.hpp"

namespace geminga::ontology {
namespace {

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

std::vector<std::string> find_similar(const el::Ontology& ontology, std::string_view name, std::size_t count) {
  name = without_brackets(name);
  const std::string_view local = local_name(name);
  const std::size_t limit = base::tolerated_slips(local);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (std::uint32_t number = 0; number < ontology.class_count(); ++number) {
    const el::ClassNumber of{number};
    const std::size_t by_name = base::edit_distance(local, local_name(ontology.iri(of)), limit);
    const std::size_t by_label =
        ontology.label(of).empty() ? limit + 1 : base::edit_distance(name, ontology.label(of), limit);
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
