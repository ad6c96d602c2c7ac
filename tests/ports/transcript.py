#!/usr/bin/python3
"""Runs the transcripts of a document: in blocks marked `console`, lines that begin with "$ " are commands, the others
what they print. All run in the folder that this is started in, in order. Prints TAP.

	transcript.py [--write] FILE     --write puts what was printed into the file"""
import re
import subprocess
import sys


def run(command):
	done = subprocess.run(["bash", "-c", command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
	return done.stdout.decode("utf-8").rstrip("\n")


def main():
	write, path = sys.argv[1:-1] == ["--write"], sys.argv[-1]
	n = failed = 0

	def again(block):
		nonlocal n, failed
		out = []
		for command, right in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block.group(2), re.M):
			found = run(command)
			found += "\n" if found else ""
			n += 1
			failed += found != right
			print(f"{'ok' if found == right else 'not ok'} {n} - {command}")
			if found != right:
				print("".join(f"# {line}\n" for line in found.splitlines()), end="")
			out.append(f"$ {command}\n{found}")
		return block.group(1) + "".join(out) + block.group(3)

	with open(path, encoding="utf-8") as file:
		text = file.read()
	text = re.sub(r"^(```console\n)(.*?)(^```$)", again, text, flags=re.M | re.S)
	if write:
		with open(path, "w", encoding="utf-8") as file:
			file.write(text)
	print(f"1..{n}")
	return 1 if failed and not write else 0


sys.exit(main())
