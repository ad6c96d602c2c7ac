"""Modules of kernels as a C file, packed by zlib, as src/backends/modules.h unpacks them."""
import zlib

BYTES_A_LINE = 32


def show(maker, modules):
	"""Prints the modules, bytes each, in the order of the kernels."""
	packed = zlib.compress(b"".join(modules), 9)
	firsts = [sum(map(len, modules[:at])) for at in range(len(modules) + 1)]
	print(f"/* Made by {maker} from src/kernels. */")
	print(f"static const u32 first_byte[TS_N_KERNELS + 1] = {{{', '.join(map(str, firsts))}}};")
	print("static const u8 packed[] = {")
	for at in range(0, len(packed), BYTES_A_LINE):
		print("\t" + "".join(f"{byte}," for byte in packed[at : at + BYTES_A_LINE]))
	print("};")
