#define SPLINECORE_SET baseline
#include "set.hpp"
