"""Addresses on the web, here and nowhere else. Empty until there is a site: nothing that needs one is shown before."""

#: Where Splinewright is presented.
WEBSITE = ""
#: Where what goes wrong is reported.
ISSUES = ""


def known():
    """[(text of a button, address)] of those that are there."""
    return [(text, address) for text, address in (("Website", WEBSITE), ("Report a Problem", ISSUES)) if address]
