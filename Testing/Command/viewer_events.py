# SPDX-License-Identifier: BSD-3-Clause
"""Events for the viewer: written as vtkInteractorEventRecorder reads them, or sent to a real window."""

import ctypes
import ctypes.util
import time

CODES = {"space": " ", "Return": "\r", "plus": "+", "minus": "-", "question": "?",
         "bracketleft": "[", "bracketright": "]", "comma": ",", "period": ".", "Escape": "\x1b"}
SHIFT = 1


def key(name, shift=False):
    """A key, pressed and released, by X's name."""
    code = CODES.get(name, name if len(name) == 1 else "\0")
    return ["%s 10 10 %d %d 1 %s" % (event, SHIFT if shift else 0, ord(code), name)
            for event in ("KeyPressEvent", "KeyReleaseEvent")]


def keys(*names):
    return [line for name in names for line in key(name)]


def mouse(event, x, y):
    return "%sEvent %d %d 0 0 0 0" % (event, x, y)


def drag(button, *places, release=True):
    """Places from the lower left corner."""
    lines = [mouse("MouseMove", *places[0]), mouse(button + "ButtonPress", *places[0])]
    lines += [mouse("MouseMove", *place) for place in places[1:]]
    return lines + ([mouse(button + "ButtonRelease", *places[-1])] if release else [])


def click(button, x, y):
    return [mouse("MouseMove", x, y), mouse(button + "ButtonPress", x, y),
            mouse(button + "ButtonRelease", x, y)]


def ticks(count):
    return ["TimerEvent 10 10 0 0 0 0"] * count


def text(lines):
    return "\n".join(["# StreamVersion 1.1", *lines]) + "\n"


class Display:
    """Keys and the mouse of an X server, by its XTEST extension."""

    def __init__(self, name):
        self.x11 = ctypes.CDLL("libX11.so.6")
        self.xtst = ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XStringToKeysym.restype = ctypes.c_ulong
        self.x11.XKeysymToKeycode.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
        self.x11.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
        self.x11.XDefaultRootWindow.restype = ctypes.c_ulong
        for function in (self.xtst.XTestFakeKeyEvent, self.xtst.XTestFakeButtonEvent):
            function.argtypes = [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int, ctypes.c_ulong]
        self.xtst.XTestFakeMotionEvent.argtypes = [
            ctypes.c_void_p, ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_ulong]
        self.display = self.x11.XOpenDisplay(name.encode())
        if not self.display:
            raise OSError("no display " + name)

    def flush(self):
        self.x11.XFlush(ctypes.c_void_p(self.display))
        time.sleep(0.1)

    def move(self, x, y):
        """From the screen's upper left corner."""
        self.xtst.XTestFakeMotionEvent(self.display, -1, x, y, 0)
        self.flush()

    def button(self, number, down):
        self.xtst.XTestFakeButtonEvent(self.display, number, int(down), 0)
        self.flush()

    def key(self, name):
        code = self.x11.XKeysymToKeycode(self.display, self.x11.XStringToKeysym(name.encode()))
        for down in (1, 0):
            self.xtst.XTestFakeKeyEvent(self.display, code, down, 0)
        self.flush()

    def close(self):
        self.x11.XCloseDisplay(ctypes.c_void_p(self.display))
