#include "reasoning/syntax/rdf/scan/bases.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace geminga::rdf {
namespace {

/// Where the path of an IRI with an authority begins; nothing for any other IRI.
std::optional<std::size_t> path_of(std::string_view iri) {
  const std::size_t scheme_end = iri.find("://");
  if (scheme_end == std::string_view::npos || scheme_end > iri.find_first_of("/?#")) return std::nullopt;
  return std::min(iri.find_first_of("/?#", scheme_end + 3), iri.size());
}

/// Whether raptor would make other names of this base than RFC 3986.
bool is_mistaken(std::string_view iri, bool is_xml) {
  const auto path = path_of(iri);
  if (!path) return false;
  const bool has_path = *path < iri.size() && iri[*path] == '/';
  const std::size_t fragment = std::min(iri.find('#'), iri.size());
  const bool has_query = iri.substr(0, fragment).find('?') != std::string_view::npos;
  return !has_path || (is_xml ? has_query : fragment < iri.size());
}

std::string in_attribute(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '"' || c == '\'') {
      out += c == '"' ? "&quot;" : "&apos;";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::vector<Rewrite> Bases::mark(std::string_view text, const std::vector<BaseText>& bases, bool is_xml) {
  constexpr std::size_t max_marks = 64;  // each is looked for in each IRI; beyond, raptor resolves as it does
  std::string segment = "geminga.base.";
  std::vector<Rewrite> rewrites;
  for (const BaseText& base : bases) {
    if (!is_mistaken(base.iri, is_xml)) continue;
    // No name of the file may look like a mark.
    while (marks_.empty() && text.find(segment) != std::string_view::npos) segment += '.';
    Mark mark;
    mark.base = base.iri.substr(0, base.iri.find('#'));
    auto known = std::ranges::find(marks_, mark.base, &Mark::base);
    if (known == marks_.end()) {
      if (marks_.size() >= max_marks) continue;
      mark.without_query = mark.base.substr(0, mark.base.find('?'));
      const std::size_t path = *path_of(mark.base);
      const std::size_t last = mark.without_query.rfind('/');
      mark.marked = path < mark.without_query.size() ? mark.without_query.substr(0, last) : mark.without_query;
      mark.marked += '/' + segment + std::to_string(marks_.size()) + '.';
      marks_.push_back(std::move(mark));
      known = marks_.end() - 1;
    }
    rewrites.push_back({base.begin, base.size, is_xml ? in_attribute(known->marked) : known->marked});
  }
  return rewrites;
}

std::string_view Bases::restored(std::string_view iri, std::string& room) const {
  for (const Mark& mark : marks_) {
    if (!iri.starts_with(mark.marked)) continue;
    const std::string_view rest = iri.substr(mark.marked.size());
    room = rest.starts_with('?') ? mark.without_query : mark.base;
    return room.append(rest);
  }
  return iri;
}

}  // namespace geminga::rdf
