"""Where a function's body can be changed by one step, and to what; found by libclang. A place has a name that stands
while its line and its function do: `src/image/png.c take_data: if (n {< -> <=} 8) return 0;`."""
import collections
import re

from clang.cindex import CursorKind as Kind, Index, TranslationUnit, TypeKind

OPERATORS = {
	"boundary": {b"<": b"<=", b"<=": b"<", b">": b">=", b">=": b">", b"==": b"!=", b"!=": b"=="},
	"arithmetic": {b"+": b"-", b"-": b"+", b"*": b"/", b"/": b"*", b"%": b"/", b"&": b"|", b"|": b"&", b"<<": b">>",
	               b">>": b"<<", b"+=": b"-=", b"-=": b"+="},
	"logic": {b"&&": b"||", b"||": b"&&"},
}
# and: negated (a condition), constant (an integer plus or minus 1), deleted (a call or an assignment),
# returned (another value).
SWAPPED = {old: (name, new) for name, pairs in OPERATORS.items() for old, new in pairs.items()}
# Released twice or never: no test of this build sees that, but `make test config=asan` does.
RELEASES = re.compile(rb"\w*(free|close|release|destroy|unmap)\w*\(")
CONSTANT = (Kind.CXX_UNARY_EXPR, Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.STRUCT_DECL, Kind.LAMBDA_EXPR)
FUNCTIONS = (Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR)
SCOPES = (Kind.NAMESPACE, Kind.CLASS_DECL, Kind.STRUCT_DECL, Kind.LINKAGE_SPEC, Kind.UNEXPOSED_DECL)
FLOATS = (TypeKind.FLOAT, TypeKind.DOUBLE)
INTEGERS = (TypeKind.BOOL, TypeKind.ENUM, TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.UCHAR, TypeKind.SHORT,
            TypeKind.USHORT, TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG)

# Its name and operator; the bytes [start, end) become `text`; the line's number.
Place = collections.namedtuple("Place", "name operator start end text line")


def span(node):
	return node.extent.start.offset, node.extent.end.offset


def bare(node):
	"""Without what the compiler adds around."""
	while node.kind in (Kind.UNEXPOSED_EXPR, Kind.PAREN_EXPR):
		inner = list(node.get_children())
		if len(inner) != 1:
			break
		node = inner[0]
	return node


def is_pointer(node):
	return node.type.get_canonical().kind in (TypeKind.POINTER, TypeKind.CONSTANTARRAY, TypeKind.INCOMPLETEARRAY)


class Finder:
	def __init__(self, path, source, flags):
		self.path, self.source, self.places, self.function = path, source, [], ""
		self.unit = parse(path, source, flags)
		self.macros = [span(node) for node in self.unit.cursor.get_children()
		               if node.kind == Kind.MACRO_INSTANTIATION and self.is_here(node)]

	def is_here(self, node):
		return node.location.file is not None and node.location.file.name == self.path

	def find(self):
		self.scan(self.unit.cursor)
		count = collections.Counter()
		for place in self.places:
			count[place.name] += 1
			n = count[place.name]
			yield place._replace(name=f"{place.name} #{n}") if n > 1 else place

	def scan(self, scope):
		for node in scope.get_children():
			if node.kind in SCOPES and self.is_here(node):
				self.scan(node)
			elif node.kind in FUNCTIONS and node.is_definition() and self.is_here(node):
				self.function = node.spelling
				for body in node.get_children():
					if body.kind == Kind.COMPOUND_STMT:
						self.visit(body)

	def visit(self, node):
		if node.kind in CONSTANT or (node.kind == Kind.VAR_DECL and node.storage_class.name == "STATIC"):
			return
		children = list(node.get_children())
		pragma = self.pragma(node)
		if b"atomic" in pragma:
			return
		if node.kind == Kind.VAR_DECL:
			children = [child for child in children if span(child)[0] > node.location.offset
			            and not self.is_size(child)]
		elif node.kind == Kind.CASE_STMT or (pragma and node.kind == Kind.FOR_STMT):
			children = children[-1:]
		self.take(node, children)
		for i, child in enumerate(children):
			if is_statement(node, i, len(children)):
				self.delete(child)
			self.visit(child)

	def is_size(self, child):
		return self.source[:span(child)[0]].rstrip().endswith(b"[")

	def pragma(self, node):
		"""Of OpenMP, before the statement."""
		if not node.kind.is_statement() and node.kind not in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR,
		                                                      Kind.UNARY_OPERATOR):
			return b""
		before = self.source[:span(node)[0]].rstrip().rsplit(b"\n", 1)[-1].strip()
		return before if before.startswith(b"#pragma omp") else b""

	def take(self, node, children):
		kind = node.kind
		if kind in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR) and len(children) == 2:
			self.swap(node, *children)
		elif kind in (Kind.IF_STMT, Kind.CONDITIONAL_OPERATOR) and children[0].kind.is_expression():
			start, end = span(children[0])
			self.add("negated", start, end, b"!(%s)" % self.source[start:end], start, start, b"!")
		elif kind == Kind.INTEGER_LITERAL:
			self.step(node)
		elif kind == Kind.UNEXPOSED_EXPR and is_pointer(node):
			children[:] = [child for child in children if child.kind != Kind.INTEGER_LITERAL]
		elif kind == Kind.RETURN_STMT and children:
			self.change_return(children[0])

	def swap(self, node, left, right):
		(start, gap), (after, end) = span(left), span(right)
		sign = self.source[gap:after].strip()
		name, new = SWAPPED.get(sign, (None, None))
		if name is None or (name == "arithmetic" and is_pointer(bare(right))):
			return
		at = self.source.index(sign, gap)
		text = self.source[start:at] + new + self.source[at + len(sign):end]
		self.add(name, start, end, text, at, at + len(sign), new)

	def step(self, node):
		start, end = span(node)
		text = self.source[start:end]
		digits = re.match(rb"(0[xX][0-9a-fA-F]+|\d+)([uUlL]*)$", text)
		if digits:
			value = int(digits[1], 16 if digits[1][:2].lower() == b"0x" else 8 if digits[1][:1] == b"0" else 10)
			value += -1 if value > 0 and start % 2 else 1
			self.add("constant", start, end, b"%d%s" % (value, digits[2]), start, end)

	def delete(self, node):
		start, end = span(node)
		kind = bare(node).kind
		if kind == Kind.BINARY_OPERATOR and re.search(rb"[^=<>!]=[^=]", self.source[start:end]) is None:
			return
		if kind in (Kind.CALL_EXPR, Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR) or (
				kind == Kind.UNARY_OPERATOR and self.source[start:end].strip(b"();")[-2:] in (b"++", b"--")):
			if not RELEASES.match(self.source[start:end]):
				self.add("deleted", start, end, b"", start, end)

	def change_return(self, node):
		start, end = span(node)
		kind, text = node.type.get_canonical().kind, self.source[start:end]
		if kind == TypeKind.POINTER and text not in (b"NULL", b"nullptr"):
			self.add("returned", start, end, b"0", start, end)
		elif kind in FLOATS:
			self.add("returned", start, end, b"(%s) + 1" % text, start, end)
		elif kind in INTEGERS:
			self.add("returned", start, end, b"!(%s)" % text, start, start, b"!")

	def add(self, operator, start, end, text, shown, shown_end, shown_text=None):
		inside = lambda at: any(a < at < b for a, b in self.macros)
		if inside(start) or inside(end) or any(a <= start and end <= b and (a, b) != (start, end)
		                                       for a, b in self.macros):
			return
		source = self.source
		first = source.rfind(b"\n", 0, shown) + 1
		last = source.find(b"\n", shown_end)
		new = text if shown_text is None else shown_text
		line = b"%s{%s -> %s}%s" % (source[first:shown], source[shown:shown_end], new, source[shown_end:last])
		line = " ".join(line.decode().split())
		name = f"{self.path} {self.function}: {line}"
		self.places.append(Place(name, operator, start, end, text.decode(), source.count(b"\n", 0, shown) + 1))


def is_statement(parent, i, n):
	if parent.kind in (Kind.FOR_STMT, Kind.WHILE_STMT, Kind.CASE_STMT, Kind.DEFAULT_STMT):
		return i == n - 1
	return parent.kind == Kind.COMPOUND_STMT or (parent.kind == Kind.IF_STMT and i > 0)


def parse(path, source, flags):
	return Index.create().parse(path, flags, [(path, source.decode())],
	                            TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)


def find(path, source, flags):
	return list(Finder(path, source, flags).find())


def compiles(path, source, flags):
	return not any(note.severity >= 3 for note in parse(path, source, flags).diagnostics)


# What stands before the text of a file with switches.
DECLARED = b"""#if defined __GNUC__ && !defined __clang__
#pragma GCC optimize("O1") /* sooner built */
#endif
#ifdef __cplusplus
extern "C" {
#endif
extern int ts_mutant;
extern unsigned char *ts_mutants_reached;
#ifdef __cplusplus
}
#endif
#define TS_MUTANT(n) (ts_mutants_reached[n] || (ts_mutants_reached[n] = 1), ts_mutant == n)
#line 1
"""
# And, once a program or library, what reads TS_MUTANT=NUMBER, and TS_MUTANTS_REACHED=FILE, whose bytes are set by the
# places passed.
DEFINED = b"""
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
static unsigned char unmapped[%d];
int ts_mutant = -1;
unsigned char *ts_mutants_reached = unmapped;
__attribute__((constructor(101))) static void begin_mutants(void)
{
	const char *number = (getenv)("TS_MUTANT"), *path = (getenv)("TS_MUTANTS_REACHED");
	if (number) ts_mutant = atoi(number);
	int file = path ? open(path, O_RDWR | O_CLOEXEC) : -1;
	void *bytes = file >= 0 ? mmap(NULL, sizeof unmapped, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
	if (bytes != MAP_FAILED) ts_mutants_reached = bytes;
}
"""


def switched(source, places):
	"""The text of a file with numbered places, [(number, place)], behind their switches."""
	for number, place in sorted(places, key=lambda item: -item[1].start):
		old = source[place.start:place.end]
		if place.operator == "deleted":
			text = b"(TS_MUTANT(%d) ? (void)0 : (void)(%s))" % (number, old)
		else:
			text = b"(TS_MUTANT(%d) ? (%s) : (%s))" % (number, place.text.encode(), old)
		source = source[:place.start] + text + source[place.end:]
	return DECLARED + source
