#include "discovery/matching/degrees/signature.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "discovery/matching/degrees/representation.hpp"

namespace geminga::matching {
namespace {

using Parameters = std::vector<Parameter>;

constexpr std::size_t max_shown_name = 200;

Parameter parameter_of(std::string_view word, const vocabulary::Vocabulary& vocabulary) {
  const auto number = vocabulary.find_term(word);
  if (number) {
    const bool has_instances = vocabulary.is_satisfiable(*number);
    return {std::string(vocabulary.iri(*number)), has_instances ? number : std::nullopt};
  }
  const bool is_bracketed = word.size() > 2 && word.starts_with('<') && word.ends_with('>');
  return {std::string(is_bracketed ? word.substr(1, word.size() - 2) : word), std::nullopt};
}

/// Takes the first name off a list with blanks and commas between names; empty where none is left. An IRI in angle
/// brackets may have commas.
std::string_view take_name(std::string_view& list) {
  constexpr std::string_view separators = " ,\t\r\n";
  list.remove_prefix(std::min(list.find_first_not_of(separators), list.size()));
  const std::size_t bracket = list.starts_with('<') ? std::min(list.find('>'), list.size()) : 0;
  const std::string_view name = list.substr(0, list.find_first_of(separators, bracket));
  list.remove_prefix(name.size());
  return name;
}

std::optional<Parameters> parameters_of(const Attributes& attributes, std::string_view key,
                                        const vocabulary::Vocabulary& vocabulary) {
  const auto stated = attributes.find(key);
  if (stated == attributes.end()) return std::nullopt;
  Parameters found;
  std::string_view rest = stated->second;
  for (auto name = take_name(rest); !name.empty(); name = take_name(rest))
    found.push_back(parameter_of(name, vocabulary));
  return found;
}

/// The best match of a required parameter among those that are there.
std::optional<Match> best(const Parameter& required, const Parameters& there, Degree weakest,
                          const vocabulary::Vocabulary& vocabulary) {
  std::optional<Match> found;
  for (const Parameter& one : there) {
    const auto match = degree_of_name({one.name, one.number}, {required.name, required.number}, vocabulary);
    if (match && !is_weaker(match->degree, weakest) && (!found || *match < *found)) found = match;
  }
  return found;
}

const Parameters& stated(const std::optional<Parameters>& parameters) {
  static const Parameters none;
  return parameters ? *parameters : none;
}

/// Calls `visit(what, required, match)` for each parameter of both sides.
template <typename Visit>
void visit_parameters(const Signature& offered, const Signature& asked, Degree weakest,
                      const vocabulary::Vocabulary& vocabulary, const Visit& visit) {
  for (const Parameter& wanted : stated(asked.outputs))
    visit("output", wanted, best(wanted, stated(offered.outputs), weakest, vocabulary));
  if (!asked.inputs) return;
  for (const Parameter& needed : stated(offered.inputs))
    visit("input", needed, best(needed, *asked.inputs, weakest, vocabulary));
}

}  // namespace

const Signature& stated(const Signature* signature) {
  static const Signature none;
  return signature == nullptr ? none : *signature;
}

bool has_signature(const Attributes& attributes) {
  return attributes.contains(inputs_attribute) || attributes.contains(outputs_attribute);
}

Signature signature_of(const Attributes& attributes, const vocabulary::Vocabulary& vocabulary) {
  return {parameters_of(attributes, inputs_attribute, vocabulary),
          parameters_of(attributes, outputs_attribute, vocabulary)};
}

std::optional<Match> degree_of_signature(const Signature& offered, const Signature& asked, Degree weakest,
                                         const vocabulary::Vocabulary& vocabulary) {
  std::optional<Match> all = Match{Degree::exact, 0};
  visit_parameters(offered, asked, weakest, vocabulary,
                   [&](std::string_view, const Parameter&, const std::optional<Match>& match) {
                     all = all && match ? std::optional(combined(*all, *match)) : std::nullopt;
                   });
  return all;
}

std::string signature_misfit(const Signature& offered, const Signature& asked, Degree weakest,
                             const vocabulary::Vocabulary& vocabulary) {
  std::string why;
  visit_parameters(offered, asked, weakest, vocabulary,
                   [&](std::string_view what, const Parameter& required, const std::optional<Match>& match) {
                     if (match) return;
                     const std::string name = required.number ? vocabulary.short_name(*required.number)
                                                              : base::printable(required.name, max_shown_name);
                     why += (why.empty() ? "" : ", ") + std::string(what) + ' ' + name +
                            (what == "output" ? " is asked for and not offered" : " is needed and not given");
                   });
  return why;
}

}  // namespace geminga::matching
