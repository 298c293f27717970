package rasterlab.engine.surface;

import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.polygon.scan.ScanlinePolygon;
import rasterlab.engine.raster.Raster;

/** Draws polygons and lines with brushes and pens into a picture. */
public final class DrawingSurface {
    private final PolygonFiller filler = new ScanlinePolygon();
    private final Raster picture;

    public DrawingSurface(Raster picture) {
        this.picture = picture;
    }

    /** Fills a polygon, as {@link PolygonFiller} does, the spans' pixels from the brush. */
    public void fill(double[] x, double[] y, FillRule rule, Brush brush) {
        int width = picture.width();
        int[] cells = picture.argb();
        filler.fill(
                x,
                y,
                rule,
                width,
                picture.height(),
                (row, from, to) -> {
                    for (int column = from; column < to; column++) {
                        int color = brush.color(column, row);
                        if (color != Brush.CLEAR) cells[row * width + column] = color;
                    }
                });
    }

    /** Draws a line from point to point: its dashes, each a few polygons. */
    public void draw(double[] x, double[] y, Pen pen, Brush brush) {
        pen.outline(x, y, (cornerX, cornerY) -> fill(cornerX, cornerY, FillRule.NON_ZERO, brush));
    }
}
