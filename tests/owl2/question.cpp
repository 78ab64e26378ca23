#include "owl2/question.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

namespace geminga::owl2 {
namespace {

namespace fs = std::filesystem;

/// Letters, digits, `.`, `_` and `-` are kept.
std::string file_name(std::string_view identifier) {
  std::string name(identifier);
  for (char& c : name) {
    const bool is_kept =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    if (!is_kept) c = '-';
  }
  return name;
}

/// Whole or not at all: several ctests may begin at once.
void write(const fs::path& path, std::string_view text) {
  std::ifstream before(path, std::ios::binary);
  if (before && std::string(std::istreambuf_iterator<char>(before), {}) == text) return;
  const fs::path fresh = path.string() + '.' + std::to_string(::getpid());
  std::ofstream(fresh, std::ios::binary) << text;
  fs::rename(fresh, path);
}

/// A catalogue says which file an import means, because not every document names itself.
void write_imports(const fs::path& folder, const std::vector<ImportedDocument>& imports) {
  std::string catalogue = "<?xml version=\"1.0\"?>\n<catalog xmlns=\"urn:oasis:names:tc:entity:xmlns:xml:catalog\">\n";
  for (std::size_t at = 0; at < imports.size(); ++at) {
    const std::string name = "imported-" + std::to_string(at) + ".rdf";
    write(folder / name, imports[at].rdf_xml);
    catalogue += "  <uri name=\"" + imports[at].iri + "\" uri=\"" + name + "\"/>\n";
  }
  write(folder / "catalog-v001.xml", catalogue + "</catalog>\n");
}

/// Writes one syntax of one case.
class Writer {
 public:
  Writer(fs::path folder, bool is_functional, std::vector<Question>& questions)
      : folder_(std::move(folder)), is_functional_(is_functional), questions_(questions) {}

  void write_case(const PublishedCase& one, const std::string& name) {
    const std::string premise = is_functional_ ? one.premise.functional : one.premise.rdf_xml;
    if (premise.empty()) return;
    fs::create_directories(folder_ / name / "premise");
    const fs::path with_imports = folder_ / name / "premise";
    const fs::path file = with_imports / ("premise" + extension());
    write(file, premise);
    if (!one.imports.empty()) write_imports(with_imports, one.imports);
    const std::string given = one.imports.empty() ? file.string() : with_imports.string();
    if (one.is_consistent) ask(name + ".consistency", true, "consistent", {given});
    if (one.is_inconsistent) ask(name + ".inconsistency", false, "consistent", {given});
    ask_whether_entailed(name, "entailment", given, one.conclusion, true);
    ask_whether_entailed(name, "non-entailment", given, one.non_conclusion, false);
  }

 private:
  [[nodiscard]] std::string extension() const { return is_functional_ ? ".ofn" : ".rdf"; }

  void ask(const std::string& name, bool is_yes, const std::string& command, std::vector<std::string> files) {
    questions_.push_back({name + (is_functional_ ? ".functional" : ""), is_yes, command, std::move(files)});
  }

  void ask_whether_entailed(const std::string& name, const std::string& what, const std::string& premise,
                            const Document& conclusion, bool is_yes) {
    const std::string& text = is_functional_ ? conclusion.functional : conclusion.rdf_xml;
    if (text.empty()) return;
    const fs::path file = folder_ / name / (what + extension());
    write(file, text);
    ask(name + '.' + what, is_yes, "entails", {premise, file.string()});
  }

  fs::path folder_;
  bool is_functional_;
  std::vector<Question>& questions_;
};

}  // namespace

std::vector<Question> write_questions(const std::vector<PublishedCase>& cases, const fs::path& folder) {
  std::set<std::string> names;
  std::vector<Question> questions;
  for (const PublishedCase& one : cases) {
    const std::string name = file_name(one.identifier);
    if (!names.insert(name).second) throw std::runtime_error("two cases are named " + name);
    Writer(folder / "rdf-xml", false, questions).write_case(one, name);
    Writer(folder / "functional", true, questions).write_case(one, name);
  }
  return questions;
}

std::string ctest_script(const std::vector<Question>& questions, const std::string& runner) {
  std::string script;
  for (const Question& question : questions) {
    script += "add_test([==[owl2." + question.name + "]==] [==[" + runner + "]==] ask [==[" + question.name + "]==] " +
              (question.is_yes ? "yes " : "no ") + question.command;
    for (const std::string& file : question.files) script += " [==[" + file + "]==]";
    script += ")\nset_tests_properties([==[owl2." + question.name + "]==] PROPERTIES TIMEOUT 300)\n";
  }
  return script;
}

}  // namespace geminga::owl2
