"""Statements of the kernels in GLSL, with their comments."""
from pycparser import c_ast

from .comments import comments
from .glsl_expressions import Expressions
from .glsl_words import below, is_own

COLUMNS = 120


class Statements(Expressions):
	"""guarded: loops tell when a driver ends them early, by ts_turn, ts_open and ts_looped of loops.glsl."""

	def __init__(self, tree, guarded):
		super().__init__(tree)
		self.guarded, self.breaks = guarded, []
		self.lines, self.depth, self.line, self.noted = [], 0, None, set()

	def put(self, text):
		self.lines.append("\t" * self.depth + text if text else "")

	def taken(self):
		lines, self.lines = self.lines, []
		return lines

	def statement(self, node):
		self.comment_above(node)
		at = len(self.lines)
		getattr(self, "put_" + type(node).__name__, self.put_expression)(node)
		if len(self.lines) == at + 1 and node.coord and node.coord.line != self.line:
			self.comment_behind(node)

	def comment_above(self, node):
		"""Once, though several statements stand on the line."""
		if not isinstance(node, c_ast.Compound) and node.coord and node.coord.line not in self.noted:
			self.noted.add(node.coord.line)
			self.documented(node)

	def comment_behind(self, node):
		lines = self.comments(node).behind.get(node.coord.line)
		if lines and "//" not in self.lines[-1]:
			self.lines[-1] += f" // {lines[0]}"

	def comments(self, node):
		return comments(node.coord.file.split("@")[0])

	def put_comment(self, lines):
		for line in lines:
			self.put(f"// {line}".rstrip())

	def put_expression(self, node):
		self.put(self.value(node) + ";")

	def put_Compound(self, node):
		self.put("{")
		self.inner(node.block_items or [])
		self.put("}")

	def inner(self, nodes):
		self.depth += 1
		for node in nodes:
			self.statement(node)
		self.depth -= 1

	def put_Decl(self, node):
		if not self.is_alias(node):
			self.put(self.declaration(node) + ";")

	def is_alias(self, node):
		"""A pointer to an item's own: a name for the thing itself, as long as that is found without an index."""
		if not is_own(self.tree.declaration(node.type)) or any(isinstance(each, c_ast.ArrayRef)
		                                                       for each in below(node.init)):
			return False
		self.aliases[node.name] = self.value(node.init)
		return True

	def declaration(self, node):
		kind = self.tree.declaration(node.type)
		if kind.kind == "array" and kind.length is None:
			kind = kind._replace(length=len(node.init.exprs))
		text = self.declared(kind, node.name)
		return text if node.init is None else f"{text} = {self.given(node.init, kind.of if is_own(kind) else kind)}"

	def put_DeclList(self, node):
		for each in node.decls:
			self.statement(each)

	def put_Return(self, node):
		self.put("return;" if node.expr is None else f"return {self.given(node.expr, self.returns)};")

	def put_If(self, node):
		self.put_headed(f"if ({self.value(node.cond)})", node.iftrue)
		if node.iffalse is None:
			return
		closes = self.lines[-1].strip() == "}"
		at = len(self.lines)
		if isinstance(node.iffalse, c_ast.If):
			self.put_If(node.iffalse)
		else:
			self.put_headed("", node.iffalse)
		first = self.lines[at].strip()
		if closes:
			self.lines[at - 1 : at + 1] = ["\t" * self.depth + f"}} else {first}".rstrip()]
		else:
			self.lines[at] = "\t" * self.depth + f"else {first}".rstrip()

	def put_headed(self, head, body):
		if isinstance(body, c_ast.Compound) or (self.guarded and isinstance(body, c_ast.Break)):
			self.put(f"{head} {{".lstrip())
			self.inner(body.block_items or [] if isinstance(body, c_ast.Compound) else [body])
			self.put("}")
			return
		at = len(self.lines)
		self.inner([body])
		if len(self.lines) == at + 1 and len(head) + len(self.lines[at].expandtabs(4)) < COLUMNS:
			self.lines[at] = "\t" * self.depth + f"{head} {self.lines[at].strip()}".lstrip()
		else:
			self.lines.insert(at, "\t" * self.depth + head)

	def put_While(self, node):
		if self.guarded:
			self.put_loop("", self.value(node.cond), "", node.stmt)
		else:
			self.put_headed(f"while ({self.value(node.cond)})", node.stmt)

	def put_For(self, node):
		first = "" if node.init is None else self.for_first(node.init)
		cond = "" if node.cond is None else self.value(node.cond)
		self.put_loop(first, cond, "" if node.next is None else self.value(node.next), node.stmt)

	def put_loop(self, first, cond, following, body):
		if self.guarded:
			cond = f"ts_turn({cond or 'true'})"
			following = ", ".join(filter(None, [following, "ts_open = true"]))
		self.breaks.append(True)
		head = "; ".join([first, cond, following]).replace("; ;", ";;")
		if self.guarded and not isinstance(body, c_ast.Compound):
			body = c_ast.Compound([body], body.coord)
		self.put_headed(f"for ({head})".replace("; )", ";)"), body)
		self.breaks.pop()
		if self.guarded:
			self.put("ts_looped();")

	def for_first(self, node):
		if not isinstance(node, c_ast.DeclList):
			return self.value(node)
		first, *others = [self.declaration(each) for each in node.decls]
		return ", ".join([first] + [text.split(" ", 1)[1] for text in others])

	def put_Switch(self, node):
		self.put(f"switch ({self.value(node.cond)}) {{")
		self.switch = self.tree.type_of(node.cond)
		self.breaks.append(False)
		for each in node.stmt.block_items:
			self.statement(each)
		self.breaks.pop()
		self.put("}")

	def put_Case(self, node):
		self.put(f"case {self.as_type(node.expr, self.switch)}:")
		self.inner(node.stmts)

	def put_Default(self, node):
		self.put("default:")
		self.inner(node.stmts)

	def put_Break(self, _):
		if self.guarded and self.breaks[-1]:
			self.put("ts_open = false;")
		self.put("break;")

	def put_Continue(self, _):
		self.put("continue;")

	def put_EmptyStatement(self, _):
		self.put(";")

	def documented(self, node):
		lines = self.comments(node).above.get(node.coord.line)
		if lines:
			self.put_comment(lines)
