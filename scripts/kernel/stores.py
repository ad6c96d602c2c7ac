"""Which floats are stored that have not passed ts_put (rule 12): a float is settled if it has, if it is a literal, was
read from what is stored, is the lesser or greater of such, or comes from a function or a variable that holds nothing
else."""
from pycparser import c_ast

from . import tree as T

CHOOSE = {"ts_min", "ts_max"}
PUTS = {"ts_put"}


def is_plain(literal):
	"""Neither -0 nor a number that ts_put makes 0."""
	if isinstance(literal, c_ast.UnaryOp):
		return is_plain(literal.expr) and value_of(literal.expr) != 0
	return value_of(literal) == 0 or value_of(literal) >= 2.0**-100


def value_of(literal):
	is_real = literal.type in ("float", "double")
	return float(literal.value.rstrip("fFlL")) if is_real else int(literal.value.rstrip("uUlL"), 0)


def literals(node):
	if T.is_literal(node):
		return [node]
	return [each for child in T.children(node) for each in literals(child)]


class Values(c_ast.NodeVisitor):
	"""What each variable of a function is given, and what the function returns. A variable whose address is taken may
	be given anything: None."""

	def __init__(self, function):
		self.given, self.returned = {}, []
		self.visit(function.node.body)
		for parameter in function.node.decl.type.args.params if function.node.decl.type.args else []:
			self.given.setdefault(parameter.name, []).append(None)

	def give(self, name, value):
		self.given.setdefault(name, []).append(value)

	def visit_Decl(self, node):
		if node.init is not None:
			self.give(node.name, node.init)
			self.visit(node.init)

	def visit_Assignment(self, node):
		if isinstance(node.lvalue, c_ast.ID):
			self.give(node.lvalue.name, node.rvalue if node.op == "=" else None)
		self.generic_visit(node)

	def visit_UnaryOp(self, node):
		if node.op == "&" and isinstance(node.expr, c_ast.ID):
			self.give(node.expr.name, None)
		self.generic_visit(node)

	def visit_Return(self, node):
		self.returned.append(node.expr)
		self.generic_visit(node)


class Whole(c_ast.NodeVisitor):
	"""The structs of which one item's own becomes a stored one,
	so that all their members pass ts_put where they are set."""

	def __init__(self, tree):
		self.tree, self.names = tree, set()
		for function in tree.functions.values():
			self.visit(function.node.body)

	def visit_Assignment(self, node):
		to, of = self.tree.type_of(node.lvalue), self.tree.type_of(node.rvalue)
		if to.kind == "struct" and to.shared and not of.shared:
			self.names.add(to.name)
		self.generic_visit(node)


class Stores:
	def __init__(self, tree):
		self.tree = tree
		self.whole = Whole(tree).names
		self.values = {name: Values(function) for name, function in tree.functions.items()}
		self.settles = dict.fromkeys(PUTS, True)

	def is_stored(self, lvalue):
		"""Whether what is assigned is stored, or will be."""
		if self.tree.type_of(lvalue).shared:
			return True
		while isinstance(lvalue, (c_ast.ArrayRef, c_ast.StructRef)):
			of = self.tree.type_of(lvalue.name)
			if isinstance(lvalue, c_ast.StructRef) and (of.of if lvalue.type == "->" else of).name in self.whole:
				return True
			lvalue = lvalue.name
		return False

	def function_settles(self, name):
		if name not in self.settles:
			self.settles[name] = False  # if it calls itself
			returned = self.values[name].returned if name in self.values else [None]
			self.settles[name] = bool(returned) and all(self.is_settled(name, value) for value in returned)
		return self.settles[name]

	def is_settled(self, function, node, within=()):
		if node is None:
			return False
		if T.is_literal(node):
			return is_plain(node)
		if isinstance(node, c_ast.Assignment):
			return self.is_settled(function, node.rvalue, within)
		if isinstance(node, c_ast.TernaryOp):
			return self.is_settled(function, node.iftrue, within) and self.is_settled(function, node.iffalse, within)
		if isinstance(node, c_ast.Cast):
			return self.tree.type_of(node.expr).name in T.INTEGERS | {"bool"}
		if isinstance(node, c_ast.FuncCall):
			return self.call_is_settled(function, node, within)
		if self.is_constant(function, node):
			return True
		if isinstance(node, c_ast.ID) and not self.tree.type_of(node).shared:
			return node.name in within or self.variable_is_settled(function, node.name, (*within, node.name))
		return self.tree.type_of(node).shared

	def unsettled_bits(self, function, node, within=()):
		"""Whether an integer is made of the bits of a float that has not passed ts_put."""
		if isinstance(node, c_ast.FuncCall) and node.name.name == "ts_f2u":
			return not self.is_settled(function, node.args.exprs[0])
		if isinstance(node, c_ast.ID) and node.name not in within:
			given = self.values[function].given.get(node.name, [])
			return any(self.unsettled_bits(function, value, (*within, node.name)) for value in given
			           if value is not None)
		return any(self.unsettled_bits(function, child, within) for child in T.children(node))

	def is_constant(self, function, node):
		"""Of one outside functions, all of whose literals are plain."""
		while isinstance(node, (c_ast.ArrayRef, c_ast.StructRef)):
			node = node.name
		if not isinstance(node, c_ast.ID) or node.name in self.values[function].given:
			return False
		constant = self.tree.constants.get(node.name)
		return constant is not None and all(is_plain(each) for each in literals(constant.init))

	def call_is_settled(self, function, node, within):
		if node.name.name in CHOOSE:
			return all(self.is_settled(function, argument, within) for argument in node.args.exprs)
		return self.function_settles(node.name.name)

	def variable_is_settled(self, function, name, within):
		given = self.values[function].given.get(name, [None])
		return all(self.is_settled(function, value, within) for value in given)
