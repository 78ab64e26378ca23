// The services that would be understood with the links to another ontology and are not today.
#ifndef GEMINGA_QUERY_ALIGNING_UNDERSTOOD_HPP
#define GEMINGA_QUERY_ALIGNING_UNDERSTOOD_HPP

#include <functional>
#include <istream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::query {

/// The superclasses of classes, by IRI, as `geminga-ontology classify --closure` prints them.
class Closure {
 public:
  /// Reads lines SUB<TAB>SUPER and keeps those of `wanted` subclasses.
  [[nodiscard]] static Closure read(std::istream& lines, const std::set<std::string, std::less<>>& wanted);

  /// Whether a class is the other one or below it.
  [[nodiscard]] bool is_below(const std::string& sub, const std::string& super) const;
  /// The classes above one, sorted; none where the class is unknown.
  [[nodiscard]] const std::set<std::string>& above(const std::string& sub) const;

 private:
  std::map<std::string, std::set<std::string>> above_;
};

/// A service and a request that would meet.
struct Meeting {
  Record service;
  Record request;
};

/// A service of a class that has no place today, and the most specific classes of ours that would be above it.
struct Meaning {
  Record service;
  std::vector<std::string> classes;  ///< IRIs, sorted
};

struct Understood {
  std::vector<Meeting> meetings;
  std::vector<Meaning> meanings;
  std::size_t expressions = 0;  ///< services and requests of class expressions, which are not compared
};

/// The IRI of a field with an IRI in angle brackets; empty for anything else.
[[nodiscard]] std::string iri_in(std::string_view field);

/// The IRIs of the concepts and representations of services and requests, which were asked for with iris=1.
[[nodiscard]] std::set<std::string, std::less<>> concepts_of(const std::vector<Record>& services,
                                                             const std::vector<Record>& requests);

/// Compares services and requests of one mode by concept and representation: conditions, scopes, protocols and
/// conversions are not looked at. `with` is the closure of our ontology, the other one, and the links; `today` that of
/// ours. A class of ours is one that `is_ours` names.
[[nodiscard]] Understood understood_with(const std::vector<Record>& services, const std::vector<Record>& requests,
                                         const Closure& today, const Closure& with,
                                         const std::function<bool(const std::string&)>& is_ours);

}  // namespace geminga::query

#endif
