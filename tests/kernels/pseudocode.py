#!/usr/bin/python3
"""Runs the printed pseudo-code of the kernels on what `touchstone explain --json` says that items were given, and
compares every function's result and every store.

pseudocode.py FOLDER PAIRS     FOLDER: what scripts/pseudocode wrote; PAIRS: lines of a trace and an explanation of it

Numbers are NumPy's float32 and integers that wrap; operands of two types are an error, for the text converts them."""
import ast
import glob
import json
import sys

import numpy as np

np.seterr(all="ignore")
BITS = {"i32": (32, True), "u32": (32, False), "i64": (64, True), "u64": (64, False), "u8": (8, False)}
SIZES = {"f32": 4, "i32": 4, "u32": 4, "i64": 8, "u64": 8, "u8": 1, "bool": 1}


class Wrong(Exception):
	pass


class Unknown(Exception):
	"""What an explanation does not hold: memory of the stage."""


class F32:
	def __init__(self, v):
		if isinstance(v, Int):
			v = v.v
		self.v = v.v if isinstance(v, F32) else np.float32(v)

	@staticmethod
	def of(x):
		if isinstance(x, F32):
			return x.v
		if isinstance(x, float):
			return np.float32(x)
		raise Wrong(f"f32 with {type(x).__name__}")

	def __add__(self, o): return F32(self.v + F32.of(o))
	def __sub__(self, o): return F32(self.v - F32.of(o))
	def __mul__(self, o): return F32(self.v * F32.of(o))
	def __truediv__(self, o): return F32(self.v / F32.of(o))
	def __radd__(self, o): return F32(F32.of(o) + self.v)
	def __rsub__(self, o): return F32(F32.of(o) - self.v)
	def __rmul__(self, o): return F32(F32.of(o) * self.v)
	def __rtruediv__(self, o): return F32(F32.of(o) / self.v)
	def __neg__(self): return F32(-self.v)
	def __lt__(self, o): return bool(self.v < F32.of(o))
	def __le__(self, o): return bool(self.v <= F32.of(o))
	def __gt__(self, o): return bool(self.v > F32.of(o))
	def __ge__(self, o): return bool(self.v >= F32.of(o))
	def __eq__(self, o): return bool(self.v == F32.of(o))
	def __ne__(self, o): return bool(self.v != F32.of(o))

	def bits(self):
		return int(self.v.view(np.uint32))


class Int:
	__slots__ = ("v", "t")

	def __init__(self, v, t):
		bits, signed = BITS[t]
		if isinstance(v, F32):
			v = int(v.v)
		v = int(v) & ((1 << bits) - 1)
		self.v, self.t = v - (1 << bits) if signed and v >> (bits - 1) else v, t

	def other(self, o):
		if isinstance(o, Int) and o.t == self.t:
			return o.v
		if type(o) is int:
			return o
		raise Wrong(f"{self.t} with {getattr(o, 't', type(o).__name__)}")

	def made(self, v): return Int(v, self.t)
	def __int__(self): return self.v
	def __index__(self): return self.v
	def __add__(self, o): return self.made(self.v + self.other(o))
	def __sub__(self, o): return self.made(self.v - self.other(o))
	def __mul__(self, o): return self.made(self.v * self.other(o))
	def __and__(self, o): return self.made(self.v & self.other(o))
	def __or__(self, o): return self.made(self.v | self.other(o))
	def __xor__(self, o): return self.made(self.v ^ self.other(o))
	def __mod__(self, o): return self.made(self.v % self.other(o))

	def __floordiv__(self, o):
		a, b = self.v, self.other(o)
		return self.made(abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1))

	def __radd__(self, o): return self.made(self.other(o) + self.v)
	def __rsub__(self, o): return self.made(self.other(o) - self.v)
	def __rmul__(self, o): return self.made(self.other(o) * self.v)
	def __rand__(self, o): return self.made(self.other(o) & self.v)
	def __ror__(self, o): return self.made(self.other(o) | self.v)
	def __rxor__(self, o): return self.made(self.other(o) ^ self.v)
	def __rfloordiv__(self, o): return self.made(self.other(o)) // self
	def __lshift__(self, o): return self.made(self.v << int(o))
	def __rshift__(self, o): return self.made(self.v >> int(o))
	def __neg__(self): return self.made(-self.v)
	def __invert__(self): return self.made(~self.v)
	def __lt__(self, o): return self.v < self.other(o)
	def __le__(self, o): return self.v <= self.other(o)
	def __gt__(self, o): return self.v > self.other(o)
	def __ge__(self, o): return self.v >= self.other(o)
	def __eq__(self, o): return self.v == self.other(o)
	def __ne__(self, o): return self.v != self.other(o)
	__hash__ = None


class Scalar:
	"""A type, which also converts."""

	def __init__(self, name):
		self.name = name

	def __call__(self, x):
		if self.name == "f32":
			return F32(x)
		return bool(x.v if isinstance(x, Int) else x) if self.name == "bool" else Int(x, self.name)

	def given(self, x):
		"""Without a conversion but of literals."""
		if self.name == "f32" and isinstance(x, (F32, float)):
			return F32(x)
		if self.name == "bool" and isinstance(x, bool):
			return x
		if isinstance(x, Int) and x.t == self.name or (type(x) is int and self.name in BITS):
			return Int(x, self.name)
		raise Wrong(f"{self.name} is given {getattr(x, 't', type(x).__name__)}")

	def new(self): return self(0)
	def size(self): return SIZES[self.name]
	align = size

	def read(self, memory, at):
		raw = bytes(memory[at : at + self.size()])
		if self.name == "f32":
			return F32(np.frombuffer(raw, "<f4")[0])
		number = int.from_bytes(raw, "little")
		return bool(number) if self.name == "bool" else Int(number, self.name)

	def write(self, memory, at, x):
		number = x.bits() if isinstance(x, F32) else int(x)
		memory[at : at + self.size()] = (number & ((1 << (8 * self.size())) - 1)).to_bytes(self.size(), "little")


class ArrayType:
	def __init__(self, of, n=None):
		self.of, self.n = of, n

	def new(self): return Array([self.of.new() for _ in range(self.n)], self.of)
	def size(self): return self.n * self.of.size()
	def align(self): return self.of.align()
	def read(self, memory, at): return Buffer(memory, at, self.of, None)

	def given(self, x):
		if self.n is None:
			return x
		items = x if isinstance(x, list) else [x[i] for i in range(self.n)]
		return Array([self.of.given(each) for each in items] + [self.of.new() for _ in range(self.n - len(items))],
		             self.of)


class BufferType:
	def __init__(self, of): self.of = of
	def new(self): return None
	def given(self, x): return x
	def size(self): return 8
	align = size


class RefType(BufferType):
	def new(self): return Ref(self.of, self.of.new()) if isinstance(self.of, Scalar) else self.of.new()

	def given(self, x):
		if isinstance(x, (Ref, Struct, Array, Buffer, View)):
			return x
		return Ref(self.of, x)


class StructType:
	def __init__(self, name, members):
		self.name, self.members, at, self.offsets = name, members, 0, {}
		for member, of in members.items():
			at = -(-at // of.align()) * of.align()
			self.offsets[member], at = at, at + of.size()
		self.end = at

	def align(self): return max(of.align() for of in self.members.values())
	def size(self): return -(-self.end // self.align()) * self.align()
	def new(self): return Struct(self, {member: of.new() for member, of in self.members.items()})
	def read(self, memory, at): return View(self, memory, at)
	def __call__(self, *values):
		given = [of.given(v) for of, v in zip(self.members.values(), values)]
		return Struct(self, dict(zip(self.members, given)))
	def given(self, x): return x


class Struct:
	def __init__(self, of, values): self.__dict__.update(values, _of=of)
	def __setattr__(self, name, x): self.__dict__[name] = self._of.members[name].given(x)


class View:
	"""A struct in a buffer."""

	def __init__(self, of, memory, at): self.__dict__.update(_of=of, _memory=memory, _at=at)
	def __getattr__(self, name): return self._of.members[name].read(self._memory, self._at + self._of.offsets[name])

	def __setattr__(self, name, x):
		put(self._memory, self._at + self._of.offsets[name], self._of.members[name], x)


class Array:
	def __init__(self, items, of, first=0): self.items, self.of, self.first = items, of, first

	def __getitem__(self, i):
		if isinstance(i, slice):
			return Array(self.items, self.of, self.first + int(i.start))
		return self.items[self.first + int(i)]

	def __setitem__(self, i, x): self.items[self.first + int(i)] = self.of.given(x)


class Memory:
	"""Bytes of a buffer, and what was stored there: (buffer, element)."""

	def __init__(self, name, data, size): self.name, self.data, self.size, self.stores = name, bytearray(data), size, []

	def __getitem__(self, i):
		if self.data is None:
			raise Unknown(self.name)
		if i.stop > len(self.data):
			raise Wrong(f"{self.name} is read behind its end")
		return self.data[i]

	def __setitem__(self, i, x):
		self.data[i] = x


class Buffer:
	def __init__(self, memory, at, of, _): self.memory, self.at, self.of = memory, at, of

	def __getitem__(self, i):
		if isinstance(i, slice):
			return Buffer(self.memory, self.at + int(i.start) * self.of.size(), self.of, None)
		return self.of.read(self.memory, self.at + int(i) * self.of.size())

	def __setitem__(self, i, x): put(self.memory, self.at + int(i) * self.of.size(), self.of, x)


class Ref:
	"""A number that a pointer is to."""

	def __init__(self, of, x): self.__dict__.update(of=of, value=of.given(x))
	def __setattr__(self, name, x): self.__dict__["value"] = self.of.given(x)


class Member(Ref):
	def __init__(self, holder, name): self.__dict__.update(holder=holder, name=name)
	def __getattr__(self, _): return getattr(self.holder, self.name)
	def __setattr__(self, _, x): setattr(self.holder, self.name, x)


class Element(Ref):
	def __init__(self, holder, i): self.__dict__.update(holder=holder, i=i)
	def __getattr__(self, _): return self.holder[self.i]
	def __setattr__(self, _, x): self.holder[self.i] = x


LOG = []


def put(memory, at, of, x):
	if isinstance(of, StructType):
		for name, member in of.members.items():
			quiet(memory, at + of.offsets[name], member, getattr(x, name))
	else:
		quiet(memory, at, of, of.given(x))
	if memory.name is not None:
		LOG.append((f"{memory.name}:{at // memory.size}", bytes(memory[at : at + of.size()])))


def quiet(memory, at, of, x):
	if isinstance(of, StructType):
		for name, member in of.members.items():
			quiet(memory, at + of.offsets[name], member, getattr(x, name))
	elif isinstance(of, ArrayType):
		for i in range(of.n):
			quiet(memory, at + i * of.of.size(), of.of, x[i])
	else:
		of.write(memory, at, of.given(x))


def copy(x):
	if isinstance(x, (Struct, View)):
		return Struct(x._of, {name: copy(getattr(x, name)) for name in x._of.members})
	if isinstance(x, Array):
		return Array([copy(each) for each in x.items[x.first :]], x.of)
	return x


def assign(to, x):
	x = copy(x)
	for name in x._of.members:
		setattr(to, name, getattr(x, name))


def member(holder, name):
	of = holder._of.members[name]
	if isinstance(holder, View):
		return Buffer(holder._memory, holder._at + holder._of.offsets[name], of.of if isinstance(of, ArrayType) else of,
		              None)
	return Member(holder, name)


def offered(change):
	"""An atomic function: what is offered is logged, for what stands there depends on others."""
	def function(p, x):
		if p.memory.name is not None:
			quiet(p.memory, p.at, p.of, change(p[0], x))
			LOG.append((f"{p.memory.name}:{p.at // p.memory.size}", raw(p.of, x)))
	return function


def following(p):
	old = p[0]
	quiet(p.memory, p.at, p.of, old + 1)
	return old


def mark(p):
	quiet(p.memory, p.at, p.of, 1)
	LOG.append((f"{p.memory.name}:{p.at // p.memory.size}", b"\1"))


def raw(of, x):
	data = bytearray(of.size())
	quiet(data, 0, of, x)
	return bytes(data)


def least(old, x): return x if x < old else old


def primitives():
	return {
		"f32": Scalar("f32"), "bool": Scalar("bool"), **{name: Scalar(name) for name in BITS}, "array": ArrayType,
		"buffer": BufferType, "ref": RefType, "copy": copy, "assign": assign, "member": member, "element": Element,
		"ts_f2u": lambda x: Int(x.bits(), "u32"),
		"ts_u2f": lambda x: F32(np.uint32(int(x)).view(np.float32)),
		"ts_sqrt": lambda x: F32(np.sqrt(F32(x).v)), "ts_floor": lambda x: F32(np.floor(F32(x).v)),
		"ts_min_u64": offered(least), "ts_min_u32": offered(least), "ts_peek_u32": lambda p: p[0],
		"ts_or_u64": offered(lambda old, x: old | x), "ts_add_i64": offered(lambda old, x: old + x),
		"ts_next_i64": following, "ts_next_u32": following, "ts_mark_u8": mark,
	}


class Typed(ast.NodeTransformer):
	"""What the text says of types, done: variables, parameters and results are given values of theirs."""

	def visit_FunctionDef(self, node):
		self.types = {each.target.id: each.annotation for each in ast.walk(node) if isinstance(each, ast.AnnAssign)}
		self.types.update({each.arg: each.annotation for each in node.args.args})
		self.result = node.returns
		self.generic_visit(node)
		given = [ast.Assign([ast.Name(a.arg, ast.Store())], self.given(a.annotation, ast.Name(a.arg, ast.Load())))
		         for a in node.args.args]
		node.body = given + node.body
		for each in node.args.args:
			each.annotation = None
		node.returns = None
		return node

	def given(self, of, value):
		return ast.Call(ast.Attribute(of, "given", ast.Load()), [value], [])

	def visit_AnnAssign(self, node):
		self.generic_visit(node)
		new = ast.Call(ast.Attribute(node.annotation, "new", ast.Load()), [], [])
		return ast.Assign([node.target], self.given(node.annotation, node.value) if node.value else new)

	def visit_Assign(self, node):
		self.generic_visit(node)
		if isinstance(node.targets[0], ast.Name) and node.targets[0].id in self.types:
			node.value = self.given(self.types[node.targets[0].id], node.value)
		return node

	def visit_Return(self, node):
		self.generic_visit(node)
		if node.value is not None:
			node.value = self.given(self.result, node.value)
		return node


def world_of(folder):
	"""Types, constants and functions of all files, and functions' parameters as types."""
	world, functions = primitives(), []
	trees = [ast.parse(open(path, encoding="utf-8").read(), path)
	         for path in glob.glob(f"{folder}/**/*.py", recursive=True)]
	nodes = [node for tree in trees for node in tree.body]
	for node in nodes:
		if isinstance(node, ast.Assign):
			world[node.targets[0].id] = ast.literal_eval(node.value)
	left = [node for node in nodes if isinstance(node, ast.ClassDef)]
	while left:
		node = left.pop(0)
		try:
			members = {each.target.id: evaluated(each.annotation, world) for each in node.body}
			world[node.name] = StructType(node.name, members)
		except NameError:
			left.append(node)
	for node in nodes:
		if isinstance(node, ast.AnnAssign):
			world[node.target.id] = evaluated(node.annotation, world).given(evaluated(node.value, world))
	signatures = {}
	for node in nodes:
		if isinstance(node, ast.FunctionDef):
			signatures[node.name] = ({each.arg: evaluated(each.annotation, world) for each in node.args.args},
			                         evaluated(node.returns, world)
			                         if not isinstance(node.returns, ast.Constant) else None)
			functions.append(Typed().visit(node))
	exec(compile(ast.fix_missing_locations(ast.Module(functions, [])), folder, "exec"), world)
	return world, signatures


def evaluated(node, world):
	return eval(compile(ast.Expression(node), "text", "eval"), world)


def scalar_of(of, told):
	"""From the number of an explanation."""
	if of.name == "f32":
		return of.read(int(told["bits"], 16).to_bytes(4, "little"), 0)
	if of.name == "u64":
		return Int(int(told, 16), "u64")
	return bool(told) if of.name == "bool" else Int(told, of.name)


def value_of(of, told, path="", buffers=None):
	if isinstance(of, StructType):
		return Struct(of, {name: value_of(each, told, f"{path}.{name.rstrip('_') if name.endswith('_') else name}",
		                                  buffers)
		                   for name, each in of.members.items()})
	if isinstance(of, ArrayType):
		return Array([value_of(of.of, told, f"{path}[{i}]", buffers) for i in range(of.n)], of.of)
	if isinstance(of, BufferType):
		return buffers(of.of, told[path])
	return scalar_of(of, told[path])


def same(of, x, told, path=""):
	if isinstance(of, StructType):
		return all(same(each, getattr(x, name), told, f"{path}.{name.rstrip('_')}")
		           for name, each in of.members.items())
	if isinstance(of, ArrayType):
		return all(same(of.of, x[i], told, f"{path}[{i}]") for i in range(of.n))
	y = scalar_of(of, told[path])
	return x.bits() == y.bits() if isinstance(x, F32) else bool(x == y)


def is_pure(of):
	if isinstance(of, StructType):
		return all(map(is_pure, of.members.values()))
	return of.n is not None and is_pure(of.of) if isinstance(of, ArrayType) else isinstance(of, Scalar)


def calls_of(lines):
	"""(function, lines of its parameters, line of its result or None) of each call."""
	open_calls = []
	for line in lines:
		while open_calls and open_calls[-1][3] >= line["depth"] and line["how"] != "result":
			yield open_calls.pop()[:3]
		if line["how"] == "call":
			open_calls.append([line["text"], {}, None, line["depth"]])
		elif open_calls and line["depth"] == open_calls[-1][3] + 1 and line["how"] == "value":
			open_calls[-1][1].setdefault(line["text"], line)
		elif line["how"] == "result":
			while open_calls[-1][3] + 1 > line["depth"]:
				yield open_calls.pop()[:3]
			open_calls[-1][2] = line
			yield open_calls.pop()[:3]
	for call in reversed(open_calls):
		yield call[:3]


def check_calls(world, signatures, lines, seen):
	"""Functions of numbers alone."""
	for name, told, result in calls_of(lines):
		parameters, returns = signatures[name]
		if result is None or not parameters or not all(map(is_pure, [*parameters.values(), returns])):
			continue
		if not all(each.rstrip("_") in told for each in parameters):
			continue
		given = [value_of(of, told[each.rstrip("_")]["value"]) for each, of in parameters.items()]
		found = world[name](*given)
		seen[name] = seen.get(name, 0) + 1
		if not same(returns, found, result["value"]):
			found = vars(found) if isinstance(found, (Struct, F32)) else found
			raise Wrong(f"{name}: {[told[each]['value'] for each in told]} gives {result['value']}, not {found}")


class Buffers:
	"""Those of a trace, by the names that explanations give to what pointers are to."""

	def __init__(self, trace):
		self.files = {path.split("/")[-1].split("-", 1)[1][: -len(".npy")]: path
		              for path in glob.glob(f"{trace}/*.npy")}
		self.memory = {}

	def __call__(self, of, text):
		if text == "NULL":
			return None
		name, _, element = text.partition(":")
		if name not in self.memory:
			self.memory[name] = self.load(name)
		return Buffer(self.memory[name], int(element or 0) * self.memory[name].size, of, None)

	def clear(self, stores):
		"""What the item stores to may hold what others made of it later: what adds begins at 0."""
		for to, _ in stores:
			name, element = to.split(":")
			if name in self.memory:
				size = self.memory[name].size
				self.memory[name][int(element) * size : (int(element) + 1) * size] = bytes(size)

	def load(self, name):
		if name == "a counter":
			return Memory(None, bytes(64), 8)
		if name not in self.files:
			raise Unknown(name)
		data = np.load(self.files[name])
		return Memory(name, data.tobytes(), data.itemsize)


def stores_of(world, lines):
	"""What an explanation says was stored or offered, as LOG has it."""
	for before, line in zip([None, *lines], lines):
		if line["how"] != "store" or ":" not in line["to"]:
			continue
		is_offer = before["how"] == "value" and before["text"].startswith("ts_") and " of " in before["text"]
		told = before if is_offer else line
		yield line["to"], raw(world[told["type"]], value_of(world[told["type"]], told["value"]))


def looks_at_others(name, functions):
	"""The kernel reads what other items change at the same time."""
	names, left = set(), [name]
	while left:
		at = left.pop()
		if at not in names and at in functions:
			names.add(at)
			left += functions[at]
		if at in ("ts_peek_u32", "ts_next_u32", "ts_next_i64"):
			return True
	return False


def check_item(world, signatures, launch, trace):
	"""A whole item, from the buffers of the trace."""
	lines, name = launch["lines"], f"ts_k_{launch['kernel']}_item"
	args, _ = signatures[name]
	buffers, stores = Buffers(trace), list(stores_of(world, lines))
	try:
		given = [value_of(of, lines[1 + i]["value"], "", buffers) for i, of in enumerate(args.values())]
		buffers.clear(stores)
		LOG.clear()
		world[name](*given)
	except Unknown:
		return False
	if LOG != stores:
		first = next(i for i in range(max(len(LOG), len(stores))) if LOG[i : i + 1] != stores[i : i + 1])
		raise Wrong(f"{name}, item {launch['item']}: store {first}: {LOG[first : first + 1]}, "
		            f"not {stores[first : first + 1]}")
	return True


def callees(folder):
	"""What each function calls."""
	for path in glob.glob(f"{folder}/**/*.py", recursive=True):
		for node in ast.parse(open(path, encoding="utf-8").read()).body:
			if isinstance(node, ast.FunctionDef):
				yield node.name, [n.func.id for n in ast.walk(node)
				                  if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)]


def main(folder, pairs):
	"""pairs: a file whose lines are a trace and an explanation of it."""
	world, signatures = world_of(folder)
	functions, seen, kernels = dict(callees(folder)), {}, set()
	for line in open(pairs, encoding="utf-8"):
		trace, path = line.split()
		told = json.load(open(path, encoding="utf-8"))
		for launch in told["launches"]:
			if launch["item"] is None or told["more_lines"] > 0:
				continue
			check_calls(world, signatures, launch["lines"], seen)
			if looks_at_others(f"ts_k_{launch['kernel']}_item", functions):
				continue
			if check_item(world, signatures, launch, trace):
				kernels.add(launch["kernel"])
	print(len(seen), "functions", sum(seen.values()), "calls", len(kernels), "kernels")


if __name__ == "__main__":
	try:
		main(*sys.argv[1:])
	except Wrong as wrong:
		sys.exit(str(wrong)[:2000])
