#!/usr/bin/env python3
"""Makes ball.obj, ball_coarse.obj, ball.mtl and ball.png beside this script: a beach ball of unit radius.

Only the standard library is needed. Run it again after a change here; the results are committed so that nobody
has to.
"""
import math
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent

# Meridians and bands from pole to pole. The coarse one is for balls of a few pixels: where a CPU draws, thousands of
# balls are as dear as their triangles are many.
FINE = (24, 14)
COARSE = (10, 6)

WIDTH, HEIGHT = 256, 128
STRIPES = 6
CAP = 0.085             # of the way from pole to pole
SAMPLES = 4             # a side, for smooth edges
# Told apart by lightness, which every eye sees; the program tints what is not white.
BRIGHT = (252, 252, 250)
DARK = (190, 190, 190)
LINE = (70, 72, 78)


def write_obj(path, meridians, bands):
    """Positions and normals are shared around the ball, so that it is closed; texture coordinates have a seam."""
    lines = ["# Made by make_ball.py", "mtllib ball.mtl", "o ball"]
    points = [(0.0, 0.0, 1.0)]
    for j in range(1, bands):
        polar = math.pi * j / bands
        for i in range(meridians):
            longitude = 2 * math.pi * i / meridians
            ring = math.sin(polar)
            points.append((ring * math.cos(longitude), ring * math.sin(longitude), math.cos(polar)))
    points.append((0.0, 0.0, -1.0))
    lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    for j in range(bands + 1):
        # A pole is a corner of one triangle a meridian: each gets the middle of its own.
        shift = 0.5 if j in (0, bands) else 0.0
        lines += [f"vt {(i + shift) / meridians:.6f} {1 - j / bands:.6f}" for i in range(meridians + 1)]
    lines += [f"vn {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    lines.append("usemtl ball")

    def corner(i, j):
        point = 1 if j == 0 else len(points) if j == bands else 2 + (j - 1) * meridians + i % meridians
        return f"{point}/{j * (meridians + 1) + i + 1}/{point}"     # OBJ counts from 1

    for j in range(bands):
        for i in range(meridians):
            if j > 0:
                lines.append(f"f {corner(i, j)} {corner(i, j + 1)} {corner(i + 1, j)}")
            if j < bands - 1:
                # At the upper pole the corner of this very triangle.
                lines.append(f"f {corner(i if j == 0 else i + 1, j)} {corner(i, j + 1)} {corner(i + 1, j + 1)}")
    path.write_text("\n".join(lines) + "\n")


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
    write_obj(FOLDER / "ball.obj", *FINE)
    write_obj(FOLDER / "ball_coarse.obj", *COARSE)
    write_mtl(FOLDER / "ball.mtl")
    write_png(FOLDER / "ball.png")
