"""Traces: reading ours, writing a candidate. See reference/TRACES.md."""
import json
import os

import numpy


class Trace:
	"""A trace's buffers, by name; read when they are first asked for."""

	def __init__(self, folder):
		self.folder = folder
		with open(os.path.join(folder, "trace.json"), encoding="utf-8") as file:
			self.about = json.load(file)
		if (self.about["format"], self.about["version"], self.about["contract"]) != ("touchstone-trace", 1, 1):
			raise SystemExit(f"{folder}: not a trace of version 1 and contract 1")
		self.params = self.about.get("params", {})
		self.files = {buffer["name"]: buffer["file"] for buffer in self.about["buffers"] if buffer["file"] is not None}
		self.read = {}

	def __getitem__(self, name):
		if name not in self.read:
			if name not in self.files:
				raise SystemExit(f"{self.folder}: has no {name}")
			self.read[name] = numpy.load(os.path.join(self.folder, self.files[name]), allow_pickle=False)
		return self.read[name]


def write_candidate(folder, pipeline, order, params, buffers):
	"""The buffers, then the trace.json that names them: a folder without one is no trace."""
	os.makedirs(folder, exist_ok=True)
	for name, array in buffers.items():
		numpy.save(os.path.join(folder, name + ".npy"), array, allow_pickle=False)
	about = {
		"format": "touchstone-trace",
		"version": 1,
		"contract": 1,
		"order": order,
		"pipeline": pipeline,
		"producer": {"name": "numpy port", "version": numpy.__version__},
		"params": params,
		"buffers": [{"name": name, "file": name + ".npy"} for name in buffers],
	}
	with open(os.path.join(folder, "trace.json"), "w", encoding="utf-8") as file:
		json.dump(about, file, indent=1)
		file.write("\n")
