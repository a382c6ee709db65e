"""The manual of the gear pump: `sphinx-build samples/manual build/manual`, with the Python module of Burin on the path."""

project = "Gear pump"
author = "The Burin team"
copyright = "2026, The Burin team"
extensions = ["burin.sphinx"]
exclude_patterns = ["_burin"]
html_theme = "alabaster"
html_theme_options = {"page_width": "60em", "sidebar_width": "14em"}
html_static_path = ["static"]
html_css_files = ["burin.css"]
latex_elements = {"papersize": "a4paper", "extraclassoptions": "openany,oneside"}

# Options of all drawings that do not set their own.
burin_options = {"style": "technical", "paper": "150x110", "margin": 3}
