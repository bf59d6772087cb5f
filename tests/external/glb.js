// Checks GLB files with the Khronos validator: no errors, no warnings. Arguments: files.
const fs = require("fs");
const validator = require("gltf-validator");

async function check(path) {
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(path)));
  const { numErrors, numWarnings, messages } = report.issues;
  const { drawCallCount, totalTriangleCount } = report.info;
  console.log(`${path}: ${numErrors} errors, ${numWarnings} warnings, ${drawCallCount} meshes, ${totalTriangleCount} triangles`);
  if (numErrors + numWarnings > 0) {
    console.log(messages);
    process.exitCode = 1;
  }
}

(async () => {
  for (const path of process.argv.slice(2)) await check(path);
})();
