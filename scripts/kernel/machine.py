"""The machine code of a build against the allow-lists of tests/kernels/objects, one per processor: the instructions
that touch floats where numbers of buffers are made, and what the objects of the C backend call from outside."""
import glob
import os
import re
import shutil
import struct
import subprocess
from functools import lru_cache

LISTS = "tests/kernels/objects"
DOUBLES = LISTS + "/doubles.txt"
BACKEND = "src/backends/c/"
# Of the host, which may compute in double; the faults of ports, which vectors.c has on purpose, are for no buffer.
HOST = re.compile(r"src/(model|scene|methods)/(?!.*(/tools/|/vectors\.c))")
# By the number that ELF has for a processor: its list, and whose binutils read its code.
PROCESSORS = {
	3: ("i686", "i686-linux-gnu"),
	21: ("powerpc64le", "powerpc64le-linux-gnu"),
	22: ("s390x", "s390x-linux-gnu"),
	40: ("arm", "arm-linux-gnueabihf"),
	62: ("x86_64", "x86_64-linux-gnu"),
	183: ("aarch64", "aarch64-linux-gnu"),
	243: ("riscv64", "riscv64-linux-gnu"),
}


def rows(path):
	"""Lines without comments, with their numbers."""
	with open(path, encoding="utf-8") as file:
		lines = [(number, re.sub(r"(^|\s+)#.*", "", line.rstrip("\n"))) for number, line in enumerate(file, 1)]
	return [(number, line) for number, line in lines if line]


class List:
	"""Patterns of whole instructions, mnemonic and operands; without a space, of mnemonics.
	`used`: the lines that were needed."""

	def __init__(self, name):
		self.path = f"{LISTS}/{name}.txt"
		self.sections, self.used = {}, set()
		for number, line in rows(self.path):
			if line.endswith(":"):
				section = self.sections.setdefault(line[:-1], [])
			else:
				section.append((number, line))
		self.patterns = {name: self.pattern(lines) for name, lines in self.sections.items()}

	@staticmethod
	def pattern(lines):
		return re.compile("|".join(f"(?P<line{number}>(?:{line}){'' if ' ' in line else '(?: .*)?'})"
		                           for number, line in lines))

	@lru_cache(maxsize=None)
	def has(self, section, text):
		match = self.patterns[section].fullmatch(text)
		if match:
			self.used.add(int(match.lastgroup[4:]))
		return bool(match)

	def unneeded(self):
		allowed = self.sections["floats"] + self.sections["doubles"] + self.sections["imports"]
		return [f"{self.path}:{number}: nothing needs `{line}`" for number, line in allowed if number not in self.used]


def processor(path):
	"""The list and the binutils of an object's processor."""
	with open(path, "rb") as file:
		head = file.read(20)
	number = struct.unpack(">H" if head[5:6] == b"\2" else "<H", head[18:20])[0] if head[:4] == b"\x7fELF" else None
	return PROCESSORS.get(number, (None, None))


def output(system, tool, *arguments):
	command = [shutil.which(f"{system}-{tool}") or tool, *arguments]
	return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout


def instructions(system, objects):
	"""Yields (object, function, instruction): its words, without comments and names of places."""
	path = function = None
	for line in output(system, "objdump", "-d", "--no-show-raw-insn", *objects).splitlines():
		if line.startswith(" ") and "\t" in line:
			text = re.sub(r"^\{\w+\} |[0-9a-f]+ <.*|\s(?:#|//|;|@ ).*", "", line.split("\t", 1)[1])
			yield path, function, " ".join(text.split())
		elif line.endswith(">:") and "<.L" not in line:
			function = line.split("<")[1][:-2]
		elif ":     file format" in line:
			path = line.split(":")[0]


def imports(system, objects):
	"""Yields (object, name)."""
	for line in output(system, "nm", "-A", "--undefined-only", *objects).splitlines():
		yield line.split(":")[0], line.split()[-1]


def sources(folder):
	"""Of each object that makes numbers of buffers."""
	found = {}
	for path in sorted(glob.glob(f"{folder}/obj/src/**/*.o", recursive=True)):
		source = os.path.relpath(path, f"{folder}/obj").removesuffix(".o")
		if source.startswith(BACKEND) or HOST.match(source):
			found[path] = source
	return found


class Code:
	"""The code of builds; after some of them, what of the lists none of them needed."""

	def __init__(self):
		self.lists, self.doubles = {}, set()
		self.exempt = {line.split(": ")[0]: number for number, line in rows(DOUBLES)}

	def faults(self, folder):
		"""What the objects below folder/obj/src do that no list allows: one line for each function and instruction."""
		source = sources(folder)
		objects = list(source)
		name, system = processor(objects[0]) if objects else (None, None)
		if name is None:
			return [f"{folder}/obj/src: no objects of a processor that {LISTS} has a list for"]
		allowed, found = self.lists.setdefault(name, List(name)), {}
		touching = [each for each in instructions(system, objects) if allowed.has("touches", each[2])]
		for path, function, text in touching:
			if not allowed.has("floats", text) and not self.is_double(allowed, source[path], text):
				found.setdefault((source[path], function, text.split()[0]), f"{source[path]}: {function}: {text}")
		for path, symbol in imports(system, [path for path in objects if source[path].startswith(BACKEND)]):
			if not allowed.has("imports", symbol):
				found[path, symbol] = f"{source[path]}: {symbol} is called from outside"
		none = [] if touching or found else [f"{folder}/obj/src: no instruction on floats, as in objects of -flto"]
		return [*found.values(), *none]

	def is_double(self, allowed, source, text):
		"""An instruction of doubles, where these are allowed: not in the backend, but for those of doubles.txt."""
		if source.startswith(BACKEND) and source not in self.exempt:
			return False
		is_double = allowed.has("doubles", text)
		if is_double:
			self.doubles.add(source)
		return is_double

	def unneeded(self):
		lines = sum((each.unneeded() for each in self.lists.values()), [])
		return lines + [f"{DOUBLES}:{number}: {source} has no doubles" for source, number in self.exempt.items()
		                if source not in self.doubles]
