"""Blender evaluates the inputs of a shape where it evaluates the shape, hidden ones, too.

Of a hidden object pointers bring nothing but shape keys: no transform, no hooks. A driver that reads its dimensions, which
depend on all of that, brings the rest; of objects whose place alone counts one that reads their transform. It always gives
0 to a property that means nothing.
"""


def start(data, path, sources, frames=()):
    """Drive the property of a path with the objects, and with the places of frames; they may have changed since the last
    time. Whether anything changed."""
    driver = _driver(data, path)
    if driver is None:
        driver = data.driver_add(path)
    elif [variable.targets[0].id for variable in driver.driver.variables] == [*sources, *frames]:
        return False
    variables = driver.driver.variables
    for variable in list(variables):
        variables.remove(variable)
    for source in sources:
        target = variables.new().targets[0]
        target.id, target.data_path = source, 'dimensions[0]'
    for frame in frames:
        variable = variables.new()
        variable.type = 'TRANSFORMS'
        variable.targets[0].id = frame
    driver.driver.expression = "0"
    return True


def stop(data, path):
    """Take the driver away, and what else there is of animation if there is nothing else."""
    if _driver(data, path) is None:
        return
    animation = data.animation_data
    animation.drivers.remove(_driver(data, path))
    if animation.action is None and not animation.drivers and not animation.nla_tracks:
        data.animation_data_clear()


def _driver(data, path):
    return data.animation_data.drivers.find(path) if data.animation_data else None
