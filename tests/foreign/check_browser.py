"""Holds glb, as three.js plays it in Chromium, against the CSV; and has the browser draw the middle frame.
Run by read_back.sh: check_browser.py FOLDER [PICTURE.png] CLOTH…"""

import base64
import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

from motion_of_csv import Motion

folder = Path(sys.argv[1])
picture = next((name for name in sys.argv[2:] if name.endswith(".png")), None)
cloths = [name for name in sys.argv[2:] if name != picture]
motion = Motion(folder, cloths)
three = Path("/usr/share/javascript/three")

# The page plays the clip to the time of each frame, adds up the morph targets by their influence as the vertex
# shader would, and leaves the places in the document. Then it draws the middle frame.
page = r"""<!doctype html><title>glb</title><body style="margin:0"><pre id="said" style="display:none"></pre>
<script src="file://THREE/build/three.min.js"></script>
<script src="file://THREE/examples/js/loaders/GLTFLoader.js"></script>
<script>
"use strict";
// Debian's three.js is of 2019; lines and points that change their shape came with r120, in just this way.
for (const kind of [THREE.Line, THREE.Points])
  kind.prototype.updateMorphTargets = kind.prototype.updateMorphTargets || THREE.Mesh.prototype.updateMorphTargets;
const said = document.getElementById("said");
const times = TIMES;
const bytes = Uint8Array.from(atob("GLB"), (letter) => letter.charCodeAt(0)).buffer;
new THREE.GLTFLoader().parse(bytes, "", (model) => {
  const mixer = new THREE.AnimationMixer(model.scene);
  const action = mixer.clipAction(model.animations[0]);
  action.setLoop(THREE.LoopOnce);  // else the end is the start again
  action.clampWhenFinished = true;
  action.play();
  const things = [];
  model.scene.traverse((thing) => { if (thing.geometry) things.push(thing); });
  const places = (thing) => {
    thing.updateWorldMatrix(true, false);
    const start = thing.geometry.attributes.position, targets = thing.geometry.morphAttributes.position || [];
    const found = [];
    for (let i = 0; i < start.count; ++i) {
      const place = new THREE.Vector3().fromBufferAttribute(start, i), ways = new THREE.Vector3();
      targets.forEach((target, k) => {
        const way = new THREE.Vector3().fromBufferAttribute(target, i);
        if (!thing.geometry.morphTargetsRelative) way.sub(place);
        ways.addScaledVector(way, thing.morphTargetInfluences[k]);
      });
      place.add(ways).applyMatrix4(thing.matrixWorld);
      found.push([place.x, place.y, place.z]);
    }
    return found;
  };
  const played = times.map((time) => {
    mixer.setTime(time);
    return Object.fromEntries(things.map((thing) => [thing.name || thing.parent.name, places(thing)]));
  });
  action.reset();
  mixer.setTime(times[Math.floor(times.length / 2)]);
  const box = new THREE.Box3();
  things.forEach((thing) => places(thing).forEach((p) => box.expandByPoint(new THREE.Vector3(...p))));
  const size = box.getSize(new THREE.Vector3()).length(), middle = box.getCenter(new THREE.Vector3());
  const camera = new THREE.PerspectiveCamera(40, 16 / 9, size / 100, size * 10);
  camera.position.copy(middle).add(new THREE.Vector3(0.3, 0.15, 1).normalize().multiplyScalar(1.25 * size));
  camera.lookAt(middle);
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xe8ecf0);
  const sun = new THREE.DirectionalLight(0xffffff, 0.9);
  sun.position.set(-0.5, 1, 0.8);
  scene.add(model.scene, sun, new THREE.HemisphereLight(0xffffff, 0x887766, 0.6));
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(960, 540);
  renderer.outputEncoding = THREE.sRGBEncoding;
  renderer.render(scene, camera);
  said.textContent = JSON.stringify({ revision: THREE.REVISION, browser: navigator.userAgent, played,
                                      drawn: renderer.domElement.toDataURL("image/png") });
}, (error) => { said.textContent = JSON.stringify({ error: String(error) }); });
</script>"""

glb = base64.b64encode((folder / "motion.glb").read_bytes()).decode()
times = [time - motion.times[0] for time in motion.times]
html = folder / "browser.html"
html.write_text(page.replace("THREE/", f"{three}/").replace("TIMES", json.dumps(times)).replace("GLB", glb))
document = subprocess.run(
    ["chromium-headless-shell", "--no-sandbox", "--allow-file-access-from-files", "--use-angle=swiftshader",
     "--enable-unsafe-swiftshader", "--virtual-time-budget=60000", "--dump-dom", html.resolve().as_uri()],
    check=True, capture_output=True, text=True, timeout=300).stdout
found = re.search(r'<pre id="said"[^>]*>(.*?)</pre>', document, re.DOTALL)[1]
assert found, "the page said nothing"
said = json.loads(found)
assert "error" not in said, said["error"]

epsilon = 1.2e-7 * max(1.0, np.abs(motion.position).max())  # m, the last place of single precision out there
worst = 0.0
for number, things in enumerate(said["played"]):
    for sheet in cloths:
        masses = [i for i, place in motion.places.items() if place[0] == sheet]
        worst = max(worst, np.abs(np.array(things[sheet]) - motion.position[number][masses]).max())
assert worst < 4 * epsilon, f"glb: off by {worst} m"
if picture:
    Path(picture).write_bytes(base64.b64decode(said["drawn"].split(",")[1]))
version = re.search(r"Chrome/(\d+)", said["browser"])[1]
print(f"three.js r{said['revision']} in Chromium {version}: {len(motion.frames)} frames are as the CSV says: glb "
      f"within {worst:.1e} m")
