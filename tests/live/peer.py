# SPDX-License-Identifier: BSD-3-Clause
"""A live session as its users have it: the program at a free port, and peers that talk to it."""
import json
import re
import signal
import socket
import subprocess

PATIENCE = 60  # seconds, of a busy machine


class Live:
    """The program; `with` begins and ends it."""

    def __init__(self, program, case, *options):
        self.call = [str(program), "session", str(case), "--listen", "localhost:0", "--time-limit", "300", *options]  # ends though the test be killed
        self.ended = None

    def __enter__(self):
        self.process = subprocess.Popen(self.call, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        said = self.process.stdout.readline() + self.process.stdout.readline()
        found = re.search(r"live at 127\.0\.0\.1:(\d+)\n", said)
        if not found:
            self.process.kill()
            raise AssertionError(said + self.process.stderr.read())
        self.port = int(found.group(1))
        return self

    def __exit__(self, wrong, *_):
        ended = self.end()
        self.process.stdout.close()
        self.process.stderr.close()
        if wrong is None and ended != (0, ""):
            raise AssertionError(f"the session ended with {ended}")

    def end(self):
        """Ctrl-C. @returns exit code and what stands on stderr, the same when asked again"""
        if self.ended:
            return self.ended
        self.process.send_signal(signal.SIGINT)
        try:
            code = self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise
        self.ended = code, self.process.stderr.read()
        return self.ended

    def peer(self):
        return Peer(self.port)


class Peer:
    """A connection."""

    def __init__(self, port, patience=PATIENCE):
        self.socket = socket.create_connection(("127.0.0.1", port), patience)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.lines = self.socket.makefile("rb")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self.lines.close()
        self.socket.close()

    def send(self, message):
        self.socket.sendall(message if isinstance(message, bytes) else json.dumps(message).encode() + b"\n")

    def hear(self):
        """The next line; None where there is no more."""
        line = self.lines.readline()
        return json.loads(line) if line else None

    def ask(self, message):
        self.send(message)
        return self.hear()
