package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.exercises.drawing.AnswerGrid;
import rasterlab.exercises.score.CasePicture;

/**
 * Draws the right answer to an input by the form that both have as JSON, for a statement: pixels
 * with the exact curve they stand for, all others as in the answer to a case.
 */
public final class RightPicture {
    private static final int MOST_COLUMNS = 80;
    private static final int MOST_ROWS = 60;

    private final JsonNode input;
    private final JsonNode exact;

    /**
     * @param input as {@code ./lab run} takes it
     * @param exact the right answer as {@code ./lab run} gives it
     */
    public RightPicture(JsonNode input, JsonNode exact) {
        this.input = input;
        this.exact = exact;
    }

    public byte[] png() {
        if (exact.has("pixels") || exact.has("picture")) return pixels();
        return CasePicture.of(new FormPictures(input, exact, exact).drawn(), CasePicture.EXPECTED)
                .orElseThrow()
                .png();
    }

    private byte[] pixels() {
        PixelSet lit = new FormPixels(input).lit(exact);
        List<Shape> curves = curves();
        List<Pixel> begin = new ArrayList<>();
        JsonNode seed = input.path("seed");
        if (seed.size() == 2) begin.add(new Pixel(seed.get(0).asInt(), seed.get(1).asInt()));
        return new AnswerGrid(shown(lit, curves)).png(lit, blocked(lit), curves, begin);
    }

    /** A given picture whole; of anything else what is drawn, with one pixel around it. */
    private PixelWindow shown(PixelSet lit, List<Shape> curves) {
        JsonNode rows = input.path("picture");
        if (!rows.isEmpty())
            return new PixelWindow(0, 0, rows.get(0).asText().length() - 1, rows.size() - 1)
                    .around(0, 0, MOST_COLUMNS, MOST_ROWS);
        Rectangle2D box = null;
        for (int i = 0; i < lit.size(); i++) {
            var pixel = new Rectangle2D.Double(lit.x(i), lit.y(i), 0, 0);
            box = box == null ? pixel : box.createUnion(pixel);
        }
        for (Shape one : curves) box = box == null ? one.getBounds2D() : union(box, one);
        if (box == null) return new PixelWindow(0, 0, 0, 0);
        var all =
                new PixelWindow(
                        (int) Math.floor(box.getMinX()) - 1,
                        (int) Math.floor(box.getMinY()) - 1,
                        (int) Math.ceil(box.getMaxX()) + 1,
                        (int) Math.ceil(box.getMaxY()) + 1);
        return all.around((int) box.getCenterX(), (int) box.getCenterY(), MOST_COLUMNS, MOST_ROWS);
    }

    private static Rectangle2D union(Rectangle2D box, Shape shape) {
        return box.createUnion(shape.getBounds2D());
    }

    /** The given pixels of another colour than the seed's, that are not written. */
    private PixelSet blocked(PixelSet lit) {
        JsonNode rows = input.path("picture");
        JsonNode seed = input.path("seed");
        var blocked = new PixelRecording(Integer.MAX_VALUE);
        if (rows.isEmpty() || seed.size() != 2) return PixelSet.of(blocked);
        char free = rows.get(seed.get(1).asInt()).asText().charAt(seed.get(0).asInt());
        for (int y = 0; y < rows.size(); y++)
            for (int x = 0; x < rows.get(y).asText().length(); x++)
                if (rows.get(y).asText().charAt(x) != free && !lit.contains(x, y))
                    blocked.plot(x, y);
        return PixelSet.of(blocked);
    }

    /** The exact line, circle, ellipse or polygon; none where the input has none of these. */
    private List<Shape> curves() {
        if (input.has("from") && input.has("to")) {
            JsonNode from = input.get("from");
            JsonNode to = input.get("to");
            return List.of(new Line2D.Double(at(from, 0), at(from, 1), at(to, 0), at(to, 1)));
        }
        if (input.has("center"))
            return List.of(
                    input.has("radius")
                            ? ellipse(at("radius"), at("radius"))
                            : ellipse(at("rx"), at("ry")));
        JsonNode polygon = input.path("polygon");
        if (polygon.isEmpty()) return List.of();
        var path = new Path2D.Double();
        path.moveTo(at(polygon.get(0), 0), at(polygon.get(0), 1));
        for (int i = 1; i < polygon.size(); i++)
            path.lineTo(at(polygon.get(i), 0), at(polygon.get(i), 1));
        path.closePath();
        return List.of(path);
    }

    private Shape ellipse(double rx, double ry) {
        JsonNode center = input.get("center");
        return new Ellipse2D.Double(at(center, 0) - rx, at(center, 1) - ry, 2 * rx, 2 * ry);
    }

    private double at(String field) {
        return FormPictures.number(input.get(field));
    }

    private static double at(JsonNode array, int index) {
        return FormPictures.number(array.get(index));
    }
}
