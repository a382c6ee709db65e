"""Burin for FreeCAD: illustrations of parts and assemblies."""

__version__ = "0.2.0"
