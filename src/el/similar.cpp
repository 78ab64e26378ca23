// Classes are compared by their local name and by their label.
#include "el/similar.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/edit_distance.hpp"
#include "base/text.hpp"
#include "el/compiled_view.hpp"

namespace geminga::el {
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

/// The IRI that the name would have.
std::string iri_of(const Ontology& ontology, std::string_view name) {
  const std::size_t colon = name.find(':');
  for (const auto& [prefix, iri] : prefixes_of(ontology.view())) {
    if (colon != std::string_view::npos && prefix == name.substr(0, colon))
      return std::string(iri) + std::string(name.substr(colon + 1));
  }
  return std::string(name);
}

struct Range {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// The classes to be compared: as many before the place of the name as behind it. Classes ascend by IRI.
Range range_around(const Ontology& ontology, std::string_view name, std::size_t most) {
  const std::uint32_t count = ontology.class_count();
  if (count <= most) return {0, count};
  const std::string iri = iri_of(ontology, name);
  Range range{0, count};
  while (range.begin < range.end) {
    const std::uint32_t middle = range.begin + (range.end - range.begin) / 2;
    if (ontology.iri(ClassNumber{middle}) < iri) {
      range.begin = middle + 1;
    } else {
      range.end = middle;
    }
  }
  const auto wanted = static_cast<std::uint32_t>(most);
  const std::uint32_t begin = std::min(range.begin - std::min(range.begin, wanted / 2), count - wanted);
  return {begin, begin + wanted};
}

}  // namespace

std::vector<std::string> find_similar(const Ontology& ontology, std::string_view name, const SimilarLimits& limits) {
  name = without_brackets(name);
  const std::string_view local = local_name(name);
  const std::size_t limit = base::tolerated_slips(local);
  std::vector<std::pair<std::size_t, std::string>> found;
  const Range range = range_around(ontology, name, limits.classes);
  for (std::uint32_t number = range.begin; number < range.end; ++number) {
    const ClassNumber of{number};
    const std::size_t by_name = base::edit_distance(local, local_name(ontology.iri(of)), limit);
    const std::size_t by_label =
        ontology.label(of).empty() ? limit + 1 : base::edit_distance(name, ontology.label(of), limit);
    const std::size_t nearest = std::min(by_name, by_label);
    if (nearest <= limit) found.emplace_back(nearest, ontology.short_name(of));
  }
  std::ranges::sort(found);
  std::vector<std::string> names;
  for (auto& [distance, similar] : found) {
    if (names.size() == limits.names) break;
    names.push_back(std::move(similar));
  }
  return names;
}

std::string alternatives(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  const std::size_t shown = std::min(names.size(), most);
  for (std::size_t at = 0; at < shown; ++at) {
    text += at == 0 ? "" : at + 1 == names.size() ? " or " : ", ";
    text += base::printable(names[at], 400);
  }
  return shown == names.size() ? text : text + " or one of " + std::to_string(names.size() - shown) + " more";
}

std::string did_you_mean(const std::vector<std::string>& names) {
  return names.empty() ? std::string() : ": did you mean " + alternatives(names) + '?';
}

}  // namespace geminga::el
