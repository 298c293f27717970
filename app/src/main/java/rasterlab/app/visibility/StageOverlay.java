package rasterlab.app.visibility;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Stroke;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Language;
import rasterlab.engine.visibility.FaceOutlines;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;

/** Paints over a picture: the present step's face, cuts, the chosen pixel, a name. */
final class StageOverlay {
    private static final Stroke WIDE = new BasicStroke(4.5f, 1, 1);
    private static final Stroke THIN = new BasicStroke(2f, 1, 1);
    private static final Stroke FINE = new BasicStroke(2.4f, 1, 1);
    private static final Stroke DASHED = new BasicStroke(1.4f, 1, 1, 10f, new float[] {6f, 5f}, 0f);

    /** Cuts drawn at once; more would hide the picture. */
    private static final int MOST_CUTS = 2000;

    private static final int PLATE_ALPHA = 225;

    private final Graphics2D g;
    private final double scale;

    /**
     * @param g in view units, its origin the picture's corner
     * @param scale device pixels per view unit
     */
    StageOverlay(Graphics2D g, double scale) {
        this.g = g;
        this.scale = scale;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    /** Writes the name of the method, on a plate of its colour. */
    void name(String method, Language language) {
        g.setFont(g.getFont().deriveFont(Font.BOLD));
        Color color = VisibilityColors.OWN.of(method);
        int y = g.getFontMetrics().getAscent() + 8;
        String called = OwnWords.called(method, language);
        Plates.plate(g, called, 12, y, color, MethodColors.inkOn(color));
    }

    /** Draws all cuts up to a step, and the face or the pixels that it was about. */
    void step(Drawn drawn, int done) {
        if (done == 0 || drawn.steps().isEmpty()) return;
        List<VisibilityStep> steps = drawn.steps().subList(0, Math.min(done, drawn.steps().size()));
        drawn.pieces().entrySet().stream()
                .filter(piece -> piece.getKey() < steps.size() - 1)
                .limit(MOST_CUTS)
                .forEach(piece -> outline(piece.getValue(), FINE, DASHED, MethodColors.WINE));
        VisibilityStep last = steps.get(steps.size() - 1);
        if (last instanceof VisibilityStep.FaceDrawn face)
            outline(
                    drawn.pieces()
                            .getOrDefault(
                                    steps.size() - 1,
                                    FaceOutlines.corners(drawn.view(), face.face())));
        else if (last instanceof VisibilityStep.FaceMoved moved)
            outline(FaceOutlines.corners(drawn.view(), moved.face()));
        else if (last instanceof VisibilityStep.FaceCut cut) {
            outline(FaceOutlines.corners(drawn.view(), cut.face()));
            cut(drawn.view(), cut);
        } else if (last instanceof VisibilityStep.SpanSeen span)
            box(span.from(), span.y(), span.to() - span.from(), 1);
        else if (last instanceof VisibilityStep.Window window)
            box(window.x(), window.y(), window.width(), window.height());
    }

    private void outline(double[] corners) {
        outline(corners, WIDE, THIN, MethodColors.BLUE);
    }

    private void outline(double[] corners, Stroke below, Stroke above, Color color) {
        if (corners.length == 0) return;
        var path = new Path2D.Double();
        path.moveTo(corners[0] / scale, corners[1] / scale);
        for (int at = 2; at < corners.length; at += 2)
            path.lineTo(corners[at] / scale, corners[at + 1] / scale);
        path.closePath();
        g.setStroke(below);
        g.setColor(Color.WHITE);
        g.draw(path);
        g.setStroke(above);
        g.setColor(color);
        g.draw(path);
    }

    private void cut(ViewedMesh view, VisibilityStep.FaceCut cut) {
        Optional<double[]> ends = FaceOutlines.cut(view, cut.face(), cut.by());
        if (ends.isEmpty()) return;
        double[] e = ends.get();
        var line = new Line2D.Double(e[0] / scale, e[1] / scale, e[2] / scale, e[3] / scale);
        g.setStroke(WIDE);
        g.setColor(Color.WHITE);
        g.draw(line);
        g.setStroke(THIN);
        g.setColor(MethodColors.WINE);
        g.draw(line);
    }

    private void box(int x, int y, int width, int height) {
        var box =
                new Rectangle2D.Double(
                        x / scale - 1, y / scale - 1, width / scale + 1, height / scale + 1);
        g.setStroke(WIDE);
        g.setColor(Color.WHITE);
        g.draw(box);
        g.setStroke(THIN);
        g.setColor(MethodColors.BLUE);
        g.draw(box);
    }

    /** Draws four ticks around a pixel, which itself stays in sight. */
    void pixel(int x, int y) {
        double middleX = (x + 0.5) / scale;
        double middleY = (y + 0.5) / scale;
        for (boolean wide : new boolean[] {true, false}) {
            g.setStroke(wide ? WIDE : THIN);
            g.setColor(wide ? Color.WHITE : Color.BLACK);
            for (int side = -1; side <= 1; side += 2) {
                g.draw(
                        new Line2D.Double(
                                middleX + 4 * side, middleY, middleX + 11 * side, middleY));
                g.draw(
                        new Line2D.Double(
                                middleX, middleY + 4 * side, middleX, middleY + 11 * side));
            }
        }
    }

    /** Writes a sentence over the picture's lower part. */
    void sentence(List<String> lines, int x, int bottom) {
        sentenceBelow(lines, x, bottom - lineHeight() * lines.size());
    }

    void sentenceBelow(List<String> lines, int x, int top) {
        Color ground = StageColors.now().ground();
        var plate = new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), PLATE_ALPHA);
        int y = top;
        for (String line : lines) {
            y += lineHeight();
            Plates.plate(g, line, x, y, plate, StageColors.now().ink());
        }
    }

    private int lineHeight() {
        return g.getFontMetrics().getHeight() + 2;
    }
}
