# SPDX-License-Identifier: Apache-2.0
"""Cycles: light alone, no bounces."""
NAME = "Cycles"
DEVICE = "CPU"
SAMPLES = "samples"
FILTER_PX = 1e-4  # a pixel whose samples see two surfaces has no one visibility


def set_up(scene, body, light, values, seed):
    scene.render.engine = "CYCLES"
    settings = scene.cycles
    settings.device = "CPU"
    set_samples(scene, values[SAMPLES])
    settings.seed = seed % (1 << 31)
    settings.use_adaptive_sampling = False
    settings.use_denoising = False
    settings.max_bounces = 0
    settings.light_sampling_threshold = 0.0
    settings.pixel_filter_type = "BLACKMAN_HARRIS"
    settings.filter_width = 0.01
    scene["cycles"]["filter_width"] = FILTER_PX  # the property itself stops at 0.01
    # Both move shadows away from where smooth normals say that they begin.
    body.cycles.shadow_terminator_offset = 0.0
    body.cycles.shadow_terminator_geometry_offset = 0.0


def set_samples(scene, count):
    scene.cycles.samples = count


def set_shadow(light, casts):
    light.cycles.cast_shadow = casts
