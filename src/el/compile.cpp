// Lays a classified ontology out in flat arrays.
#include "el/compile.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "compiled_generated.h"
#include "el/canonical.hpp"
#include "el/container.hpp"
#include "el/interval_index.hpp"
#include "el/rows.hpp"

namespace geminga::el {
namespace {

constexpr std::uint32_t none = NumberTable::none;

/// Prefixes that explanations use, where the files do not give these words another meaning.
constexpr std::pair<std::string_view, std::string_view> usual_prefixes[] = {
    {"owl", "http://www.w3.org/2002/07/owl#"},
    {"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"},
    {"rdfs", "http://www.w3.org/2000/01/rdf-schema#"},
    {"xsd", "http://www.w3.org/2001/XMLSchema#"},
};

/// All names of the compiled form, sorted; each once.
class NamePool {
 public:
  void add(std::string_view name) { names_.push_back(name); }
  void sort() {
    std::ranges::sort(names_);
    names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
  }
  [[nodiscard]] std::uint32_t number_of(std::string_view name) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(names_, name) - names_.begin());
  }
  [[nodiscard]] const std::vector<std::string_view>& names() const { return names_; }

 private:
  std::vector<std::string_view> names_;
};

class Compiler {
 public:
  Compiler(const OntologySource& source, const Classification& classification)
      : source_(source),
        classification_(classification),
        hashes_(source),
        order_(canonical_order(source, hashes_)),
        left_out_(left_out(source, classification)) {}

  std::vector<std::byte> run();

 private:
  struct Label {
    std::string_view text;
    std::uint32_t class_number;
    std::string_view language;
  };

  void find_labels();
  void find_prefixes();
  void find_names();
  [[nodiscard]] bool fits() const;
  [[nodiscard]] std::uint32_t number_of_name(NameId id) const { return pool_.number_of(source_.name(id)); }
  void write_names(compiled::OntologyT& out) const;
  void write_classes(compiled::OntologyT& out) const;
  void write_taxonomy(compiled::OntologyT& out) const;
  void write_axioms(compiled::OntologyT& out) const;

  const OntologySource& source_;
  const Classification& classification_;
  ContentHashes hashes_;
  CanonicalOrder order_;
  std::vector<LeftOut> left_out_;
  std::vector<Label> labels_;
  std::vector<std::pair<std::string_view, std::string_view>> prefixes_;
  NamePool pool_;
};

void Compiler::find_labels() {
  const auto class_of = [&](std::string_view iri) {
    const auto& classes = classification_.classes;
    const auto found = std::ranges::lower_bound(classes, iri, {}, [&](NameId id) { return source_.name(id); });
    return found != classes.end() && source_.name(*found) == iri ? static_cast<std::uint32_t>(found - classes.begin())
                                                                 : none;
  };
  for (const OntologySource::Label& label : source_.labels()) {
    const std::uint32_t number = class_of(source_.name(label.entity));
    if (number != none) labels_.push_back({source_.name(label.text), number, source_.name(label.language)});
  }
  std::ranges::sort(labels_, {}, [](const Label& l) { return std::tuple(l.text, l.class_number, l.language); });
  const auto repeated =
      std::ranges::unique(labels_, {}, [](const Label& l) { return std::tuple(l.text, l.class_number, l.language); });
  labels_.erase(repeated.begin(), repeated.end());
}

void Compiler::find_prefixes() {
  for (const OntologySource::Prefix& prefix : source_.prefixes()) {
    prefixes_.emplace_back(source_.name(prefix.prefix), source_.name(prefix.iri));
  }
  for (const auto& usual : usual_prefixes) {
    if (std::ranges::none_of(prefixes_, [&](const auto& known) { return known.first == usual.first; })) {
      prefixes_.push_back(usual);
    }
  }
  std::ranges::sort(prefixes_);
}

void Compiler::find_names() {
  pool_.add("");
  for (const auto& [prefix, iri] : prefixes_) {
    pool_.add(prefix);
    pool_.add(iri);
  }
  for (const Label& label : labels_) pool_.add(label.text);
  for (const NameId id : classification_.classes) pool_.add(source_.name(id));
  for (const TermId term : order_.terms) pool_.add(source_.name_of(term));
  pool_.sort();
}

bool Compiler::fits() const {
  std::size_t bytes = 0;
  for (const std::string_view name : pool_.names()) bytes += name.size() + 4;
  bytes += classification_.class_count() * 40 + classification_.parents.size() * 8 + labels_.size() * 8;
  bytes += order_.terms.size() * 13 + order_.axioms.size() * 13;
  for (const auto& axiom : order_.axioms) bytes += axiom.arguments.size() * 4;
  for (const TermId term : order_.terms) bytes += source_.term(term).arguments.size() * 4;
  for (const LoadedFile& file : source_.files()) bytes += file.path.size() + file.ontology_iri.size() + 32;
  for (const LeftOut& left : left_out_) bytes += left.construct.size() + left.first.size() + 48;
  return bytes < max_compiled_bytes - (std::size_t{1} << 20);
}

void Compiler::write_names(compiled::OntologyT& out) const {
  for (const std::string_view name : pool_.names()) {
    out.text.insert(out.text.end(), name.begin(), name.end());
    out.name_end.push_back(static_cast<std::uint32_t>(out.text.size()));
  }
  for (const auto& [prefix, iri] : prefixes_) {
    out.prefix_name.push_back(pool_.number_of(prefix));
    out.prefix_iri.push_back(pool_.number_of(iri));
  }
  for (const FileId id : order_.files) {
    const LoadedFile& loaded = source_.files()[static_cast<std::size_t>(id)];
    auto file = std::make_unique<compiled::FileT>();
    file->path = loaded.path;
    file->ontology_iri = loaded.ontology_iri;
    file->size = loaded.content.size;
    file->hash = loaded.content.hash;
    out.files.push_back(std::move(file));
  }
  for (const LeftOut& left : left_out_) {
    auto entry = std::make_unique<compiled::LeftOutT>();
    entry->construct = left.construct;
    entry->count = left.count;
    entry->first = left.first;
    out.left_out.push_back(std::move(entry));
  }
}

void Compiler::write_classes(compiled::OntologyT& out) const {
  for (const NameId id : classification_.classes) out.class_name.push_back(number_of_name(id));
  for (const ClassNumber number : classification_.representative) {
    out.representative.push_back(static_cast<std::uint32_t>(number));
  }
  out.thing = static_cast<std::uint32_t>(classification_.thing);
  out.nothing = static_cast<std::uint32_t>(classification_.nothing);
  // English first, then what has no language, then the rest.
  const auto preference = [](const Label& label) {
    return std::tuple(label.language == "en"             ? 0
                      : label.language.starts_with("en") ? 1
                      : label.language.empty()           ? 2
                                                         : 3,
                      label.language, label.text);
  };
  std::vector<const Label*> best(classification_.class_count(), nullptr);
  for (const Label& label : labels_) {
    const bool is_repeated = !out.label_text.empty() && out.label_class.back() == label.class_number &&
                             out.label_text.back() == pool_.number_of(label.text);
    if (!is_repeated) {
      out.label_text.push_back(pool_.number_of(label.text));
      out.label_class.push_back(label.class_number);
    }
    const Label*& known = best[label.class_number];
    if (known == nullptr || preference(label) < preference(*known)) known = &label;
  }
  for (const Label* label : best) out.class_label.push_back(label == nullptr ? none : pool_.number_of(label->text));
}

void Compiler::write_taxonomy(compiled::OntologyT& out) const {
  const auto count = static_cast<std::uint32_t>(classification_.class_count());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> up;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> down;
  for (std::uint32_t number = 0; number < count; ++number) {
    for (const ClassNumber parent : classification_.parents_of(ClassNumber{number})) {
      up.emplace_back(number, static_cast<std::uint32_t>(parent));
      down.emplace_back(static_cast<std::uint32_t>(parent), number);
    }
  }
  const Rows<std::uint32_t> parents(count, up);
  const Rows<std::uint32_t> children(count, down);
  const IntervalIndex index(parents);
  out.parent_begin.push_back(0);
  out.child_begin.push_back(0);
  out.further_begin.push_back(0);
  for (std::uint32_t number = 0; number < count; ++number) {
    out.parents.insert(out.parents.end(), parents[number].begin(), parents[number].end());
    out.parent_begin.push_back(static_cast<std::uint32_t>(out.parents.size()));
    out.children.insert(out.children.end(), children[number].begin(), children[number].end());
    out.child_begin.push_back(static_cast<std::uint32_t>(out.children.size()));
    const auto node = static_cast<std::uint32_t>(classification_.representative[number]);
    out.own_interval.emplace_back(index.own(node).first, index.own(node).last);
    // Only representatives keep lists; the reader goes through them.
    if (node == number) {
      for (const Interval interval : index.further(node)) out.further.emplace_back(interval.first, interval.last);
    }
    out.further_begin.push_back(static_cast<std::uint32_t>(out.further.size()));
  }
}

void Compiler::write_axioms(compiled::OntologyT& out) const {
  out.term_begin.push_back(0);
  for (const TermId id : order_.terms) {
    const Term term = source_.term(id);
    out.term_kind.push_back(static_cast<std::uint8_t>(term.kind));
    out.term_name.push_back(number_of_name(term.name));
    out.term_number.push_back(term.number);
    for (const TermId argument : hashes_.sorted(term.arguments, set_begin(term.kind, term.arguments.size()))) {
      out.term_arguments.push_back(order_.number_of_term[static_cast<std::size_t>(argument)]);
    }
    out.term_begin.push_back(static_cast<std::uint32_t>(out.term_arguments.size()));
  }
  out.axiom_begin.push_back(0);
  for (const auto& axiom : order_.axioms) {
    out.axiom_kind.push_back(static_cast<std::uint8_t>(source_.axiom(axiom.axiom).kind));
    out.axiom_file.push_back(axiom.file);
    out.axiom_line.push_back(axiom.line);
    for (const TermId argument : axiom.arguments) {
      out.axiom_arguments.push_back(order_.number_of_term[static_cast<std::size_t>(argument)]);
    }
    out.axiom_begin.push_back(static_cast<std::uint32_t>(out.axiom_arguments.size()));
  }
}

std::vector<std::byte> Compiler::run() {
  find_labels();
  find_prefixes();
  find_names();
  if (!fits()) return {};
  compiled::OntologyT out;
  out.digest = digest(source_);
  out.is_consistent = classification_.is_consistent;
  write_names(out);
  write_classes(out);
  write_taxonomy(out);
  write_axioms(out);
  if (out.further.size() > max_compiled_bytes / 16) return {};
  flatbuffers::FlatBufferBuilder builder;
  builder.Finish(compiled::Ontology::Pack(builder, &out));
  return wrap({builder.GetBufferPointer(), builder.GetSize()});
}

}  // namespace

std::vector<std::byte> compile(const OntologySource& source, const Classification& classification) {
  return Compiler(source, classification).run();
}

}  // namespace geminga::el
