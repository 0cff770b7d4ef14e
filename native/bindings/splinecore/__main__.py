"""`python -m splinecore`: what files hold, conversion, meshes, comparison."""

import sys

from .command import main

sys.exit(main())
