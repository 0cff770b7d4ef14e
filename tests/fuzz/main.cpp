#include "targets.hpp"

// What libFuzzer calls; FUZZ_TARGET is one of the functions of targets.hpp.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  splinecore::fuzz::run_for_a_while(splinecore::fuzz::FUZZ_TARGET, {data, size});
  return 0;
}
