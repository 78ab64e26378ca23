// Classes are compared by their local name and by their label.
#include "reasoning/compiled/similar.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include "base/edit_distance.hpp"
#include "base/text.hpp"

namespace geminga::compiled {
namespace {

std::string_view without_brackets(std::string_view name) {
  if (name.size() > 2 && name.front() == '<' && name.back() == '>') return name.substr(1, name.size() - 2);
  return name;
}

/// The most bits of a signature that one typing error changes: two swapped letters take part in three pairs.
constexpr std::size_t bits_per_slip = 6;

/// The classes to compare, ascending: those whose signatures differ least from those of the name.
std::vector<std::uint32_t> candidates_of(const Ontology& ontology, std::string_view name, std::size_t slips,
                                         std::size_t most) {
  const std::uint32_t count = ontology.class_count();
  std::vector<std::uint32_t> candidates;
  const std::span<const std::uint64_t> signatures = ontology.signatures();
  if (count <= most || signatures.size() != 2 * std::size_t{count}) {
    for (std::uint32_t of = 0; of < std::min<std::size_t>(count, most); ++of) candidates.push_back(of);
    return candidates;
  }
  const std::uint64_t by_name = signature_of(local_name(name));
  const std::uint64_t by_label = signature_of(name);
  std::vector<std::uint8_t> distances(count);
  std::array<std::size_t, 65> at_distance{};
  for (std::uint32_t of = 0; of < count; ++of) {
    const std::uint64_t label = signatures[std::size_t{2} * of + 1];
    int distance = std::popcount(by_name ^ signatures[std::size_t{2} * of]);
    if (label != 0) distance = std::min(distance, std::popcount(by_label ^ label));
    distances[of] = static_cast<std::uint8_t>(distance);
    ++at_distance[static_cast<std::size_t>(distance)];
  }
  // All classes up to some distance, and as many of the next distance as there is room for.
  std::size_t whole = 0;
  std::size_t room = most;
  const std::size_t beyond = std::min<std::size_t>(slips * bits_per_slip + 1, at_distance.size());
  while (whole < beyond && at_distance[whole] <= room) room -= at_distance[whole++];
  if (whole == beyond) room = 0;
  for (std::uint32_t of = 0; of < count; ++of) {
    if (distances[of] > whole || (distances[of] == whole && room == 0)) continue;
    if (distances[of] == whole) --room;
    candidates.push_back(of);
  }
  return candidates;
}

}  // namespace

std::string_view local_name(std::string_view name) {
  const auto end = name.find_last_of(":/#");
  return end == std::string_view::npos ? name : name.substr(end + 1);
}

std::uint64_t signature_of(std::string_view word) {
  const auto lower = [](char c) {
    const auto octet = static_cast<unsigned char>(c);
    return static_cast<std::uint32_t>(c >= 'A' && c <= 'Z' ? octet | 0x20U : octet);
  };
  std::uint64_t signature = 0;
  std::uint32_t last = 0;
  const auto add = [&](std::uint32_t next) {
    signature |= std::uint64_t{1} << (((last << 8U | next) * 0x9e3779b1U) >> 26U);
    last = next;
  };
  for (const char c : word.substr(0, base::max_compared_bytes)) add(lower(c));
  add(0);
  return signature;
}

std::vector<std::string> find_similar(const Ontology& ontology, std::string_view name, const SimilarLimits& limits) {
  name = without_brackets(name);
  const std::string_view local = local_name(name);
  const std::size_t limit = base::tolerated_slips(local);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::uint32_t number : candidates_of(ontology, name, limit, limits.classes)) {
    const taxonomy::ClassNumber of{number};
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

}  // namespace geminga::compiled
