package rasterlab.app.line.figure;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.line.trace.LineColors;

/** Light for a pixel of length against the angle to the rows in degrees, method by method. */
record BrightnessPicture(
        SlopeFigure figure, List<String> methods, List<List<Double>> light, BrightnessWords words)
        implements PlanePicture {
    /**
     * The text that is written over it.
     *
     * @param even at the line of even brightness
     * @param degrees along the angles
     * @param light along the light
     */
    record BrightnessWords(String even, String degrees, String light) {}

    /** The least contrast of lines so wide, each of which has its name and its own dashes too. */
    private static final double SEEN = 2;

    /** The most light that is shown. */
    static final double TOP = 1.1;

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        nameAxes(g, map, colors);
        Color faint = MethodColors.mix(colors.axis(), colors.ink(), 0.3);
        g.setColor(faint);
        g.setStroke(dashed());
        double y = map.viewY(1);
        g.draw(new Line2D.Double(map.viewX(0), y, map.viewX(SlopeFigure.STEEPEST), y));
        double x = map.viewX(figure.degrees());
        g.setColor(colors.focus());
        g.draw(new Line2D.Double(x, map.viewY(0), x, map.viewY(TOP)));
        for (int i = 0; i < methods.size(); i++) curve(g, map, colors, i);
        plate(g, words.even, map.viewX(4), y - 8, colors);
        for (int i = 0; i < methods.size(); i++) key(g, map, colors, i);
    }

    /**
     * Writes the axes' names beyond the curves: below the end of the one axis, over the end of the
     * other.
     */
    private void nameAxes(Graphics2D g, PlaneMap map, StageColors colors) {
        FontMetrics metrics = g.getFontMetrics();
        double right = map.viewX(SlopeFigure.STEEPEST) - metrics.stringWidth(words.degrees);
        plate(g, words.degrees, right, map.viewY(0) + metrics.getAscent() + 5, colors);
        plate(g, words.light, map.viewX(0) + 8, map.viewY(TOP) - 4, colors);
    }

    private static BasicStroke dashed() {
        return new BasicStroke(
                1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {6, 4}, 0);
    }

    private void curve(Graphics2D g, PlaneMap map, StageColors colors, int method) {
        var path = new Path2D.Double();
        for (int degrees = 0; degrees < light.get(method).size(); degrees++) {
            double at = light.get(method).get(degrees);
            if (Double.isNaN(at)) continue;
            boolean begins = degrees == 0 || Double.isNaN(light.get(method).get(degrees - 1));
            if (begins) path.moveTo(map.viewX(degrees), map.viewY(at));
            else path.lineTo(map.viewX(degrees), map.viewY(at));
        }
        g.setStroke(stroke(method));
        g.setColor(ink(colors, method));
        g.draw(path);
    }

    /** The second one dashed, so that both are seen where they are one. */
    private static BasicStroke stroke(int method) {
        return method == 0
                ? new BasicStroke(3.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND)
                : new BasicStroke(
                        3, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {9, 7}, 0);
    }

    /** The method's own colour where it can be seen: darkened, sky blue would be taken for blue. */
    private Color ink(StageColors colors, int method) {
        Color own = LineColors.OWN.of(methods.get(method));
        boolean seen = MethodColors.contrast(own, colors.ground()) >= SEEN;
        return seen ? own : MethodColors.edgeOn(colors.ground(), own);
    }

    /** Writes the methods' names below each other in the lower left corner. */
    private void key(Graphics2D g, PlaneMap map, StageColors colors, int method) {
        FontMetrics metrics = g.getFontMetrics();
        double y = map.viewY(0.08) - (methods.size() - 1 - method) * (metrics.getHeight() + 6);
        double x = map.viewX(4);
        g.setColor(ink(colors, method));
        g.setStroke(stroke(method));
        g.draw(new Line2D.Double(x, y - 4, x + 25, y - 4));
        plate(g, methods.get(method), x + 34, y, colors);
    }

    private static void plate(Graphics2D g, String words, double x, double y, StageColors colors) {
        Plates.plate(g, words, (int) x, (int) y, colors.ground(), colors.ink());
    }
}
