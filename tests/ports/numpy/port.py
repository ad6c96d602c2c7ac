#!/usr/bin/python3
"""Two stages of EPR, visibility and splat, and one of iVIR, scatter, in numpy, from a trace to a candidate: PORTING.md,
sections 4 and 8.

port.py TRACE CANDIDATE [--stages visibility,splat] [--arrival] [--break N]

--arrival lets the points stand in the reverse order, as if threads had appended them so, and numbers them by it.

--break N damages one line, for tests of the comparison:
	1 a plane of the frustum belongs to the outside     2 back faces are seen
	3 all half a texel to the right and down            4 splat.clip=off: the whole box of a splat, not only the piece's
	texels 5 axial depth instead of distance                   10 contracted: the distance's sum is fused
	11 the last writer wins, not the least key          12 boxes shifted as unsigned numbers
	13 squares of half size 128, not 129
and these take what the documents say otherwise, where few scenes tell:
	6 rule 19: a polygon without area keeps its box     7 rule 16: sides through the axis, 1 for f
	8 visibility: the sides in texels, f X > f z        9 splat: a piece that is clipped away has points all the same
"""
import argparse

import scatter
import splat
import visibility
from traces import Trace, write_candidate

STAGES = {'visibility': visibility, 'splat': splat, 'scatter': scatter}
METHODS = {'reflections': {'epr': ('visibility', 'splat')}, 'soft-shadows': {'ivir': ('scatter',), 'vir': ('scatter',)},
           'omni-shadows': {'ivir': ('scatter',), 'vir': ('scatter',)}}
SUPPORTED = {'visibility.test': ('plane', 'vertex'), 'splat.clip': ('on', 'off'),
             'splat.box': ('centre', 'touched'), 'splat.plane_depth': ('off',)}


def arguments():
	parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
	parser.add_argument('trace')
	parser.add_argument('candidate')
	parser.add_argument('--stages', default='visibility,splat', type=lambda names: names.split(','))
	parser.add_argument('--arrival', action='store_true', help='points in the reverse order')
	parser.add_argument('--break', dest='broken', type=int, default=0, choices=range(14), help='damage a line')
	return parser.parse_args()


def refuse(trace, stages):
	for name in stages:
		if name not in METHODS[trace.effect].get(trace.pipeline, ()):
			raise SystemExit(f'stage {name} of {trace.effect} by {trace.pipeline} is not supported')
	for name, values in SUPPORTED.items():
		if trace.params[name] not in values:
			raise SystemExit(f'{name}={trace.params[name]} is not supported')


def main():
	given = arguments()
	trace = Trace(given.trace)
	refuse(trace, given.stages)
	buffers = {}
	if given.arrival:
		for name in ('points.key', 'points.record'):
			buffers[name] = trace[name] = trace[name][::-1]
	for name in given.stages:
		buffers.update(STAGES[name].run(trace, given.broken))
	write_candidate(given.candidate, trace, 'arrival' if given.arrival else 'canonical', buffers)


if __name__ == '__main__':
	main()
