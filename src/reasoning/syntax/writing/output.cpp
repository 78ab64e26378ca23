#include "reasoning/syntax/writing/output.hpp"

#include <utility>

namespace geminga::writing {
namespace {

constexpr std::size_t piece_octets = std::size_t{1} << 16;

}  // namespace

void Output::add(std::string_view text) {
  if (problem_) return;
  octets_ += text.size();
  if (octets_ > limits_.octets)
    return fail("the text has more than " + std::to_string(limits_.octets) + " octets: write fewer files");
  waiting_ += text;
  if (waiting_.size() >= piece_octets) flush();
}

void Output::fail(std::string why) {
  if (!problem_) problem_ = std::move(why);
}

void Output::flush() {
  if (!problem_ && !waiting_.empty() && !sink_(waiting_)) fail("the output takes no more");
  waiting_.clear();
}

std::optional<std::string> Output::finish() {
  flush();
  return problem_;
}

}  // namespace geminga::writing
