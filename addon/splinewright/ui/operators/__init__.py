"""Operators: each gathers its settings, calls a function of core or bridge, and reports."""
