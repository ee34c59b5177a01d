# SPDX-License-Identifier: Apache-2.0
"""Blender scenes for Umbrameter: an add-on (File > Export > Umbrameter scene) that is also a command.

blender -b FILE.blend -P umbrameter_blender.py -- --out DIR [--camera NAME] [--light NAME]... [--width PX]
    [--pictures cycles,eevee] [--samples N] [--seed N]
blender -b -P umbrameter_blender.py -- --install-addon

writes DIR/scene.toml, which `umbrameter validate` reads, scene.glb beside it and, with --pictures, what `umbrameter score` reads.
Exit codes: 0 fine, 1 the program's own fault, 2 the scene or the command cannot be used; each with one sentence.
"""
import argparse
import os
import pathlib
import shutil
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import bpy
from bpy.props import BoolProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

try:
    from umbrameter_scene import engine_pictures, folder
    from umbrameter_scene.said import Refused, Said
except ModuleNotFoundError as missing:  # numpy: Blender takes it from the first python3 of PATH
    sys.stderr.write(f"umbrameter_blender: error: Blender's Python has no module '{missing.name}' (Debian: python3-{missing.name}; "
                     "another python3 first in PATH hides it)\n")
    if __name__ == "__main__":
        sys.exit(2)
    raise

bl_info = {
    "name": "Umbrameter scene",
    "description": "Writes what Umbrameter measures shadows on: evaluated meshes, lights with their sizes, cameras, masks",
    "author": "The Umbrameter authors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "File > Export > Umbrameter scene",
    "category": "Import-Export",
}


def run(out, camera="", lights=(), width=0, pictures=(), samples=0, seed=1):
    """(summary, warnings, commands that score the pictures). Raises Refused."""
    said = Said()
    export = folder.export(bpy.context.scene, pathlib.Path(out).absolute(), camera, lights, width, said)
    commands = []
    for engine in pictures:
        commands += engine_pictures.draw(export, engine, samples, seed, said)
    return export.summary, said.lines(), commands


class EXPORT_OT_umbrameter(bpy.types.Operator, ExportHelper):
    """Write a folder that umbrameter reads"""
    bl_idname = "export_scene.umbrameter"
    bl_label = "Export Umbrameter scene"
    filename_ext = ""
    use_filter_folder = True

    camera: StringProperty(name="Camera", description="Whose view scene.toml has; empty: the scene's")
    light: StringProperty(name="Light", description="The one light to write; empty: all")
    cycles: BoolProperty(name="Cycles' pictures", description="Also render what `umbrameter score` reads; Blender waits")
    eevee: BoolProperty(name="EEVEE's pictures", description="Also draw what `umbrameter score` reads; Blender waits")
    samples: IntProperty(name="Samples", description="Per pixel of those pictures; 0: the engine's default", min=0, max=65536)

    def execute(self, _context):
        pictures = [name for name in engine_pictures.NAMES if getattr(self, name)]
        try:
            summary, warnings, commands = run(self.filepath, self.camera, [self.light] if self.light else [], 0, pictures, self.samples)
        except (Refused, OSError) as why:
            self.report({"ERROR"}, sentence(why))
            return {"CANCELLED"}
        for warning in warnings:
            self.report({"WARNING"}, warning)
        for line in (summary, *commands):
            self.report({"INFO"}, line)
        return {"FINISHED"}


def menu_entry(self, _context):
    self.layout.operator(EXPORT_OT_umbrameter.bl_idname, text="Umbrameter scene (folder)")


def register():
    bpy.utils.register_class(EXPORT_OT_umbrameter)
    bpy.types.TOPBAR_MT_file_export.append(menu_entry)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu_entry)
    bpy.utils.unregister_class(EXPORT_OT_umbrameter)


def sentence(why):
    return f"{why.filename}: {why.strerror}" if isinstance(why, OSError) and why.filename else str(why)


def install_addon():
    """Copies what the add-on needs into the user's add-ons, and switches it on for good."""
    addons = pathlib.Path(bpy.utils.user_resource("SCRIPTS", path="addons", create=True))
    target = addons / "umbrameter_blender"
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(HERE / "umbrameter_scene", target / "umbrameter_scene", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copyfile(__file__, target / "__init__.py")
    if engine_pictures.ENGINES:
        for name in ("blender", *engine_pictures.NAMES):
            shutil.copytree(engine_pictures.ENGINES / name, target / "engines" / name, ignore=shutil.ignore_patterns("__pycache__"))
    bpy.ops.preferences.addon_enable(module="umbrameter_blender")
    bpy.ops.wm.save_userpref()
    return target


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Refused(f"{message} (see --help)")


def engine_names(text):
    names = [name for name in text.split(",") if name]
    for name in names:
        if name not in engine_pictures.NAMES:
            raise argparse.ArgumentTypeError(f"'{name}' is none of {', '.join(engine_pictures.NAMES)}")
    return names


def positive(text):
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no whole number above 0")
    return int(text)


def arguments(given):
    parser = Parser(prog="blender -b FILE.blend -P umbrameter_blender.py --", description="A Blender scene as an Umbrameter scene folder.")
    parser.add_argument("--out", metavar="DIR", help="the folder to write; files of the same names are replaced")
    parser.add_argument("--camera", default="", metavar="NAME", help="whose view scene.toml has (default: the scene's)")
    parser.add_argument("--light", action="append", default=[], metavar="NAME", help="only this light; may be repeated (default: all)")
    parser.add_argument("--width", type=positive, default=0, metavar="PX", help="of pictures (default: the render's)")
    parser.add_argument("--pictures", type=engine_names, default=[], metavar="cycles,eevee", help="render these, ready for `umbrameter score`")
    parser.add_argument("--samples", type=positive, default=0, metavar="N", help="per pixel of pictures (default: the engine's)")
    parser.add_argument("--seed", type=positive, default=1, metavar="N", help="of Cycles' samples")
    parser.add_argument("--install-addon", action="store_true", help="put the add-on into File > Export, and do nothing else")
    options = parser.parse_args(given)
    if not options.install_addon and not options.out:
        parser.error("--out DIR is missing")
    return options


def main():
    # Blender's own words are no part of the answer.
    sys.stdout.flush()
    answer = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    given = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    try:
        if "-h" in given or "--help" in given:
            sys.stdout = answer
        options = arguments(given)
        if options.install_addon:
            print(f"installed {install_addon()}", file=answer)
            return 0
        if not bpy.data.filepath:
            raise Refused("no file is open (blender -b FILE.blend -P umbrameter_blender.py -- --out DIR)")
        summary, warnings, commands = run(options.out, options.camera, options.light, options.width, options.pictures,
                                          options.samples, options.seed)
    except (Refused, OSError) as why:
        print(f"umbrameter_blender: error: {sentence(why)}", file=sys.stderr)
        return 2
    except Exception as why:
        print(f"umbrameter_blender: error: a fault of the program: {why!r}", file=sys.stderr)
        return 1
    for warning in warnings:
        print(f"umbrameter_blender: warning: {warning}", file=sys.stderr)
    print(f"{pathlib.Path(options.out) / 'scene.toml'}: {summary}", file=answer)
    for command in commands:
        print(command, file=answer)
    answer.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main())
