"""Prints the names of the functions in a little-endian 32-bit ELF, a line each."""
import struct
import sys

data = open(sys.argv[1], "rb").read()
offset, = struct.unpack_from("<I", data, 32)
size, count = struct.unpack_from("<HH", data, 46)
sections = [struct.unpack_from("<10I", data, offset + i * size) for i in range(count)]
for section in sections:
    if section[1] != 2:  # SHT_SYMTAB
        continue
    strings = sections[section[6]][4]
    for at in range(section[4], section[4] + section[5], 16):
        name, _, _, info = struct.unpack_from("<IIIB", data, at)
        if info & 15 == 2:  # STT_FUNC
            print(data[strings + name : data.index(b"\0", strings + name)].decode())
