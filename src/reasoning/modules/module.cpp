// A name that enters the signature brings in the axioms that wait for it.
#include "reasoning/modules/module.hpp"

#include <algorithm>
#include <unordered_map>

namespace geminga::modules {
namespace {

/// Walks from names to axioms and from axioms to names.
class Walk {
 public:
  Walk(const ModuleIndex& index, std::size_t most)
      : index_(index),
        most_(most),
        view_(index.view()),
        is_in_signature_(view_.term_count(), false),
        is_taken_(view_.axiom_count(), false),
        test_(view_, index.built_in(), is_in_signature_, index.uses()) {}

  std::vector<std::uint32_t> run(std::span<const std::uint32_t> terms) {
    for (const std::uint32_t term : terms) enter(term);
    follow();
    for (const std::uint32_t axiom : index_.unconditional()) {
      if (is_over()) break;
      look_at(axiom);
      follow();
    }
    return std::move(module_);
  }

 private:
  [[nodiscard]] bool is_over() const { return module_.size() >= most_; }

  /// Adds the names in a term to the signature. Recursion is bounded by the nesting of terms.
  void enter(std::uint32_t term) {
    if (is_in_signature_[term]) return;
    is_in_signature_[term] = true;
    if (is_entity(view_.kind_of_term(term))) names_.push_back(term);
    for (const std::uint32_t argument : view_.arguments_of_term(term)) enter(argument);
  }

  void follow() {
    while (next_ < names_.size() && !is_over()) {
      const std::uint32_t name = names_[next_++];
      for (const std::uint32_t axiom : index_.axioms_of(name)) look_at(axiom);
      const auto woken = waiting_.find(name);
      if (woken == waiting_.end()) continue;
      const std::vector<std::uint32_t> axioms = std::move(woken->second);
      for (const std::uint32_t axiom : axioms) look_at(axiom);
    }
  }

  void look_at(std::uint32_t axiom) {
    if (is_taken_[axiom] || is_over()) return;
    switch (test_.test(axiom)) {
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
  std::size_t most_;
  const taxonomy::ClassifiedView& view_;
  std::vector<bool> is_in_signature_;
  std::vector<bool> is_taken_;
  LocalityTest test_;
  std::vector<std::uint32_t> names_;  ///< of the signature, in the order in which they came
  std::size_t next_ = 0;              ///< the first name whose axioms have not been looked at
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> waiting_;  ///< by name, beside the index
  std::vector<std::uint32_t> module_;
};

}  // namespace

ModuleIndex::ModuleIndex(const taxonomy::ClassifiedView& view) : view_(&view) {
  if (view.built_in.size() != built_in_count) return;  // a view without axioms
  const auto& terms = view.built_in;
  built_in_ = {terms[0], terms[1], terms[2], terms[3], terms[4], terms[5]};
}

std::optional<std::uint32_t> ModuleIndex::term_of(taxonomy::ClassNumber number) const {
  const auto at = static_cast<std::size_t>(number);
  if (at >= view_->term_of_class.size() || view_->term_of_class[at] == taxonomy::ClassifiedView::none)
    return std::nullopt;
  return view_->term_of_class[at];
}

std::vector<std::uint32_t> extract_module(const ModuleIndex& index, std::span<const taxonomy::ClassNumber> classes,
                                          std::span<const std::uint32_t> more_terms, std::size_t most) {
  std::vector<std::uint32_t> terms;
  for (const taxonomy::ClassNumber number : classes) {
    if (const auto term = index.term_of(number)) terms.push_back(*term);
  }
  terms.insert(terms.end(), more_terms.begin(), more_terms.end());
  return Walk(index, most).run(terms);
}

}  // namespace geminga::modules
