#include "compare/konclude.hpp"

#include <libxml/parser.h>
#include <libxml/tree.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/axiom.hpp"

namespace geminga::compare {
namespace {

namespace fs = std::filesystem;

struct FreeDocument {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};

std::string_view view(const xmlChar* text) {
  return text == nullptr ? std::string_view() : reinterpret_cast<const char*>(text);
}

std::string attribute(const xmlNode* node, const char* name) {
  xmlChar* value = xmlGetProp(node, reinterpret_cast<const xmlChar*>(name));
  std::string text(view(value));
  xmlFree(value);
  return text;
}

std::string name_of(const xmlNode* node) {
  std::string iri = attribute(node, "IRI");
  if (iri == owl::owl_thing || attribute(node, "abbreviatedIRI") == "owl:Thing") return "Thing";
  if (iri == owl::owl_nothing || attribute(node, "abbreviatedIRI") == "owl:Nothing") return "Nothing";
  return iri;
}

/// Runs `Konclude TASK`; what it took, and what it said.
std::pair<TimedRun, std::string> run(std::string_view task, const fs::path& input, const fs::path& output,
                                     const fs::path& log, unsigned seconds) {
  std::vector<std::string> words{"Konclude", std::string(task), "-w", "2", "-i", input.string()};
  if (!output.empty()) words.insert(words.end(), {"-o", output.string()});
  const TimedRun ran = run_timed(words, seconds, log);
  std::ifstream file(log);
  std::ostringstream said;
  said << file.rdbuf();
  return {ran, said.str()};
}

/// A folder that is gone afterwards.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "geminga-konclude-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Calls `take` with the kind of each axiom and the names of its classes and named individuals. The error says why
/// there is nothing to read.
std::optional<std::string> for_each_axiom(
    const fs::path& file, const std::function<void(std::string_view, const std::vector<std::string>&)>& take) {
  // From memory: where our RDF reader is linked, libxml2 opens no file any more.
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::unique_ptr<xmlDoc, FreeDocument> document(
      xmlReadMemory(text.data(), static_cast<int>(text.size()), nullptr, nullptr, XML_PARSE_NONET | XML_PARSE_HUGE));
  const xmlNode* root = document == nullptr ? nullptr : xmlDocGetRootElement(document.get());
  if (root == nullptr) return "it wrote no OWL/XML";
  for (const xmlNode* axiom = root->children; axiom != nullptr; axiom = axiom->next) {
    if (axiom->type != XML_ELEMENT_NODE) continue;
    std::vector<std::string> names;
    for (const xmlNode* part = axiom->children; part != nullptr; part = part->next) {
      const bool is_name = view(part->name) == "Class" || view(part->name) == "NamedIndividual";
      if (part->type == XML_ELEMENT_NODE && is_name) names.push_back(name_of(part));
    }
    take(view(axiom->name), names);
  }
  return std::nullopt;
}

/// The OWL/XML that Konclude writes about a consistent ontology, read by `read`.
std::expected<cases::Closure, std::string> answer_of(
    std::string_view task, const fs::path& file, unsigned seconds, Effort* effort,
    const std::function<std::expected<cases::Closure, std::string>(const fs::path&)>& read) {
  const auto has_model = konclude_consistency(file, seconds, effort);
  if (!has_model) return std::unexpected(has_model.error());
  if (!*has_model) return cases::Closure{"inconsistent"};
  const Scratch scratch;
  const fs::path output = scratch.path() / "answer.owx";
  const TimedRun ran = run(task, file, output, scratch.path() / "log", seconds).first;
  if (effort != nullptr) *effort = ran.effort;
  if (ran.status != 0) return std::unexpected("Konclude ended with status " + std::to_string(ran.status));
  return read(output);
}

/// The types in what Konclude's realisation writes.
std::expected<cases::Closure, std::string> types_of_owl_xml(const fs::path& file) {
  cases::Closure types;
  const auto error = for_each_axiom(file, [&](std::string_view kind, const std::vector<std::string>& names) {
    if (kind == "ClassAssertion" && names.size() == 2 && names[0] != "Thing")
      types.push_back(names[1] + " < " + names[0]);
  });
  if (error) return std::unexpected(*error);
  std::ranges::sort(types);
  types.erase(std::ranges::unique(types).begin(), types.end());  // it writes some twice
  return types;
}

}  // namespace

bool is_konclude_installed() { return std::system("command -v Konclude > /dev/null 2>&1") == 0; }

std::expected<cases::Closure, std::string> closure_of_owl_xml(const fs::path& file) {
  std::vector<std::pair<std::string, std::string>> pairs;
  const auto error = for_each_axiom(file, [&](std::string_view kind, const std::vector<std::string>& names) {
    if (kind == "SubClassOf" && names.size() == 2) pairs.emplace_back(names[0], names[1]);
    if (kind != "EquivalentClasses") return;
    for (const std::string& name : names) {
      pairs.emplace_back(name, names.front());
      pairs.emplace_back(names.front(), name);
    }
  });
  if (error) return std::unexpected(*error);
  return cases::closure_of_pairs(pairs);
}

std::expected<bool, std::string> konclude_consistency(const fs::path& file, unsigned seconds, Effort* effort) {
  const Scratch scratch;
  const auto [asked, answer] = run("consistency", file, {}, scratch.path() / "log", seconds);
  if (effort != nullptr) *effort = asked.effort;
  if (answer.find("is inconsistent") != std::string::npos) return false;
  if (answer.find("is consistent") != std::string::npos) return true;
  return std::unexpected("Konclude does not say whether it is consistent (status " + std::to_string(asked.status) +
                         ")");
}

std::expected<cases::Closure, std::string> konclude_closure(const fs::path& file, unsigned seconds, Effort* effort) {
  return answer_of("classification", file, seconds, effort, closure_of_owl_xml);
}

std::expected<cases::Closure, std::string> konclude_types(const fs::path& file, unsigned seconds, Effort* effort) {
  return answer_of("realization", file, seconds, effort, types_of_owl_xml);
}

}  // namespace geminga::compare
