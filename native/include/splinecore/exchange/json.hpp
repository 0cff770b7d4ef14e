#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/curve/power_curve.hpp"
#include "splinecore/patch/patch_set.hpp"
#include "splinecore/region/region.hpp"

namespace splinecore {

/// Anything that a text can hold.
using Value = std::variant<BezierCurve, HermiteCurve, NurbsCurve, BezierPatch, HermitePatch,
                           NurbsPatch, PatchSet, PowerCurve, Region>;

/// One value, or a list of them.
using Document = std::variant<Value, std::vector<Value>>;

/// The newest version of the text; from_json() reads it and older ones. Version 2 added power curves, 3 regions.
/// to_json() writes the oldest version that has all kinds of the document, so that older readers read it.
inline constexpr int kJsonVersion = 3;

/// JSON that from_json() reads back equal in every bit: numbers are the shortest that do.
std::string to_json(const Document& document);

/// @throws InvalidShape if the text is not JSON, is not of this format, is of a newer version, or
///         holds an invalid shape. The message says where.
Document from_json(std::string_view text);

}  // namespace splinecore
