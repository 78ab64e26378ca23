// Checks everything that must be right in a compiled ontology, so that reading it needs no further checks. Nothing in
// the file is trusted.
#ifndef GEMINGA_REASONING_COMPILED_COMPILED_CHECKS_HPP
#define GEMINGA_REASONING_COMPILED_COMPILED_CHECKS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reasoning/compiled/compiled_view.hpp"

namespace geminga::compiled {

/// Notes the first error and its offset in the file. Passes over arrays have no branches, so that compilers can use
/// vectors. Only an array with an error is looked at again, for the offset.
class Checker {
 public:
  explicit Checker(std::span<const std::byte> file) : file_(file) {}

  void expect(bool condition, std::string_view what) {
    if (!condition && problem_.empty()) problem_ = what;
  }
  /// The same for an array: the error names the offset where it begins.
  template <typename Number>
  void expect(bool condition, std::string_view what, std::span<const Number> array, std::size_t at = 0) {
    if (condition || failed()) return;
    problem_ = what;
    offset_ = static_cast<std::size_t>(reinterpret_cast<const std::byte*>(array.data() + at) - file_.data());
  }

  /// Expects all numbers to be below `end`.
  template <typename Number>
  void in_range(std::span<const Number> numbers, std::size_t end, std::string_view what) {
    const auto is_wrong = [&](Number number) { return number >= end; };
    if (end > 0xffffffffU) return;
    const auto bound = static_cast<std::uint32_t>(end);
    std::uint32_t wrong = 0;
    for (const Number number : numbers) wrong |= static_cast<std::uint32_t>(number >= bound);
    if (wrong != 0) locate(numbers, is_wrong, what);
  }
  /// The same for numbers that may also be none.
  void in_range_or_none(taxonomy::ClassifiedView::Numbers numbers, std::size_t end, std::string_view what) {
    const auto is_wrong = [&](std::uint32_t number) {
      return number >= end && number != taxonomy::ClassifiedView::none;
    };
    std::uint32_t wrong = 0;
    for (const std::uint32_t number : numbers) wrong |= static_cast<std::uint32_t>(is_wrong(number));
    if (wrong != 0) locate(numbers, is_wrong, what);
  }
  /// Expects the borders of rows: one more than there are rows, from 0 to the number of items, never descending.
  void borders(taxonomy::ClassifiedView::Numbers begin, std::size_t rows, std::size_t items, std::string_view what) {
    expect(begin.size() == rows + 1, what, begin);
    if (failed()) return;
    expect(begin.front() == 0, what, begin);
    ends(begin.subspan(1), items, what);
  }
  /// Expects the ends of pieces: never descending, the last one the number of items.
  void ends(taxonomy::ClassifiedView::Numbers ends, std::size_t items, std::string_view what) {
    expect((ends.empty() ? 0 : ends.back()) == items, what, ends);
    std::uint32_t wrong = 0;
    for (std::size_t at = 1; at < ends.size(); ++at) wrong |= static_cast<std::uint32_t>(ends[at] < ends[at - 1]);
    if (wrong == 0) return;
    const auto down = std::ranges::adjacent_find(ends, std::greater<>());
    expect(false, what, ends, static_cast<std::size_t>(down - ends.begin()) + 1);
  }

  [[nodiscard]] bool failed() const { return !problem_.empty(); }
  /// The error in one line.
  [[nodiscard]] CompiledError error() const {
    return {"the compiled ontology is damaged: " + problem_ +
            (offset_ ? " at offset " + std::to_string(*offset_) : std::string()) +
            " cannot be right: compile it again"};
  }

 private:
  template <typename Number, typename Test>
  void locate(std::span<const Number> numbers, Test&& is_wrong, std::string_view what) {
    const auto found = std::ranges::find_if(numbers, is_wrong);
    expect(false, what, numbers, static_cast<std::size_t>(found - numbers.begin()));
  }

  std::span<const std::byte> file_;
  std::string problem_;
  std::optional<std::size_t> offset_;
};

void check_taxonomy(const taxonomy::ClassifiedView& view, Checker& check);
void check_conversions(std::span<const taxonomy::Conversion> conversions, const taxonomy::ClassifiedView& view,
                       Checker& check);
void check_units(const UnitsView& units, Checker& check);
void check_labels(const LabelsView& labels, const taxonomy::ClassifiedView& taxonomy, Checker& check);
/// Checks the axioms of a view whose taxonomy has been checked. `files` and `groups` are the numbers of files and
/// left-outs.
void check_axioms(const taxonomy::ClassifiedView& view, std::size_t files, std::size_t groups, Checker& check);

}  // namespace geminga::compiled

#endif
