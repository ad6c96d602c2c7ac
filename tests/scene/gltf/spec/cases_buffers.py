"""Buffers, buffer views and accessors."""
from document import GONE, data, data_uri, edit, glb, pack, view
from judges import BASE, MAY, MUST, SHOULD, Chapter, ignored, noted, pixels, refused, same
from scenes import (CORNERS, FOUR, STILL, base, buffer_in, buffered, colours, first_position, moving, octets,
                    shared_view, sparse, sparse_indices, strided, unaligned_in_view)

CHAPTER = Chapter("3.6: buffers and accessors")
row = CHAPTER.row

row("3.6.1.1", MUST, "data are little-endian", "little_endian",
    base(), pixels(FOUR))
row("3.6.1.1", MUST, "a buffer's file is as long as byteLength, or longer", "buffer_longer",
    buffer_in("longer.bin", "longer.bin", more=bytes(99)), same(BASE))
row("3.6.1.1", MUST, "a buffer's file is as long as byteLength: a shorter file", "buffer_shorter",
    buffer_in("shorter.bin", "shorter.bin", cut=4), refused("byteLength says"))
row("3.6.1.1", MUST, "a buffer's data URI is as long as byteLength", "buffer_data_shorter",
    buffered(octets, cut=9), refused("byteLength says"))
row("3.6.1.1", MUST, "data: URIs of buffers: application/gltf-buffer", "buffer_gltf_type",
    buffered(lambda content: data_uri("application/gltf-buffer", content)), same(BASE))
row("3.6.1.1", MUST, "a view holds one kind of data: indices and attributes in one", "view_shared",
    shared_view(), same(BASE), "concerns GPU buffers; read alike")
row("3.6.1.1", SHOULD, "target says vertices or indices", "view_target_wrong",
    edit(base(), ("bufferViews/0/target", 34963), ("bufferViews/3/target", 34962)), ignored(), "target is not read")
row("3.6.1.1", MUST, "only views of vertex attributes have byteStride: indices", "stride_of_indices",
    edit(base(), ("bufferViews/3/byteStride", 4)), refused("a byteStride under indices"))
row("3.6.1.1", MUST, "only views of vertex attributes have byteStride: keyframes", "stride_of_keyframes",
    edit(moving(STILL + ((0, 0, 0),)), ("bufferViews/6/byteStride", 16), ("accessors/5/count", 2)), noted("byteStride"))
row("3.6.1.1", MUST, "only views of vertex attributes have byteStride: an image's", "stride_of_image",
    edit(base(), ("bufferViews/4/byteStride", 4)), ignored(), "not read")

row("3.6.1.2", MUST, "the BIN chunk is buffers[0] without uri", "glb_buffer",
    glb(base()), same(BASE))
row("3.6.1.2", MUST, "where such a buffer is, there is a BIN chunk", "glb_no_bin",
    glb(base(), "J"), refused("no BIN chunk"))
row("3.6.1.2", MUST, "where such a buffer is, there is a BIN chunk: a .gltf", "gltf_no_uri",
    edit(buffered(octets), ("buffers/0/uri", GONE)), refused("uri is missing"))
row("3.6.1.2", MUST, "other buffers without uri have no meaning", "glb_second_no_uri",
    glb(edit(buffered(octets), ("buffers/0/uri", GONE), ("buffers/1", {"byteLength": 4}))),
    refused("buffers/1/uri is missing"))
row("3.6.1.2", MAY, "the BIN chunk may be longer, by its padding", "glb_bin_longer",
    glb(base(), binary_more=bytes(4)), same(BASE))
row("3.6.1.2", MUST, "the BIN chunk is not shorter", "glb_bin_shorter",
    glb(base(), binary=base().bytes[0][:-8]), refused("the BIN chunk has"))
row("3.6.1.2", MUST, "a buffer without uri that nothing uses", "buffer_unused_no_uri",
    edit(buffered(octets), ("buffers/1", {"byteLength": 4})), refused("buffers/1/uri is missing"),
    "its meaning is left to extensions; the refusal says which it is")

row("3.6.2.1", MUST, "byteStride places the items of attributes", "stride_16",
    edit(base(), ("accessors/0/bufferView", view(strided(CORNERS, 3, 4), byteStride=16))), same(BASE))

row("3.6.2.2", MUST, "the type of a component is one of six: 5124", "component_5124",
    edit(base(), ("accessors/3/componentType", 5124)), refused("componentType 5124"))
row("3.6.2.2", MUST, "the type of a component is one of six: 5130", "component_5130",
    edit(base(), ("accessors/0/componentType", 5130)), refused("componentType is 5130"))
row("3.6.2.2", MUST, "no NaN in positions", "position_nan",
    first_position(float("nan")), refused("is not finite"))
row("3.6.2.2", MUST, "no infinity in positions", "position_infinite",
    first_position(float("inf")), refused("is not finite"))
row("3.6.2.2", MUST, "no NaN in keyframes", "keyframe_nan",
    moving(values=((0, 0, 0), (float("nan"), 0, 0))), refused("is not finite"))
row("3.6.2.2", MUST, "no NaN in what is not read", "unread_nan",
    base(attributes={"_HEAT": data("f32", "SCALAR", [float("nan")] * 4)}), noted('"_HEAT" is ignored'))

row("3.6.2.3", MUST, "a sparse accessor replaces items", "sparse_valid",
    sparse(), same(BASE))
row("3.6.2.3", MUST, "a sparse accessor without a view begins with zeros", "sparse_zeros",
    sparse(begun=False), same(BASE))
row("3.6.2.3", MUST, "no more items are replaced than there are", "sparse_count",
    sparse((0, 1, 2, 3, 3), [0] * 15, count=5), refused("sparse/count is"))
row("3.6.2.3", MUST, "sparse indices grow", "sparse_unsorted",
    sparse((3, 2)), refused("indices must increase"))
row("3.6.2.3", MUST, "sparse indices are below count", "sparse_beyond",
    sparse((2, 4)), refused("index 4 of 4"))
row("3.6.2.3", MUST, "sparse has count, indices, values", "sparse_no_values",
    edit(sparse(), ("accessors/0/sparse/values", GONE)), refused("sparse/values is missing"))
row("3.6.2.3", MUST, "indices may be sparse", "sparse_of_indices",
    sparse_indices(), same(BASE))

row("3.6.2.4", MUST, "an accessor begins at a multiple of its component in the buffer", "unaligned",
    edit(base(), ("accessors/0/bufferView", view(bytes(2) + pack("f32", CORNERS) + bytes(2))),
         ("accessors/0/byteOffset", 2)), refused("a multiple of 4 is expected"))
row("3.6.2.4", MUST, "an accessor begins at a multiple of its component in its view too", "unaligned_in_view",
    unaligned_in_view(), ignored(), "aligned in the buffer, which is what counts for reading")
row("3.6.2.4", MUST, "byteStride is a multiple of the component, and of 4", "stride_14",
    edit(base(), ("accessors/0/bufferView", view(bytes(14 * 4), byteStride=14))), refused("multiple of 4"))
row("3.6.2.4", MUST, "byteStride is not less than an item", "stride_8",
    edit(base(), ("bufferViews/0/byteStride", 8)), refused("byteStride 8"))
row("3.6.2.4", MUST, "attributes that share a view have a byteStride", "view_of_two_attributes",
    edit(base(), ("bufferViews/0/byteLength", 96), ("accessors/1/bufferView", 0), ("accessors/1/byteOffset", 48)),
    ignored(), "read tightly packed, as a view without byteStride is")
row("3.6.2.4", MUST, "an accessor lies inside its view", "accessor_beyond",
    edit(base(), ("accessors/0/count", 5)), refused("ends at byte 60"))
row("3.6.2.4", MUST, "attributes begin at multiples of 4: colours of 3 bytes", "colour_of_3_bytes",
    base(attributes=colours([255] * 12, "u8", "VEC3", normalized=True)), ignored(),
    "read tightly packed: there is no other reading")

row("3.6.2.5", MUST, "min and max have as many numbers as components", "bounds_short",
    edit(base(), ("accessors/0/min", [0])), ignored(), "min and max are not read")
row("3.6.2.5", MUST, "min and max are those of the data", "bounds_wrong",
    edit(base(), ("accessors/0/min", [5, 5, 5]), ("accessors/0/max", [6, 6, 6])), ignored(),
    "min and max are not read; the box is measured")
row("3.6.2.5", MUST, "positions have min and max", "bounds_none",
    edit(base(), ("accessors/0/min", GONE), ("accessors/0/max", GONE)), ignored(), "min and max are not read")
row("3.6.2.5", MUST, "keyframe times have min and max", "bounds_none_times",
    edit(moving(), ("accessors/4/min", GONE), ("accessors/4/max", GONE)), ignored(), "min and max are not read")
