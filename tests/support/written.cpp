// A reader of just enough functional-style syntax.
#include "written.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>

#include "reasoning/compiled/compile.hpp"

namespace geminga::owl {
namespace {

const std::string test_namespace = "https://t.example/#";
const std::string xsd = "http://www.w3.org/2001/XMLSchema#";

class Reader {
 public:
  Reader(Ontology& source, std::string_view text, FileId file) : source_(source), text_(text), file_(file) {}

  void read() {
    std::uint32_t line = 1;
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      rest_ = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      rest_ = rest_.substr(0, rest_.find('#'));
      skip();
      if (!rest_.empty()) read_axiom(line);
      ++line;
    }
  }

 private:
  void skip() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
  }
  bool take(char character) {
    skip();
    if (rest_.empty() || rest_.front() != character) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::string_view word() {
    skip();
    std::size_t size = 0;
    if (!rest_.empty() && rest_.front() == '"') size = rest_.find('"', 1) + 1;
    while (size < rest_.size() && std::string_view(" ()").find(rest_[size]) == std::string_view::npos) ++size;
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return found;
  }

  void read_axiom(std::uint32_t line) {
    const std::string_view name = word();
    for (std::uint8_t kind = 0; kind < axiom_kind_count; ++kind) {
      if (to_string(AxiomKind{kind}) != name) continue;
      std::uint32_t number = 0;
      const std::vector<TermId> arguments = read_arguments(number);
      source_.add(AxiomKind{kind}, arguments, file_, line);
      return;
    }
    ADD_FAILURE() << "no axiom: " << name;
  }

  std::vector<TermId> read_arguments(std::uint32_t& number) {
    std::vector<TermId> arguments;
    if (!take('(')) ADD_FAILURE() << "( is missing before " << rest_;
    while (!take(')')) {
      if (rest_.empty()) {
        ADD_FAILURE() << ") is missing";
        break;
      }
      if (rest_.front() >= '0' && rest_.front() <= '9') {
        const std::string_view digits = word();
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
      } else {
        arguments.push_back(read_term());
      }
    }
    return arguments;
  }

  TermId read_term() {
    const std::string_view name = word();
    skip();
    if (!rest_.empty() && rest_.front() == '(') {
      for (std::uint8_t kind = 0; kind < term_kind_count; ++kind) {
        if (to_string(TermKind{kind}) != name) continue;
        std::uint32_t number = 0;
        std::vector<TermId> arguments = read_arguments(number);
        if (TermKind{kind} == TermKind::datatype_restriction) arguments = with_facets(arguments);
        return source_.term(TermKind{kind}, arguments, number);
      }
      ADD_FAILURE() << "no expression: " << name;
    }
    return entity(name);
  }

  /// A datatype, then names of facets and literals in turn.
  std::vector<TermId> with_facets(const std::vector<TermId>& arguments) {
    std::vector<TermId> result = {arguments.front()};
    for (std::size_t at = 1; at + 1 < arguments.size(); at += 2) {
      result.push_back(source_.facet(source_.name_of(arguments[at]), arguments[at + 1]));
    }
    return result;
  }

  TermId entity(std::string_view name) {
    if (name == "Thing") return source_.named_class(owl_thing);
    if (name == "Nothing") return source_.named_class(owl_nothing);
    if (name.starts_with("owl:")) {
      return source_.object_property("http://www.w3.org/2002/07/owl#" + std::string(name.substr(4)));
    }
    if (name.starts_with('"')) {
      const std::size_t quote = name.find('"', 1);
      const std::string_view lexical = name.substr(1, quote - 1);
      const std::string_view type = name.substr(quote + 1);
      if (type.starts_with("^x:")) return source_.literal(lexical, xsd + std::string(type.substr(3)));
      return source_.literal(lexical, "", type.starts_with("@") ? type.substr(1) : "");
    }
    if (name.starts_with("d:")) return source_.data_property(test_namespace + std::string(name.substr(2)));
    if (name.starts_with("i:")) return source_.individual(test_namespace + std::string(name.substr(2)));
    if (name.starts_with("x:")) return source_.datatype(xsd + std::string(name.substr(2)));
    if (name.starts_with("_:")) return source_.anonymous_individual(name);
    if (name.front() >= 'A' && name.front() <= 'Z') return source_.named_class(test_namespace + std::string(name));
    return source_.object_property(test_namespace + std::string(name));
  }

  Ontology& source_;
  std::string_view text_;
  std::string_view rest_;
  FileId file_;
};

}  // namespace

void write_into(Ontology& source, std::string_view text, const std::string& path) {
  source.add_prefix("t", test_namespace);
  Reader(source, text, source.add_file(path)).read();
}

Ontology written(std::string_view text, const std::string& path) {
  Ontology source;
  write_into(source, text, path);
  EXPECT_FALSE(source.problem()) << *source.problem();
  EXPECT_TRUE(source.omissions().empty()) << source.name(source.omissions().front().construct);
  return source;
}

taxonomy::Classification classified(const Ontology& source) {
  auto classification = el::classify(source);
  if (!classification) ADD_FAILURE() << classification.error().text;
  return std::move(classification).value();
}

compiled::Ontology loaded(const Ontology& source) {
  auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, classified(source)));
  if (!ontology) ADD_FAILURE() << ontology.error().text;
  return std::move(ontology).value();
}

compiled::Ontology loaded(std::string_view text) { return loaded(written(text)); }

std::vector<std::string> closure(const compiled::Ontology& ontology) {
  if (!ontology.is_consistent()) return {"inconsistent"};
  const auto name_of = [&](taxonomy::ClassNumber number) {
    const std::string_view iri = ontology.iri(number);
    return std::string(iri.substr(iri.find('#') + 1));
  };
  const taxonomy::ClassNumber thing = *ontology.find_iri(owl_thing);
  const taxonomy::ClassNumber nothing = *ontology.find_iri(owl_nothing);
  std::vector<std::string> lines;
  for (std::uint32_t sub = 0; sub < ontology.class_count(); ++sub) {
    const taxonomy::ClassNumber below{sub};
    if (below == nothing) continue;
    if (!ontology.is_satisfiable(below)) {
      lines.push_back(name_of(below) + " < Nothing");
      continue;
    }
    for (const taxonomy::ClassNumber above : ontology.subsumers(below)) {
      EXPECT_TRUE(ontology.is_subsumed(below, above)) << name_of(below) << " < " << name_of(above);
      if (above != below && above != thing) lines.push_back(name_of(below) + " < " + name_of(above));
    }
  }
  std::ranges::sort(lines);
  return lines;
}

std::vector<std::string> closure(std::string_view text) { return closure(loaded(text)); }

taxonomy::ClassNumber named(const compiled::Ontology& ontology, std::string_view name) {
  const auto found = ontology.find("t:" + std::string(name));
  EXPECT_TRUE(found) << (found ? "" : found.error().text);
  return found.value_or(taxonomy::ClassNumber{0});
}

}  // namespace geminga::owl
