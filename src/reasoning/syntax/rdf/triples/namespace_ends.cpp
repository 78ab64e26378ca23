// Keeps one bit for each depth of the stack of namespaces that this thread used last. A stack belongs to one parser,
// and a parser to one thread for its life, so that no other thread begins namespaces in it.
#include "reasoning/syntax/rdf/triples/namespace_ends.hpp"

#include <dlfcn.h>
#include <raptor2.h>

#include <limits>

namespace geminga::rdf {
namespace {

/// Depths beyond these are always handed on.
constexpr int depths_known = std::numeric_limits<std::uint64_t>::digits;
constexpr std::uint64_t all_depths = std::numeric_limits<std::uint64_t>::max();

struct NamespaceDepths {
  const raptor_namespace_stack* stack = nullptr;
  std::uint64_t may_have_some = all_depths;  ///< a bit for each depth
  bool sees_begins = false;                  ///< raptor begins its namespaces by the function below
  std::uint64_t spared = 0;
};

thread_local NamespaceDepths depths;

/// Raptor's own function of this name.
template <typename Function>
Function* function_of_raptor(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Whether a namespace may have begun at this depth since the last end of one. From here on none has.
bool may_end_some(const raptor_namespace_stack* stack, int depth) {
  if (stack != depths.stack) {
    depths.stack = stack;
    depths.may_have_some = all_depths;
  }
  if (!depths.sees_begins || depth < 0 || depth >= depths_known) return true;
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(depth);
  const bool may_have_some = (depths.may_have_some & bit) != 0;
  depths.may_have_some &= ~bit;
  if (!may_have_some) ++depths.spared;
  return may_have_some;
}

}  // namespace

void forget_namespace_depths() { depths = {.spared = depths.spared}; }

std::uint64_t spared_namespace_ends() { return depths.spared; }

}  // namespace geminga::rdf

// Visible to libraptor2 even where a program hides its names.
extern "C" {

/// Begins a namespace. Its depth is raptor's secret, so that it may be any.
[[gnu::visibility("default")]] void raptor_namespaces_start_namespace(raptor_namespace_stack* stack,
                                                                      raptor_namespace* space) {
  static const auto start = geminga::rdf::function_of_raptor<decltype(raptor_namespaces_start_namespace)>(
      "raptor_namespaces_start_namespace");
  geminga::rdf::depths.stack = stack;
  geminga::rdf::depths.may_have_some = geminga::rdf::all_depths;
  geminga::rdf::depths.sees_begins = true;
  start(stack, space);
}

/// Ends the namespaces of an element.
[[gnu::visibility("default")]] void raptor_namespaces_end_for_depth(raptor_namespace_stack* stack, int depth) {
  static const auto end =
      geminga::rdf::function_of_raptor<decltype(raptor_namespaces_end_for_depth)>("raptor_namespaces_end_for_depth");
  if (geminga::rdf::may_end_some(stack, depth)) end(stack, depth);
}
}
