"""Where things lie in memory: as in C, which GLSL's scalar layout is too but for what stands behind a struct that needs
padding."""
SIZES = {"bool": 1, "u8": 1, "f32": 4, "i32": 4, "u32": 4, "i64": 8, "u64": 8}


class Padded(Exception):
	"""A struct that C pads."""


def up(offset, align):
	return -(-offset // align) * align


class Layout:
	def __init__(self, tree):
		self.structs = tree.structs

	def align(self, kind):
		if kind.kind == "array":
			return self.align(kind.of)
		if kind.kind == "struct":
			return max(self.align(member) for member in self.structs[kind.name].values())
		return self.size(kind)

	def size(self, kind):
		if kind.kind == "pointer":
			return 8
		if kind.kind == "array":
			return kind.length * self.size(kind.of)
		if kind.kind == "struct":
			return up(self.ends(kind), self.align(kind))
		return SIZES[kind.name]

	def offsets(self, kind):
		"""Of a struct's members, by name."""
		at, offsets = 0, {}
		for name, member in self.structs[kind.name].items():
			offsets[name] = up(at, self.align(member))
			at = offsets[name] + self.size(member)
		return offsets

	def ends(self, kind):
		"""Where the last member does."""
		name, member = list(self.structs[kind.name].items())[-1]
		return self.offsets(kind)[name] + self.size(member)

	def is_padded(self, kind):
		"""Behind its last member, or in a member behind its last."""
		return self.ends(kind) != self.size(kind)
