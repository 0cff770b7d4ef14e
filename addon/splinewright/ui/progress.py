"""A progress display for work that may take more than a moment."""

from contextlib import contextmanager


@contextmanager
def shown(context, total):
    """Gives a function that is called with how many of `total` steps are done."""
    manager = context.window_manager
    manager.progress_begin(0, total)
    try:
        yield manager.progress_update
    finally:
        manager.progress_end()
