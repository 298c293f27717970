package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.Cell;
import rasterlab.app.practice.Board.Dot;
import rasterlab.app.practice.Board.Figure;
import rasterlab.app.practice.Board.Look;
import rasterlab.app.practice.Board.Path;
import rasterlab.app.practice.Board.Run;
import rasterlab.app.practice.Board.Space;
import rasterlab.app.practice.Sketch.Walked;

/** Areas that are filled row by row: the next run of pixels is drawn with the pointer. */
final class RowSketches {
    private static final String FROM = "from";
    private static final String TO = "to";
    private static final String ROW = "y";

    /** A wrong run is drawn so far; nobody sees more. */
    private static final int MOST = 200;

    private RowSketches() {}

    /** A seed in a picture with walls. */
    static Board fill(Walked walked) {
        JsonNode picture = walked.input().path("picture");
        JsonNode seed = walked.input().path("seed");
        char filled =
                picture.path(seed.path(1).intValue()).asText().charAt(seed.path(0).intValue());
        var figures = new ArrayList<Figure>();
        for (int y = 0; y < picture.size(); y++)
            for (int x = 0; x < picture.get(y).asText().length(); x++)
                if (picture.get(y).asText().charAt(x) != filled)
                    figures.add(new Cell(x, y, Look.WALL));
        addRuns(walked, figures);
        figures.add(border(picture.path(0).asText().length(), picture.size()));
        figures.add(new Dot(QuestionPoints.of(seed), "", Look.GIVEN));
        return new Board(Space.PIXELS, figures, new Run(ROW, FROM, TO));
    }

    /** A path around all pixels of a picture. */
    static Path border(int width, int height) {
        double right = width - 0.5;
        double bottom = height - 0.5;
        return new Path(
                List.of(
                        new Point2D.Double(-0.5, -0.5),
                        new Point2D.Double(right, -0.5),
                        new Point2D.Double(right, bottom),
                        new Point2D.Double(-0.5, bottom)),
                true,
                Look.GIVEN);
    }

    static Board polygon(Walked walked) {
        var figures = new ArrayList<Figure>();
        addRuns(walked, figures);
        JsonNode told = walked.told().path(ROW);
        JsonNode width = walked.input().path("size").path(0);
        figures.add(new Path(QuestionPoints.all(walked.input().path("polygon")), true, Look.GIVEN));
        if (told.isNumber())
            figures.add(
                    new Path(
                            List.of(
                                    new Point2D.Double(0, told.doubleValue()),
                                    new Point2D.Double(
                                            width.doubleValue() - 1, told.doubleValue())),
                            false,
                            Look.ASKED));
        return new Board(Space.PIXELS, figures, new Run("", FROM, TO));
    }

    private static void addRuns(Walked walked, List<Figure> figures) {
        for (int i = 0; i < walked.steps().size(); i++)
            add(figures, walked.steps().get(i), walked.steps().get(i), walked.look(i));
        walked.wrong()
                .ifPresent(
                        answer ->
                                add(
                                        figures,
                                        answer,
                                        walked.steps().get(walked.steps().size() - 1),
                                        Look.WRONG));
    }

    /**
     * @param step has the row where the run does not
     */
    private static void add(List<Figure> figures, JsonNode run, JsonNode step, Look look) {
        int y = run.path(ROW).asInt(step.path(ROW).intValue());
        int from = run.path(FROM).intValue();
        int to = Math.min(run.path(TO).intValue(), from + MOST);
        for (int x = from; x < to; x++) figures.add(new Cell(x, y, look));
    }
}
