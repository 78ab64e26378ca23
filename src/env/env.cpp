// Compiles the header alone.
#include "env/env.hpp"
