# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens pages in Chromium without a window; the environment variable CHROMIUM names it."""

import html
import json
import os
import re
import subprocess

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
