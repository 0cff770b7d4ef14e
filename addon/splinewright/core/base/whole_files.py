"""Files that are never half written."""


def write(path, content, encoding='utf-8'):
    """Write a file of a text, or of bytes. One that is there stays whole until the new one is. Raises OSError."""
    partial = path.with_name(f"{path.name}.part")
    try:
        if isinstance(content, bytes):
            partial.write_bytes(content)
        else:
            partial.write_text(content, encoding=encoding)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)
