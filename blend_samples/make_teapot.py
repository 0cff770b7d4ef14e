"""Newell's teapot: one object of 32 bicubic Bezier patches on 306 shared points."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
stage.add('add_teapot', "Teapot", color='clay', resolution_u=16, resolution_v=16)
stage.ground()
stage.camera((2.4, -4.4, 2.7), (0.1, 0, 0.68), 50)
stage.smooth()
stage.finish("teapot", samples=64)
