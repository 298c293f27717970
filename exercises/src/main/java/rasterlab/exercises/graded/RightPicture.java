package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Format;
import rasterlab.exercises.drawing.AnswerGrid;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.PictureBytes;

/**
 * Draws the right answer to an input by what the topic's format says of both, for a statement:
 * pixels with the exact curve they stand for, all others as in the answer to a case.
 */
public final class RightPicture {
    private static final int MOST_COLUMNS = 80;
    private static final int MOST_ROWS = 60;

    private final FormFields fields;
    private final JsonNode exact;

    /**
     * @param input as {@code ./lab run} takes it
     * @param exact the right answer as {@code ./lab run} gives it
     */
    public RightPicture(Format<?, ?, ?> format, JsonNode input, JsonNode exact) {
        this.fields = new FormFields(format, input);
        this.exact = exact;
    }

    /** The picture, in each language. */
    public PictureBytes drawn() {
        boolean pixels =
                Stream.of(FieldKind.PIXELS, FieldKind.PICTURE)
                        .anyMatch(kind -> !fields.answered(exact, kind).isEmpty());
        if (pixels) return PictureBytes.alike(pixels());
        return CasePicture.of(new FormPictures(fields, exact, exact).drawn(), CasePicture.EXPECTED)
                .orElseThrow()
                .file();
    }

    private byte[] pixels() {
        PixelSet lit = new FormPixels(fields).lit(exact);
        List<Shape> curves = curves();
        List<Pixel> begin = new ArrayList<>();
        JsonNode seed = fields.one(FieldKind.SEED);
        if (seed.size() == 2) begin.add(new Pixel(seed.get(0).asInt(), seed.get(1).asInt()));
        return new AnswerGrid(shown(lit, curves)).png(lit, blocked(lit), curves, begin);
    }

    /** A given picture whole; of anything else what is drawn, with one pixel around it. */
    private PixelWindow shown(PixelSet lit, List<Shape> curves) {
        JsonNode rows = fields.one(FieldKind.PICTURE);
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
        JsonNode rows = fields.one(FieldKind.PICTURE);
        JsonNode seed = fields.one(FieldKind.SEED);
        var blocked = new PixelRecording(Integer.MAX_VALUE);
        if (rows.isEmpty() || seed.size() != 2) return PixelSet.of(blocked);
        char free = rows.get(seed.get(1).asInt()).asText().charAt(seed.get(0).asInt());
        for (int y = 0; y < rows.size(); y++)
            for (int x = 0; x < rows.get(y).asText().length(); x++)
                if (rows.get(y).asText().charAt(x) != free && !lit.contains(x, y))
                    blocked.plot(x, y);
        return PixelSet.of(blocked);
    }

    /** The exact line, circle, ellipse or polygons; none where the input has none of these. */
    private List<Shape> curves() {
        JsonNode from = fields.one(FieldKind.START);
        JsonNode to = fields.one(FieldKind.END);
        if (from.isArray() && to.isArray()) {
            Shape line = new Line2D.Double(at(from, 0), at(from, 1), at(to, 0), at(to, 1));
            return Stream.concat(Stream.of(line), window().stream()).toList();
        }
        JsonNode center = fields.one(FieldKind.CENTER);
        if (center.isArray()) return List.of(ellipse(center));
        List<Shape> outlines = new ArrayList<>();
        for (JsonNode one : fields.given(FieldKind.POLYGON)) outline(one, outlines);
        for (JsonNode all : fields.given(FieldKind.POLYGONS))
            for (JsonNode one : all) outline(one, outlines);
        return outlines;
    }

    /** The outline of the pixels of a window whose columns and rows are given. */
    private Optional<Shape> window() {
        JsonNode sides = fields.one(FieldKind.WINDOW);
        if (sides.size() != 4) return Optional.empty();
        double width = at(sides, 2) - at(sides, 0) + 1;
        double height = at(sides, 3) - at(sides, 1) + 1;
        return Optional.of(
                new Rectangle2D.Double(at(sides, 0) - 0.5, at(sides, 1) - 0.5, width, height));
    }

    private static void outline(JsonNode corners, List<Shape> into) {
        if (corners.isEmpty()) return;
        var path = new Path2D.Double();
        path.moveTo(at(corners.get(0), 0), at(corners.get(0), 1));
        for (int i = 1; i < corners.size(); i++)
            path.lineTo(at(corners.get(i), 0), at(corners.get(i), 1));
        path.closePath();
        into.add(path);
    }

    private Shape ellipse(JsonNode center) {
        double radius = number(FieldKind.RADIUS, 0);
        double rx = number(FieldKind.RADIUS_X, radius);
        double ry = number(FieldKind.RADIUS_Y, radius);
        return new Ellipse2D.Double(at(center, 0) - rx, at(center, 1) - ry, 2 * rx, 2 * ry);
    }

    private double number(FieldKind kind, double otherwise) {
        return fields.given(kind).stream()
                .mapToDouble(FormPictures::number)
                .findFirst()
                .orElse(otherwise);
    }

    private static double at(JsonNode array, int index) {
        return FormPictures.number(array.get(index));
    }
}
