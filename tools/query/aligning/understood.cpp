#include "query/aligning/understood.hpp"

#include <algorithm>
#include <utility>

namespace geminga::query {
namespace {

/// A concept and a representation by IRI. The representation of a request that takes any, and of a service that states
/// none, is empty.
struct Meant {
  std::string concept_iri;
  std::string representation_iri;
};

Meant meant_by(const Record& record) { return {iri_in(record["concept"]), iri_in(record["representation"])}; }

bool meets(const Meant& service, const Meant& request, const Closure& closure) {
  if (!closure.is_below(service.concept_iri, request.concept_iri)) return false;
  if (request.representation_iri.empty()) return true;
  return !service.representation_iri.empty() &&
         closure.is_below(service.representation_iri, request.representation_iri);
}

/// The most specific classes of ours that are above `iri` with the links.
std::vector<std::string> nearest(const std::string& iri, const Closure& with, const Closure& today,
                                 const std::function<bool(const std::string&)>& is_ours) {
  std::vector<std::string> classes;
  for (const std::string& above : with.above(iri)) {
    if (is_ours(above)) classes.push_back(above);
  }
  std::vector<std::string> most_specific;
  for (const std::string& one : classes) {
    const bool has_narrower = std::ranges::any_of(classes, [&](const std::string& other) {
      return other != one && today.is_below(other, one) && !today.is_below(one, other);
    });
    if (!has_narrower) most_specific.push_back(one);
  }
  return most_specific;
}

}  // namespace

Closure Closure::read(std::istream& lines, const std::set<std::string, std::less<>>& wanted) {
  Closure closure;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos || !wanted.contains(std::string_view(line).substr(0, tab))) continue;
    closure.above_[line.substr(0, tab)].insert(line.substr(tab + 1));
  }
  return closure;
}

bool Closure::is_below(const std::string& sub, const std::string& super) const {
  return sub == super || above(sub).contains(super);
}

const std::set<std::string>& Closure::above(const std::string& sub) const {
  static const std::set<std::string> none;
  const auto found = above_.find(sub);
  return found == above_.end() ? none : found->second;
}

std::string iri_in(std::string_view field) {
  const bool is_iri = field.size() > 2 && field.front() == '<' && field.back() == '>' &&
                      field.find_first_of(" <>", 1) == field.size() - 1;
  return is_iri ? std::string(field.substr(1, field.size() - 2)) : "";
}

std::set<std::string, std::less<>> concepts_of(const std::vector<Record>& services,
                                               const std::vector<Record>& requests) {
  std::set<std::string, std::less<>> iris;
  for (const auto* records : {&services, &requests}) {
    for (const Record& record : *records) {
      for (const char* key : {"concept", "representation"}) {
        if (std::string iri = iri_in(record[key]); !iri.empty()) iris.insert(std::move(iri));
      }
    }
  }
  return iris;
}

Understood understood_with(const std::vector<Record>& services, const std::vector<Record>& requests,
                           const Closure& today, const Closure& with,
                           const std::function<bool(const std::string&)>& is_ours) {
  Understood understood;
  const auto is_expression = [](const Record& record) {
    return !record["concept"].empty() && iri_in(record["concept"]).empty();
  };
  understood.expressions = static_cast<std::size_t>(std::ranges::count_if(services, is_expression)) +
                           static_cast<std::size_t>(std::ranges::count_if(requests, is_expression));
  for (const Record& service : services) {
    const Meant offered = meant_by(service);
    if (offered.concept_iri.empty()) continue;
    for (const Record& request : requests) {
      const Meant asked = meant_by(request);
      if (asked.concept_iri.empty() || request["mode"] != service["mode"]) continue;
      if (meets(offered, asked, with) && !meets(offered, asked, today))
        understood.meetings.push_back({service, request});
    }
    if (is_ours(offered.concept_iri)) continue;
    auto classes = nearest(offered.concept_iri, with, today, is_ours);
    if (!classes.empty()) understood.meanings.push_back({service, std::move(classes)});
  }
  return understood;
}

}  // namespace geminga::query
