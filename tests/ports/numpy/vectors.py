#!/usr/bin/python3
"""Computes the arithmetic vectors of the primitives that this port has, as a port does it on its device.

	vectors.py VECTORS OUT [fused]     VECTORS: what `touchstone vectors -o VECTORS` wrote

With `fused` a * b + c is rounded once, as a compiler that contracts would do it."""
import os
import sys

import numpy

import contract


def muladd(v):
	if sys.argv[3:] == ["fused"]:
		return (v["a"].astype(numpy.float64) * v["b"] + v["c"]).astype(numpy.float32)
	return v["a"] * v["b"] + v["c"]


PRIMITIVES = {
	"add": lambda v: v["a"] + v["b"],
	"mul": lambda v: v["a"] * v["b"],
	"div": lambda v: v["a"] / v["b"],
	"sqrt": lambda v: numpy.sqrt(v["a"]),
	"muladd": muladd,
	"mulsub": lambda v: v["c"] - v["a"] * v["b"],
	"put": lambda v: contract.flush(v["x"]),
	"dot": lambda v: contract.dot(v["a"], v["b"]),
	"cross": lambda v: contract.cross(v["a"], v["b"]),
	"length": lambda v: contract.length(v["a"]),
	"fix": lambda v: contract.fix(v["x"], v["frac"], v["bits"]).astype(numpy.int32),
	"floor_i32": lambda v: contract.floor(v["x"]).astype(numpy.int32),
	"key": lambda v: contract.key(contract.flush(v["depth"]), v["payload"]),
}

numpy.seterr(all="ignore")
os.makedirs(sys.argv[2], exist_ok=True)
for name, compute in PRIMITIVES.items():
	given = numpy.load(os.path.join(sys.argv[1], name + ".in.npy"))
	numpy.save(os.path.join(sys.argv[2], name + ".out.npy"), compute(given))
