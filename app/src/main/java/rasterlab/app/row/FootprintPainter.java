package rasterlab.app.row;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import rasterlab.app.canvas.StageColors;
import rasterlab.engine.raster.PixelMark;

/**
 * Paints the texture that is filtered and in it the footprint of the chosen pixel, as squares of
 * some part of it.
 */
final class FootprintPainter {
    /** The footprint's share of the picture that enlarges it. */
    private static final double SHARE = 0.6;

    /** Texels that are seen at least, of the shorter side. */
    private static final double FEWEST = 4;

    /** Repetitions of the picture that are seen at most. */
    private static final double MOST = 4;

    private static final double[][] CORNERS = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};

    private final Graphics2D g;
    private final RowScene.FilteredImage image;
    private final BufferedImage texels;

    /** s, t of its middle, within the picture, and ds/dx, dt/dx, ds/dy, dt/dy. */
    private final double[] footprint;

    FootprintPainter(Graphics2D g, RowScene.FilteredImage image, int pixel) {
        this.g = g;
        this.image = image;
        texels = texels(image);
        footprint = new double[6];
        System.arraycopy(image.footprints(), 6 * pixel, footprint, 0, footprint.length);
        footprint[0] -= Math.floor(footprint[0]);
        footprint[1] -= Math.floor(footprint[1]);
    }

    /** The bottom row of texels lies at the bottom. */
    private static BufferedImage texels(RowScene.FilteredImage image) {
        int width = image.width();
        int height = image.height();
        var texels = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        for (int row = 0; row < height; row++)
            texels.setRGB(0, height - 1 - row, width, 1, image.argb(), row * width, width);
        return texels;
    }

    /** Draws the picture once, the footprint brought into it where the picture repeats. */
    void whole(int left, int top, int size) {
        paint(left, top, size, new double[] {0, 0}, 1);
    }

    /** Draws the footprint, and of the repeated picture what lies around it. */
    void enlarged(int left, int top, int size) {
        double wide = Math.abs(footprint[2]) + Math.abs(footprint[4]);
        double high = Math.abs(footprint[3]) + Math.abs(footprint[5]);
        double fewest = FEWEST / Math.min(image.width(), image.height());
        double side = Math.min(MOST, Math.max(fewest, Math.max(wide, high) / SHARE));
        double[] from = {footprint[0] - side / 2, footprint[1] - side / 2};
        paint(left, top, size, from, side);
    }

    /**
     * @param from s and t of the lower left corner
     * @param side of the part that is seen, in s and t
     */
    private void paint(int left, int top, int size, double[] from, double side) {
        var part = (Graphics2D) g.create();
        part.clipRect(left, top, size, size);
        part.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        double scale = size / side;
        for (double s = Math.floor(from[0]); s < from[0] + side; s++)
            for (double t = Math.floor(from[1]); t < from[1] + side; t++) {
                var place = new AffineTransform();
                place.translate(
                        left + scale * (s - from[0]), top + size - scale * (t + 1 - from[1]));
                place.scale(scale / image.width(), scale / image.height());
                part.drawImage(texels, place, null);
            }
        outline(part, left - scale * from[0], top + size + scale * from[1], scale);
        part.dispose();
        g.setColor(StageColors.now().axis());
        g.setStroke(new BasicStroke(1));
        g.drawRect(left, top, size, size);
    }

    /**
     * @param x of s = 0
     * @param y of t = 0
     * @param scale view units to s = 1 and t = 1
     */
    private void outline(Graphics2D part, double x, double y, double scale) {
        var outline = new Path2D.Double();
        for (double[] c : CORNERS) {
            double px = x + scale * (footprint[0] + c[0] * footprint[2] + c[1] * footprint[4]);
            double py = y - scale * (footprint[1] + c[0] * footprint[3] + c[1] * footprint[5]);
            if (outline.getCurrentPoint() == null) outline.moveTo(px, py);
            else outline.lineTo(px, py);
        }
        outline.closePath();
        part.setColor(Color.WHITE);
        part.setStroke(new BasicStroke(5));
        part.draw(outline);
        part.setColor(PixelMark.COLOR);
        part.setStroke(new BasicStroke(2));
        part.draw(outline);
    }
}
