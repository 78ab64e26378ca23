// Files, classes, taxonomy and labels as the compiled form has them.
#include "reasoning/compiled/compile_sections.hpp"

#include <algorithm>
#include <memory>
#include <tuple>

#include "base/rows.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/prefixes/prefixes.hpp"
#include "reasoning/owl/source_paths.hpp"
#include "reasoning/taxonomy/interval_index.hpp"

namespace geminga::compiled {
namespace {

void append(std::vector<std::uint8_t>& text, std::vector<std::uint32_t>& ends, std::string_view piece) {
  text.insert(text.end(), piece.begin(), piece.end());
  ends.push_back(static_cast<std::uint32_t>(text.size()));
}

void write_prefixes(const owl::Ontology& source, form::TaxonomyT& out) {
  const owl::Prefixes prefixes(source);
  for (const auto& [word, iri] : prefixes.all()) {
    auto entry = std::make_unique<form::PrefixT>();
    entry->prefix = word;
    entry->iri = iri;
    out.prefixes.push_back(std::move(entry));
  }
}

/// A label of a class.
struct Label {
  std::string_view text;
  std::uint32_t class_number;
  std::string_view language;
};

/// The class of each name, or none.
std::vector<std::uint32_t> classes_by_name(const CompilerInput& input) {
  std::vector<std::uint32_t> class_of_name(input.source.name_count(), none);
  for (std::uint32_t number = 0; number < input.classification.class_count(); ++number) {
    class_of_name[static_cast<std::size_t>(input.classification.classes[number])] = number;
  }
  return class_of_name;
}

/// The labels of classes by text, then class, then language; each once.
std::vector<Label> labels_of_classes(const CompilerInput& input) {
  const owl::Ontology& source = input.source;
  const std::vector<std::uint32_t> class_of_name = classes_by_name(input);
  std::vector<Label> labels;
  for (const owl::Ontology::Label& label : source.labels()) {
    const std::uint32_t number = class_of_name[static_cast<std::size_t>(label.entity)];
    if (number != none) labels.push_back({source.name(label.text), number, source.name(label.language)});
  }
  const auto key = [](const Label& label) { return std::tuple(label.text, label.class_number, label.language); };
  std::ranges::sort(labels, {}, key);
  const auto repeated = std::ranges::unique(labels, {}, key);
  labels.erase(repeated.begin(), repeated.end());
  return labels;
}

/// English labels come first, then those without a language, then the rest.
auto preference(const Label& label) {
  const int rank = label.language == "en" ? 0 : label.language.starts_with("en") ? 1 : label.language.empty() ? 2 : 3;
  return std::tuple(rank, label.language, label.text);
}

}  // namespace

void write_sources(const CompilerInput& input, const CompileOptions& options, form::TaxonomyT& out) {
  const owl::Ontology& source = input.source;
  std::vector<std::uint32_t> number_of_file(source.files().size(), none);
  for (const owl::FileId id : input.order.files) {
    number_of_file[static_cast<std::size_t>(id)] = static_cast<std::uint32_t>(out.files.size());
    const owl::LoadedFile& loaded = source.files()[static_cast<std::size_t>(id)];
    auto file = std::make_unique<form::FileT>();
    file->path = options.folder.empty() ? loaded.path : owl::seen_from_folder(options.folder, loaded.path);
    file->ontology_iri = loaded.ontology_iri;
    file->size = loaded.content.size;
    file->hash = loaded.content.hash;
    out.files.push_back(std::move(file));
  }
  for (const owl::LeftOut& left : left_out(source, input.classification)) {
    auto entry = std::make_unique<form::LeftOutT>();
    entry->construct = left.construct;
    entry->count = left.count;
    entry->file = left.file < number_of_file.size() ? number_of_file[left.file] : none;
    entry->line = left.line;
    out.left_out.push_back(std::move(entry));
  }
  out.gaps.assign(options.gaps.begin(), options.gaps.end());
  write_prefixes(source, out);
  for (const auto& axiom : input.order.axioms) {
    out.axioms += source.axiom(axiom.axiom).kind == owl::AxiomKind::declaration ? 0U : 1U;
  }
}

void write_classes(const CompilerInput& input, form::TaxonomyT& out) {
  const taxonomy::Classification& classification = input.classification;
  const auto count = static_cast<std::uint32_t>(classification.class_count());
  out.is_consistent = classification.is_consistent;
  out.thing = static_cast<std::uint32_t>(classification.thing);
  out.nothing = static_cast<std::uint32_t>(classification.nothing);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> up;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> down;
  for (std::uint32_t number = 0; number < count; ++number) {
    append(out.class_text, out.class_end, input.source.name(classification.classes[number]));
    const auto node = static_cast<std::uint32_t>(classification.representative[number]);
    out.representative.push_back(node);
    if (node != number) out.members.emplace_back(node, number);
    for (const taxonomy::ClassNumber parent : classification.parents_of(taxonomy::ClassNumber{number})) {
      up.emplace_back(number, static_cast<std::uint32_t>(parent));
      down.emplace_back(static_cast<std::uint32_t>(parent), number);
    }
  }
  std::ranges::sort(out.members, {}, [](const form::Member& one) { return std::pair(one.node(), one.other()); });
  const base::Rows<std::uint32_t> parents(count, up);
  const base::Rows<std::uint32_t> children(count, down);
  const taxonomy::IntervalIndex index(parents);
  out.parent_begin.push_back(0);
  out.child_begin.push_back(0);
  for (std::uint32_t number = 0; number < count; ++number) {
    out.parents.insert(out.parents.end(), parents[number].begin(), parents[number].end());
    out.parent_begin.push_back(static_cast<std::uint32_t>(out.parents.size()));
    out.children.insert(out.children.end(), children[number].begin(), children[number].end());
    out.child_begin.push_back(static_cast<std::uint32_t>(out.children.size()));
    const std::uint32_t node = out.representative[number];
    const taxonomy::Interval own = index.own(node);
    // Equivalent classes have the intervals of their representative, which is the smallest of them.
    if (node != number) {
      out.reach.push_back(out.reach[node]);
      continue;
    }
    const auto further_begin = static_cast<std::uint32_t>(out.further.size());
    for (const taxonomy::Interval interval : index.further(node))
      out.further.emplace_back(interval.first, interval.last);
    const auto further_end = static_cast<std::uint32_t>(out.further.size());
    const std::uint32_t flag = further_begin == further_end ? 0 : taxonomy::Reach::flag;
    if (node == out.representative[out.nothing]) {
      out.reach.emplace_back(taxonomy::Reach::flag, 0, 0, 0);
    } else {
      out.reach.emplace_back(own.first, (own.last - own.first) | flag, further_begin, further_end);
    }
  }
}

void write_signatures(const form::LabelsT& labels, form::TaxonomyT& out) {
  const std::string_view iris(reinterpret_cast<const char*>(out.class_text.data()), out.class_text.size());
  const std::string_view texts(reinterpret_cast<const char*>(labels.text.data()), labels.text.size());
  const auto row = [](std::string_view text, const std::vector<std::uint32_t>& ends, std::size_t at) {
    const std::uint32_t begin = at == 0 ? 0 : ends[at - 1];
    return text.substr(begin, ends[at] - begin);
  };
  out.signatures.reserve(2 * out.class_end.size());
  for (std::size_t number = 0; number < out.class_end.size(); ++number) {
    out.signatures.push_back(signature_of(local_name(row(iris, out.class_end, number))));
    const std::uint32_t label = labels.label_of_class[number];
    out.signatures.push_back(label == none ? 0 : signature_of(row(texts, labels.end, label)));
  }
}

void write_conversions(const CompilerInput& input, form::TaxonomyT& out) {
  if (input.source.conversions().empty()) return;
  const std::vector<std::uint32_t> class_of_name = classes_by_name(input);
  for (const owl::Ontology::Conversion& one : input.source.conversions()) {
    const std::uint32_t from = class_of_name[static_cast<std::size_t>(one.from)];
    const std::uint32_t to = class_of_name[static_cast<std::size_t>(one.to)];
    if (from != none && to != none) out.conversions.emplace_back(from, to, one.cost);
  }
  std::ranges::sort(out.conversions, {}, [](const form::Conversion& one) { return std::pair(one.from(), one.to()); });
}

void write_labels(const CompilerInput& input, form::LabelsT& out) {
  const std::vector<Label> labels = labels_of_classes(input);
  std::vector<const Label*> best(input.classification.class_count(), nullptr);
  out.label_of_class.assign(best.size(), none);
  out.class_begin.push_back(0);
  std::string_view last;
  for (const Label& label : labels) {
    if (out.end.empty() || label.text != last) {
      if (!out.end.empty()) out.class_begin.push_back(static_cast<std::uint32_t>(out.classes.size()));
      append(out.text, out.end, label.text);
      last = label.text;
    }
    const bool is_repeated = out.classes.size() > out.class_begin.back() && out.classes.back() == label.class_number;
    if (!is_repeated) out.classes.push_back(label.class_number);
    const Label*& known = best[label.class_number];
    if (known != nullptr && preference(*known) <= preference(label)) continue;
    known = &label;
    out.label_of_class[label.class_number] = static_cast<std::uint32_t>(out.end.size() - 1);
  }
  if (!out.end.empty()) out.class_begin.push_back(static_cast<std::uint32_t>(out.classes.size()));
}

}  // namespace geminga::compiled
