//! What a file seems to be that is no mesh which can be read.

/// How a kind of file begins, what it is, and what to do with it.
type Kind = (&'static [u8], &'static str, &'static str);

const UNPACK: &str = "unpack it and give the file that was in it";
const PLAIN_TEXT: &str = "save it as plain text or as UTF-8";
const DOWNLOAD: &str = "download the file itself";
const EXPORT: &str = "open it in the program it comes from and export the surface as STL, OBJ or PLY";

const KINDS: [Kind; 21] = [
    (b"\xff\xfe", "text in UTF-16", PLAIN_TEXT),
    (b"\xfe\xff", "text in UTF-16", PLAIN_TEXT),
    (b"\x1f\x8b", "compressed by gzip", UNPACK),
    (b"PK\x03\x04", "a ZIP archive (3MF and FreeCAD files are such)", UNPACK),
    (b"BZh", "compressed by bzip2", UNPACK),
    (b"\xfd7zXZ", "compressed by xz", UNPACK),
    (b"\x28\xb5\x2f\xfd", "compressed by zstd", UNPACK),
    (b"7z\xbc\xaf", "a 7z archive", UNPACK),
    (b"glTF", "a glTF file", EXPORT),
    (b"{", "JSON (glTF files are such)", EXPORT),
    (b"ISO-10303", "a STEP file", EXPORT),
    (b"# vtk", "a VTK file", EXPORT),
    (b"<?xml", "XML (VTP, AMF and COLLADA files are such)", EXPORT),
    (b"<VTKFile", "a VTK file", EXPORT),
    (b"<!DOCTYPE", "a page of the web", DOWNLOAD),
    (b"<html", "a page of the web", DOWNLOAD),
    (b"<", "XML", EXPORT),
    (b"OFF\n", "an OFF file", EXPORT),
    (b"OFF\r", "an OFF file", EXPORT),
    (b"$MeshFormat", "a Gmsh file", EXPORT),
    (
        b"version https://git-lfs",
        "what Git LFS keeps in place of a large file",
        "fetch it with `git lfs pull`",
    ),
];

/// So many bytes at the start of a file tell whether it is text.
const LOOKED_AT: usize = 4096;

/// What a file seems to be and what to do with it, if that is no mesh.
pub(super) fn seems(bytes: &[u8]) -> Option<(&'static str, &'static str)> {
    let text = without_mark(bytes).trim_ascii_start();
    let begins = |(start, ..): &&Kind| bytes.starts_with(start) || text.starts_with(start);
    KINDS.iter().find(begins).map(|(_, what, remedy)| (*what, *remedy))
}

/// Whether a file is text, as far as its beginning tells.
pub(super) fn is_text(bytes: &[u8]) -> bool {
    let is_control = |byte: &u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
    !bytes.iter().take(LOOKED_AT).any(is_control)
}

/// A text without the mark by which some editors tell that it is UTF-8.
pub(super) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}
