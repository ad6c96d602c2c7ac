"""Prints a PTX module as C: a statement for each instruction, whose meaning is the function of its name in
instructions.h. What is not known there does not compile. Usage: ptx.py < MODULE.ptx > MODULE.c"""
import re
import sys

OPERAND = re.compile(r"\{[^}]*\}|\[[^\]]*\]|\([^)]*\)|[^\s,{}\[\]()]+")
REGISTERS = {"p": "bool", "rs": "u16", "r": "u32", "rd": "u64", "f": "f32", "SP": "u64", "SPL": "u64"}
SPECIAL = {"%ctaid.x": "ctaid", "%ntid.x": "ntid", "%tid.x": "tid"}
HIGH = re.compile(r"\{ \.reg \.b32 tmp; mov\.b64 \{tmp, (%r\d+)\}, (%rd\d+); \}")  # by newer clangs
BYTES = {"8": 1, "16": 2, "32": 4, "64": 8}


class Refused(Exception):
	"""What the translation does not know."""


def name_of(register):
	return "_" + register[1:]


def is_float(word):
	return re.fullmatch(r"%f\d+", word) is not None


def value(word, kind):
	"""An operand as C, of the type that the instruction takes."""
	if word in SPECIAL:
		return SPECIAL[word]
	if re.fullmatch(r"0f[0-9A-F]{8}", word):
		return f"u2f(0x{word[2:]}u)"
	if word.startswith("%"):
		bits = is_float(word) and kind != "f32"
		return f"f2u({name_of(word)})" if bits else name_of(word)
	return word if re.fullmatch(r"-?\d+", word) else f"(u64){word}"


def address(word, offset=0):
	"""What stands in brackets: a register or a symbol, and a number of bytes."""
	base, _, more = word[1:-1].partition("+")
	return f"{value(base, 'u64')} + {int(more or 0) + offset}"


def assignment(word, kind, expression):
	target = name_of(word)
	return f"{target} = u2f({expression});" if is_float(word) and kind != "f32" else f"{target} = {expression};"


def elements(word):
	return OPERAND.findall(word[1:-1]) if word.startswith("{") else [word]


def transfer(words, operands):
	"""ld and st, also of vectors; the space of memory does not matter, as all addresses are generic."""
	kind = words[-1]
	how = "_volatile" if "volatile" in words else ""
	place, named = (operands[1], operands[0]) if words[0] == "ld" else operands[:2]
	lines = []
	for i, word in enumerate(elements(named)):
		at = address(place, i * BYTES[kind[1:]])
		if words[0] == "ld":
			lines.append(assignment(word, kind, f"ld{how}_{kind}({at})"))
		else:
			lines.append(f"st{how}_{kind}({at}, {value(word, kind)});")
	return " ".join(lines)


def call(operands):
	"""Its results, its function and its parameters are blocks of bytes."""
	named = [operand for operand in operands if not operand.startswith("(")]
	blocks = [word for operand in operands if operand.startswith("(") for word in OPERAND.findall(operand[1:-1])]
	return f"{named[0]}({', '.join(blocks)});"


def statement(text):
	"""One instruction without its semicolon."""
	guard = re.match(r"@(!?)%(p\d+) ", text)
	opcode, _, rest = text[guard.end() if guard else 0 :].partition(" ")
	words, operands = opcode.split("."), OPERAND.findall(rest)
	if words[0] == "bra":
		made = f"goto {operands[0]};"
	elif words[0] == "ret":
		made = "return;"
	elif words[0] == "call":
		made = call(operands)
	elif words[0] in ("ld", "st"):
		made = transfer(words, operands)
	else:
		arithmetic = [word for word in words if word not in ("global", "local")]
		sources = [address(operand) if operand.startswith("[") else value(operand, words[-1])
		           for operand in operands[1:]]
		first = words[-2] if words[0] == "cvt" else words[-1]
		made = assignment(operands[0], first, f"{'_'.join(arithmetic)}({', '.join(sources)})")
	return f"if ({guard.group(1)}_{guard.group(2)}) {made}" if guard else made


def parameters(text):
	return re.findall(r"\.param\s+(?:\.align \d+\s+)?\.\w+\s+(\w+)(?:\[\d+\])?", text or "")


def block(text):
	"""`.param` or `.local` inside a function, as bytes."""
	found = re.fullmatch(r"\.(param|local)\s+(?:\.align \d+\s+)?\.[bu](\d+)\s+(\w+)(?:\[(\d+)\])?", text)
	if found is None:
		raise Refused(text)
	space, bits, name, count = found.groups()
	n_bytes = BYTES[bits] * int(count or 1)
	unset = f" memset({name}, 0xa5, sizeof {name});" if space == "local" else ""
	return f"_Alignas(16) u8 {name}[{n_bytes}];{unset}"


def body(text):
	"""What stands between the braces of a function."""
	registers = sorted(set(re.findall(r"%((?:p|rs|rd|r|f)\d+|SPL?)\b", text)))
	yield "".join(f"{REGISTERS[re.sub(r'[0-9]', '', name)]} _{name}; " for name in registers)
	for part in re.findall(r"\s*([{}]|[$\w]+:|[^{};]+(?:\{[^{};]*\}[^{};]*)*;)", text[: text.rindex("}")]):
		part = " ".join(part.rstrip(";").split())
		if part in "{}" or part.endswith(":"):
			yield part + (";" if part.endswith(":") else "")
		elif part.startswith((".param", ".local")):
			yield block(part)
		elif not part.startswith((".reg", ".pragma")):
			yield statement(part)


def function(part):
	"""A .func or an .entry: its results and parameters are blocks of bytes."""
	head, brace, rest = part.partition("{")
	found = re.match(r"\.(?:visible )?\.?(func|entry)\s+(\([^)]*\)\s*)?(\w+)\s*(\([^)]*\))?", head)
	kind, result, name, given = found.groups()
	names = parameters(result) + parameters(given)
	if kind == "entry":
		yield f"void {name}(u8 **given, u32 ctaid, u32 ntid, u32 tid) {{"
		yield from (f"u8 *{parameter} = given[{i}];" for i, parameter in enumerate(names))
	else:
		given = ", ".join("u8 *" + parameter for parameter in names) or "void"
		yield f"static void {name}({given})" + (" {" if brace else ";")
	if brace:
		yield from body(rest)
		yield "}"


def parameter_sizes(part):
	"""Of an entry, for the driver, which copies them: ended by 0."""
	name = re.match(r"\.visible \.entry (\w+)", part).group(1)
	found = re.findall(r"\.param\s+(?:\.align \d+\s+)?\.[bu](\d+)\s+\w+(?:\[(\d+)\])?", part.partition("{")[0])
	sizes = [str(BYTES[bits] * int(count or 1)) for bits, count in found]
	return f"const u32 {name}_sizes[] = {{{', '.join(sizes)}, 0}};"


def main():
	text = HIGH.sub(r"mov.high.b64 \1, \2;", re.sub(r"//.*", "", sys.stdin.read()))
	head, *parts = re.split(r"^(?=\.(?:func|visible|const)\b)", text, flags=re.M)
	if re.search(r"^\.target sm_\d+$", head, re.M) is None or re.search(r"^\.address_size 64$", head, re.M) is None:
		raise Refused(head)
	print('#include "instructions.h"')
	for part in parts:
		if part.startswith(".const"):
			print(re.sub(r"^\.const \.align (\d+) \.b8", r"_Alignas(\1) static const u8", part).strip())
			continue
		for line in function(part):
			print(line)
		if ".entry" in part:
			print(parameter_sizes(part))


if __name__ == "__main__":
	try:
		main()
	except (Refused, AttributeError, KeyError, IndexError) as error:
		sys.exit(f"ptx.py: not known: {error}")
