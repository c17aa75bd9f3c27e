#!/usr/bin/env python3
"""Draws the files of docs/tutorial.md with QGIS, without its window (Debian: python3-qgis).

usage: qgis_pictures.py FOLDER

FOLDER has the files; tin.png and dem.png are written into it.
"""
import os
import pathlib
import sys

os.environ["QT_QPA_PLATFORM"] = "offscreen"

from qgis.core import (  # noqa: E402
    QgsApplication, QgsColorRampShader, QgsFillSymbol, QgsLineSymbol, QgsMapRendererParallelJob,
    QgsMapSettings, QgsMarkerSymbol, QgsPalLayerSettings, QgsRasterLayer, QgsRasterShader,
    QgsRectangle, QgsRendererCategory, QgsCategorizedSymbolRenderer, QgsSingleBandPseudoColorRenderer,
    QgsTextBufferSettings, QgsTextFormat, QgsVectorLayer, QgsVectorLayerSimpleLabeling)
from qgis.PyQt.QtCore import QSize, Qt  # noqa: E402
from qgis.PyQt.QtGui import QColor, QPainter  # noqa: E402


def vector(folder, name):
    layer = QgsVectorLayer(str(folder / name), name, "ogr")
    if not layer.isValid():
        sys.exit(f"QGIS cannot read {folder / name}")
    print(f"{name}: {layer.featureCount()} features, {layer.crs().authid()}")
    return layer


def raster(folder, name):
    layer = QgsRasterLayer(str(folder / name), name)
    if not layer.isValid():
        sys.exit(f"QGIS cannot read {folder / name}")
    print(f"{name}: {layer.width()} by {layer.height()} cells, {layer.crs().authid()}")
    return layer


def by_category(layer, field, symbols):
    layer.setRenderer(QgsCategorizedSymbolRenderer(
        field, [QgsRendererCategory(value, symbol, str(value)) for value, symbol in symbols]))


def draw(layers, extent, size, file, has_few_colours):
    settings = QgsMapSettings()
    settings.setLayers(layers)
    settings.setDestinationCrs(layers[0].crs())
    settings.setExtent(extent)
    settings.setOutputSize(QSize(*size))
    settings.setBackgroundColor(QColor("white"))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    image = job.renderedImage()
    if has_few_colours:
        image = image.convertToFormat(image.Format_Indexed8, Qt.ThresholdDither)
    image.save(str(file), "PNG")


def tin_layers(folder):
    triangles = vector(folder, "terrain.gpkg")
    def fill(colour):
        return QgsFillSymbol.createSimple({"color": colour, "outline_color": "#8a8a8a",
                                           "outline_width": "0.15"})
    by_category(triangles, "changed", [(0, fill("#ffffff")), (1, fill("#9ecae1"))])
    edges = vector(folder, "changed.gpkg")
    by_category(edges, "kind", [
        ("old", QgsLineSymbol.createSimple({"color": "#b3261a", "width": "0.5",
                                            "line_style": "dash"})),
        ("new", QgsLineSymbol.createSimple({"color": "#0f55a8", "width": "0.7"}))])
    pits = vector(folder, "pits.gpkg")
    def mark(colour):
        return QgsMarkerSymbol.createSimple({"color": colour, "size": "2.8",
                                             "outline_color": "#2b2a28", "outline_width": "0.4"})
    by_category(pits, "fate", [("removed", mark("#f7b52c")), ("left", mark("#ffffff"))])
    return [pits, edges, triangles]


def dem_layers(folder):
    contours = vector(folder, "contours.gpkg")
    contours.renderer().setSymbol(QgsLineSymbol.createSimple({"color": "#5a4632", "width": "0.3"}))
    text = QgsTextFormat()
    text.setSize(8)
    text.setColor(QColor("#3a2c1c"))
    halo = QgsTextBufferSettings()
    halo.setEnabled(True)
    halo.setSize(0.8)
    text.setBuffer(halo)
    labels = QgsPalLayerSettings()
    labels.fieldName = "elevation"
    labels.placement = QgsPalLayerSettings.Line
    labels.setFormat(text)
    contours.setLabeling(QgsVectorLayerSimpleLabeling(labels))
    contours.setLabelsEnabled(True)
    heights = raster(folder, "dem.tif")
    band = heights.dataProvider().bandStatistics(1)
    colours = QgsColorRampShader(band.minimumValue, band.maximumValue)
    colours.setColorRampType(QgsColorRampShader.Interpolated)
    names = ["#b5d6b0", "#f0ead0", "#ecccaa", "#ffffff"]
    step = (band.maximumValue - band.minimumValue) / (len(names) - 1)
    colours.setColorRampItemList([
        QgsColorRampShader.ColorRampItem(band.minimumValue + i * step, QColor(name))
        for i, name in enumerate(names)])
    shader = QgsRasterShader()
    shader.setRasterShaderFunction(colours)
    heights.setRenderer(QgsSingleBandPseudoColorRenderer(heights.dataProvider(), 1, shader))
    heights.setBlendMode(QPainter.CompositionMode_Multiply)
    return [contours, heights, raster(folder, "shade.tif")]


def main():
    folder = pathlib.Path(sys.argv[1])
    application = QgsApplication([], False)
    application.initQgis()
    layers = tin_layers(folder)
    draw(layers, QgsRectangle(273480, 5274480, 273590, 5274555), (900, 620),
         folder / "tin.png", True)
    layers = dem_layers(folder)
    draw(layers, layers[1].extent(), (480, 480), folder / "dem.png", False)
    sys.stdout.flush()
    os._exit(0)  # QGIS does not end quietly


main()
