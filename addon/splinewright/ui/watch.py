"""Which data-blocks an update of Blender's depsgraph concerns."""


def changed_blocks(updates):
    """The original objects and data-blocks whose geometry or transform changed."""
    return {update.id.original for update in updates
            if update.is_updated_geometry or update.is_updated_transform}
