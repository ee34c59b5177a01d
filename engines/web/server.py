# SPDX-License-Identifier: Apache-2.0
"""A loopback server for one page: it reads from a few folders and takes the pictures. Others do not know its secret."""
import http.server
import mimetypes
import pathlib
import secrets
import threading

TYPES = {".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".html": "text/html"}
LARGEST_PICTURE = 1 << 30


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def place(self, folders):
        """What /<secret>/<folder>/<path> names; None unless it lies in that folder."""
        parts = self.path.split("?")[0].split("/", 3)
        if len(parts) != 4 or not secrets.compare_digest(parts[1], self.server.secret) or parts[2] not in folders:
            return None
        root = folders[parts[2]].resolve()
        path = (root / parts[3]).resolve()
        return path if path.is_relative_to(root) else None

    def answer(self, status, body=b"", kind="text/plain"):
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_GET(self):
        path = self.place(self.server.readable)
        if path is None or not path.is_file():
            return self.answer(404)
        kind = TYPES.get(path.suffix) or mimetypes.guess_type(path.name)[0] or "application/octet-stream"
        self.answer(200, path.read_bytes(), kind)

    def do_POST(self):
        path = self.place(self.server.writable)
        size = int(self.headers.get("Content-Length", 0))
        if path is None or size > LARGEST_PICTURE:
            self.close_connection = True
            return self.answer(403)
        path.write_bytes(self.rfile.read(size))
        self.answer(200)

    def log_message(self, *_):
        pass


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self, folders):
        """`folders`: readable ones by name. Set `writable` = {"out": folder} before a picture."""
        super().__init__(("127.0.0.1", 0), Handler)
        self.secret = secrets.token_urlsafe(16)
        self.readable = {name: pathlib.Path(folder) for name, folder in folders.items()}
        self.writable = {}
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def url(self, path):
        return f"http://127.0.0.1:{self.server_address[1]}/{self.secret}/{path}"
