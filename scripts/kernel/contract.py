"""The rules of the numeric contract (reference/CONTRACT.md) that the kernels' tree shows."""
from itertools import repeat

from pycparser import c_ast

from . import tree as T
from .stores import Stores

FLOAT_OPERATORS = {"+", "-", "*", "/", "==", "!=", "<", ">", "<=", ">="}
# Where the range of a float is proved before it becomes an integer.
TRUNCATES = {"ts_f2i", "ts_k_floor_within"}
# Where two results of 4 bytes are one of 8, because that is where devices have the operation.
POINTS_ANEW = {"ts_k_vector_key_min"}


def is_float(kind):
	return kind.kind == "scalar" and kind.name == "f32"


def is_integer(kind):
	return kind.kind == "scalar" and kind.name in T.INTEGERS


def is_null(node):
	return isinstance(node, c_ast.Cast) and isinstance(node.expr, c_ast.Constant) and node.expr.value == "0"


def takes(to, of, node):
	"""Why a value is not taken as it is; None if it is."""
	if T.is_literal(node) and is_integer(of):
		return "an integer becomes a float: write the literal as a float" if is_float(to) else None
	if to.kind != "scalar" or of.kind != "scalar" or to.name == of.name:
		return None
	if "f32" in (to.name, of.name):
		return f"{of.name} becomes {to.name}: write the cast"
	if T.RANKS.index(of.name) > T.RANKS.index(to.name):
		return f"{of.name} becomes {to.name}, which is narrower: write the cast"
	return None


class Rules(c_ast.NodeVisitor):
	"""Of one function, or of constants outside functions: None."""

	def __init__(self, tree, stores, function, node):
		self.tree, self.function, self.stores, self.faults = tree, function, stores, []
		self.name = function.name if function else None
		self.visit(node)

	def fault(self, node, reason):
		self.faults.append((T.place(node.coord.file), node.coord.line, reason))

	def type_of(self, node):
		return self.tree.type_of(node)

	def members(self, kind):
		return repeat(kind.of) if kind.kind == "array" else self.tree.structs[kind.name].values()

	def taken(self, to, node, at):
		if isinstance(node, c_ast.InitList):
			for kind, each in zip(self.members(to), node.exprs):
				self.taken(kind, each, at)
			return
		reason = takes(to, self.type_of(node), node)
		if reason:
			self.fault(at, reason)

	def visit_Decl(self, node):
		if node.init is not None:
			self.taken(self.tree.declaration(node.type), node.init, node)
			self.visit(node.init)

	def visit_FuncCall(self, node):
		name = node.name.name
		if name == self.name:
			self.fault(node, "no function calls itself")
		arguments = node.args.exprs if node.args else []
		for to, argument in zip(self.tree.names[0][name].with_, arguments):
			self.taken(to, argument, node)
		for argument in arguments:
			self.visit(argument)

	def visit_StructRef(self, node):
		self.visit(node.name)

	def visit_ID(self, node):
		if self.type_of(node).kind == "function":
			self.fault(node, f"{node.name} is called, not pointed to")

	def visit_Return(self, node):
		if node.expr is not None:
			self.taken(self.function.type.of, node.expr, node)
		self.generic_visit(node)

	def visit_Cast(self, node):
		to, of = self.type_of(node), self.type_of(node.expr)
		if is_float(of) and not is_float(to) and self.name not in TRUNCATES:
			self.fault(node, f"({to.name}) of a float needs a proved range: use ts_f2i, ts_floor_i32 or ts_fix")
		if to.kind == "pointer" and not is_null(node) and self.name not in POINTS_ANEW:
			self.fault(node, "a pointer is not cast")
		self.visit(node.expr)

	def visit_BinaryOp(self, node):
		left, right = self.type_of(node.left), self.type_of(node.right)
		floats = is_float(left) or is_float(right)
		if floats and not (is_float(left) and is_float(right)):
			self.fault(node, f"{left.name} {node.op} {right.name}: write the cast, or the literal as a float")
		if floats and node.op not in FLOAT_OPERATORS:
			self.fault(node, f"{node.op} is no operation of floats")
		if node.op == "<<" and left.name not in ("u32", "u64"):
			self.fault(node, "a signed number is shifted: shift an unsigned one")
		self.generic_visit(node)

	def visit_UnaryOp(self, node):
		if node.op in ("++", "--", "p++", "p--") and is_float(self.type_of(node.expr)):
			self.fault(node, f"{node.op.strip('p')} is no operation of floats")
		if node.op != "sizeof":
			self.visit(node.expr)

	def visit_Assignment(self, node):
		to = self.type_of(node.lvalue)
		if is_float(to) and node.op != "=":
			self.fault(node, f"{node.op} of a float: write the operation")
		if node.op == "=":
			self.taken(to, node.rvalue, node)
		if is_float(to) and to.shared and not self.stores.is_settled(self.name, node.rvalue):
			self.fault(node, "a float is stored that has not passed ts_put")
		self.generic_visit(node)


def faults(tree):
	stores = Stores(tree)
	rules = [Rules(tree, stores, function, function.node.body) for function in tree.functions.values()]
	rules += [Rules(tree, stores, None, constant) for constant in tree.constants.values()]
	return sum((each.faults for each in rules), [])
