from . import BezierPatch, HermitePatch, NurbsPatch, PatchSet

LIMIT: int

def loads(text: str, flip: bool = False) -> PatchSet:
    r"""Read Bezier patches from BPT text.

    Parameters
    ----------
    text : str
        The text.
    flip : bool, default False
        Whether u and v of every patch are exchanged.

    Returns
    -------
    PatchSet
        The patches; equal points become one.

    Raises
    ------
    InvalidShape
        If the text is not BPT or ends early; the message has the line.

    Examples
    --------
    >>> patches = sc.bpt.loads("1\n1 1\n0 0 0  0 1 0  1 0 0  1 1 0")
    >>> len(patches), patches[0].degree
    (1, (1, 1))
    """
def dumps(value: NurbsPatch | BezierPatch | HermitePatch | PatchSet) -> str:
    """Write patches as BPT text.

    Parameters
    ----------
    value : patch or PatchSet
        Patches; those that are not Bezier patches become exact Bezier patches.

    Returns
    -------
    str
        The text.

    Raises
    ------
    InvalidShape
        If a patch is rational, which the format cannot hold.

    Examples
    --------
    >>> plane = sc.build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    >>> sc.bpt.loads(sc.bpt.dumps(plane))[0].degree
    (1, 1)
    """
