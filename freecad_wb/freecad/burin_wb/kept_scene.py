"""What the kernel's process keeps from job to job, so that the next one makes anew only what has changed."""

import hashlib

LOOKS = "drawn", "hatched", "transparent", "style"


def digest_of(brep):
    """The same for the same shape while a document is open."""
    return brep.exact() if hasattr(brep, "exact") else hashlib.sha256(brep).digest()


class KeptScene:
    """The scene of the last job and the session that drew it."""

    def __init__(self, burin):
        self._burin = burin
        self.session = burin.Session()
        self._key, self._scene = None, None
        self._canonical = {}  # by the digests of shapes

    def scene(self, job, cancel=None):
        """The job's scene: that of the last job where its parts are the same, in the looks of this one."""
        key = [self._part_key(part) for part in job.parts]
        if key != self._key:
            self._key = self._scene = None  # not two of them at once
            self._scene = self._made(job, cancel)
            self._key = key
        for made, part in zip(self._scene.parts, job.parts):
            for look in LOOKS:
                setattr(made, look, getattr(part, look))
        return self._scene

    def canonical(self, brep, canonical):
        """What `canonical` makes of a shape, once as long as jobs have it."""
        digest = digest_of(brep)
        if digest not in self._canonical:
            self._canonical[digest] = canonical(brep)
        return self._canonical[digest]

    def forget_others(self, job):
        """Lets go of what is known of shapes that the job does not have."""
        held = {digest_of(part.brep) for part in job.parts if part.brep is not None}
        self._canonical = {digest: known for digest, known in self._canonical.items() if digest in held}

    def _made(self, job, cancel):
        scene, shapes = self._burin.Scene(), {}
        for part in job.parts:
            common = dict(color=part.color, assembly=part.assembly, source=part.source)
            if cancel is not None and cancel.cancelled:
                raise self._burin.Cancelled("cancelled")
            if part.brep is None:
                made = scene.add_mesh(part.vertices, part.triangles, part.name, **common)
            else:
                if id(part.brep) not in shapes:
                    shapes[id(part.brep)] = self._burin.Brep(part.brep)
                made = scene.add_brep(shapes[id(part.brep)], part.name, placement=part.matrix(),
                                      face_colors=part.face_colors, **common)
            made.definition = part.definition
            if part.threads:
                made.threads = part.threads
            if part.opacity < 1:  # that of faces is with their colours
                made.opacity = part.opacity
        return scene

    @staticmethod
    def _part_key(part):
        said = part.name, part.source, part.color, part.opacity, part.face_colors, tuple(part.assembly), part.definition, part.placement, repr(part.threads)
        if part.brep is not None:
            return (*said, digest_of(part.brep))
        digest = hashlib.sha256(part.vertices.tobytes())
        digest.update(part.triangles.tobytes())
        return (*said, part.vertices.shape, digest.digest())
