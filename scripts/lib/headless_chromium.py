# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens pages in Chromium without a window, which the environment variable CHROMIUM names; and the data of a view's page."""

import array
import base64
import contextlib
import html
import http.server
import json
import os
import re
import subprocess
import sys
import threading

# To be put into a page before its own scripts: keeps what went wrong.
LISTEN = """<script>
const problems = [];
addEventListener("error", (event) => problems.push(event.message || event.target.src || event.target.href), true);
addEventListener("securitypolicyviolation", (event) => problems.push(event.blockedURI));
for (const name of ["error", "warn"])
  console[name] = (...words) => problems.push(words.join(" "));
</script>
"""


def chromium(folder, *arguments):
    """What it prints. Its renderer is software, and its profile lies in `folder`."""
    command = [os.environ["CHROMIUM"], "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
               "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", f"--user-data-dir={folder}/profile",
               "--hide-scrollbars", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=280, check=True).stdout


def report_in(dom):
    """The JSON that a script has written into the element `report` of a page."""
    found = re.search(r'<pre id="report">(.*?)</pre>', dom)
    if not found:
        raise AssertionError(f"no report: {dom[-2000:]}")
    return json.loads(html.unescape(found[1]))


def arrays_of(page):
    """The arrays in a page that --view has written, by their names."""
    result = {}
    codes = {"points": "f", "inside": "B", "rounds": "B"}
    pattern = r'<script type="application/octet-stream" id="(\w+)" data-count="(\d+)">([^<]*)</script>'
    for name, count, text in re.findall(pattern, page):
        code = codes.get(name, "I")
        numbers = array.array(code)
        numbers.frombytes(base64.b64decode(text)[:int(count) * numbers.itemsize])
        if sys.byteorder == "big":
            numbers.byteswap()
        result[name] = numbers
    return result


@contextlib.contextmanager
def served(folder):
    """The address of a server for the files of a folder. A page may POST to /report when it is done; only then is /done
    there. So a page with an image /done is loaded, and its DOM dumped, when it is done."""
    is_done = threading.Event()

    class Handler(http.server.SimpleHTTPRequestHandler):
        extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map, ".mjs": "text/javascript"}

        def __init__(self, *arguments):
            super().__init__(*arguments, directory=folder)

        def do_GET(self):
            if self.path == "/done":
                is_done.wait(200)
            super().do_GET()

        def do_POST(self):
            is_done.set()
            self.send_response(204)
            self.end_headers()

        def log_message(self, *_):
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_address[1]}"
        finally:
            server.shutdown()
            thread.join()
