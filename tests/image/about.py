"""Prints what the pictures say about themselves: PICTURE NAME=TEXT, a line each, of the text chunks of a PNG (PNG 1.2,
section 4.2.3) and of the string attributes of an EXR (OpenEXR's file layout). A time is printed as well."""
import struct
import sys


def png(data):
	at = 8
	while at < len(data):
		size, kind = struct.unpack_from(">I4s", data, at)
		body = data[at + 8:at + 8 + size]
		if kind == b"tEXt":
			yield body.split(b"\0", 1)
		elif kind in (b"zTXt", b"iTXt", b"tIME"):
			yield kind, body
		at += 12 + size


def exr(data):
	at = 8
	while data[at] != 0:
		name, kind = data[at:].split(b"\0", 2)[:2]
		at += len(name) + len(kind) + 2
		size, = struct.unpack_from("<I", data, at)
		if kind == b"string":
			yield name, data[at + 4:at + 4 + size]
		at += 4 + size


for path in sys.argv[1:]:
	with open(path, "rb") as file:
		whole = file.read()
	for title, text in (png if path.endswith(".png") else exr)(whole):
		print(f"{path} {title.decode()}={text.decode()}")
