// The walk: a name that comes into the signature wakes the axioms that wait for it.
#include "el/module.hpp"

#include <algorithm>
#include <unordered_map>

namespace geminga::el {
namespace {

/// The number of a name, or CompiledView::none.
std::uint32_t find_name(const CompiledView& view, std::string_view name) {
  std::uint32_t first = 0;
  std::uint32_t last = static_cast<std::uint32_t>(view.name_end.size());
  while (first < last) {
    const std::uint32_t middle = first + (last - first) / 2;
    if (view.name(middle) < name) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return first < view.name_end.size() && view.name(first) == name ? first : CompiledView::none;
}

BuiltIn find_built_in(const CompiledView& view) {
  const std::uint32_t thing = find_name(view, owl_thing);
  const std::uint32_t nothing = find_name(view, owl_nothing);
  const std::uint32_t top_object = find_name(view, "http://www.w3.org/2002/07/owl#topObjectProperty");
  const std::uint32_t top_data = find_name(view, "http://www.w3.org/2002/07/owl#topDataProperty");
  const std::uint32_t bottom_object = find_name(view, "http://www.w3.org/2002/07/owl#bottomObjectProperty");
  const std::uint32_t bottom_data = find_name(view, "http://www.w3.org/2002/07/owl#bottomDataProperty");
  BuiltIn found;
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    const std::uint32_t name = view.term_name[term];
    switch (view.kind_of_term(term)) {
      case TermKind::named_class:
        if (name == thing) found.thing = term;
        if (name == nothing) found.nothing = term;
        break;
      case TermKind::object_property:
        if (name == top_object) found.top_object_property = term;
        if (name == bottom_object) found.bottom_object_property = term;
        break;
      case TermKind::data_property:
        if (name == top_data) found.top_data_property = term;
        if (name == bottom_data) found.bottom_data_property = term;
        break;
      default:
        break;
    }
  }
  return found;
}

bool is_name(TermKind kind) { return kind <= TermKind::anonymous_individual && kind != TermKind::datatype; }

/// Walks from names to axioms and from axioms to names.
class Walk {
 public:
  explicit Walk(const ModuleIndex& index)
      : index_(index),
        view_(index.view()),
        is_in_signature_(view_.term_count(), false),
        is_taken_(view_.axiom_count(), false),
        test_(view_, index.built_in(), is_in_signature_, index.uses()) {}

  std::vector<std::uint32_t> run(std::span<const std::uint32_t> terms) {
    for (const std::uint32_t term : terms) enter(term);
    follow();
    for (const std::uint32_t axiom : index_.unconditional()) {
      look_at(axiom);
      follow();
    }
    return std::move(module_);
  }

 private:
  /// Takes a term's names into the signature. Recursion is bounded by the nesting of terms.
  void enter(std::uint32_t term) {
    if (is_in_signature_[term]) return;
    is_in_signature_[term] = true;
    if (is_name(view_.kind_of_term(term))) names_.push_back(term);
    for (const std::uint32_t argument : view_.arguments_of_term(term)) enter(argument);
  }

  void follow() {
    while (next_ < names_.size()) {
      const std::uint32_t name = names_[next_++];
      for (const std::uint32_t axiom : index_.axioms_of(name)) look_at(axiom);
      const auto woken = waiting_.find(name);
      if (woken == waiting_.end()) continue;
      const std::vector<std::uint32_t> axioms = std::move(woken->second);
      for (const std::uint32_t axiom : axioms) look_at(axiom);
    }
  }

  void look_at(std::uint32_t axiom) {
    if (is_taken_[axiom]) return;
    switch (test_.of(axiom)) {
      case Locality::always:
        return;
      case Locality::waiting:
        for (const std::uint32_t name : test_.names()) waiting_[name].push_back(axiom);
        return;
      case Locality::not_local:
        is_taken_[axiom] = true;
        module_.push_back(axiom);
        for (const std::uint32_t argument : view_.arguments_of_axiom(axiom)) enter(argument);
    }
  }

  const ModuleIndex& index_;
  const CompiledView& view_;
  std::vector<bool> is_in_signature_;
  std::vector<bool> is_taken_;
  LocalityTest test_;
  std::vector<std::uint32_t> names_;  ///< of the signature, in the order in which they came
  std::size_t next_ = 0;              ///< of them, the first whose axioms have not been looked at
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> waiting_;  ///< beside what the index says
  std::vector<std::uint32_t> module_;
};

}  // namespace

ModuleIndex::ModuleIndex(const CompiledView& view)
    : view_(view),
      built_in_(find_built_in(view)),
      uses_(view.term_count(), 0),
      class_terms_(view.class_count(), CompiledView::none) {
  for (const std::uint32_t argument : view.term_arguments) ++uses_[argument];
  for (const std::uint32_t argument : view.axiom_arguments) ++uses_[argument];
  std::vector<std::uint32_t> class_of_name(view.name_end.size(), CompiledView::none);
  for (std::uint32_t number = 0; number < view.class_count(); ++number) class_of_name[view.class_name[number]] = number;
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    const std::uint32_t number = class_of_name[view.term_name[term]];
    if (view.kind_of_term(term) == TermKind::named_class && number != CompiledView::none) class_terms_[number] = term;
  }
  const std::vector<bool> nothing_yet(view.term_count(), false);
  LocalityTest test(view, built_in_, nothing_yet, uses_);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting;
  waiting.reserve(view.axiom_count());
  for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) {
    const Locality locality = test.of(axiom);
    for (const std::uint32_t name : test.names()) waiting.emplace_back(name, axiom);
    if (locality != Locality::not_local) continue;
    unconditional_.push_back(axiom);
    // It is in every module; where a name of it is met, it comes early.
    for (const std::uint32_t argument : view.arguments_of_axiom(axiom)) {
      if (is_name(view.kind_of_term(argument))) waiting.emplace_back(argument, axiom);
    }
  }
  axioms_of_ = Rows<std::uint32_t>(view.term_count(), waiting);
}

std::optional<std::uint32_t> ModuleIndex::term_of(ClassNumber number) const {
  const std::uint32_t term = class_terms_[static_cast<std::size_t>(number)];
  if (term == CompiledView::none) return std::nullopt;
  return term;
}

std::vector<std::uint32_t> extract_module(const ModuleIndex& index, std::span<const ClassNumber> classes,
                                          std::span<const std::uint32_t> more_terms) {
  std::vector<std::uint32_t> terms;
  for (const ClassNumber number : classes) {
    if (const auto term = index.term_of(number)) terms.push_back(*term);
  }
  terms.insert(terms.end(), more_terms.begin(), more_terms.end());
  return Walk(index).run(terms);
}

}  // namespace geminga::el
