#!/usr/bin/python3
"""A port of two stages of EPR, visibility and splat, as an example of a candidate: reads what these stages read from a
trace, writes what they write.

	port.py TRACE CANDIDATE [--stages visibility,splat] [--arrival] [--break N]

--arrival lets the points stand in the reverse order, as if threads had appended them so, and numbers them by it.

--break N damages one line, for tests of the comparison:
	1 a plane of the frustum belongs to the outside     2 back faces are seen
	3 splats half a texel to the right and down         4 the whole box of a splat, not only the triangle's texels
	5 axial depth instead of distance"""
import argparse

import splat
import visibility
from traces import Trace, write_candidate

STAGES = {"visibility": visibility, "splat": splat}


def main():
	parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
	parser.add_argument("trace")
	parser.add_argument("candidate")
	parser.add_argument("--stages", default="visibility,splat")
	parser.add_argument("--arrival", action="store_true")
	parser.add_argument("--break", dest="broken", type=int, default=0, choices=range(6))
	options = parser.parse_args()
	trace = Trace(options.trace)
	buffers = {}
	if options.arrival:
		buffers = {name: trace[name][::-1] for name in ("points.key", "points.record")}
		trace.read.update(buffers)
	for stage in options.stages.split(","):
		buffers.update(STAGES[stage].run(trace, options.broken))
	write_candidate(options.candidate, "epr", "arrival" if options.arrival else "canonical", trace.params, buffers)


main()
