#include "answers/questions.hpp"

#include <algorithm>
#include <array>

#include "answers/explain.hpp"
#include "answers/ontology.hpp"
#include "answers/security.hpp"
#include "answers/status.hpp"
#include "answers/why.hpp"
#include "shell/json.hpp"

namespace geminga::answers {
namespace {

using enum Key::Type;

constexpr Key concept_key{"concept",
                          "A concept: prefix:Name, <IRI>, a label, or a class expression in Manchester syntax"};
constexpr Key representation_key{"representation", "In this representation: prefix:Name or <IRI>"};
constexpr Key id_key{"id", "This 32-bit number instead of a concept, decimal or 0x", number};
constexpr Key text_key{"text", "This text instead of a concept"};
constexpr Key mode_key{"mode", "In this mode: oto, otm/stream or otm/pubsub"};
constexpr Key convert_key{"convert", "Also what can be converted: yes, no or the largest cost"};
constexpr Key where_key{"where", "A condition over attributes, as in: rate >= 30 and frame = \"map\""};
constexpr Key on_key{"on", "On participants that are known to be this: a class or a class expression"};
constexpr Key filter_key{"filter", "A text that occurs in a word, name, identity or attribute"};

constexpr auto participant_keys = std::to_array<Key>(
    {{"concept", "Only those that are known to be this: a class or a class expression, as in: canSee some Ball"},
     {"degree", "The weakest degree that counts: exact, equivalent, narrower (the default), broader or overlapping"},
     {"where", "A condition over the attributes of their descriptions, as in: battery >= 30 %"},
     {"provider", "One of these: PARTICIPANT,..."}});
constexpr auto service_keys = std::to_array<Key>({concept_key,
                                                  representation_key,
                                                  id_key,
                                                  text_key,
                                                  mode_key,
                                                  {"provider", "Of this PARTICIPANT or PARTICIPANT/PEER"},
                                                  filter_key,
                                                  {"unused", "Only those that nobody asks for, and why", flag}});
constexpr auto request_keys = std::to_array<Key>({concept_key,
                                                  representation_key,
                                                  id_key,
                                                  text_key,
                                                  mode_key,
                                                  {"provider", "Of this consumer, PARTICIPANT or PARTICIPANT/PEER"},
                                                  filter_key,
                                                  {"unmatched", "Only those that nobody serves, and why", flag}});
constexpr auto match_keys = std::to_array<Key>(
    {concept_key,
     representation_key,
     id_key,
     text_key,
     {"degree", "The weakest degree that counts: exact, equivalent, narrower (the default), broader or overlapping"},
     mode_key,
     where_key,
     on_key,
     {"provider", "From one of these: PARTICIPANT[/PEER],..."},
     {"limit", "At most so many, the best", number},
     convert_key});
constexpr auto explain_keys = std::to_array<Key>(
    {{"sub", "The class that may be below: prefix:Name, <IRI> or a label"}, {"super", "The class that may be above"}});
constexpr auto why_keys = std::to_array<Key>(
    {{"subscription", "A request that exists, by its word PARTICIPANT/PEER/NUMBER in requests"},
     {"service", "A service that exists, by its word PARTICIPANT/PEER/NUMBER in services"},
     concept_key,
     representation_key,
     id_key,
     text_key,
     mode_key,
     {"match", "The weakest degree that the request takes: exact, equivalent, narrower, broader or overlapping"},
     {"provider", "From one of these: PARTICIPANT[/PEER],..."},
     {"favour", "First from these: PARTICIPANT[/PEER],..."},
     {"prefer", "The attributes that are best, as in: rate desc"},
     {"rank", "The criteria by which providers are ranked first"},
     where_key,
     {"protocol", "In one of these protocols, separated by commas"},
     on_key,
     {"scope", "From these hosts: host, group, any or names, and ! before what is excluded"},
     {"limit", "From so many at most", number},
     convert_key,
     {"reach", "any: also what cannot be reached from this host; default: routed"},
     {"offer.concept", "A concept that might be offered, instead of service"},
     {"offer.representation", "The representation that might be offered"},
     {"offer.id", "The number that might be offered", number},
     {"offer.text", "The text that might be offered"},
     {"offer.mode", "The mode that might be offered"},
     {"offer.address", "The address that might be offered"},
     {"offer.port", "The port that might be offered", number},
     {"offer.protocol", "The protocol that might be offered"},
     {"offer.priority", "The priority that might be offered", number},
     {"offer.scope", "The hosts for which it might be offered"},
     {"offer.for", "A condition over attributes of consumers"},
     {"offer.provider", "The PARTICIPANT/PEER that might offer it"}});

constexpr auto concepts_keys = std::to_array<Key>(
    {{"begin", "The beginning of the name, as in soccer:Ba"}, {"limit", "At most so many; never over 1000", number}});
constexpr auto taxonomy_keys =
    std::to_array<Key>({{"class", "The classes right below this one; default: owl:Thing"},
                        {"contains", "Instead, the classes in whose name this text occurs"},
                        {"skip", "The number of classes to leave out at the beginning", number},
                        {"limit", "At most so many; never over 500", number}});

constexpr auto all_kinds = std::to_array<Kind>(
    {{"participants",
      "Every robot that is known: id, name, addresses, seconds since it was heard, loss (0 to 1), digest of its "
      "ontology, whether it hears this host, its description of itself; with concept, those that are known to be that.",
      "id", participant_keys},
     {"services",
      "Every service that is offered in the team, with its provider, concept, mode, address and whether it is used.",
      "service", service_keys},
     {"requests",
      "Every request for services in the team, and whether it is served; with unmatched, the likely reason why nobody "
      "serves it.",
      "subscription", request_keys},
     {"match", "The services that suit a concept, expression, number or text, best first, with the degree of each.",
      "service", match_keys},
     {"explain", "Whether one class of the ontology is below another, and the axioms that say so, with file and line.",
      "", explain_keys},
     {"why",
      "Why a request and a service meet or do not: each check with its reason and what would mend it. With a request "
      "alone: why nobody serves it, or who does; with a service alone: who takes it. Either may be one that nobody has "
      "stated.",
      "", why_keys, true},
     {"ontology",
      "The ontology that is loaded: files, classes, digest, what the reasoner left out, and robots that have another "
      "one.",
      "",
      {}},
     {"concepts", "The names of classes of the ontology that begin with a text.", "", concepts_keys},
     {"taxonomy",
      "The tree of the ontology's classes, node by node, with how many offers and requests are below each; those below "
      "<http://www.w3.org/2002/07/owl#Nothing> can have no instance.",
      "", taxonomy_keys},
     {"hearing",
      "Who hears whom: what each other robot last said of whom it has heard within a quarter, a half or one interval, "
      "or "
      "longer ago.",
      "witness",
      {}},
     {"status", "The daemon itself: state, uptime, counts, traffic, memory.", "", {}},
     {"security", "How datagrams are sealed, who lacks which key, and what was rejected; no key itself.", "", {}}});

/// Before the name of an attribute.
constexpr auto attribute_prefixes = std::to_array<std::string_view>({"attr.", "offer.attr."});

bool is_key_character(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-';
}

bool takes(const Kind& kind, std::string_view key) {
  if (std::ranges::find(kind.keys, key, &Key::name) != kind.keys.end()) return true;
  if (!kind.takes_attributes || !std::ranges::all_of(key, is_key_character)) return false;
  return std::ranges::any_of(attribute_prefixes, [&](std::string_view prefix) {
    return key.size() > prefix.size() && key.starts_with(prefix);
  });
}

std::string listed(const auto& entries, auto name) {
  std::string text;
  for (const auto& entry : entries) text += (text.empty() ? "" : ", ") + std::string(entry.*name);
  return text.empty() ? "none" : text;
}

Question question_of(const Parameters& parameters) {
  Question question;
  for (const auto& [key, value] : parameters) {
    if (key == "subscription") {
      question.subscription = value;
    } else if (key == "service") {
      question.service = value;
    } else {
      question.parameters.emplace_back(key, value);
    }
  }
  return question;
}

std::string value_of(const Parameters& parameters, std::string_view key) {
  const auto found = std::ranges::find(parameters, key, &Parameters::value_type::first);
  return found == parameters.end() ? "" : found->second;
}

}  // namespace

std::span<const Kind> kinds() { return all_kinds; }

const Kind* find_kind(std::string_view word) {
  const auto found = std::ranges::find(all_kinds, word, &Kind::word);
  return found == all_kinds.end() ? nullptr : &*found;
}

std::string kind_words() { return listed(all_kinds, &Kind::word); }

std::expected<void, std::string> check(const Kind& kind, const Parameters& parameters) {
  for (const auto& [key, value] : parameters) {
    if (!takes(kind, key)) {
      return std::unexpected("no key '" + key + "' goes with " + std::string(kind.word) +
                             ": these do: " + listed(kind.keys, &Key::name));
    }
    if (value.empty()) return std::unexpected(key + "= has nothing behind it");
  }
  return {};
}

boost::json::value document_of(std::string_view kind, const Parameters& parameters, const Answer& answer) {
  if (kind == "status") return status_document(answer);
  if (kind == "security") return security_document(security_of(answer));
  if (kind == "ontology") return ontology_document(ontology_of(answer));
  if (kind == "why") return why_document(question_of(parameters), answer);
  if (kind == "taxonomy") {
    boost::json::object object = shell::to_json(answer.end);
    object.erase("count");
    object["classes"] = shell::to_json(answer.records);
    return object;
  }
  if (kind == "explain") return explain_document({value_of(parameters, "sub"), value_of(parameters, "super")}, answer);
  return shell::to_json(answer.records);
}

}  // namespace geminga::answers
