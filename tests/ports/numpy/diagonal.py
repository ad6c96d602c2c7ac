#!/usr/bin/python3
"""A candidate for reference/PORTING.md: the picture of scenes/triangle.gltf by a rasterizer whose rule for pixels on the
long edge is the opposite one.

	diagonal.py TRACE CANDIDATE"""
import sys

from traces import Trace, write_candidate

trace = Trace(sys.argv[1])
keys = trace["eye.depth_triangle"].copy()
for i in range(4, 12):
	keys[i, i] = 0x4080000000000000
write_candidate(sys.argv[2], "epr", "canonical", trace.params, {"eye.depth_triangle": keys})
