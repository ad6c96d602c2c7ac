"""Which variables may be read before they are set: on every way to where a variable, or a member of a struct, is read,
something was assigned to it. An array is set by one of its elements, and what a function gets by a pointer to change is
set by it."""
import re

from pycparser import c_ast

from . import tree as T

NEVER = None  # the state behind what does not go on
# They give a struct away of which they set a part, and the rest is not read.
GIVES_PART = re.compile(r"ts_k_(clip|shadow_caster|splat_triangle|surface_geometry)")


def both(a, b):
	"""What is set whichever way was taken."""
	return b if a is NEVER else a if b is NEVER else a & b


class Flow:
	"""Of one function. A state is the set of what is set, by its names: "v", "v.x"."""

	def __init__(self, tree, function):
		self.tree, self.faults = tree, {}
		self.gives_part = GIVES_PART.fullmatch(function.name)
		self.unset = {}  # the places of variables that were declared without a value, by their names
		self.breaks, self.continues = [], []
		self.statement(function.node.body, frozenset())

	def places(self, name, kind):
		"""Of a variable or a member: its own, or those of its members."""
		if kind.kind != "struct":
			return {name}
		return set().union(*(self.places(f"{name}.{member}", of)
		                     for member, of in self.tree.structs[kind.name].items()))

	def place(self, node):
		"""The name of what an expression is, if it is in a variable that was declared without a value, and whether that
		is an element of an array."""
		if isinstance(node, c_ast.ID):
			return (node.name if node.name in self.unset else None), False
		if isinstance(node, c_ast.StructRef) and node.type == ".":
			name, element = self.place(node.name)
			return (f"{name}.{node.field.name}" if name and not element else name), element
		if isinstance(node, c_ast.ArrayRef) and self.tree.type_of(node.name).kind == "array":
			return self.place(node.name)[0], True
		return None, False

	def under(self, name):
		root = name.split(".")[0]
		return {place for place in self.unset[root] if (place + ".").startswith(name + ".")}

	def read(self, node, state):
		name = self.place(node)[0]
		missing = self.under(name) - state if name and state is not NEVER else set()
		if missing and not (self.gives_part and self.under(name) & state):
			at = node.coord
			self.faults[T.place(at.file), at.line, name] = f"{min(missing)} may be read before it is set"

	def set(self, node, state):
		name = self.place(node)[0]
		return state | self.under(name) if name and state is not NEVER else state

	def each(self, nodes, state):
		for node in nodes:
			state = self.statement(node, state)
		return state

	def statement(self, node, state):
		return getattr(self, "of_" + type(node).__name__, self.of_children)(node, state)

	def of_children(self, node, state):
		return self.each(T.children(node), state)

	def of_Decl(self, node, state):
		if node.init is not None:
			self.unset.pop(node.name, None)
			return self.statement(node.init, state)
		self.unset[node.name] = self.places(node.name, self.tree.declaration(node.type))
		return state if state is NEVER else state - self.unset[node.name]

	def of_ID(self, node, state):
		self.read(node, state)
		return state

	def of_StructRef(self, node, state):
		if self.place(node)[0] is None:
			return self.statement(node.name, state)
		self.read(node, state)
		return state

	def of_ArrayRef(self, node, state):
		state = self.statement(node.subscript, state)
		if self.place(node)[0] is None:
			return self.statement(node.name, state)
		self.read(node, state)
		return state

	def of_Assignment(self, node, state):
		state = self.statement(node.rvalue, state)
		if node.op != "=":
			self.read(node.lvalue, state)
		return self.set(node.lvalue, self.within(node.lvalue, state))

	def within(self, node, state):
		"""What is read to find where something is."""
		if isinstance(node, c_ast.ArrayRef):
			state = self.statement(node.subscript, state)
		if isinstance(node, (c_ast.ArrayRef, c_ast.StructRef)):
			return self.within(node.name, state) if self.place(node)[0] else self.statement(node.name, state)
		return self.statement(node.expr, state) if isinstance(node, c_ast.UnaryOp) else state

	def of_FuncCall(self, node, state):
		kinds = self.tree.names[0][node.name.name].with_
		changed = []
		for kind, argument in zip(kinds, node.args.exprs if node.args else []):
			of = argument.expr if isinstance(argument, c_ast.UnaryOp) and argument.op == "&" else argument
			if kind.kind == "pointer" and self.place(of)[0] and (not kind.of.const
			                                                     or self.tree.type_of(of).kind == "array"):
				changed += [] if kind.of.const else [of]
				state = self.within(of, state)
			else:
				state = self.statement(argument, state)
		for of in changed:
			state = self.set(of, state)
		return state

	def of_UnaryOp(self, node, state):
		if node.op == "&" and self.place(node.expr)[0]:
			return self.set(node.expr, self.within(node.expr, state))
		return self.statement(node.expr, state)

	def of_BinaryOp(self, node, state):
		state = self.statement(node.left, state)
		right = self.statement(node.right, state)
		return state if node.op in ("&&", "||") else right

	def of_TernaryOp(self, node, state):
		state = self.statement(node.cond, state)
		return both(self.statement(node.iftrue, state), self.statement(node.iffalse, state))

	def of_If(self, node, state):
		state = self.statement(node.cond, state)
		yes = self.statement(node.iftrue, state)
		return both(yes, self.statement(node.iffalse, state) if node.iffalse else state)

	def of_Return(self, node, state):
		if node.expr is not None:
			self.statement(node.expr, state)
		return NEVER

	def of_Break(self, _node, state):
		self.breaks[-1] = both(self.breaks[-1], state)
		return NEVER

	def of_Continue(self, _node, state):
		self.continues[-1] = both(self.continues[-1], state)
		return NEVER

	def of_For(self, node, state):
		if getattr(node, "init", None) is not None:
			state = self.statement(node.init, state)
		tested = self.statement(node.cond, state) if node.cond is not None else state
		self.breaks.append(NEVER)
		self.continues.append(NEVER)
		last = self.statement(node.stmt, tested)
		last = both(last, self.continues.pop())
		if getattr(node, "next", None) is not None:
			last = self.statement(node.next, last)
		out = self.breaks.pop()
		if node.cond is not None and getattr(node.cond, "name", None) != "true":
			out = both(out, last if self.runs(node) else both(tested, last))
		return self.with_elements(node.stmt, out)

	of_While = of_For

	def runs(self, node):
		"""Whether a loop is known to run at least once."""
		first = getattr(node, "init", None)
		first = first.decls[0] if isinstance(first, c_ast.DeclList) else first
		cond = node.cond
		if not isinstance(first, c_ast.Decl) or not isinstance(cond, c_ast.BinaryOp) or cond.op not in ("<", "<="):
			return False
		begin, end = self.tree.value(first.init), self.tree.value(cond.right)
		named = isinstance(cond.left, c_ast.ID) and cond.left.name == first.name
		return named and begin is not None and end is not None and begin < end + (cond.op == "<=")

	def with_elements(self, body, state):
		"""Arrays whose elements a loop sets are taken as set behind it."""
		found = Elements(self, body).names
		return state if state is NEVER else state.union(*(self.under(name) for name in found))

	def of_Switch(self, node, state):
		state = self.statement(node.cond, state)
		self.breaks.append(NEVER)
		last, whole = NEVER, False
		for each in node.stmt.block_items or []:
			if isinstance(each, (c_ast.Case, c_ast.Default)):
				whole |= isinstance(each, c_ast.Default)
				last = self.each(each.stmts or [], both(state, last))
			else:
				last = self.statement(each, last)
		out = both(self.breaks.pop(), last)
		return out if whole else both(out, state)


class Elements(c_ast.NodeVisitor):
	"""The arrays of which a statement sets an element."""

	def __init__(self, flow, node):
		self.flow, self.names = flow, set()
		self.visit(node)

	def visit_Assignment(self, node):
		name, element = self.flow.place(node.lvalue)
		if name and element:
			self.names.add(name)
		self.generic_visit(node)


def faults(tree):
	for function in tree.functions.values():
		for (path, line, _), reason in Flow(tree, function).faults.items():
			yield path, line, reason
