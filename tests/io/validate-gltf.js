// Prints the Khronos validator's report on a file as JSON.
const fs = require('fs'), path = require('path');
const validator = require(path.join(process.cwd(), 'node_modules', 'gltf-validator'));
const file = process.argv[2];
const read = name => new Uint8Array(fs.readFileSync(name));
validator.validateBytes(read(file), {
  uri: path.basename(file),
  externalResourceFunction: uri => Promise.resolve(read(path.join(path.dirname(file), decodeURIComponent(uri)))),
}).then(report => console.log(JSON.stringify(report)), error => { console.error(error); process.exit(1); });
