"""Reading traces and writing candidates: TRACES.md, sections 2, 3 and 6."""
import json
import pathlib

import numpy as np


class Trace(dict):
	"""The buffers of a trace by name, each loaded when first asked for."""

	def __init__(self, folder):
		super().__init__()
		self.folder = pathlib.Path(folder)
		about = json.loads((self.folder / 'trace.json').read_text())
		self.effect, self.pipeline, self.params = about['effect'], about['pipeline'], about['params']
		self.files = {buffer['name']: buffer['file'] for buffer in about['buffers']}

	def __missing__(self, name):
		if not self.files.get(name):
			raise SystemExit(f'{self.folder}: no {name}')
		self[name] = np.load(self.folder / self.files[name])
		return self[name]


def write_candidate(folder, reference, order, buffers):
	"""Of the same run as the reference."""
	folder = pathlib.Path(folder)
	folder.mkdir(parents=True, exist_ok=True)
	for name, array in buffers.items():
		np.save(folder / f'{name}.npy', np.ascontiguousarray(array))
	about = {
		'format': 'touchstone-trace', 'version': 1, 'contract': 1, 'order': order, 'effect': reference.effect,
		'pipeline': reference.pipeline, 'producer': {'name': 'numpy port', 'version': '1'}, 'params': reference.params,
		'buffers': [{'name': name, 'file': f'{name}.npy'} for name in buffers],
	}
	(folder / 'trace.json').write_text(json.dumps(about, indent=1) + '\n')
