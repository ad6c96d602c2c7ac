"""The rules of the numeric contract (reference/CONTRACT.md) that the kernels' tree shows."""
import re
from itertools import repeat

from pycparser import c_ast

from . import literals
from . import tree as T
from .comments import comments
from .stores import Stores

FLOAT_OPERATORS = {"+", "-", "*", "/", "==", "!=", "<", ">", "<=", ">="}
UNSIGNED = {"u32", "u64"}
# Where the range of a float is proved before it becomes an integer.
TRUNCATES = {"ts_f2i", "ts_k_floor_within"}
FLOORS = "ts_k_floor_quotient"
ROWS = "src/kernels/vectors/"  # hold what primitives give
ARRIVAL, SAYS_SO = re.compile(r"ts_next_[iu]\d+"), "order of arrival"
ATOMIC = re.compile(r"ts_(?:min|or|add|next|mark)_u\d+|ts_(?:add|next)_i64")
# Where two results of 4 bytes are one of 8, because that is where devices have the operation; and where the words of a
# row are a record, which the functions under test get by a pointer.
POINTS_ANEW = re.compile(r"ts_k_vector_(key_min|add_i64)|ts_row_at_\w+")


STATEMENTS = (c_ast.Compound, c_ast.If, c_ast.For, c_ast.While, c_ast.DoWhile, c_ast.Switch, c_ast.Case, c_ast.Default)


def is_float(kind):
	return kind.kind == "scalar" and kind.name == "f32"


def is_integer(kind):
	return kind.kind == "scalar" and kind.name in T.INTEGERS


def calls(node):
	"""The names of the functions that are called in an expression or a statement."""
	own = [node.name.name] if isinstance(node, c_ast.FuncCall) else []
	return own + [name for child in T.children(node) for name in calls(child)]


def with_effects(tree):
	"""The atomic operations, and all functions that come to one."""
	called = {name: set(calls(function.node.body)) for name, function in tree.functions.items()}
	found = set(filter(ATOMIC.fullmatch, set().union(*called.values())))
	while more := {name for name, names in called.items() if names & found} - found:
		found |= more
	return found


def products(node):
	"""Those of two numbers that are not literals, in an expression."""
	found = [each for child in T.children(node) for each in products(child)]
	one = isinstance(node, c_ast.BinaryOp) and node.op == "*"
	one = one and not (T.is_literal(node.left) or T.is_literal(node.right))
	return found + [node] if one else found


def takes_pointer(to, of):
	if of.kind not in ("pointer", "array"):
		return None if of.kind == "null" else "no integer is a pointer: write NULL"
	if to.of.kind == of.of.kind == "pointer":
		return None
	if to.of.shared != of.of.shared:
		return "what items share and what is an item's own are not in one memory: TS_GLOBAL says which"
	if to.of.name != of.of.name:
		return f"a pointer to {of.of.name} becomes one to {to.of.name}"
	return "what is constant becomes writable" if of.of.const and not to.of.const else None


def takes(to, of, node):
	"""Why a value is not taken as it is; None if it is."""
	if to.kind == "pointer":
		return takes_pointer(to, of)
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

	def __init__(self, tree, stores, effects, function, node):
		self.tree, self.function, self.stores, self.effects, self.faults = tree, function, stores, effects, []
		self.name = function.name if function else None
		self.dropped = None
		self.visit(node)

	def fault(self, node, reason):
		self.faults.append((T.place(node.coord.file), node.coord.line, reason))

	def type_of(self, node):
		return self.tree.type_of(node)

	def members(self, kind):
		return repeat(kind.of) if kind.kind == "array" else self.tree.structs[kind.name].values()

	def taken(self, to, node, at):
		if isinstance(node, c_ast.InitList) != (to.kind == "array"):
			if to.kind != "struct":
				self.fault(at, "braces stand about each struct and array, and about nothing else")
				return
		if isinstance(node, c_ast.InitList):
			if to.name in self.stores.whole and self.holds_floats(to):
				self.fault(at, f"{to.name} is stored whole: set its members one by one, by ts_put")
			for kind, each in zip(self.members(to), node.exprs):
				self.taken(kind, each, at)
			return
		self.converted(to, self.type_of(node), node, at)

	def converted(self, to, of, node, at):
		reason = takes(to, of, node)
		if reason:
			self.fault(at, reason)

	def bits(self, node, value):
		if not T.place(node.coord.file).startswith(ROWS) and self.stores.unsettled_bits(self.name, value):
			self.fault(node, "bits of a float are stored that has not passed ts_put")

	def visit_Compound(self, node):
		for each in node.block_items or []:
			self.full(each.init if isinstance(each, c_ast.Decl) else each)
		self.generic_visit(node)

	def full(self, node):
		"""A full expression, whose parts are evaluated in an order that no language promises."""
		if isinstance(node, STATEMENTS) or node is None:
			return
		if sum(name in self.effects for name in calls(node)) > 1:
			self.fault(node, "two effects in one expression: their order is not promised")

	def truth(self, node):
		if node is not None and self.type_of(node).name != "bool":
			self.fault(node, f"{self.type_of(node).name} is no truth value: compare it")

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
			if ATOMIC.fullmatch(name):
				self.bits(node, argument)
		if ARRIVAL.fullmatch(name) and node is not self.dropped and SAYS_SO not in self.said():
			self.fault(node, f"the result of {name} is the {SAYS_SO}: say above the function what sorts it")

	def said(self):
		"""Above the function."""
		return " ".join(comments(self.function.path.split("@")[0]).above.get(self.function.line, []))

	def visit_StructRef(self, node):
		self.visit(node.name)

	def visit_ID(self, node):
		if self.type_of(node).kind == "function":
			self.fault(node, f"{node.name} is called, not pointed to")

	def visit_Return(self, node):
		if node.expr is not None:
			self.taken(self.function.type.of, node.expr, node)
		self.generic_visit(node)

	def visit_If(self, node):
		self.truth(node.cond)
		self.generic_visit(node)

	visit_While = visit_For = visit_If

	def visit_TernaryOp(self, node):
		yes, no = self.type_of(node.iftrue), self.type_of(node.iffalse)
		self.truth(node.cond)
		if is_float(yes) != is_float(no):
			self.fault(node, f"one of {yes.name} and {no.name}: write the cast, or the literal as a float")
		self.generic_visit(node)

	def visit_Cast(self, node):
		to, of = self.type_of(node), self.type_of(node.expr)
		self.dropped = node.expr if to.name == "void" else self.dropped
		self.visit(node.expr)
		if to.kind == "scalar" and to.name == "void":
			return
		if is_float(to) and of.name == "u64":
			self.fault(node, "u64 becomes f32, for which some processors take a sum: convert an i64")
		if is_float(of) and not is_float(to) and self.name not in TRUNCATES:
			self.fault(node, f"({to.name}) of a float needs a proved range: use ts_f2i, ts_floor_i32 or ts_fix")
		if "pointer" in (to.kind, of.kind) and of.kind != "null" and not POINTS_ANEW.fullmatch(self.name or ""):
			self.fault(node, "a pointer is not cast")

	def visit_BinaryOp(self, node):
		if node.op in ("&&", "||"):
			self.truth(node.left)
			self.truth(node.right)
		else:
			self.operation(node, node.op, self.type_of(node.left), self.type_of(node.right))
		self.generic_visit(node)

	def operation(self, node, op, left, right):
		floats = is_float(left) or is_float(right)
		if floats and not (is_float(left) and is_float(right)):
			self.fault(node, f"{left.name} {op} {right.name}: write the cast, or the literal as a float")
		if floats and op not in FLOAT_OPERATORS:
			self.fault(node, f"{op} is no operation of floats")
		if op == "%" and not (left.name in UNSIGNED and right.name in UNSIGNED):
			self.fault(node, "a signed number has no remainder in GLSL: take that of an unsigned one")
		if op == "/" and self.name != FLOORS and not floats and not {left.name, right.name} <= UNSIGNED:
			self.fault(node, f"a quotient of signed numbers is cut towards 0: {FLOORS} rounds down")
		if op == "<<" and left.name not in ("u32", "u64"):
			self.fault(node, "a signed number is shifted: shift an unsigned one")
		if left.kind == "pointer" and op not in ("+", "-", "==", "!="):
			self.fault(node, f"{op} is no operation of pointers")

	def visit_ArrayRef(self, node):
		for each in products(node.subscript):
			if self.type_of(each).name in ("u32", "i32"):
				self.fault(node, "a product of 32 bits is an index: widen its factors")
		self.generic_visit(node)

	def visit_UnaryOp(self, node):
		if node.op == "!":
			self.truth(node.expr)
		if node.op in ("++", "--", "p++", "p--", "~") and is_float(self.type_of(node.expr)):
			self.fault(node, f"{node.op.strip('p')} is no operation of floats")
		self.visit(node.expr)

	def visit_Constant(self, node):
		if node.type in ("float", "double"):
			reason = literals.fault(node.value)
			if reason:
				self.fault(node, reason)

	def visit_Assignment(self, node):
		to = self.type_of(node.lvalue)
		if node.op == "=":
			self.taken(to, node.rvalue, node)
		else:
			self.changed(node, to)
		if is_float(to) and self.stores.is_stored(node.lvalue) and not self.stores.is_settled(self.name, node.rvalue):
			self.fault(node, "a float is stored that has not passed ts_put")
		if not is_float(to) and self.stores.is_stored(node.lvalue):
			self.bits(node, node.rvalue)
		self.generic_visit(node)

	def changed(self, node, to):
		"""By an operation: as if that were written out."""
		by = self.type_of(node.rvalue)
		if is_float(to):
			self.fault(node, f"{node.op} of a float: write the operation")
		elif to.kind == "scalar":
			self.operation(node, node.op[:-1], to, by)
			if node.op not in ("<<=", ">>="):
				self.converted(to, by, node.rvalue, node)

	def holds_floats(self, kind):
		if kind.kind == "struct":
			return any(self.holds_floats(member) for member in self.tree.structs[kind.name].values())
		return self.holds_floats(kind.of) if kind.kind == "array" else is_float(kind)


def faults(tree):
	stores = Stores(tree)
	effects = with_effects(tree)
	rules = [Rules(tree, stores, effects, function, function.node.body) for function in tree.functions.values()]
	rules += [Rules(tree, stores, effects, None, constant) for constant in tree.constants.values()]
	return sum((each.faults for each in rules), [])
