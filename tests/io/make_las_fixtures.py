#!/usr/bin/env python3
"""Writes the LAS and LAZ files of tests/io/las. Needs numpy, laspy and lazrs.

    tests/io/make_las_fixtures.py [FOLDER]

Each .laz has a .las of the same name beside it, or of the name before the first '_', with the same
points, which is not compressed. The chunks are small, so that there are many.
"""
import io
import pathlib
import struct
import sys

import laspy
import lazrs
import numpy as np

POINTS = 200
CHUNK = 64
VERSIONS = {f: "1.2" for f in range(4)} | {4: "1.3", 5: "1.3"} | {f: "1.4" for f in range(6, 11)}
EXTRA = {0: 2, 3: 3, 5: 1, 6: 5, 8: 2}


def points_of(point_format, count=POINTS):
    """Points of a made-up terrain, with all that a format can say."""
    rng = np.random.default_rng(point_format)
    header = laspy.LasHeader(point_format=point_format, version=VERSIONS[point_format])
    header.scales, header.offsets = [0.01, 0.01, 0.001], [400000, 5600000.5, -12.25]
    for i in range(EXTRA.get(point_format, 0)):
        header.add_extra_dim(laspy.ExtraBytesParams(name=f"extra{i}", type=["u1", "i2", "f8"][i % 3]))
    las = laspy.LasData(header)
    i = np.arange(count)
    las.X = i % 20 * 50 + rng.integers(0, 40, count) - 500
    las.Y = i // 20 * 60 + rng.integers(0, 40, count)
    las.Z = 1000 * np.sin(i / 9) + rng.integers(-20, 20, count) + (rng.random(count) < 0.2) * 9000
    las.intensity = rng.integers(0, 3000, count)
    las.number_of_returns = rng.choice([1, 1, 1, 2, 3, 5], count)
    las.return_number = 1 + (rng.random(count) * np.asarray(las.number_of_returns)).astype(int)
    las.scan_direction_flag = i // 20 % 2
    las.edge_of_flight_line = i % 20 == 0
    las.classification = rng.choice([1, 2, 2, 2, 5, 9], count)
    las.withheld = rng.random(count) < 0.05
    las.synthetic = rng.random(count) < 0.1
    las.key_point = rng.random(count) < 0.1
    las.user_data = rng.choice([0, 0, 7, 200], count)
    las.point_source_id = 100 + i // 70
    names = set(las.point_format.dimension_names)
    if point_format >= 6:
        las.overlap = rng.random(count) < 0.1
        las.scanner_channel = np.where(rng.random(count) < 0.3, rng.integers(0, 4, count), 0)
        las.classification = np.where(i % 50 == 7, 200, las.classification)
        las.scan_angle = 3000 * np.sin(i / 7)
    else:
        las.scan_angle_rank = 20 * np.sin(i / 7)
    if "gps_time" in names:
        step = np.where(rng.random(count) < 0.3, 0, 1e-5) + (rng.random(count) < 0.02) * 1e3
        las.gps_time = 1e5 + np.cumsum(step) + (i // 30 % 3) * 5e4
    if "red" in names:
        for colour in ("red", "green", "blue"):
            las[colour] = rng.integers(0, 65536, count)
        grey = i % 3 == 0
        las.green, las.blue = (np.where(grey, las.red, las[c]) for c in ("green", "blue"))
    if "nir" in names:
        las.nir = rng.integers(0, 65536, count)
    if "wavepacket_offset" in names:
        las.wavepacket_index = rng.integers(0, 3, count)
        las.wavepacket_offset = np.cumsum(rng.integers(0, 500, count))
        las.wavepacket_size = rng.choice([64, 128], count)
        for name in ("return_point_wave_location", "x_t", "y_t", "z_t"):
            las[name] = rng.random(count)
    for k in range(EXTRA.get(point_format, 0)):
        las[f"extra{k}"] = rng.integers(0, 100, count) if k != 1 else np.full(count, 3)
    return las


def bytes_of(las):
    stream = io.BytesIO()
    las.write(stream)
    return stream.getvalue()


def laszip_record(las, chunk, item_version=None, compressor=None):
    """The content of the record 'laszip encoded'."""
    extra = las.header.point_format.num_extra_bytes
    known = lazrs.LazVlr.new_for_compression(las.header.point_format.id, extra, False)
    record = bytearray(known.record_data())
    struct.pack_into("<I", record, 12, chunk)
    if item_version is not None:
        for at in range(34, len(record), 6):
            # Extra bytes of version 1 are other ones to LASzip than to lazrs.
            if struct.unpack_from("<H", record, at)[0] != 0:
                struct.pack_into("<H", record, at + 4, item_version)
    if compressor is not None:
        struct.pack_into("<H", record, 0, compressor)
    return bytes(record)


def compressed(las, record, chunks=None):
    """A whole LAZ file, with chunks of the given numbers of points if those vary."""
    plain = bytes_of(las)
    begin = struct.unpack_from("<I", plain, 96)[0]
    size = struct.unpack_from("<H", plain, 105)[0]
    vlr = struct.pack("<H16sHH32s", 0, b"laszip encoded", 22204, len(record), b"") + record
    header = bytearray(plain[:begin] + vlr)
    struct.pack_into("<I", header, 96, len(header))
    struct.pack_into("<I", header, 100, struct.unpack_from("<I", header, 100)[0] + 1)
    header[104] |= 128
    stream = io.BytesIO(header)
    stream.seek(0, io.SEEK_END)
    points = np.frombuffer(plain, np.uint8, size * len(las), begin)
    if chunks is None:
        compressor = lazrs.LasZipCompressor(stream, lazrs.LazVlr(record))
        compressor.compress_many(points)
    else:
        compressor = lazrs.ParLasZipCompressor(stream, lazrs.LazVlr(record))
        ends = np.cumsum([0, *chunks]) * size
        compressor.compress_chunks([points[a:b] for a, b in zip(ends, ends[1:])])
    compressor.done()
    return stream.getvalue()


def unchunked(las):
    """As LASzip 1 wrote them: one run of points, without a table."""
    record = laszip_record(las, len(las), item_version=1)
    file = bytearray(compressed(las, record))
    begin = struct.unpack_from("<I", file, 96)[0]
    table = struct.unpack_from("<q", file, begin)[0]
    struct.pack_into("<H", file, begin - len(record), 1)
    return bytes(file[:begin] + file[begin + 8 : table])


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "las")
    folder.mkdir(exist_ok=True)

    def put(name, content):
        (folder / name).write_bytes(content)

    variable = 0xFFFFFFFF
    for point_format in range(11):
        las = points_of(point_format)
        put(f"{point_format}.las", bytes_of(las))
        put(f"{point_format}.laz", compressed(las, laszip_record(las, CHUNK)))
        if point_format in (1, 7):
            chunks = [1, 50, 2, 120, POINTS - 173]
            put(f"{point_format}_variable.laz", compressed(las, laszip_record(las, variable), chunks))
        if point_format in (0, 1):
            put(f"{point_format}_v1.laz", compressed(las, laszip_record(las, CHUNK, 1)))
            put(f"{point_format}_unchunked.laz", unchunked(las))


if __name__ == "__main__":
    main()
