// The checks of a compiled ontology.
#include "el/compiled_view.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "compiled_generated.h"
#include "el/container.hpp"
#include "el/source.hpp"

namespace geminga::el {
namespace {

static_assert(std::endian::native == std::endian::little, "the compiled form is read in place");
static_assert(sizeof(Interval) == sizeof(compiled::Interval));

/// Reports the first thing that is wrong.
class Checker {
 public:
  void expect(bool condition, std::string_view what) {
    if (!condition && problem_.empty()) problem_ = what;
  }
  /// All below `end`.
  void in_range(std::span<const std::uint32_t> numbers, std::size_t end, std::string_view what) {
    expect(std::ranges::all_of(numbers, [&](std::uint32_t number) { return number < end; }), what);
  }
  /// Row borders: one more than rows, from 0 to the number of items, never down.
  void borders(std::span<const std::uint32_t> begin, std::size_t rows, std::size_t items, std::string_view what) {
    expect(begin.size() == rows + 1 && begin.front() == 0 && begin.back() == items && std::ranges::is_sorted(begin),
           what);
  }
  [[nodiscard]] bool failed() const { return !problem_.empty(); }
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

template <typename Element>
std::span<const std::uint32_t> numbers(const flatbuffers::Vector<Element>* vector) {
  return {reinterpret_cast<const std::uint32_t*>(vector->Data()), vector->size()};
}
std::span<const Interval> intervals(const flatbuffers::Vector<const compiled::Interval*>* vector) {
  return {reinterpret_cast<const Interval*>(vector->Data()), vector->size()};
}

CompiledView make_view(const compiled::Ontology& root) {
  CompiledView view;
  view.root = &root;
  view.digest = root.digest();
  view.is_consistent = root.is_consistent();
  view.text = {reinterpret_cast<const char*>(root.text()->Data()), root.text()->size()};
  view.name_end = numbers(root.name_end());
  view.prefix_name = numbers(root.prefix_name());
  view.prefix_iri = numbers(root.prefix_iri());
  view.class_name = numbers(root.class_name());
  view.class_label = numbers(root.class_label());
  view.representative = numbers(root.representative());
  view.thing = root.thing();
  view.nothing = root.nothing();
  view.parent_begin = numbers(root.parent_begin());
  view.parents = numbers(root.parents());
  view.child_begin = numbers(root.child_begin());
  view.children = numbers(root.children());
  view.own_interval = intervals(root.own_interval());
  view.further_begin = numbers(root.further_begin());
  view.further = intervals(root.further());
  view.label_text = numbers(root.label_text());
  view.label_class = numbers(root.label_class());
  view.term_kind = {root.term_kind()->Data(), root.term_kind()->size()};
  view.term_name = numbers(root.term_name());
  view.term_number = numbers(root.term_number());
  view.term_begin = numbers(root.term_begin());
  view.term_arguments = numbers(root.term_arguments());
  view.axiom_kind = {root.axiom_kind()->Data(), root.axiom_kind()->size()};
  view.axiom_file = numbers(root.axiom_file());
  view.axiom_line = numbers(root.axiom_line());
  view.axiom_begin = numbers(root.axiom_begin());
  view.axiom_arguments = numbers(root.axiom_arguments());
  return view;
}

void check_names(const CompiledView& view, Checker& check) {
  const std::size_t names = view.name_end.size();
  check.expect(std::ranges::is_sorted(view.name_end) && (names == 0 ? 0 : view.name_end.back()) == view.text.size(),
               "the borders of names");
  if (check.failed()) return;
  for (std::uint32_t at = 1; at < names; ++at) {
    if (view.name(at - 1) < view.name(at)) continue;
    check.expect(false, "the order of names");
    return;
  }
  check.expect(view.prefix_name.size() == view.prefix_iri.size(), "the number of prefixes");
  check.in_range(view.prefix_name, names, "a prefix");
  check.in_range(view.prefix_iri, names, "the IRI of a prefix");
}

void check_classes(const CompiledView& view, Checker& check) {
  const std::size_t names = view.name_end.size();
  const std::size_t count = view.class_name.size();
  check.in_range(view.class_name, names, "the name of a class");
  check.expect(std::ranges::adjacent_find(view.class_name, std::greater_equal<>()) == view.class_name.end(),
               "the order of classes");
  check.expect(
      view.class_label.size() == count && view.representative.size() == count && view.own_interval.size() == count,
      "the number of classes");
  check.expect(view.thing < count && view.nothing < count, "owl:Thing or owl:Nothing");
  if (check.failed()) return;
  check.expect(
      view.name(view.class_name[view.thing]) == owl_thing && view.name(view.class_name[view.nothing]) == owl_nothing,
      "the names of owl:Thing and owl:Nothing");
  check.expect(std::ranges::all_of(view.class_label,
                                   [&](std::uint32_t label) { return label < names || label == CompiledView::none; }),
               "a label");
  check.in_range(view.representative, count, "a representative");
  if (check.failed()) return;
  check.expect(
      std::ranges::all_of(view.representative, [&](std::uint32_t node) { return view.representative[node] == node; }),
      "a representative");
  check.borders(view.parent_begin, count, view.parents.size(), "the borders of parents");
  check.in_range(view.parents, count, "a parent");
  check.borders(view.child_begin, count, view.children.size(), "the borders of children");
  check.in_range(view.children, count, "a child");
  check.borders(view.further_begin, count, view.further.size(), "the borders of intervals");
  check.expect(view.label_text.size() == view.label_class.size(), "the number of labels");
  check.in_range(view.label_text, names, "the text of a label");
  check.expect(std::ranges::is_sorted(view.label_text), "the order of labels");
  check.in_range(view.label_class, count, "the class of a label");
}

void check_terms(const CompiledView& view, Checker& check) {
  const std::size_t count = view.term_kind.size();
  check.expect(view.term_name.size() == count && view.term_number.size() == count, "the number of terms");
  check.expect(std::ranges::all_of(view.term_kind, [](std::uint8_t kind) { return kind < term_kind_count; }),
               "the kind of a term");
  check.in_range(view.term_name, view.name_end.size(), "the name of a term");
  check.borders(view.term_begin, count, view.term_arguments.size(), "the borders of arguments of terms");
  if (check.failed()) return;
  // An argument comes before what it is in, so nothing is part of itself; and no deeper than readers allow.
  std::vector<std::uint16_t> depth(count, 0);
  std::vector<TermKind> kinds;
  for (std::uint32_t term = 0; term < count; ++term) {
    kinds.clear();
    for (const std::uint32_t argument : view.arguments_of_term(term)) {
      check.expect(argument < term, "an argument of a term");
      if (check.failed()) return;
      depth[term] = std::max(depth[term], static_cast<std::uint16_t>(depth[argument] + 1));
      kinds.push_back(view.kind_of_term(argument));
    }
    check.expect(is_well_formed(view.kind_of_term(term), kinds), "the form of a term");
    check.expect(depth[term] <= SourceLimits{}.nesting, "the nesting of a term");
    if (check.failed()) return;
  }
}

void check_axioms(const CompiledView& view, Checker& check) {
  const std::size_t count = view.axiom_kind.size();
  check.expect(view.axiom_file.size() == count && view.axiom_line.size() == count, "the number of axioms");
  check.expect(std::ranges::all_of(view.axiom_kind, [](std::uint8_t kind) { return kind < axiom_kind_count; }),
               "the kind of an axiom");
  check.in_range(view.axiom_file, view.root->files()->size(), "the file of an axiom");
  check.borders(view.axiom_begin, count, view.axiom_arguments.size(), "the borders of arguments of axioms");
  check.in_range(view.axiom_arguments, view.term_kind.size(), "an argument of an axiom");
  if (check.failed()) return;
  std::vector<TermKind> kinds;
  for (std::uint32_t axiom = 0; axiom < count && !check.failed(); ++axiom) {
    kinds.clear();
    for (const std::uint32_t argument : view.arguments_of_axiom(axiom)) kinds.push_back(view.kind_of_term(argument));
    check.expect(is_well_formed(view.kind_of_axiom(axiom), kinds), "the form of an axiom");
  }
}

}  // namespace

std::expected<CompiledView, CompiledError> view_compiled(std::span<const std::byte> file) {
  constexpr flatbuffers::uoffset_t max_depth = 4;
  constexpr flatbuffers::uoffset_t max_tables = 1'000'000;  // files and left-outs; all else is in flat arrays
  const auto payload = unwrap(file);
  if (!payload) return std::unexpected(payload.error());
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(payload->data());
  flatbuffers::Verifier verifier(bytes, payload->size(), max_depth, max_tables);
  if (!verifier.VerifyBuffer<compiled::Ontology>(nullptr)) {
    return std::unexpected(CompiledError{"the compiled ontology is damaged: it is no FlatBuffer of its schema"});
  }
  const CompiledView view = make_view(*flatbuffers::GetRoot<compiled::Ontology>(bytes));
  Checker check;
  for (const auto& step : {check_names, check_classes, check_terms, check_axioms}) {
    step(view, check);
    if (check.failed()) {
      return std::unexpected(
          CompiledError{"the compiled ontology is damaged: " + check.problem() + " cannot be right"});
    }
  }
  return view;
}

std::vector<LoadedFile> files_of(const CompiledView& view) {
  std::vector<LoadedFile> files;
  for (const compiled::File* file : *view.root->files())
    files.push_back({file->path()->str(), file->ontology_iri()->str(), {file->size(), file->hash()}});
  return files;
}

std::vector<LeftOut> left_out_of(const CompiledView& view) {
  std::vector<LeftOut> left_out;
  for (const compiled::LeftOut* left : *view.root->left_out()) {
    left_out.push_back({left->construct()->str(), left->count(), left->first()->str()});
  }
  return left_out;
}

}  // namespace geminga::el
