#!/usr/bin/python3
"""The primitives of CONTRACT.md that this port has, on the inputs of `touchstone vectors`: PORTING.md, section 1.

vectors.py VECTORS OUT [fused|divided]
"""
import pathlib
import sys

import numpy as np

import contract


def footprint(width, d, n, divided=False):
	"""Rule 32: by the product of two lengths; divided: by one after the other."""
	lengths = contract.length(d) * contract.length(n)
	with np.errstate(divide='ignore', invalid='ignore'):
		along = np.abs(contract.dot(d, n))
		cosine = along / contract.length(d) / contract.length(n) if divided else along / lengths
	cosine = np.where(lengths > 0, cosine, np.float32(1))
	return contract.flush(width / np.sqrt(np.maximum(cosine, np.float32(1 / 64))))


PRIMITIVES = {
	'add': np.add, 'mul': np.multiply, 'div': np.divide, 'sqrt': np.sqrt,
	'muladd': lambda a, b, c: a * b + c, 'mulsub': lambda a, b, c: c - a * b,
	'put': contract.put, 'fix': contract.fix, 'floor_i32': contract.floor_i32,
	'dot': contract.dot, 'cross': contract.cross, 'length': contract.length, 'key': contract.key,
	'footprint': footprint,
}


def main(vectors, out, variant=''):
	out = pathlib.Path(out)
	out.mkdir(parents=True, exist_ok=True)
	faults = {'fused': {'muladd': contract.fused},
	          'divided': {'footprint': lambda *given: footprint(*given, divided=True)}}
	primitives = PRIMITIVES | faults.get(variant, {})
	for name, primitive in primitives.items():
		given = np.load(pathlib.Path(vectors, f'{name}.in.npy'))
		np.save(out / f'{name}.out.npy', primitive(*(given[field] for field in given.dtype.names)))


if __name__ == '__main__':
	main(*sys.argv[1:])
