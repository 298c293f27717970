package rasterlab.exercises.drawing;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import rasterlab.exercises.drawing.PlaneFigure.FigureKind;

/**
 * Fills what polygons cover, pixel by pixel: pale where expected and actual ones both do, hatched
 * by − where only expected ones do, by + where only actual ones do.
 */
final class PlaneFill {
    /** Pixels from one sign of a hatch to the next. */
    private static final int HATCH = 14;

    private static final int ARM = 2;

    private final PlaneToPixels view;
    private final int width;
    private final int height;

    PlaneFill(PlaneToPixels view, int width, int height) {
        this.view = view;
        this.width = width;
        this.height = height;
    }

    void paint(BufferedImage image, List<PlaneFigure> expected, List<PlaneFigure> actual) {
        int[] wanted = covered(expected);
        int[] got = covered(actual);
        for (int i = 0; i < wanted.length; i++)
            if (wanted[i] != 0 || got[i] != 0) {
                int x = i % width;
                int y = i / width;
                Color color = wanted[i] == 0 ? Ink.EXTRA : got[i] == 0 ? Ink.MISSING : Ink.EXPECTED;
                boolean sign = color != Ink.EXPECTED && isSign(x, y, color == Ink.EXTRA);
                image.setRGB(x, y, (sign ? Ink.faint(color) : Ink.pale(color)).getRGB());
            }
    }

    private static boolean isSign(int x, int y, boolean plus) {
        int dx = Math.abs(x % HATCH - HATCH / 2);
        int dy = Math.abs(y % HATCH - HATCH / 2);
        return dx <= ARM && dy == 0 || plus && dx == 0 && dy <= ARM;
    }

    /** Whether a polygon covers the centre, for each pixel. */
    private int[] covered(List<PlaneFigure> figures) {
        var mask = new BufferedImage(width, height, BufferedImage.TYPE_BYTE_BINARY);
        Graphics2D g = mask.createGraphics();
        g.setColor(Color.WHITE);
        for (PlaneFigure each : figures)
            if (each.form() == FigureKind.POLYGON && each.isFinite()) g.fill(view.inside(each));
        g.dispose();
        return mask.getRaster().getSamples(0, 0, width, height, 0, (int[]) null);
    }
}
