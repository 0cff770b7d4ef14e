"""Runs pytest inside Blender: blender --background ... --python run.py -- PYTEST_ARGUMENTS"""

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "sharing")]
sys.dont_write_bytecode = True
arguments = sys.argv[sys.argv.index('--') + 1:]
code = pytest.main(['-q', '-p', 'no:cacheprovider', '-p', 'sharing', '--rootdir', str(HERE), *(arguments or [str(HERE)])])
sys.stdout.flush()
sys.exit(int(code))
