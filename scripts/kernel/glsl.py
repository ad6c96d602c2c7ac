"""The kernels as GLSL for Vulkan: structs, references to them, constants, and functions, whose pointers to what is an
item's own are values or `inout`."""
from pycparser import c_ast

from . import tree as T
from .glsl_statements import Statements
from .glsl_words import is_own, member_of


class Writer(Statements):
	def __init__(self, tree, guarded=False):
		super().__init__(tree, guarded)
		self.lengths = Lengths(tree).found

	def function(self, function):
		self.path, self.line, self.returns, self.aliases = function.path, function.line, function.type.of, {}
		self.documented(function.node.decl)
		for lengths in self.lengths.get(function.name, [{}]):
			named = zip(parameters(function), function.type.with_)
			texts = [self.parameter(each, kind, lengths.get(each.name)) for each, kind in named]
			self.put(f"{self.type(function.type.of)} {function.name}({', '.join(texts)})")
			self.noted = {function.line}
			self.statement(function.node.body)
			self.put("")

	def parameter(self, node, kind, length):
		if not is_own(kind):
			return self.declared(kind, node.name)
		how = "" if kind.of.const else "inout "
		of = kind.of if length is None else T.Type("array", "array", kind.of, length=length)
		return how + self.declared(of, node.name)

	def is_padded(self, kind):
		members = self.tree.structs[kind.name].values()
		return any(member.kind == "pointer" for member in members) and self.layout.is_padded(kind)

	def struct(self, node):
		self.documented(node)
		kind = T.Type("struct", node.name)
		self.put(f"struct {node.name} {{")
		self.depth += 1
		for member in node.type.type.decls:
			self.documented(member) if member.coord.line != node.coord.line else None
			self.put(self.declared(self.tree.structs[node.name][member.name], member_of(member.name)) + ";")
			self.comment_behind(member)
		if self.is_padded(kind):
			self.put("uint padding;")
		self.depth -= 1
		self.put("};")

	def refer(self, kind):
		"""A type of references."""
		how = f"buffer_reference, scalar, buffer_reference_align = {self.layout.align(kind)}"
		self.put(f"layout({how}) buffer {self.reference(kind)} {{ {self.type(kind)} v; }};")

	def enumeration(self, node):
		for each in node.values.enumerators:
			self.put(f"const int {each.name} = {self.tree.enumerators[each.name]};")

	def constant(self, node):
		self.documented(node)
		self.put(f"const {self.declaration(node)};")


def parameters(function):
	listed = function.node.decl.type.args
	return [each for each in (listed.params if listed else []) if each.name is not None]


class Lengths(c_ast.NodeVisitor):
	"""Pointers to an item's own that are arrays: the lengths that callers give, by function, as lists of {parameter:
	length}."""

	def __init__(self, tree):
		self.tree, self.found = tree, {}
		for function in tree.functions.values():
			self.function = function
			self.visit(function.node.body)

	def visit_FuncCall(self, node):
		self.generic_visit(node)
		function = self.tree.functions.get(node.name.name)
		if function is None or not node.args:
			return
		lengths = {}
		for parameter, kind, argument in zip(parameters(function), function.type.with_, node.args.exprs):
			of = self.tree.type_of(argument)
			if is_own(kind) and of.kind == "array":
				lengths[parameter.name] = of.length
			elif is_own(kind) and isinstance(argument, c_ast.ID) and argument.name in self.own_arrays():
				lengths[parameter.name] = self.own_arrays()[argument.name]
		if lengths and lengths not in self.found.setdefault(function.name, []):
			self.found[function.name].append(lengths)

	def own_arrays(self):
		"""The caller's parameters that are declared as arrays."""
		return {p.name: self.tree.value(p.type.dim) for p in parameters(self.function)
		        if isinstance(p.type, c_ast.ArrayDecl) and p.type.dim is not None}
