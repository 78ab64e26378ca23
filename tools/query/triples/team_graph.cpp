#include "query/triples/team_graph.hpp"

#include <set>
#include <string_view>
#include <utility>

#include "query/triples/class_triples.hpp"

namespace geminga::query {
namespace {

constexpr std::string_view team_namespace = "https://geminga.example/team/";
constexpr std::string_view attribute_namespace = "https://geminga.example/attribute#";
constexpr std::string_view datatype_property = "http://www.w3.org/2002/07/owl#DatatypeProperty";

std::string core(std::string_view word) { return std::string(core_namespace) + std::string(word); }

/// The IRI of a participant, by its identifier, or of a service or request, by its key.
std::string individual(std::string_view key) { return std::string(team_namespace) + std::string(key); }

/// The participant of a key `PARTICIPANT/PEER/NUMBER`.
std::string_view participant_of(std::string_view key) { return key.substr(0, key.find('/')); }

/// The IRI of a text `<IRI>`; empty where it is another text, as of an expression.
std::string_view iri_in(std::string_view text) {
  const bool is_iri = text.size() > 2 && text.starts_with('<') && text.find('>') == text.size() - 1;
  return is_iri ? text.substr(1, text.size() - 2) : std::string_view();
}

class Writing {
 public:
  explicit Writing(TripleSyntax syntax) : triples_(syntax) {}

  void add_participant(const Record& record) {
    const std::string it = individual(record["id"]);
    triples_.add_type(it, core("Participant"));
    add_text(it, "name", record["name"]);
    add_parts(it, "address", record["addresses"]);
    add_number(it, "heard", record["heard"], "decimal");
    add_number(it, "loss", record["loss"], "decimal");
    if (record["ontology"] != "-") add_text(it, "ontologyDigest", record["ontology"]);
  }

  /// A participant is what describes it.
  void add_description(const Record& record) {
    const std::string it = individual(participant_of(record["service"]));
    if (const auto iri = iri_in(record["concept"]); !iri.empty()) {
      triples_.add_type(it, iri);
    } else {
      add_text(it, "expression", record["concept"]);
      classes_.add(it, record["concept"]);
    }
    add_attributes(it, record);
  }

  void add_service(const Record& record) {
    const std::string it = add_common(record, record["service"], "Publication", "offers");
    add_number(it, "used", record["used"] == "1" ? "true" : "false", "boolean");
    const std::string_view concept_text = record["concept"];
    const std::string_view concept_iri = iri_in(concept_text);
    const std::string_view representation = iri_in(record["representation"]);
    const std::string information = it + "#information";
    const bool has_expression = concept_iri.empty() && !concept_text.empty() && classes_.add(information, concept_text);
    if (concept_iri.empty() && !has_expression && representation.empty()) return;
    triples_.add_word(it, "provides", iri_node(information));
    if (!concept_iri.empty()) triples_.add_type(information, concept_iri);
    if (representation.empty()) return;
    const std::string form = it + "#representation";
    triples_.add_word(information, "hasRepresentation", iri_node(form));
    triples_.add_type(form, representation);
  }

  void add_request(const Record& record) {
    const std::string it = add_common(record, record["subscription"], "Subscription", "asksFor");
    add_number(it, "served", record["served"] == "1" ? "true" : "false", "boolean");
  }

  [[nodiscard]] std::string finish() && {
    for (const std::string& property : properties_) triples_.add_type(property, datatype_property);
    classes_.write(triples_);
    return std::move(triples_).finish();
  }

 private:
  void add_text(const std::string& subject, std::string_view word, std::string_view text) {
    if (!text.empty()) triples_.add_word(subject, word, literal_node(text));
  }
  void add_number(const std::string& subject, std::string_view word, std::string_view text, std::string_view datatype) {
    if (!text.empty()) triples_.add_word(subject, word, literal_node(text, datatype));
  }
  /// One triple for each part of a list with commas.
  void add_parts(const std::string& subject, std::string_view word, std::string_view list) {
    while (!list.empty()) {
      const auto comma = list.find(',');
      add_text(subject, word, list.substr(0, comma));
      list = comma == std::string_view::npos ? std::string_view() : list.substr(comma + 1);
    }
  }

  /// Adds what publications and subscriptions share. Gives the IRI.
  std::string add_common(const Record& record, std::string_view key, std::string_view kind, std::string_view relation) {
    std::string it = individual(key);
    triples_.add_word(individual(participant_of(key)), relation, iri_node(it));
    triples_.add_type(it, core(kind));
    add_text(it, "name", record["name"]);
    add_identity(it, record);
    add_text(it, "mode", record["mode"]);
    add_text(it, "address", record["address"]);
    add_number(it, "port", record["port"], "integer");
    add_text(it, "protocol", record["protocol"]);
    add_number(it, "priority", record["priority"], "integer");
    add_attributes(it, record);
    return it;
  }

  void add_attributes(const std::string& it, const Record& record) {
    for (const auto& [name, value] : record.attributes) {
      const std::string property = std::string(attribute_namespace) + name;
      properties_.insert(property);
      triples_.add(it, property, value_node(value));
    }
  }

  void add_identity(const std::string& it, const Record& record) {
    add_number(it, "number", record["id"], "integer");
    add_text(it, "text", record["text"]);
    const std::string_view concept_text = record["concept"];
    if (const auto iri = iri_in(concept_text); !iri.empty()) {
      triples_.add_word(it, "statedConcept", iri_node(iri));
    } else {
      add_text(it, "expression", concept_text);
    }
    if (const auto iri = iri_in(record["representation"]); !iri.empty()) {
      triples_.add_word(it, "statedRepresentation", iri_node(iri));
    }
  }

  Triples triples_;
  ClassTriples classes_;              ///< individuals of class expressions
  std::set<std::string> properties_;  ///< of attributes
};

}  // namespace

std::string team_document(const Team& team, TripleSyntax syntax) {
  Writing writing(syntax);
  for (const Record& record : team.participants) writing.add_participant(record);
  for (const Record& record : team.descriptions) writing.add_description(record);
  for (const Record& record : team.services) writing.add_service(record);
  for (const Record& record : team.requests) writing.add_request(record);
  return std::move(writing).finish();
}

}  // namespace geminga::query
