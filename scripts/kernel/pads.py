"""Pads of stored records: a function that sets every other member sets them too,
so that equal records have equal bytes."""
from pycparser import c_ast

from . import tree as T


class Members(c_ast.NodeVisitor):
	"""set: by struct, the members of stored ones that a function assigns or hands out to be changed."""

	def __init__(self, tree, function):
		self.tree, self.set = tree, {}
		self.visit(function.node.body)

	def take(self, node):
		while isinstance(node, c_ast.ArrayRef):
			node = node.name
		if isinstance(node, c_ast.StructRef):
			of = self.tree.type_of(node.name)
			of = of.of if node.type == "->" else of
			if of.shared:
				self.set.setdefault(of.name, set()).add(node.field.name)

	def visit_Assignment(self, node):
		self.take(node.lvalue)
		self.generic_visit(node)

	def visit_FuncCall(self, node):
		for to, argument in zip(self.tree.names[0][node.name.name].with_, node.args.exprs if node.args else []):
			if to.kind == "pointer" and not to.of.const:
				self.take(argument)
		self.generic_visit(node)


def faults(tree):
	found = []
	for function in tree.functions.values():
		for name, given in Members(tree, function).set.items():
			left = set(tree.structs[name]) - given
			if left and all(member.startswith("pad") for member in left):
				found.append((T.place(function.path), function.line, f"{min(left)} of {name} is not set: 0 is right"))
	return found
