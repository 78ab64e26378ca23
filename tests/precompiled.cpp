// CMake compiles precompiled.hpp on behalf of a target, and a target needs a source.
