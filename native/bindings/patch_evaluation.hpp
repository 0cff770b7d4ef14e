#pragma once

#include "arrays.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "splinecore/patch/patch_set.hpp"

// Points, derivatives and normals of patches and of sets of them.
namespace bindings {

py::array evaluate(const splinecore::NurbsPatch& patch, const py::object& u, const py::object& v,
                   const py::object& side, const py::object& at_infinity, const py::object& dtype,
                   const py::object& out, const py::object& threads, const py::object& cancel);

py::array derivatives(const splinecore::NurbsPatch& patch, const py::object& u, const py::object& v,
                      const py::object& order, const py::object& side, const py::object& at_infinity,
                      const py::object& out, const py::object& threads, const py::object& cancel);

py::array first_derivatives(const splinecore::NurbsPatch& patch, const py::object& u, const py::object& v,
                            const py::object& side, const py::object& at_infinity, const py::object& out,
                            const py::object& threads, const py::object& cancel);

py::array evaluate_grid(const splinecore::NurbsPatch& patch, const py::object& u, const py::object& v,
                        const py::object& side, const py::object& at_infinity, const py::object& dtype,
                        const py::object& out, const py::object& threads, const py::object& cancel);

py::tuple evaluate_grid_with_normals(const splinecore::NurbsPatch& patch, const py::object& u, const py::object& v,
                                     const py::object& side, const py::object& at_infinity, const py::object& dtype,
                                     const py::object& out, const py::object& threads, const py::object& cancel);

py::array evaluate_grid(const splinecore::PatchSet& set, const py::object& u, const py::object& v,
                        const py::object& side, const py::object& at_infinity, const py::object& dtype,
                        const py::object& out, const py::object& threads, const py::object& cancel);

py::tuple evaluate_grid_with_normals(const splinecore::PatchSet& set, const py::object& u, const py::object& v,
                                     const py::object& side, const py::object& at_infinity, const py::object& dtype,
                                     const py::object& out, const py::object& threads, const py::object& cancel);

}  // namespace bindings
