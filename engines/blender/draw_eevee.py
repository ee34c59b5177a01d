# SPDX-License-Identifier: Apache-2.0
"""EEVEE: shadow maps, drawn once a sample from another point of the light where shadows are soft."""
NAME = "EEVEE"
DEVICE = "Mesa llvmpipe, OpenGL on a virtual display"
SAMPLES = "taa_render_samples"
# By our parameters' names, which are Blender's own.
SCENE = ("use_shadow_high_bitdepth", "use_soft_shadows")
SIZES = ("shadow_cube_size", "shadow_cascade_size")
LIGHT = ("shadow_buffer_bias", "shadow_buffer_clip_start", "use_contact_shadow", "contact_shadow_distance",
         "contact_shadow_bias", "contact_shadow_thickness", "shadow_cascade_count", "shadow_cascade_max_distance",
         "shadow_cascade_fade", "shadow_cascade_exponent")


def set_up(scene, body, light, values, seed):
    scene.render.engine = "BLENDER_EEVEE"
    scene.render.filter_size = 0.0
    settings = scene.eevee
    set_samples(scene, values[SAMPLES])
    for name in SCENE:
        setattr(settings, name, values[name])
    for name in SIZES:
        setattr(settings, name, str(values[name]))
    for name in LIGHT:
        if hasattr(light, name):  # cascades belong to the sun
            setattr(light, name, values[name])
    settings.light_threshold = 0.0
    settings.use_gtao = settings.use_bloom = settings.use_ssr = False
    light.specular_factor = 0.0


def set_samples(scene, count):
    scene.eevee.taa_render_samples = count


def set_shadow(light, casts):
    light.use_shadow = casts
