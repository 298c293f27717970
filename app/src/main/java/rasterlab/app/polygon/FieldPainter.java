package rasterlab.app.polygon;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.engine.raster.PixelMark;

/** Draws a field: where a method says inside, and where another judge says otherwise. */
final class FieldPainter {
    /** The view units between points from which on each is drawn by itself, with a mark. */
    private static final double ROOMY = 11;

    private static final double SHARE = 0.32;

    private final Graphics2D g;
    private final PlaneMap map;
    private final StageColors colors;
    private final ClassificationField field;
    private final double size;

    FieldPainter(Graphics2D g, PlaneMap map, StageColors colors, ClassificationField field) {
        this.g = g;
        this.map = map;
        this.colors = colors;
        this.field = field;
        size = field.step() * map.scaleX();
    }

    /** Paints where the first judge says inside, in that colour; where it refuses, in grey. */
    void paintInside(Color color) {
        Color light = MethodColors.mix(colors.ground(), color, SHARE);
        Color gray = MethodColors.mix(colors.ground(), colors.axis(), SHARE);
        for (int row = 0; row < field.rows(); row++) {
            int column = 0;
            while (column < field.columns()) {
                int from = column;
                if (field.refused(column, row)) fill(from, column++, row, gray, 0.5);
                else if (!field.first(column, row)) column++;
                else if (size >= ROOMY) fill(from, column++, row, light, 0.8);
                else {
                    while (column < field.columns() && field.first(column, row)) column++;
                    fill(from, column - 1, row, light, 1);
                }
            }
        }
    }

    /**
     * Paints where the judges differ.
     *
     * @param onlyFirst where only the first says inside
     * @param onlySecond where only the second does
     */
    void paintDifferences(Color onlyFirst, Color onlySecond) {
        for (int row = 0; row < field.rows(); row++)
            for (int column = 0; column < field.columns(); column++)
                if (field.differ(column, row))
                    mark(column, row, field.first(column, row) ? onlyFirst : onlySecond);
    }

    private void mark(int column, int row, Color color) {
        boolean extra = field.first(column, row);
        if (size >= ROOMY && color.equals(MethodColors.VERMILLION)) {
            double wide = Math.min(size, 18);
            (extra ? PixelMark.EXTRA : PixelMark.MISSING)
                    .paint(
                            g,
                            map.viewX(field.x(column)) - wide / 2,
                            map.viewY(field.y(row)) - wide / 2,
                            wide);
            return;
        }
        fill(column, column, row, color, 1);
        if (!extra) fill(column, column, row, colors.ground(), 0.45);
    }

    /** Squares around points of a row, cut at whole view units so that no seam is seen. */
    private void fill(int from, int to, int row, Color color, double share) {
        Object smooth = g.getRenderingHint(RenderingHints.KEY_ANTIALIASING);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_OFF);
        double half = size * share / 2;
        double y = map.viewY(field.y(row));
        int left = (int) Math.round(map.viewX(field.x(from)) - half);
        int right = (int) Math.round(map.viewX(field.x(to)) + half);
        int top = (int) Math.round(y - half);
        int bottom = (int) Math.round(y + half);
        g.setColor(color);
        g.fillRect(left, top, right - left, bottom - top);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, smooth);
    }
}
