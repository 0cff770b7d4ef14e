"""Paint on surfaces: stripes that their exact normals reflect, and colors of numbers."""

from functools import cache

import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

#: How a surface may be painted.
PAINTS = {'ZEBRA': 0, 'REFLECTION': 1, 'HIGHLIGHT': 2, 'NUMBERS': 3}

#: Of numbers, from the smallest one by way of 0 to the largest one.
COLORS = np.array([(0.08, 0.20, 0.62), (0.35, 0.62, 0.90), (0.93, 0.93, 0.90), (0.96, 0.60, 0.38), (0.70, 0.06, 0.10)])

#: Of distances, from none to the largest.
DISTANCES = np.array([(0.10, 0.16, 0.50), (0.05, 0.50, 0.66), (0.36, 0.74, 0.40), (0.95, 0.82, 0.25), (0.78, 0.10, 0.12)])

# The 3D view takes light, not sRGB. More than 128 bytes of push constants are not to be had everywhere.
_TYPES = """
struct Paint {
    mat4 view_projection;
    mat4 matrix;
    mat4 normal_matrix;
    vec4 eye;
    vec4 axis;
    vec4 numbers;
    vec4 colors[5];
};
"""

_VERTEX = """
void main()
{
    vec4 at = paint.matrix * vec4(pos, 1.0);
    place = at.xyz;
    normal = mat3(paint.normal_matrix) * nor;
    number = value;
    gl_Position = paint.view_projection * at;
}
"""

_FRAGMENT = """
float band(float t, float width)
{
    float edge = clamp(width, 1e-5, 0.5);
    float dark = smoothstep(0.5 - edge, 0.5 + edge, abs(2.0 * fract(t) - 1.0));
    return mix(dark, 0.5, clamp(2.0 * width - 0.5, 0.0, 1.0));
}

vec3 color_of(float t)
{
    float s = 2.0 * clamp(t, -1.0, 1.0) + 2.0;
    int i = int(min(s, 3.0));
    return mix(paint.colors[i].xyz, paint.colors[i + 1].xyz, s - float(i));
}

vec4 seen(vec3 srgb)
{
    vec3 part = max(srgb, vec3(0.0));
    return vec4(mix(part / 12.92, pow((part + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), part)), 1.0);
}

void main()
{
    vec3 n = normalize(normal);
    vec3 to = normalize(paint.eye.w == 0.0 ? paint.eye.xyz : place - paint.eye.xyz);
    float light = 0.7 + 0.3 * abs(dot(n, to));
    int kind = int(paint.numbers.x);
    float count = paint.numbers.y;
    vec3 axis = paint.axis.xyz;
    if (kind == 3) {
        bool is_known = abs(number) < 1e37;
        color = seen(light * (is_known ? color_of(number * paint.numbers.z + paint.numbers.w) : vec3(0.5)));
        return;
    }
    vec3 way = kind == 2 ? n : reflect(to, n);
    float t;
    float other;
    if (kind == 1) {
        vec3 side = normalize(abs(axis.z) < 0.9 ? cross(axis, vec3(0.0, 0.0, 1.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
        float turn = atan(dot(way, cross(axis, side)), dot(way, side)) / 3.14159265;
        t = turn * count;
        other = (turn < 0.0 ? turn + 2.0 : turn) * count;
    }
    else {
        float along = dot(way, axis);
        t = acos(clamp(kind == 2 ? abs(along) : along, -1.0, 1.0)) / 3.14159265 * count;
        other = t;
    }
    float white = band(t, 2.0 * min(fwidth(t), fwidth(other)));
    color = seen(light * mix(vec3(0.03), vec3(0.95), white));
}
"""


@cache
def shader():
    """Needs a window."""
    info = gpu.types.GPUShaderCreateInfo()
    info.typedef_source(_TYPES)
    info.uniform_buf(0, 'Paint', 'paint')
    for i, (kind, name) in enumerate((('VEC3', 'pos'), ('VEC3', 'nor'), ('FLOAT', 'value'))):
        info.vertex_in(i, kind, name)
    between = gpu.types.GPUStageInterfaceInfo("splinewright_between")
    for kind, name in (('VEC3', 'place'), ('VEC3', 'normal'), ('FLOAT', 'number')):
        between.smooth(kind, name)
    info.vertex_out(between)
    info.fragment_out(0, 'VEC4', 'color')
    info.vertex_source(_VERTEX)
    info.fragment_source(_FRAGMENT)
    return gpu.shader.create_from_info(info)


def colors_at(parts, colors=COLORS):
    """(n, 3): RGB of parts of the range, from -1 to 1."""
    return np.stack([np.interp(2.0 * np.asarray(parts) + 2.0, range(len(colors)), channel) for channel in colors.T], -1)


def batch(faces):
    """What draw() draws of core.analysis.faces.Faces."""
    values = np.where(np.isfinite(faces.values), faces.values, np.float32(3e38))
    return batch_for_shader(shader(), 'TRIS', {'pos': faces.positions, 'nor': faces.normals, 'value': values},
                            indices=faces.triangles)


def draw(prepared, matrix, kind, count=1.0, axis=(0.0, 0.0, 1.0), reach=1.0, colors=COLORS):
    """In the current 3D view. kind: of PAINTS. reach: the number that has the last color; the first has the opposite one,
    or with DISTANCES 0."""
    view, used = gpu.matrix.get_model_view_matrix(), shader()
    projection = gpu.matrix.get_projection_matrix()
    back = view.inverted()
    is_perspective = projection[3][3] == 0.0
    eye = (*back.translation, 1.0) if is_perspective else (*-back.col[2].xyz, 0.0)
    scale = 1.0 / reach if reach > 0.0 else 0.0
    numbers = (PAINTS[kind], count, *((2.0 * scale, -1.0) if colors is DISTANCES else (scale, 0.0)))
    normal_matrix = matrix.inverted_safe().transposed().to_3x3().to_4x4()
    columns = [column for each in (projection @ view, matrix, normal_matrix) for column in each.transposed()]
    flat = np.concatenate([*columns, eye, (*axis, 0.0), numbers, *np.pad(colors, [(0, 0), (0, 1)])]).astype(np.float32)
    block = gpu.types.GPUUniformBuf(gpu.types.Buffer('FLOAT', len(flat), flat))     # is used until all is drawn
    used.uniform_block('paint', block)
    was_written = gpu.state.depth_mask_get()
    gpu.state.depth_mask_set(True)      # in views without solid faces one hides the other, too
    prepared.draw(used)
    gpu.state.depth_mask_set(was_written)
