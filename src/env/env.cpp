// Compiles the header on its own, so that it stands alone.
#include "env/env.hpp"
