#!/bin/bash
# Arithmetic vectors: written as a whole, read by others, and judged exactly; a folder that cannot be judged is refused.
. "$(dirname "$0")/tap.bash"
cd "$scratch" || exit 1

# poke FILE OFFSET VALUE: turns bits of one byte, counted from the end of the file.
poke() {
	python3 - "$@" << 'END'
import sys
name, offset, bits = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
data = bytearray(open(name, "rb").read())
data[len(data) - offset] ^= bits
open(name, "wb").write(data)
END
}

run vectors -o v
n=$(python3 -c 'import json; print(len(json.load(open("v/vectors.json"))["primitives"]))')
[ "$status" -eq 0 ] && [ "$n" -ge 50 ] && [ "$(ls v | wc -l)" -eq $((2 * n + 1)) ] &&
	grep -q "^$n primitives of 4096" stdout
verdict $? "-o writes $n primitives and their description"
[ ! -e v.partial ]
verdict $? 'and nothing else'

python3 - << 'END'
import ast, json, math, struct
index = json.load(open("v/vectors.json"))
sizes = {"<f4": "f", "<i4": "i", "<u4": "I", "<i8": "q", "<u8": "Q"}
def load(part):
    data = open("v/" + part["file"], "rb").read()
    assert data[:8] == b"\x93NUMPY\x01\x00"
    (n,) = struct.unpack("<H", data[8:10])
    header = ast.literal_eval(data[10:10 + n].decode())
    dtype = ast.literal_eval(part["dtype"]) if part["dtype"][0] == "[" else part["dtype"]
    assert header == {"descr": dtype, "fortran_order": False, "shape": tuple(part["shape"])}
    fields = header["descr"] if isinstance(dtype, list) else [("", dtype)]
    row = "<" + "".join(sizes[f[1]] * (f[2][0] if len(f) > 2 else 1) for f in fields)
    row = row if isinstance(dtype, list) else row[0] + row[1] * math.prod(part["shape"][1:])
    return list(struct.iter_unpack(row, data[10 + n:]))
f32 = lambda x: struct.unpack("<f", struct.pack("<f", x))[0]
for p in index["primitives"]:
    rows, results = load(p["in"]), load(p["out"])
    assert len(rows) == len(results) == index["items"]
    if p["name"] == "mul":
        assert all(f32(a * b) == r for (a, b), (r,) in zip(rows, results))
    if p["name"] == "edge":
        assert all((c - a) * (f - b) - (d - b) * (e - a) == r for (a, b, c, d, e, f), (r,) in zip(rows, results))
END
verdict $? 'their headers say what vectors.json says, and what is in them is right'

if python3 -c 'import numpy' 2> /dev/null; then
	python3 - << 'END'
import ast, json, numpy
for p in json.load(open("v/vectors.json"))["primitives"]:
    rows, results = numpy.load("v/" + p["in"]["file"]), numpy.load("v/" + p["out"]["file"])
    dtype = ast.literal_eval(p["out"]["dtype"]) if p["out"]["dtype"][0] == "[" else p["out"]["dtype"]
    assert rows.shape == (4096,) and list(results.shape) == p["out"]["shape"] and results.dtype == dtype
    if p["name"] == "add":
        assert (rows["a"] + rows["b"] == results).all()
END
	verdict $? 'numpy reads them'
else
	tests=$((tests + 1))
	echo "ok $tests - numpy reads them # SKIP no numpy"
fi

run vectors --check v
[ "$status" -eq 0 ] && grep -q "^$n primitives right, 0 wrong, 0 not there" stdout
verdict $? '--check passes what -o wrote'
refuses 'not empty' vectors -o v
echo mine > v/mine
refuses 'holds mine' vectors -o v --force
rm v/mine
run vectors -o v --force
[ "$status" -eq 0 ] && run vectors --check v && [ "$status" -eq 0 ]
verdict $? '--force replaces earlier vectors'

mkdir port && cp v/dot.out.npy v/muladd.out.npy port
prints "^2 primitives right, 0 wrong, $((n - 2)) not there" vectors --check port
poke port/dot.out.npy $((4 * 96)) 1
run vectors --check port
[ "$status" -eq 1 ] && grep -q '^dot, item 4000, the first of 1 wrong' stdout && grep -q 'apart  *[-+]1 ulp' stdout &&
	grep -q '^1 primitives right, 1 wrong' stdout
verdict $? 'one wrong bit is found, by primitive and item'
for line in '  a  *[-0-9].* [-]*0x.*(........), ' '  b ' '  expected ' '  found ' '  fault '; do
	grep -q "^$line" stdout
	verdict $? "and told: $line"
done
run vectors --check port --json
[ "$status" -eq 1 ] && python3 - << 'END'
import json
r = json.load(open("stdout"))
first = r["first_wrong"][0]
assert (r["right"], r["wrong"]) == (1, 1) and len(r["first_wrong"]) == 1
assert (first["primitive"], first["item"], abs(first["apart"])) == ("dot", 4000, 1)
assert [len(first["in"][k]) for k in "ab"] == [3, 3] and first["expected"] != first["found"]
assert [p["wrong"] for p in r["primitives"] if p["primitive"] == "dot"] == [1]
END
verdict $? 'and in JSON'

# Of a record the column is named.
mkdir record && cp v/light.out.npy record && poke record/light.out.npy 4 1
run vectors --check record
[ "$status" -eq 1 ] && grep -q '^light, item 4095, the first of 1 wrong' stdout &&
	grep -q 'apart .* ulp in arrives$' stdout &&
	grep -q '^  expected l  *[-0-9]' stdout && grep -q '^  found arrives  *[-0-9]' stdout
verdict $? 'a wrong column of a record is named'

# A port that fuses, one that flushes and one that multiplies by reciprocals, in exact arithmetic of fractions.
python3 - << 'END'
import math, struct
from fractions import Fraction
def load(name, row):
    data = open("v/" + name, "rb").read()
    at = 10 + struct.unpack("<H", data[8:10])[0]
    return data[:at], list(struct.iter_unpack(row, data[at:]))
def f32(x):
    """To the nearest float, ties to even: from a fraction."""
    if x == 0: return 0.0
    e = max(-149, abs(x.numerator).bit_length() - x.denominator.bit_length() - 25) # or up to two more
    while abs(x) / Fraction(2) ** e >= 2 ** 24: e += 1
    return math.copysign(float(round(x / Fraction(2) ** e) * Fraction(2) ** e), x)
def save(name, head, values):
    open("port/" + name, "wb").write(head + b"".join(struct.pack("<f", v) for v in values))
head, out = load("muladd.out.npy", "<f")
fused = []
for (a, b, c), (r,) in zip(load("muladd.in.npy", "<fff")[1], out):
    exact = Fraction(a) * Fraction(b) + Fraction(c)
    fused.append(r if exact == 0 or abs(exact) >= Fraction(2) ** 127 else f32(exact))
save("muladd.out.npy", head, fused)
head, out = load("add.out.npy", "<f")
tiny = 2.0 ** -126
flush = lambda x: x if abs(x) >= tiny else x * 0.0
save("add.out.npy", head, [flush(f32(Fraction(flush(a)) + Fraction(flush(b)))) if max(abs(a), abs(b)) < 1 and flush(a) +
    flush(b) != 0 else r for (a, b), (r,) in zip(load("add.in.npy", "<ff")[1], out)])
head, out = load("div.out.npy", "<f")
save("div.out.npy",
     head, [f32(Fraction(a) * Fraction(f32(1 / Fraction(b)))) if a != 0 and 2.0 ** -60 < abs(a) < 2.0 ** 60
    and 2.0 ** -60 < abs(b) < 2.0 ** 60 else r for (a, b), (r,) in zip(load("div.in.npy", "<ff")[1], out)])
END
verdict $? 'three faults are planted'
run vectors --check port
for fault in 'muladd .*fused multiply-add' 'add .*flush to zero' 'div .*reciprocal division'; do
	[ "$status" -eq 1 ] && grep -q "^$fault" stdout
	verdict $? "named: $fault"
done
awk '/fused multiply-add|flush to zero|reciprocal division/ && NF >= 6 && $1 ~ /^(muladd|add|div)$/ {
		if ($3 != $NF) bad = 1
		n++
	}
	END { exit bad || n != 3 }' stdout
verdict $? 'and each explains every wrong item'

mkdir bad && cp v/add.out.npy bad && truncate -s -1 bad/add.out.npy
refuses 'bad/add.out.npy: 16383 bytes of data; its shape needs 16384' vectors --check bad
truncate -s 40 bad/add.out.npy
refuses 'bad/add.out.npy: not a .npy' vectors --check bad
: > bad/add.out.npy
refuses 'bad/add.out.npy: not a .npy' vectors --check bad
cp v/i32_to_f32.out.npy bad/add.out.npy && sed -i 's/<f4/<f8/' bad/add.out.npy
refuses "bad/add.out.npy: dtype '<f8'; '<f4' would be right" vectors --check bad
cp v/add.out.npy bad && sed -i 's/(4096,), }/(64, 64),}/' bad/add.out.npy
refuses 'bad/add.out.npy: shape (64, 64); (4096,) would be right' vectors --check bad
cp v/add.out.npy bad && sed -i 's/False/True /' bad/add.out.npy
refuses 'Fortran order' vectors --check bad
rm bad/add.out.npy && mkdir bad/add.out.npy
refuses 'not a regular file' vectors --check bad
rmdir bad/add.out.npy && mkfifo bad/add.out.npy
refuses 'not a regular file' vectors --check bad
rm bad/add.out.npy && cp v/add.out.npy bad/ad.out.npy
refuses 'no primitive "ad"; the nearest is add' vectors --check bad
rm bad/ad.out.npy && cp v/add.* bad && poke bad/add.in.npy 1 1
refuses 'bad/add.in.npy: not the inputs of this version' vectors --check bad
cp v/* bad && sed -i 's/"contract": 1/"contract": 7/' bad/vectors.json
refuses 'contract 7; this is touchstone .* of contract 1' vectors --check bad
echo '{}' > bad/vectors.json
refuses 'no "contract" in it' vectors --check bad
mkdir empty
refuses 'no PRIMITIVE.out.npy there' vectors --check empty
refuses 'Not a directory' vectors --check v/vectors.json
refuses 'No such file' vectors --check nowhere
refuses 'write them with -o DIR, or judge' vectors
refuses 'write them with -o DIR, or judge' vectors -o w --check v
refuses 'leave --force out' vectors --check v --force
refuses 'needs a value' vectors --check
refuses 'write them with -o DIR' vectors add
"$touchstone" vectors --check v > /dev/full 2> stderr
[ $? -eq 2 ] && [ "$(wc -l < stderr)" -eq 1 ] && grep -q 'No space left' stderr
verdict $? 'a full standard output is an error'

run vectors mul add -o "$scratch/two"
[ "$status" -eq 0 ] &&
	[ "$(cd "$scratch/two" && echo *)" = 'add.in.npy add.out.npy mul.in.npy mul.out.npy vectors.json' ] &&
	[ "$(grep -c '"rule"' "$scratch/two/vectors.json")" -eq 2 ]
verdict $? 'the primitives that are named'
refuses 'no primitive "ad"; the nearest is add' vectors ad -o "$scratch/none"
refuses 'judges all that are there; leave "add" out' vectors add --check "$scratch/two"
finish
