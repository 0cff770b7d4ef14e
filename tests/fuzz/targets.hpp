#pragma once

#include "bytes.hpp"

namespace splinecore::fuzz {

// What is done with the bytes of an input. Each has a folder of its name in tests/data/fuzz, with inputs to begin with
// and those that once broke something.

/// The bytes are a text: what is read is written and read again.
void json(Input data);

/// The bytes are a formula, after one that says of how many variables.
void formula(Input data);

/// A curve and a walk of verbs and measures.
void curve(Input data);

/// A patch and a walk of verbs and measures.
void patch(Input data);

/// Some patches, some with common sides, and their meshes.
void tessellation(Input data);

/// A pool of points and patches that index it, as a file that is damaged may have them.
void definition(Input data);

/// Points and numbers, and whatever makes shapes of them: build and conic.
void build(Input data);

/// A shape, or points that one goes through, and what is asked of it: nearest points, boxes, lengths, frames, features.
void features(Input data);

/// Points or a shape, and what is fitted to them: curves and patches near points, rebuilt and fair ones, feet of normals,
/// integrals over surfaces.
void fit(Input data);

/// Curves and patches, where they meet, and what is made of that: parts, offsets, corners, what goes on and what is between.
void meet(Input data);

/// Runs a target, and ends it where it takes long: what is slow is no finding, and hides others.
void run_for_a_while(void (*target)(Input data), Input data);

struct Target {
  const char* name;
  void (*run)(Input data);
};

inline constexpr std::array<Target, 10> kTargets{{{"json", json},
                                                 {"formula", formula},
                                                 {"curve", curve},
                                                 {"patch", patch},
                                                 {"tessellation", tessellation},
                                                 {"definition", definition},
                                                 {"build", build},
                                                 {"features", features},
                                                 {"fit", fit},
                                                 {"meet", meet}}};

}  // namespace splinecore::fuzz
