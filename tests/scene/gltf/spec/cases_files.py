"""Extensions and extras as such, and the container GLB."""
from document import GONE, edit, glb, glb_of_odd_length
from judges import BASE, MAY, MUST, SHOULD, Chapter, ignored, refused, same
from scenes import base, buffered, instanced, octets, two_squares

CHAPTER = Chapter("3.12 and 4: extensions and GLB")
row = CHAPTER.row

row("3.12", MUST, "extensions that are used are listed: one that is not read", "ext_unlisted",
    edit(base(), ("materials/0/extensions/KHR_materials_sheen", {"sheenColorFactor": [1, 0, 0]})),
    same(BASE, '"KHR_materials_sheen" is not supported'))
row("3.12", MUST, "extensions that are used are listed: instances", "ext_unlisted_instances",
    instanced([(-1.25, 0, 0), (1.25, 0, 0)], listed=False), same(two_squares()), "read all the same")
row("3.12", MUST, "extensions that are used are listed: one that is read", "ext_unlisted_known",
    edit(base(), ("extensionsUsed", GONE)), ignored(), "read all the same")
row("3.12", MUST, "an extension that is required and unknown: not loaded", "ext_required_unknown",
    edit(base().uses("VENDOR_a"), ("extensionsRequired", ["VENDOR_a"])), refused('requires the extension "VENDOR_a"'))
row("3.12", MAY, "an extension that is used and unknown: ignored", "ext_used_unknown",
    base().uses("VENDOR_a"), same(BASE, '"VENDOR_a" is not supported'))
row("3.12", MUST, "what is required is used too", "ext_required_unused",
    edit(base(), ("extensionsRequired", ["KHR_texture_transform"])), ignored(), "read all the same")
row("3.12", MUST, "extensionsRequired is a list of text", "ext_required_text",
    edit(base(), ("extensionsRequired", "KHR_texture_transform")), refused("extensionsRequired is"))
row("3.12", MUST, "extensions that are used are listed: Draco, its data nowhere else", "ext_unlisted_draco",
    edit(base(),
         ("meshes/0/primitives/0/extensions",
          {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}),
         ("accessors/0/bufferView", GONE), ("accessors/3/bufferView", GONE)),
    refused("is compressed by KHR_draco_mesh_compression"))
row("3.12", MUST, "extensions that are used are listed: a node that KHR_node_visibility hides", "ext_unlisted_hidden",
    edit(base(), ("nodes/1/extensions", {"KHR_node_visibility": {"visible": False}})),
    same(BASE, '"KHR_node_visibility" is not supported'))
row("3.12", MAY, "a listed extension of nodes that is not read", "ext_hidden",
    edit(base().uses("KHR_node_visibility"), ("nodes/1/extensions", {"KHR_node_visibility": {"visible": False}})),
    same(BASE, '"KHR_node_visibility" is not supported'))

row("4.4.2", MUST, "magic is glTF", "glb_magic",
    glb(base(), magic=b"glTf"), refused('does not begin with "glTF"'))
row("4.4.2", MUST, "version is 2", "glb_version",
    glb(base(), version=1), refused("container version 1"))
row("4.4.2", MUST, "the version in the JSON is checked too", "glb_asset_version",
    glb(edit(base(), ("asset/version", "1.0"))), refused("2.0 is expected"))
row("4.4.2", MUST, "length is that of the file: too long", "glb_length_long",
    glb(base(), longer=4), refused("the header says"))
row("4.4.2", MUST, "length is that of the file: bytes behind", "glb_behind",
    glb(base(), behind=bytes(4)), same(BASE, "bytes after the end"))

row("4.4.3.1", MUST, "chunks begin and end at multiples of 4", "glb_chunk_5",
    glb_of_odd_length(base()), refused("a multiple of 4 is expected"))
row("4.4.3.1", MUST, "chunks come in order: BIN first", "glb_bin_first",
    glb(base(), "BJ"), refused("the first chunk, and no other, must be JSON"))
row("4.4.3.1", MUST, "JSON occurs once", "glb_json_twice",
    glb(base(), "JBJ"), refused("the first chunk, and no other, must be JSON"))
row("4.4.3.1", MUST, "BIN occurs once", "glb_bin_twice",
    glb(base(), "JBB"), refused("the BIN chunk must be the second and only one"))
row("4.4.3.1", MUST, "chunks of unknown kinds are ignored", "glb_unknown_chunk",
    glb(base(), "JBX"), same(BASE))

row("4.4.3.2", MUST, "JSON is padded with spaces", "glb_json_nul",
    glb(base(), text_more=bytes(4)), refused("JSON is expected"))

row("4.4.3.3", MUST, "BIN is the second chunk", "glb_bin_third",
    glb(base(), "JXB"), refused("the BIN chunk must be the second"))
row("4.4.3.3", MUST, "BIN is padded with zeros", "glb_bin_pad",
    glb(base(), binary_more=b"\xff" * 4), ignored(), "padding is not read")
row("4.4.3.3", SHOULD, "an empty BIN chunk is left out", "glb_bin_empty",
    glb(buffered(octets), binary=b""), same(BASE))
