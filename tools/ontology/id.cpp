// `geminga-ontology id`: the 32-bit identity of a concept, with or without a representation (src/identity/IDENTITY.md).
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>

#include "base/text.hpp"
#include "geminga/identity.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/class_names.hpp"
#include "ontology/loading/compiled_form.hpp"

namespace geminga::ontology {
namespace {

struct IdRequest {
  std::string concept_name;
  std::string representation_name;
  std::vector<std::string> files;
  bool as_json = false;
  bool is_lenient = false;
};

/// The IRI of a name that is one: `<IRI>`, or with a scheme that is no prefix.
std::optional<std::string> plain_iri(const std::string& name) {
  if (name.size() > 2 && name.front() == '<' && name.back() == '>') return name.substr(1, name.size() - 2);
  if (name.find("://") != std::string::npos || name.starts_with("urn:")) return name;
  return std::nullopt;
}

/// Resolves names. Loads the ontologies when the first name needs them.
class Resolver {
 public:
  Resolver(const IdRequest& request, base::Budget& budget) : request_(request), budget_(budget) {}

  std::optional<std::string> resolve(const std::string& name) {
    if (auto iri = plain_iri(name)) {
      const bool is_good = !iri->empty() && base::is_valid_utf8(*iri) && !base::has_control_character(*iri) &&
                           iri->find_first_of("<> \"") == std::string::npos;
      if (is_good) return iri;
      say_error(base::printable(name) + " is no IRI: write it without spaces, quotes and angle brackets");
      return std::nullopt;
    }
    if (!ontology_ && !open()) return std::nullopt;
    const auto number = find_or_say(*ontology_, name);
    if (!number) return std::nullopt;
    return std::string(ontology_->iri(*number));
  }

 private:
  bool open() {
    const auto classified =
        classify_or_say(request_.files.empty() ? std::vector{shipped_ontologies().string()} : request_.files,
                        {.is_lenient = request_.is_lenient, .budget = &budget_});
    if (classified) ontology_ = compile_or_say(*classified);
    return ontology_.has_value();
  }

  const IdRequest& request_;
  base::Budget& budget_;
  std::optional<compiled::Ontology> ontology_;
};

Exit print_id(const IdRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  Resolver resolver(request, budget);
  const auto concept_iri = resolver.resolve(request.concept_name);
  if (!concept_iri) return Exit::usage;
  SemanticIdentity identity{*concept_iri, {}};
  if (!request.representation_name.empty()) {
    const auto representation_iri = resolver.resolve(request.representation_name);
    if (!representation_iri) return Exit::usage;
    identity.representation_iri = *representation_iri;
  }
  const Id32 id = id32(identity);
  std::string text = std::to_string(id) + '\n';
  if (request.as_json) {
    const boost::json::object document{{"id", id},
                                       {"hex", "0x" + base::to_hex(id, 8)},
                                       {"canonical", canonical_form(identity)},
                                       {"concept", identity.concept_iri},
                                       {"representation", identity.representation_iri}};
    text = json_text(document) + '\n';
  }
  return print_or_say(text);
}

}  // namespace

void add_id(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<IdRequest>();
  CLI::App* command = program.add_subcommand("id", "Print the 32-bit identity of a concept and a representation");
  command->add_option("CONCEPT", request->concept_name, "prefix:Name, <IRI>, a bare IRI, or a label")
      ->required()
      ->type_name("");
  command->add_option("REPRESENTATION", request->representation_name, "the same; unstated where it is left out")
      ->type_name("");
  command
      ->add_option("--ontology", request->files, "where prefixes and labels come from; else the ontologies that ship")
      ->type_name("FILES");
  add_lenient(*command, request->is_lenient);
  command->add_flag("--json", request->as_json, "print number, hexadecimal number and canonical form as JSON");
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nA limit of the search does not change an identity.\n"
      "\nExamples:\n  geminga-ontology id soccer:BallInfo soccer:CartesianFieldFrame\n"
      "  geminga-ontology id '<http://example.org/a>' --json");
  run_when_named(*command, choice, request, print_id);
}

}  // namespace geminga::ontology
