# How Sphinx makes the site of the pages that stage.py puts together. Nothing on it comes from elsewhere:
# it is read without a network.
project = "hodt"
author = "The hodt authors"
extensions = ["myst_parser"]
exclude_patterns = ["extra"]
html_theme = "furo"
html_title = "hodt"
html_extra_path = ["extra"]  # what doxygen made
html_static_path = ["static"]
html_css_files = ["site.css"]
highlight_language = "text"  # of blocks that do not say theirs
html_copy_source = False
html_show_copyright = False
myst_enable_extensions = ["deflist"]
myst_heading_anchors = 4
python_maximum_signature_line_length = 90
python_use_unqualified_type_names = True
