"""Stored floats that are computed from what was stored there: sums across items, whose order no device promises (rule
30). The lesser or greater of what was there and another is the same in each order."""
from pycparser import c_ast

from . import tree as T
from .stores import CHOOSE, PUTS, Values

PYRAMID = "ts_k_mip_item"  # makes a level of an array from the one before


def is_stored_float(kind):
	return kind.kind == "scalar" and kind.name == "f32" and kind.shared


class Sums(c_ast.NodeVisitor):
	"""Of one function."""

	def __init__(self, tree, function):
		self.tree, self.given, self.faults = tree, Values(function).given, []
		self.visit(function.node.body)

	def names(self, node, within=()):
		"""Of the arrays that a pointer or an element may be of."""
		while isinstance(node, (c_ast.ArrayRef, c_ast.UnaryOp, c_ast.BinaryOp)) or getattr(node, "type", None) == ".":
			is_one, is_two = (isinstance(node, kind) for kind in (c_ast.UnaryOp, c_ast.BinaryOp))
			node = node.expr if is_one else node.left if is_two else node.name
		if isinstance(node, c_ast.StructRef):
			return {f"{name}->{node.field.name}" for name in self.names(node.name, within)}
		if not isinstance(node, c_ast.ID):
			return set()
		values = [value for value in self.given.get(node.name, [None]) if value is not None]
		if node.name in within or not values or self.tree.type_of(node).kind != "pointer":
			return {node.name}
		return set().union(*(self.names(value, (*within, node.name)) for value in values))

	def follow(self, node, how, within):
		values = self.given.get(node.name, []) if node.name not in within else []
		return set().union(*(how(value, (*within, node.name)) for value in values if value is not None))

	def computed(self, node, within=()):
		"""The arrays from whose floats a value is computed, other than by taking one of them."""
		if isinstance(node, c_ast.ID):
			return self.follow(node, self.computed, within)
		if isinstance(node, c_ast.TernaryOp):
			return self.computed(node.iftrue, within) | self.computed(node.iffalse, within)
		if isinstance(node, c_ast.FuncCall) and node.name.name in CHOOSE | PUTS | {"ts_flush"}:
			return set().union(*(self.computed(each, within) for each in node.args.exprs))
		return set() if is_stored_float(self.tree.type_of(node)) else self.read(node)

	def read(self, node, within=()):
		"""Those that are read anywhere in an expression."""
		if isinstance(node, c_ast.ID) and self.tree.type_of(node).kind != "pointer":
			return self.follow(node, self.read, within)
		kind = self.tree.types.get(id(node))
		is_one = isinstance(kind, T.Type) and (is_stored_float(kind) or kind.kind == "pointer"
		                                       and is_stored_float(kind.of))
		found = self.names(node) if is_one else set()
		return found.union(*(self.read(child, within) for child in T.children(node) if id(child) in self.tree.types
		                     or isinstance(child, c_ast.ExprList)))

	def judge(self, node, to, values):
		again = self.names(to) & set().union(*values)
		if again:
			reason = f"{min(again)} is computed from itself: floats are not summed across items"
			self.faults.append((T.place(node.coord.file), node.coord.line, reason))

	def visit_Assignment(self, node):
		if is_stored_float(self.tree.type_of(node.lvalue)):
			self.judge(node, node.lvalue, [self.computed(node.rvalue)])
		self.generic_visit(node)

	def visit_FuncCall(self, node):
		"""A function that stores by a pointer."""
		arguments = node.args.exprs if node.args else []
		for kind, argument in zip(self.tree.names[0][node.name.name].with_, arguments):
			if kind.kind == "pointer" and is_stored_float(kind.of) and not kind.of.const:
				self.judge(node, argument, [self.read(other) for other in arguments if other is not argument])
		self.generic_visit(node)


def faults(tree):
	return sum((Sums(tree, function).faults for name, function in tree.functions.items() if name != PYRAMID), [])
