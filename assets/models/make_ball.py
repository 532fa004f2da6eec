#!/usr/bin/env python3
"""Makes ball.obj, ball.mtl and ball.png beside this script: a beach ball of unit radius.

Only the standard library is needed. Run it again after a change here; the results are committed so that nobody
has to.
"""
import math
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent

# Triangles are dear where a CPU draws them: 5000 balls of this many still make a usable frame rate there.
MERIDIANS = 16
PARALLELS = 10          # bands from pole to pole

WIDTH, HEIGHT = 256, 128
STRIPES = 6
CAP = 0.085             # of the way from pole to pole
SAMPLES = 4             # a side, for smooth edges
WHITE = (250, 250, 247)
# Told apart by lightness too, which every eye sees.
BRIGHT = (250, 250, 247)
DARK = (92, 96, 104)
LINE = (58, 60, 66)


def write_obj(path):
    lines = ["# Made by make_ball.py", "mtllib ball.mtl", "o ball"]
    for j in range(PARALLELS + 1):
        for i in range(MERIDIANS + 1):
            u, v = i / MERIDIANS, j / PARALLELS
            longitude, polar = 2 * math.pi * u, math.pi * v
            x = math.sin(polar) * math.cos(longitude)
            y = math.sin(polar) * math.sin(longitude)
            z = math.cos(polar)
            if j in (0, PARALLELS):
                u = (i + 0.5) / MERIDIANS       # the middle of the one triangle that uses this pole vertex
            lines.append(f"v {x:.6f} {y:.6f} {z:.6f}")
            lines.append(f"vt {u:.6f} {1 - v:.6f}")
            lines.append(f"vn {x:.6f} {y:.6f} {z:.6f}")
    lines.append("usemtl ball")
    for j in range(PARALLELS):
        for i in range(MERIDIANS):
            a = j * (MERIDIANS + 1) + i + 1     # OBJ counts from 1
            b = a + MERIDIANS + 1               # one band further down
            if j > 0:
                lines.append(face(a, b, a + 1))
            if j < PARALLELS - 1:
                lines.append(face(a + 1, b, b + 1))
    path.write_text("\n".join(lines) + "\n")


def face(*vertices):
    return "f " + " ".join(f"{v}/{v}/{v}" for v in vertices)


def write_mtl(path):
    path.write_text("# Made by make_ball.py\nnewmtl ball\nKa 1 1 1\nKd 1 1 1\nKs 0.35 0.35 0.35\nNs 60\nillum 2\n"
                    "map_Kd ball.png\n")


def colour_at(u, v):
    from_pole = min(v, 1 - v)
    if from_pole < CAP:
        return BRIGHT if from_pole < CAP - 0.012 else LINE
    place = u * STRIPES
    return BRIGHT if int(place) % 2 == 0 else DARK


def write_png(path):
    rows = []
    for y in range(HEIGHT):
        row = bytearray([0])                    # PNG filter: none
        for x in range(WIDTH):
            total = [0.0, 0.0, 0.0]
            for k in range(SAMPLES * SAMPLES):
                u = (x + (k % SAMPLES + 0.5) / SAMPLES) / WIDTH
                v = (y + (k // SAMPLES + 0.5) / SAMPLES) / HEIGHT
                total = [t + c for t, c in zip(total, colour_at(u, v))]
            row += bytes(round(t / SAMPLES ** 2) for t in total)
        rows.append(bytes(row))
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0)     # 8-bit RGB
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(b"".join(rows), 9)), (b"IEND", b""))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in chunks:
            file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)))


if __name__ == "__main__":
    write_obj(FOLDER / "ball.obj")
    write_mtl(FOLDER / "ball.mtl")
    write_png(FOLDER / "ball.png")
