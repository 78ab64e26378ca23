#include "reasoning/modules/signature_module.hpp"

#include <numeric>

#include "reasoning/modules/source_locality.hpp"

namespace geminga::modules {
namespace {

using owl::TermId;

bool is_name(owl::TermKind kind) { return kind <= owl::TermKind::anonymous_individual; }

/// Makes modules among some axioms of one source.
class Extraction {
 public:
  Extraction(const owl::Ontology& source, std::span<const TermId> signature)
      : source_(source), signature_(signature), names_of_(source.axiom_count()) {}

  [[nodiscard]] std::vector<std::uint32_t> run(const std::vector<std::uint32_t>& among, Outside outside) {
    std::vector<bool> is_in_signature(source_.term_count());
    SourceLocality locality(source_, is_in_signature, outside);
    std::vector<bool> is_taken(source_.axiom_count());
    std::vector<std::vector<std::uint32_t>> waiting(source_.term_count());
    std::vector<TermId> entered;
    const auto enter = [&](TermId name) {
      if (is_in_signature[static_cast<std::size_t>(name)]) return;
      is_in_signature[static_cast<std::size_t>(name)] = true;
      entered.push_back(name);
    };
    const auto test = [&](std::uint32_t number) {
      if (is_taken[number] || locality.is_local(source_.axiom(number))) return;
      is_taken[number] = true;
      for (const TermId name : names_of(number)) enter(name);
    };
    for (const TermId name : signature_) enter(name);
    for (const std::uint32_t number : among) {
      for (const TermId name : names_of(number)) waiting[static_cast<std::size_t>(name)].push_back(number);
    }
    for (const std::uint32_t number : among) test(number);
    while (!entered.empty()) {
      const TermId name = entered.back();
      entered.pop_back();
      for (const std::uint32_t number : waiting[static_cast<std::size_t>(name)]) test(number);
    }
    std::vector<std::uint32_t> module;
    for (const std::uint32_t number : among) {
      if (is_taken[number]) module.push_back(number);
    }
    return module;
  }

 private:
  const std::vector<TermId>& names_of(std::uint32_t number) {
    std::vector<TermId>& names = names_of_[number];
    if (!names.empty()) return names;
    for (const TermId term : owl::terms_in(source_, source_.axiom(number).arguments)) {
      if (is_name(source_.kind(term))) names.push_back(term);
    }
    return names;
  }

  const owl::Ontology& source_;
  std::span<const TermId> signature_;
  std::vector<std::vector<TermId>> names_of_;  ///< by axiom; empty: not looked for, or there is none
};

}  // namespace

std::vector<std::uint32_t> extract_module(const owl::Ontology& source, std::span<const TermId> signature,
                                          ModuleKind kind) {
  std::vector<std::uint32_t> module(source.axiom_count());
  std::iota(module.begin(), module.end(), 0U);
  Extraction extraction(source, signature);
  if (kind != ModuleKind::top) module = extraction.run(module, Outside::is_empty);
  if (kind == ModuleKind::bottom) return module;
  while (true) {
    std::vector<std::uint32_t> smaller = extraction.run(module, Outside::is_everything);
    if (kind == ModuleKind::top) return smaller;
    smaller = extraction.run(smaller, Outside::is_empty);
    if (smaller.size() == module.size()) return module;
    module = std::move(smaller);
  }
}

}  // namespace geminga::modules
