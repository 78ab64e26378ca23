// A case of a few axioms and everything that follows from them, for parameterised tests.
#ifndef GEMINGA_TESTS_REASONING_EL_ENTAILED_HPP
#define GEMINGA_TESTS_REASONING_EL_ENTAILED_HPP

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "support/written.hpp"

namespace geminga::el {

struct Entailed {
  const char* name;
  const char* axioms;
  std::vector<std::string> closure;
  bool is_complete = true;  ///< el uses every axiom
};

inline void PrintTo(const Entailed& one, std::ostream* out) { *out << one.name; }
inline std::string name_of(const testing::TestParamInfo<Entailed>& one) { return one.param.name; }

/// Expects exactly the closure of the case, and that el says whether it is complete.
inline void expect_exactly(const Entailed& one) {
  const owl::Ontology source = owl::written(one.axioms);
  EXPECT_EQ(owl::closure(owl::loaded(source)), one.closure) << one.axioms;
  EXPECT_EQ(owl::classified(source).unused.empty(), one.is_complete) << one.axioms;
}

}  // namespace geminga::el

#endif
