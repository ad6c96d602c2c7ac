# Two small images, and what judges the JUnit XML of a comparison. Read after tap.bash, in the root.
junit_schema=$(realpath tests/cli/junit.xsd)

# writes NAME: the PNG that the Python on standard input makes of `pixels`, 10 x 4 of [128, 128, 128].
writes() {
	cat > change.py && python3 - "$1" <<'PY'
import struct, sys, zlib
width, height = 10, 4
pixels = [[128, 128, 128] for _ in range(width * height)]
exec(open("change.py").read())
rows = b"".join(b"\0" + bytes(sum(pixels[y * width:(y + 1) * width], [])) for y in range(height))
def chunk(kind, data):
	return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
head = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2, 4: 6}[len(pixels[0])], 0, 0, 0)
open(sys.argv[1], "wb").write(b"\x89PNG\r\n\x1a\n"
                              + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
PY
}
# writes_exr NAME CHANNELS [BEGIN [WIDTH [FIRST]]]: black, 10 x 4, not compressed: header, offsets of rows, rows
# (OpenEXR's file layout). The first pixel stands at BEGIN,BEGIN of a picture of WIDTH x WIDTH; a channel I is of whole
# numbers, the first of which is FIRST.
writes_exr() {
	python3 - "$@" <<'PY'
import struct, sys
width, height, names = 10, 4, sys.argv[2]
begin, whole, first = (int(word) for word in (sys.argv[3:] + ["0", "0", "0"][len(sys.argv) - 3:]))
def attribute(name, kind, body):
	return f"{name}\0{kind}\0".encode() + struct.pack("<I", len(body)) + body
window = struct.pack("<4i", begin, begin, begin + width - 1, begin + height - 1)
shown = struct.pack("<4i", 0, 0, whole - 1, whole - 1) if whole else window
def channel(name):
	return name.encode() + struct.pack("<BIIII", 0, 0 if name == "I" else 2, 0, 1, 1)
channels = b"".join(map(channel, sorted(names))) + b"\0"
head = struct.pack("<II", 20000630, 2) + attribute("channels", "chlist", channels)
head += attribute("compression", "compression", b"\0")
head += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", shown)
head += attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
head += attribute("screenWindowCenter", "v2f", bytes(8))
head += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
row = 4 * width * len(names)
offsets = [len(head) + 8 * height + y * (row + 8) for y in range(height)]
rows = b"".join(struct.pack("<iI", begin + y, row) + struct.pack("<I", 0 if y else first) + bytes(row - 4)
                for y in range(height))
open(sys.argv[1], "wb").write(head + struct.pack(f"<{height}Q", *offsets) + rows)
PY
}
# writes_two: a.png, and b.png, of which 3 values of 2 pixels differ.
writes_two() {
	writes a.png <<< ''
	writes b.png <<< 'pixels[12][1], pixels[12][2], pixels[30][0] = 138, 148, 108'
}
# suits TESTS FAILURES ERRORS SKIPPED NAME: j.xml suits the schema and counts so many.
suits() {
	xmllint --noout --schema "$junit_schema" j.xml 2> lint && python3 - "${@:1:4}" <<'PY'
import sys, xml.dom.minidom
suite = xml.dom.minidom.parse("j.xml").documentElement
keys = ["tests", "failures", "errors", "skipped"]
assert [suite.getAttribute(k) for k in keys] == sys.argv[1:], [suite.getAttribute(k) for k in keys]
for key, element in zip(keys, ["testcase", "failure", "error", "skipped"]):
	assert len(suite.getElementsByTagName(element)) == int(suite.getAttribute(key)), key
PY
	verdict $? "$5"
}
