# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command share: running it, and reading what it writes.

SOFTSHADOWS_COMMAND is the command's path. Without a display an Xvfb is started; where that is
missing, too, the tests are skipped (exit code 125).
"""

import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy

COMMAND = os.environ.get("SOFTSHADOWS_COMMAND", "softshadows")
ENVIRONMENT = dict(os.environ)


def read_png(path):
    """The pixels of an 8-bit PNG, height x width x 3 (RGB) or 4 (RGBA)."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path + " is no PNG"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        at += 12 + length
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and color in (2, 6), path + " is not 8-bit RGB or RGBA"
            channels = 3 if color == 2 else 4
        elif kind == b"IDAT":
            packed += body
    stride, raw = channels * width, zlib.decompress(packed)
    rows, above = [], bytes(stride + channels)  # each with a black pixel at its left
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(channels)
        for i, value in enumerate(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)]):
            left, up, corner = row[i], above[i + channels], above[i]
            if kind == 4:  # Paeth: whichever is nearest to left + up - corner
                distances = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
                expected = (left, up, corner)[distances.index(min(distances))]
            else:
                expected = (0, left, up, (left + up) // 2)[kind]
            row.append((value + expected) & 255)
        rows.append(row[channels:])
        above = bytes(row)
    return numpy.array(rows, int).reshape(height, width, channels)


def start_display():
    """As setUpModule: an Xvfb where there is no display, until the module is done."""
    if ENVIRONMENT.get("DISPLAY"):
        return
    if not shutil.which("Xvfb"):
        print("There is no display and no Xvfb: skipped.")
        sys.exit(125)
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-noreset"],
        pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writing)
    unittest.addModuleCleanup(server.wait)
    unittest.addModuleCleanup(server.terminate)
    with os.fdopen(reading) as pipe:
        ENVIRONMENT["DISPLAY"] = ":" + pipe.readline().strip()


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def run_command(self, *arguments, environment=None):
        return subprocess.run([COMMAND, *arguments], cwd=self.folder, text=True,
                              errors="replace", timeout=120, env=environment or ENVIRONMENT,
                              capture_output=True)

    def succeed(self, *arguments):
        result = self.run_command(*arguments)
        self.assertEqual(result.returncode, 0, "%s\n%s" % (arguments, result.stderr))
        for line in result.stderr.splitlines():
            self.assertRegex(line, "^softshadows: (warning|note): ")
        return result

    def expect_failure(self, code, words, *arguments, environment=None):
        """One message that has these words, this exit code, and no file that was not there."""
        before = sorted(os.listdir(self.folder))
        result = self.run_command(*arguments, environment=environment)
        self.assertEqual(result.returncode, code, "%s\n%s" % (arguments, result.stderr))
        lines = [line for line in result.stderr.splitlines() if not line.startswith("See: ")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("softshadows: error: "), result.stderr)
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(result.stdout, "")
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def compare(self, picture, reference):
        return json.loads(self.succeed("compare", picture, reference, "--json").stdout)["picture"]
