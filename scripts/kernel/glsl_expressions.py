"""Expressions of the kernels in GLSL: buffer references in the place of pointers to what items share, values in that of
pointers to what is an item's own. Each gives its text and how tightly it binds."""
from pycparser import c_ast

from . import tree as T
from .glsl_words import NAMES, PRECEDENCE, PRIMARY, UNARY, is_mixed, is_same, literal, member_of, name_of
from .layout import Layout


class Expressions:
	def __init__(self, tree):
		self.tree, self.layout, self.aliases, self.path = tree, Layout(tree), {}, None

	def type(self, kind):
		if kind.kind == "scalar":
			return NAMES[kind.name]
		if kind.kind == "struct":
			return kind.name
		if kind.kind == "array":
			return self.type(self.element(kind)) + self.dimensions(kind)
		if kind.kind == "pointer" and kind.of.shared:
			return self.reference(kind.of)
		return self.type(kind.of)

	def element(self, kind):
		return self.element(kind.of) if kind.kind == "array" else kind

	def dimensions(self, kind):
		return f"[{kind.length}]{self.dimensions(kind.of)}" if kind.kind == "array" else ""

	def reference(self, kind):
		return f"{kind.name}_ref"

	def declared(self, kind, name):
		return f"{self.type(self.element(kind))} {name_of(name)}{self.dimensions(kind)}"

	def value(self, node):
		"""As it is used: what is own and pointed to is the thing itself."""
		return self.expression(node)[0]

	def bound(self, node, tight, op=None):
		text, level = self.expression(node)
		return text if level >= tight and not is_mixed(node, op) else f"({text})"

	def as_type(self, node, to, tight=0, op=None):
		"""Converted as C converts it without being told."""
		of = self.tree.type_of(node)
		if to.kind == "scalar" and of.kind == "scalar" and to.name != of.name:
			return self.converted(node, of, to)
		if of.kind == "null":
			return f"{self.type(to)}(0ul)"
		return self.bound(node, tight, op)

	def converted(self, node, of, to):
		if isinstance(node, c_ast.Constant) and to.name in ("i32", "u32", "i64", "u64"):
			return literal(node.value, to.name)
		inner = self.value(node)
		if of.name == "i32" and to.name in ("i64", "u64"):
			return f"ts_i64({inner})" if to.name == "i64" else f"uint64_t(ts_i64({inner}))"
		return f"{NAMES[to.name]}({inner})"

	def expression(self, node):
		return getattr(self, "of_" + type(node).__name__)(node)

	def of_Constant(self, node):
		return literal(node.value, self.tree.type_of(node).name), PRIMARY

	def of_ID(self, node):
		if node.name in self.aliases:
			return self.aliases[node.name], PRIMARY
		kind = self.tree.type_of(node)
		if kind.kind == "array" and self.is_shared(kind):
			raise T.Refused(self.path, node.coord.line, "an array that items share")
		return name_of(node.name), PRIMARY

	def is_shared(self, kind):
		return self.element(kind).shared

	def of_FuncCall(self, node):
		name = node.name.name
		arguments = node.args.exprs if node.args else []
		kinds = self.tree.names[0][name].with_
		texts = [self.as_type(argument, kind) for argument, kind in zip(arguments, kinds)]
		return f"{name}({', '.join(texts)})", PRIMARY

	def of_StructRef(self, node):
		kind = self.tree.type_of(node)
		if kind.kind == "array" and self.is_shared(kind):
			return self.address(node, kind.of)
		return self.place(node), PRIMARY

	of_ArrayRef = of_StructRef

	def place(self, node):
		"""A thing, to be read or written."""
		if isinstance(node, c_ast.StructRef):
			holder = self.tree.type_of(node.name)
			if node.type == "->" and holder.of.shared:
				return f"{self.bound(node.name, PRIMARY)}.v.{member_of(node.field.name)}"
			inner = self.place(node.name) if node.type == "." else self.bound(node.name, PRIMARY)
			return f"{inner}.{member_of(node.field.name)}"
		if isinstance(node, c_ast.ArrayRef):
			return self.element_place(node)
		if isinstance(node, c_ast.UnaryOp) and node.op == "*":
			return self.pointed(node.expr)
		return self.bound(node, PRIMARY)

	def pointed(self, node):
		"""What a pointer is to."""
		if not self.tree.type_of(node).of.shared:
			return self.bound(node, PRIMARY)
		if isinstance(node, c_ast.UnaryOp) and node.op == "&":
			return self.place(node.expr)
		return f"{self.bound(node, PRIMARY)}.v"

	def element_place(self, node):
		of = self.tree.type_of(node.name)
		if of.kind == "pointer" and of.of.shared:
			text, level = self.element_address(node)
			return f"{text}.v" if level == PRIMARY else f"({text}).v"
		return f"{self.place(node.name)}[{self.value(node.subscript)}]"

	def element_address(self, node):
		"""Of an element behind a pointer, and how tightly it binds."""
		of = self.tree.type_of(node.name)
		at = self.value(node.subscript)
		if of.parted:
			size = self.layout.size(of.of)
			return f"TS_PART({self.reference(of.of)}, {self.value(node.name)}, {at}, {size})", PRIMARY
		if self.tree.type_of(node.subscript).name not in ("i64", "u64"):
			return f"{self.bound(node.name, PRIMARY)}[{at}]", PRIMARY
		level = PRECEDENCE["+"]
		return f"{self.bound(node.name, level)} + {self.bound(node.subscript, level + 1)}", level

	def bytes(self, node):
		"""Where something that items share lies: a reference and an offset behind it."""
		if isinstance(node, c_ast.ArrayRef):
			of = self.tree.type_of(node.name)
			if of.kind == "pointer":
				return self.element_address(node)[0], []
			base, offset = self.bytes(node.name)
			return base, offset + [f"uint64_t({self.value(node.subscript)}) * {self.layout.size(of.of)}ul"]
		if isinstance(node, c_ast.StructRef):
			of = self.tree.type_of(node.name)
			holder = of.of if node.type == "->" else of
			base, offset = (self.value(node.name), []) if node.type == "->" else self.bytes(node.name)
			at = self.layout.offsets(holder._replace(shared=False, const=False))[node.field.name]
			return base, offset + ([f"{at}ul"] if at else [])
		if isinstance(node, c_ast.UnaryOp) and node.op == "*":
			return self.value(node.expr), []
		raise T.Refused(self.path, node.coord.line, "this has no address")

	def address(self, node, kind):
		if isinstance(node, c_ast.ArrayRef) and self.tree.type_of(node.name).kind == "pointer":
			return self.element_address(node)
		base, offset = self.bytes(node)
		return f"{self.reference(kind)}({' + '.join([f'uint64_t({base})', *offset])})", PRIMARY

	def of_UnaryOp(self, node):
		if node.op == "&":
			of = self.tree.type_of(node.expr)
			return self.address(node.expr, of) if of.shared else (self.place(node.expr), PRIMARY)
		if node.op == "*":
			return self.place(node), PRIMARY
		if self.tree.type_of(node).kind == "pointer":
			return f"{self.place(node.expr)} = {self.place(node.expr)} {node.op.strip('p')[0]} 1", -1
		if node.op in ("p++", "p--"):
			return self.place(node.expr) + node.op[1:], UNARY
		if node.op in ("++", "--"):
			return node.op + self.place(node.expr), UNARY
		of = self.tree.type_of(node.expr)
		inner = self.as_type(node.expr, T.I32, UNARY) if of.name == "u8" else self.bound(node.expr, UNARY + 1)
		return node.op + inner, UNARY

	def of_BinaryOp(self, node):
		left, right = self.tree.type_of(node.left), self.tree.type_of(node.right)
		level = PRECEDENCE[node.op]
		if {"pointer", "array", "null"} & {left.kind, right.kind}:
			return self.of_pointers(node, left, right, level)
		if node.op in ("&&", "||"):
			return f"{self.operand(node.left, node.op)} {node.op} {self.operand(node.right, node.op)}", level
		if node.op in ("<<", ">>"):
			to = T.scalar(T.wider(left.name, "i32"))
			by = self.bound(node.right, level + 1, node.op)
			return f"{self.as_type(node.left, to, level, node.op)} {node.op} {by}", level
		to = T.scalar(T.wider(left.name, right.name)) if "f32" not in (left.name, right.name) else left
		if left.name == right.name == "bool":
			to = left
		if node.op == "/" and to.name == "f32":
			return f"ts_quotient({self.value(node.left)}, {self.value(node.right)})", PRIMARY
		by = self.as_type(node.right, to, level + 1, node.op)
		return f"{self.as_type(node.left, to, level, node.op)} {node.op} {by}", level

	def operand(self, node, op):
		"""Of && and ||, which stand in parentheses in each other."""
		text, level = self.expression(node)
		is_loose = level < PRECEDENCE["||"] or (level <= PRECEDENCE["&&"] and not is_same(node, op))
		return f"({text})" if is_loose else text

	def of_pointers(self, node, left, right, level):
		if node.op in ("==", "!="):
			return f"{self.as_address(node.left)} {node.op} {self.as_address(node.right)}", level
		if not left.of.shared:
			raise T.Refused(self.path, node.coord.line, "a pointer to an item's own is moved")
		text = self.value(node.left) if level <= PRECEDENCE["+"] else self.bound(node.left, level)
		return f"{text} {node.op} {self.bound(node.right, level + 1)}", level

	def as_address(self, node):
		return "0ul" if self.tree.type_of(node).kind == "null" else f"uint64_t({self.value(node)})"

	def of_TernaryOp(self, node):
		kind = self.tree.type_of(node)
		yes, no = self.as_type(node.iftrue, kind, 1), self.as_type(node.iffalse, kind, 0)
		return f"{self.bound(node.cond, 1)} ? {yes} : {no}", 0

	def of_Cast(self, node):
		to, of = self.tree.type_of(node), self.tree.type_of(node.expr)
		if to.kind == "pointer":
			return f"{self.type(to)}(uint64_t({self.value(node.expr)}))", PRIMARY
		if to.name == "void":
			return self.expression(node.expr)
		if to.name == of.name:
			return self.expression(node.expr)
		return self.converted(node.expr, of, to), PRIMARY

	def of_Assignment(self, node):
		to = self.tree.type_of(node.lvalue)
		if node.op in ("<<=", ">>="):
			return f"{self.place(node.lvalue)} {node.op} {self.value(node.rvalue)}", -1
		return f"{self.place(node.lvalue)} {node.op} {self.given(node.rvalue, to)}", -1

	def of_ExprList(self, node):
		return ", ".join(self.value(each) for each in node.exprs), -2

	def given(self, node, to):
		if isinstance(node, c_ast.InitList):
			return self.constructed(node, to)
		return self.as_type(node, to)

	def constructed(self, node, to):
		if to.kind == "array":
			to = to if to.length is not None else to._replace(length=len(node.exprs))
			return f"{self.type(to)}({', '.join(self.given(each, to.of) for each in node.exprs)})"
		members = self.tree.structs[to.name].values()
		padding = ["0u"] if self.is_padded(to) else []
		return f"{to.name}({', '.join([self.given(each, kind) for kind, each in zip(members, node.exprs)] + padding)})"
