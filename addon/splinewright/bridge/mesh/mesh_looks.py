"""The Look of each patch of a mesh, kept while the faces themselves come and go."""

import numpy as np

from ...core.base.failures import Refusal
from ..data import versions
from ..data.shading import Look
from . import mesh_layers

#: Face attribute: which patch of the shape a face belongs to.
PATCH_NAME = "patch"


def name_patches(mesh, face_patches):
    """Note for each face its patch."""
    attribute = mesh_layers.ours(mesh, PATCH_NAME, 'INT', 'FACE')
    if attribute is None:
        users = mesh.attributes.get(PATCH_NAME)
        if users is not None:
            mesh_layers.remove(mesh, PATCH_NAME)
        attribute = mesh.attributes.new(PATCH_NAME, 'INT', 'FACE')
    attribute.data.foreach_set('value', face_patches)


def looks_by_patch(mesh):
    """The Look of each patch's first face, by the number of the patch; {} where that is not known."""
    return kept(mesh)[0]


def kept(mesh):
    """(looks_by_patch(), what faces of a patch have that differ from one another: mesh_layers.Layers)."""
    patches = _patches(mesh)
    if patches is None:
        return {}, []
    indices, smooth = _material_indices(mesh), _smooth(mesh)
    first = np.full(1 + patches.max(), -1)
    first[patches[::-1]] = np.arange(len(patches))[::-1]
    looks = {number: Look(int(indices[face]), bool(smooth[face]))
             for number, face in enumerate(first.tolist()) if face >= 0}
    if np.array_equal(indices[first[patches]], indices) and np.array_equal(smooth[first[patches]], smooth):
        return looks, []
    return looks, [mesh_layers.Layer(name, 'FIELD', 'FACE', values[:, None])
                   for name, values in (('material_index', indices), ('use_smooth', smooth))]


def _material_indices(mesh):
    indices = mesh_layers.column(mesh, 'polygons', 'material_index', 'material_index', np.int32)
    return np.zeros(len(mesh.polygons), np.int32) if indices is None else indices


def _smooth(mesh):
    """(faces,): where these are attributes, faces that are not smooth are marked."""
    if not versions.marks_are_attributes:
        return mesh_layers.read(mesh.polygons, 'use_smooth', 1, bool)[:, 0]
    sharp = mesh_layers.column(mesh, 'polygons', '', 'sharp_face', bool)
    return np.ones(len(mesh.polygons), bool) if sharp is None else ~sharp


def set_looks(mesh, looks):
    """Give the faces of each patch its Look; those of patches that are not named have the first material, smooth."""
    patches = _patches(mesh)
    if patches is None:
        return
    of_patch = [looks.get(patch, Look()) for patch in range(1 + patches.max())]
    indices = np.array([look.material_index for look in of_patch], np.int32)[patches]
    if indices.any():                   # the first is what faces have, and a layer of zeros costs memory
        mesh.polygons.foreach_set('material_index', indices)
    mesh.polygons.foreach_set('use_smooth', np.array([look.use_smooth for look in of_patch])[patches])


def set_material(mesh, piece, index):
    """Give the faces of one patch, counted from 1, or of all where it is 0, a material index. Raises Refusal."""
    patches = _patches(mesh)
    count = 0 if patches is None else 1 + int(patches.max())
    if piece > count:
        raise Refusal("the shape has {count} patches, there is none of number {number}",
                      "the shape has {count} patch, there is none of number {number}", count=count, number=piece)
    indices = np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get('material_index', indices)
    indices[(patches == piece - 1) if piece else slice(None)] = index
    mesh.polygons.foreach_set('material_index', indices)
    mesh.update()


def set_materials(mesh, indices):
    """Give the faces of each patch its material index, one after the other."""
    patches = _patches(mesh)
    if patches is not None:
        mesh.polygons.foreach_set('material_index', np.array(indices, np.int32)[patches])
        mesh.update()


def shaded_normals(mesh, normals):
    """Corner normals (c, 3) with those of flat faces in place of the exact ones. The mesh is up to date."""
    smooth = np.empty(len(mesh.polygons), bool)
    mesh.polygons.foreach_get('use_smooth', smooth)
    if smooth.all():
        return normals
    of_faces, counts = np.empty((len(smooth), 3), np.float32), np.empty(len(smooth), np.int32)
    mesh.polygons.foreach_get('normal', of_faces.ravel())
    mesh.polygons.foreach_get('loop_total', counts)
    return np.where(np.repeat(smooth, counts)[:, None], normals, np.repeat(of_faces, counts, axis=0))


def patch_of_face(mesh, face):
    """The number, counted from 1, of the patch that a face of a mesh, also of an evaluated one, shows; 0 if unknown."""
    attribute = mesh_layers.ours(mesh, PATCH_NAME, 'INT', 'FACE')
    return attribute.data[face].value + 1 if attribute is not None and face < len(attribute.data) else 0


def _patches(mesh):
    """The patch of each face, or None where that is not known."""
    attribute = mesh_layers.ours(mesh, PATCH_NAME, 'INT', 'FACE')
    if attribute is None or not len(mesh.polygons) or len(attribute.data) != len(mesh.polygons):
        return None
    patches = mesh_layers.read(attribute.data, 'value', 1, np.int32)[:, 0]
    return patches if patches.min() >= 0 else None
