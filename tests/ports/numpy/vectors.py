#!/usr/bin/python3
"""The primitives of CONTRACT.md that this port has, on the inputs of `touchstone vectors`: PORTING.md, section 1.

vectors.py VECTORS OUT [fused]
"""
import pathlib
import sys

import numpy as np

import contract


def fused(a, b, c):
	"""The product is exact in binary64; a sum that binary64 rounds too is rounded twice."""
	return (a.astype(np.float64) * b + c).astype(np.float32)


PRIMITIVES = {
	'add': np.add, 'mul': np.multiply, 'div': np.divide, 'sqrt': np.sqrt,
	'muladd': lambda a, b, c: a * b + c, 'mulsub': lambda a, b, c: c - a * b,
	'put': contract.flush, 'fix': contract.fix, 'floor_i32': contract.floor_i32,
	'dot': contract.dot, 'cross': contract.cross, 'length': contract.length, 'key': contract.key,
}


def main(vectors, out, variant=''):
	out = pathlib.Path(out)
	out.mkdir(parents=True, exist_ok=True)
	primitives = PRIMITIVES | ({'muladd': fused} if variant == 'fused' else {})
	for name, primitive in primitives.items():
		given = np.load(pathlib.Path(vectors, f'{name}.in.npy'))
		np.save(out / f'{name}.out.npy', primitive(*(given[field] for field in given.dtype.names)))


if __name__ == '__main__':
	main(*sys.argv[1:])
