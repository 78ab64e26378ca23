// Any octets as a recording: whatever is in it, the reader comes to its end, times never run backwards, and each
// question at each moment is answered in lines of GCNP that can be read.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "discovery/gcnp/event.hpp"
#include "recording/reader.hpp"
#include "recording/talk.hpp"

namespace {

using namespace geminga;
using namespace geminga::recording;

void require(bool condition) {
  if (!condition) std::abort();
}

/// Asks everything of a state.
void ask(const State& state) {
  Talk talk(1);
  talk.hear(
      "0 sys hello\n1 query participants\n1 query services\n1 query requests unmatched=1\n1 query match\n1 query "
      "status\n"
      "1 query ontology\n1 query security\n1 query why subscription=a29154c3/1/1\n");
  for (std::string text; !(text = talk.next_answer(state)).empty();) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      require(line.ends_with('\r'));
      line.pop_back();
      require(gcnp::read_reply(line).has_value());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(octets), size));
  Reader reader(in, [](const Finding& finding) { require(!finding.text.empty()); });
  State state;
  At last{};
  while (true) {
    const auto entry = reader.next();
    if (!entry || !*entry) break;
    require((*entry)->at >= last);
    last = (*entry)->at;
    state.apply(**entry);
  }
  ask(state);
  return 0;
}
