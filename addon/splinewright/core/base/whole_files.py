"""Files that are never half written."""


def write(path, text, encoding='utf-8'):
    """Write a text file. One that is there stays whole until the new one is. Raises OSError."""
    partial = path.with_name(f"{path.name}.part")
    try:
        partial.write_text(text, encoding=encoding)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)
