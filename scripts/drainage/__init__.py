"""The drainage experiment: what a TIN of some of a raster's cells knows of the raster's land."""
