"""Irradiance at points by the path tracer of Mitsuba 3.

From each point cosine rays start, as from its sensor `irradiancemeter`; the integrator `path` samples emitters from the first hit
on. Points that are `lit` sample an emitter too, weighted by the balance heuristic, as for somebody who looks straight at the point.
"""

import drjit as dr
import mitsuba as mi
import numpy

# Paths of one launch. Chosen.
LAUNCH = 2**21


class Meter:
    """Points with normals in a scene, which `mitsuba.load_dict` has made."""

    def __init__(self, scene, points, normals, lit):
        self.scene = scene
        self.lit = lit
        self.integrator = mi.load_dict({"type": "path", "max_depth": -1, "rr_depth": 5})
        self.points = mi.Point3f(numpy.asarray(points, numpy.float32).T)
        self.normals = mi.Normal3f(numpy.asarray(normals, numpy.float32).T)
        self.count = len(points)

    def launch(self, paths, seed):
        """Sums and sums of squares over so many paths from each point."""
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(seed, self.count * paths)
        point = dr.arange(mi.UInt32, self.count * paths) // paths
        at = dr.zeros(mi.SurfaceInteraction3f, self.count * paths)
        at.p = dr.gather(mi.Point3f, self.points, point)
        at.n = dr.gather(mi.Normal3f, self.normals, point)
        at.sh_frame = mi.Frame3f(at.n)
        light = self.by_rays(at, sampler)
        if self.lit:
            light += self.by_lamps(at, sampler)
        sums = dr.block_sum(light, paths), dr.block_sum(light * light, paths)
        dr.eval(sums)
        return [numpy.array(own, float) for own in sums]

    def by_lamps(self, at, sampler):
        """Light of a point on an emitter, weighted by the balance heuristic."""
        sample, weight = self.scene.sample_emitter_direction(at, sampler.next_2d(), True)
        cosine = dr.maximum(dr.dot(at.n, sample.d), 0)
        share = sample.pdf / (sample.pdf + cosine * dr.inv_pi)
        return dr.select(cosine > 0, weight[0] * cosine * share, 0)

    def by_rays(self, at, sampler):
        """Light along a cosine ray."""
        local = mi.warp.square_to_cosine_hemisphere(sampler.next_2d())
        ray = at.spawn_ray(at.to_world(local))
        light, _, _ = self.integrator.sample(self.scene, sampler, mi.RayDifferential3f(ray))
        if self.lit:
            return dr.pi * (light[0] - self.by_both(at, ray, mi.warp.square_to_cosine_hemisphere_pdf(local)))
        return dr.pi * light[0]

    def by_both(self, at, ray, density):
        """What the emitter at the end of a ray sends, as far as the balance heuristic leaves it to points on emitters."""
        hit = self.scene.ray_intersect(ray)
        emitter = hit.emitter(self.scene)
        own = emitter.eval(hit)[0]
        sample = mi.DirectionSample3f(self.scene, hit, at)
        other = dr.select(emitter != None, self.scene.pdf_emitter_direction(at, sample), 0)  # noqa: E711
        return dr.select(own > 0, own * other / (other + density), 0)

    def irradiance(self, paths, seed):
        """Means over so many paths from each point, and their standard errors."""
        most = max(1, LAUNCH // self.count)
        launches = -(-paths // most)
        sums = [numpy.zeros(self.count), numpy.zeros(self.count)]
        done = 0
        for k in range(launches):
            now = paths * (k + 1) // launches - paths * k // launches
            for total, part in zip(sums, self.launch(now, seed * 100003 + k)):
                total += part
            done += now
        means = sums[0] / done
        return means, numpy.sqrt(numpy.maximum(sums[1] / done - means**2, 0) / max(1, done - 1))
