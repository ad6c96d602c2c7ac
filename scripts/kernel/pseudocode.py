"""The kernels as exact pseudo-code in the syntax of Python: every conversion is written, a pointer to an item's own is
the thing itself or a reference, and a pointer to what items share is a buffer from an element on."""
import re
import struct

from pycparser import c_ast

from . import tree as T
from .comments import comments
from .glsl import Lengths, parameters
from .glsl_words import PRECEDENCE, below, is_own

WORDS = {"and", "as", "assert", "async", "await", "class", "def", "del", "from", "global", "import", "in", "is",
         "lambda", "not", "or", "pass", "raise", "range", "try", "with", "yield", "None"}
PRIMARY, UNARY, NOT, TERNARY = 30, 20, 1.5, -2
COLUMNS = 120
LOGICAL = {"&&": "and", "||": "or"}
INTEGERS = ("i32", "u32", "i64", "u64", "u8")


def name_of(word):
	return word + "_" if word in WORDS else word


def literal(text, kind):
	if kind != "f32":
		return text.rstrip("uUlL")
	value = float.fromhex(text.rstrip("f")) if "x" in text else float(text.rstrip("f"))
	shortest = next(short for short in (f"{value:.{n}g}" for n in range(1, 18))
	                if rounded(float(short)) == rounded(value))
	return shortest if re.search(r"[.e]", shortest) else shortest + ".0"


def rounded(value):
	"""To binary32."""
	return struct.pack("<f", value)


def wrapped(line):
	"""Long lines in several, broken behind commas within brackets."""
	text, lines = line, []
	while len(text) > COLUMNS:
		at = [m.end() for m in re.finditer(r", ", text[:COLUMNS])
		      if text[: m.start()].count("(") > text[: m.start()].count(")")]
		if not at or text.lstrip().startswith("#"):
			break
		lines.append(text[: at[-1]].rstrip())
		text = " " * (len(line) - len(line.lstrip()) + 8) + text[at[-1] :]
	return lines + [text]


class Writer:
	def __init__(self, tree):
		self.tree, self.lines, self.depth = tree, [], 0
		self.lengths = Lengths(tree).found

	def put(self, text):
		self.lines += wrapped("    " * self.depth + text) if text else [""]

	def taken(self):
		lines, self.lines = self.lines, []
		return lines

	def type(self, kind):
		if kind.kind == "array":
			return f"array({self.type(kind.of)}{'' if kind.length is None else f', {kind.length}'})"
		if kind.kind == "pointer":
			return f"buffer({self.type(kind.of)})" if kind.of.shared else f"ref({self.type(kind.of)})"
		return kind.name

	def function(self, function):
		self.returns, self.noted, node = function.type.of, {function.line}, function.node
		self.note(node.decl)
		kinds = dict(zip([p.name for p in parameters(function)], function.type.with_))
		self.params = kinds
		self.cells = set(self.pointed_scalars(node.body))
		lengths = self.lengths.get(function.name, [{}])
		for name, kind in kinds.items():
			length = {each[name] for each in lengths if name in each}
			if length:
				of = T.Type("array", "array", kind.of, length=length.pop() if len(length) == 1 else None)
				kinds[name] = kind._replace(of=of._replace(const=kind.of.const))
		listed = ", ".join(f"{name_of(name)}: {self.parameter(kind)}" for name, kind in kinds.items())
		gives = self.type(self.returns) if self.returns.name != "void" else "None"
		self.put(f"def {function.name}({listed}) -> {gives}:")
		self.depth += 1
		for name, kind in kinds.items():
			if kind.kind == "struct" and self.is_changed(node.body, name):
				self.put(f"{name_of(name)} = copy({name_of(name)})")
		self.body(node.body)
		self.depth -= 1
		self.put("")

	def struct(self, node):
		self.note(node)
		self.put(f"class {node.name}:")
		self.depth += 1
		for member in node.type.type.decls:
			behind = comments(member.coord.file.split("@")[0]).behind.get(member.coord.line)
			kind = self.type(self.tree.structs[node.name][member.name])
			self.put(f"{name_of(member.name)}: {kind}" + (f"  # {behind[0]}" if behind else ""))
		self.depth -= 1
		self.put("")

	def enumeration(self, node):
		for each in node.values.enumerators:
			self.put(f"{each.name} = {self.tree.enumerators[each.name]}")
		self.put("")

	def constant(self, node):
		self.cells, self.params = set(), {}
		self.note(node)
		self.put_Decl(node)
		self.put("")

	def parameter(self, kind):
		return self.type(kind.of) if is_own(kind) and kind.of.const else self.type(kind)

	def pointed_scalars(self, body):
		"""Variables of one number that a pointer is made to."""
		for each in below(body):
			if isinstance(each, c_ast.UnaryOp) and each.op == "&" and isinstance(each.expr, c_ast.ID):
				if self.tree.type_of(each.expr).kind == "scalar":
					yield each.expr.name

	def is_changed(self, body, name):
		return any(isinstance(each, c_ast.Assignment) and root(each.lvalue) == name or is_step(each)
		           and root(each.expr) == name or
		           isinstance(each, c_ast.FuncCall) and name in self.lent(each) for each in below(body))

	def lent(self, call):
		"""What a function that is called may change."""
		kinds = self.tree.names[0][call.name.name].with_
		return [root(each.expr) for each, kind in zip(call.args.exprs if call.args else [], kinds)
		        if isinstance(each, c_ast.UnaryOp) and each.op == "&" and not kind.of.const]

	def note(self, node):
		for line in comments(node.coord.file.split("@")[0]).above.get(node.coord.line, []):
			self.put(f"# {line}".rstrip())

	def body(self, node):
		at = len(self.lines)
		for each in node.block_items or [] if isinstance(node, c_ast.Compound) else [node]:
			self.statement(each)
		if len(self.lines) == at:
			self.put("pass")

	def inner(self, node):
		self.depth += 1
		self.body(node)
		self.depth -= 1

	def statement(self, node):
		"""With the comment above its line, once, though several statements stand on the line."""
		if not isinstance(node, c_ast.Compound) and node.coord and node.coord.line not in self.noted:
			self.noted.add(node.coord.line)
			self.note(node)
		self.after = []
		getattr(self, "put_" + type(node).__name__, self.put_expression)(node)

	def finish(self, text):
		"""A line, and behind it what its expression changes."""
		self.put(text)
		for line in self.after:
			self.put(line)
		self.after = []

	def put_expression(self, node):
		if is_step(node):
			self.put(f"{self.place(node.expr)} {node.op.strip('p')[0]}= 1")
		elif not (isinstance(node, c_ast.Cast) and self.tree.type_of(node).name == "void"
		          and isinstance(node.expr, c_ast.ID)):
			self.finish(self.value(node))

	def put_Compound(self, node):
		self.body(node)

	def put_EmptyStatement(self, _):
		self.put("pass")

	def put_Decl(self, node):
		self.after = []
		kind = self.tree.declaration(node.type)
		if kind.kind == "array" and kind.length is None:
			kind = kind._replace(length=len(node.init.exprs))
		name, cell = name_of(node.name), node.name in self.cells
		of = f"ref({self.type(kind)})" if cell else self.type(kind)
		self.finish(f"{name}: {of}" + ("" if node.init is None else f" = {self.given(node.init, kind)}"))

	def put_DeclList(self, node):
		for each in node.decls:
			self.put_Decl(each)

	def put_Assignment(self, node):
		to = self.tree.type_of(node.lvalue)
		if to.kind == "struct" and isinstance(node.lvalue, c_ast.UnaryOp) and not to.shared:
			self.finish(f"assign({self.place(node.lvalue)}, {self.value(node.rvalue)})")
			return
		right = self.value(node.rvalue) if node.op in ("<<=", ">>=") else self.given(node.rvalue, to)
		op = "//=" if node.op == "/=" and to.name != "f32" else node.op
		self.finish(f"{self.place(node.lvalue)} {op} {right}")

	def put_Return(self, node):
		if self.after:
			raise T.Refused(None, node.coord.line, "a return that changes something")
		is_own = isinstance(node.expr, c_ast.ID) and node.expr.name not in self.params
		text = "" if node.expr is None else self.value(node.expr) if is_own and self.returns.kind == "struct" \
			else self.given(node.expr, self.returns)
		self.put(f"return {text}".rstrip())

	def put_If(self, node, word="if"):
		self.put(f"{word} {self.truth(node.cond)}:")
		self.inner(node.iftrue)
		if isinstance(node.iffalse, c_ast.If):
			self.put_If(node.iffalse, "elif")
		elif node.iffalse is not None:
			self.put("else:")
			self.inner(node.iffalse)

	def put_While(self, node):
		self.steps = [None] + getattr(self, "steps", [])
		self.put_looped(node)
		self.steps.pop(0)

	def put_For(self, node):
		if isinstance(node.init, c_ast.DeclList):
			self.put_DeclList(node.init)
		elif node.init is not None:
			self.statement(node.init)
		self.steps = [node.next] + getattr(self, "steps", [])
		self.put_looped(node)
		self.depth += 1
		self.step()
		self.depth -= 1
		self.steps.pop(0)

	def put_looped(self, node):
		"""What the condition changes behind its value is changed before the body and when the loop ends."""
		self.after = []
		cond = "True" if node.cond is None else self.value(node.cond)
		after, self.after = self.after, []
		self.put(f"while {cond}:")
		self.depth += 1
		for line in after:
			self.put(line)
		self.depth -= 1
		self.inner(node.stmt)

	def step(self):
		following = self.steps[0]
		for each in following.exprs if isinstance(following, c_ast.ExprList) else [following] if following else []:
			self.statement(each)

	def put_Continue(self, _):
		self.step()
		self.put("continue")

	def put_Break(self, _):
		self.put("break")

	def put_Switch(self, node):
		chosen = self.bound(node.cond, PRECEDENCE["=="] + 1)
		word, empty = "if", []
		for case in node.stmt.block_items:
			body = [each for each in case.stmts or [] if not isinstance(each, c_ast.Break)]
			if isinstance(case, c_ast.Default):
				self.put("else:")
			else:
				empty.append(f"{chosen} == {self.value(case.expr)}")
				if not body:
					continue
				self.put(f"{word} {' or '.join(empty)}:")
			word, empty = "elif", []
			self.inner(c_ast.Compound(body, case.coord))

	def truth(self, node):
		text = self.value(node)
		if self.after:
			raise T.Refused(None, node.coord.line, "a decision that changes something")
		return text

	def value(self, node):
		return self.expression(node)[0]

	def bound(self, node, tight):
		text, level = self.expression(node)
		return text if level >= tight else f"({text})"

	def given(self, node, to):
		"""For a variable, a parameter or a result of that type."""
		if isinstance(node, c_ast.InitList):
			if to.kind == "array":
				return f"[{', '.join(self.given(each, to.of) for each in node.exprs)}]"
			members = self.tree.structs[to.name].values()
			return f"{to.name}({', '.join(self.given(each, kind) for kind, each in zip(members, node.exprs))})"
		is_copied = to.kind in ("struct", "array") and not isinstance(node, (c_ast.FuncCall, c_ast.TernaryOp))
		return f"copy({self.value(node)})" if is_copied else self.as_type(node, to)

	def as_type(self, node, to, tight=TERNARY):
		of = self.tree.type_of(node)
		if to.kind == "scalar" and of.kind == "scalar" and to.name != of.name:
			return self.converted(node, of, to)
		return self.bound(node, tight)

	def converted(self, node, of, to):
		if isinstance(node, c_ast.Constant) and to.name != "f32" and of.name != "f32":
			return literal(node.value, of.name)
		return f"{to.name}({self.value(node)})"

	def expression(self, node):
		return getattr(self, "of_" + type(node).__name__)(node)

	def of_Constant(self, node):
		return literal(node.value, self.tree.type_of(node).name), PRIMARY

	def of_ID(self, node):
		if node.name == "ts_null":
			return "None", PRIMARY
		if node.name in ("true", "false"):
			return node.name.capitalize(), PRIMARY
		return name_of(node.name) + (".value" if node.name in self.cells else ""), PRIMARY

	def of_FuncCall(self, node):
		kinds = self.tree.names[0][node.name.name].with_
		texts = [self.argument(each, kind) for each, kind in zip(node.args.exprs if node.args else [], kinds)]
		return f"{node.name.name}({', '.join(texts)})", PRIMARY

	def argument(self, node, kind):
		if kind.kind == "struct":
			return self.value(node)
		return self.as_type(node, kind)

	def place(self, node):
		return self.bound(node, PRIMARY)

	def of_StructRef(self, node):
		of = self.tree.type_of(node.name)
		holder = self.bound(node.name, PRIMARY)
		if node.type == "->" and of.of.shared:
			holder += "[0]"
		return f"{holder}.{name_of(node.field.name)}", PRIMARY

	def of_ArrayRef(self, node):
		return f"{self.bound(node.name, PRIMARY)}[{self.value(node.subscript)}]", PRIMARY

	def of_UnaryOp(self, node):
		of = self.tree.type_of(node.expr)
		if node.op == "*":
			return self.pointed(node.expr, of), PRIMARY
		if node.op == "&":
			return self.address(node.expr, of), PRIMARY
		if node.op in ("p++", "p--"):
			self.after.append(f"{self.place(node.expr)} {node.op[1]}= 1")
			return self.place(node.expr), PRIMARY
		if node.op in ("++", "--"):
			self.put_expression(node)
			return self.place(node.expr), PRIMARY
		if node.op == "!":
			return f"not {self.bound(node.expr, PRECEDENCE['=='])}", NOT
		inner = self.converted(node.expr, of, T.I32) if of.name in ("u8", "bool") else self.bound(node.expr, UNARY + 1)
		return node.op + inner, UNARY

	def pointed(self, node, of):
		text = self.bound(node, PRIMARY)
		if of.of.shared:
			return f"{text}[0]"
		is_plain = of.of.kind != "scalar" or (isinstance(node, c_ast.ID) and of.of.const and node.name in self.params)
		return text if is_plain else f"{text}.value"

	def address(self, node, of):
		if of.shared:
			if isinstance(node, c_ast.ArrayRef):
				return f"{self.bound(node.name, PRIMARY)}[{self.value(node.subscript)}:]"
			if isinstance(node, c_ast.StructRef):
				return f'member({self.holder(node)}, "{node.field.name}")'
			return self.bound(node.expr, PRIMARY)
		if of.kind in ("struct", "array"):
			return self.place(node)
		if isinstance(node, c_ast.ID):
			return name_of(node.name)
		if isinstance(node, c_ast.ArrayRef):
			return f"element({self.bound(node.name, PRIMARY)}, {self.value(node.subscript)})"
		return f'member({self.holder(node)}, "{node.field.name}")'

	def holder(self, node):
		return self.of_StructRef(node)[0].rsplit(".", 1)[0]

	def of_BinaryOp(self, node):
		left, right = self.tree.type_of(node.left), self.tree.type_of(node.right)
		if {"pointer", "array", "null"} & {left.kind, right.kind}:
			return self.of_pointers(node, left)
		level = PRECEDENCE[node.op]
		if node.op in LOGICAL:
			return f"{self.bound(node.left, level)} {LOGICAL[node.op]} {self.bound(node.right, level + .25)}", level
		if node.op in ("<<", ">>"):
			to = T.scalar(T.wider(left.name, "i32"))
			if isinstance(node.left, c_ast.Constant):
				return f"{to.name}({self.value(node.left)}) {node.op} {self.bound(node.right, 11)}", PRECEDENCE["<<"]
			return f"{self.as_type(node.left, to, 11)} {node.op} {self.bound(node.right, 11)}", PRECEDENCE["<<"]
		to = left if left.name == right.name == "bool" else T.scalar(T.wider(left.name, right.name))
		op = self.quotient(node.op, to)
		comparing = node.op in ("==", "!=", "<", ">", "<=", ">=")
		low = 8 if comparing else max(level, 2) if not node.op in "|^&" else UNARY
		right = self.as_type(node.right, to, low if comparing else low + 1)
		return f"{self.as_type(node.left, to, low)} {op} {right}", PRECEDENCE["=="] if comparing else level

	def quotient(self, op, to):
		if op != "/" or to.name == "f32":
			return op
		return "//"

	def of_pointers(self, node, left):
		if node.op in ("==", "!="):
			one, other = self.bound(node.left, 8), self.bound(node.right, 8)
			return f"{one} {'is' if node.op == '==' else 'is not'} {other}", PRECEDENCE["=="]
		return f"{self.bound(node.left, PRIMARY)}[{self.value(node.right)}:]", PRIMARY

	def of_TernaryOp(self, node):
		kind = self.tree.type_of(node)
		yes, no = self.as_type(node.iftrue, kind, TERNARY + 1), self.as_type(node.iffalse, kind)
		return f"{yes} if {self.bound(node.cond, TERNARY + 1)} else {no}", TERNARY

	def of_Cast(self, node):
		to, of = self.tree.type_of(node), self.tree.type_of(node.expr)
		if to.kind == "pointer" or to.name in ("void", of.name):
			return self.expression(node.expr)
		return self.converted(node.expr, of, to) if not isinstance(node.expr, c_ast.Constant) else \
			f"{to.name}({self.value(node.expr)})", PRIMARY

	def of_Assignment(self, node):
		"""Within another: before it."""
		self.put_Assignment(node)
		return self.place(node.lvalue), PRIMARY

	def of_ExprList(self, node):
		return ", ".join(self.value(each) for each in node.exprs), TERNARY


def root(node):
	while isinstance(node, (c_ast.StructRef, c_ast.ArrayRef)):
		node = node.name
	return node.name if isinstance(node, c_ast.ID) else None


def is_step(node):
	return isinstance(node, c_ast.UnaryOp) and node.op in ("++", "--", "p++", "p--")
