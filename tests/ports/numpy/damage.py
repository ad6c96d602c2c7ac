#!/usr/bin/python3
"""Candidates with the faults of ports, by hand: damage.py WHAT TRACE CANDIDATE. fields: positions and normals of some
pixels in the mirrors. count: a point less of one piece, which moves all sums behind it, and a bit of the picture."""
import glob
import shutil
import sys
import numpy


def open_buffer(folder, name):
	path, = glob.glob(f"{folder}/*-{name}.npy")
	return path, numpy.load(path)


def fields(folder):
	path, pixels = open_buffer(folder, "mirror_pixel.record")
	pixels["position"][100:112, 0] += numpy.float32(0.25)
	pixels["normal"][110:113, 1] *= numpy.float32(-1)
	numpy.save(path, pixels)


def count(folder):
	path, sums = open_buffer(folder, "points.offset")
	piece = numpy.flatnonzero(numpy.diff(sums))[17]
	sums[piece + 1:] -= 1
	numpy.save(path, sums)
	path, picture = open_buffer(folder, "image.srgb")
	picture[20, 30, 1] ^= 1
	numpy.save(path, picture)


what, trace, candidate = sys.argv[1:]
shutil.copytree(trace, candidate, dirs_exist_ok=True)
{"fields": fields, "count": count}[what](candidate)
