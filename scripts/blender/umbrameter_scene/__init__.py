# SPDX-License-Identifier: Apache-2.0
"""A Blender scene as an Umbrameter scene folder. umbrameter_blender.py beside this folder is the way in."""
