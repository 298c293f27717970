package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.practice.Board.BoardCell;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardFigure;
import rasterlab.app.practice.Board.BoardPath;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.RunPick;
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
        var figures = new ArrayList<BoardFigure>();
        for (int y = 0; y < picture.size(); y++)
            for (int x = 0; x < picture.get(y).asText().length(); x++)
                if (picture.get(y).asText().charAt(x) != filled)
                    figures.add(new BoardCell(x, y, FigureLook.WALL));
        addRuns(walked, figures);
        figures.add(border(picture.path(0).asText().length(), picture.size()));
        figures.add(new BoardDot(QuestionPoints.of(seed), "", FigureLook.GIVEN));
        return new Board(BoardSpace.PIXELS, figures, new RunPick(ROW, FROM, TO));
    }

    /** A path around all pixels of a picture. */
    static BoardPath border(int width, int height) {
        double right = width - 0.5;
        double bottom = height - 0.5;
        return new BoardPath(
                List.of(
                        new Point2D.Double(-0.5, -0.5),
                        new Point2D.Double(right, -0.5),
                        new Point2D.Double(right, bottom),
                        new Point2D.Double(-0.5, bottom)),
                true,
                FigureLook.GIVEN);
    }

    static Board polygon(Walked walked) {
        var figures = new ArrayList<BoardFigure>();
        addRuns(walked, figures);
        JsonNode told = walked.given().path(ROW);
        JsonNode width = walked.input().path("size").path(0);
        figures.add(
                new BoardPath(
                        QuestionPoints.all(walked.input().path("polygon")),
                        true,
                        FigureLook.GIVEN));
        if (told.isNumber())
            figures.add(
                    new BoardPath(
                            List.of(
                                    new Point2D.Double(0, told.doubleValue()),
                                    new Point2D.Double(
                                            width.doubleValue() - 1, told.doubleValue())),
                            false,
                            FigureLook.ASKED));
        return new Board(BoardSpace.PIXELS, figures, new RunPick("", FROM, TO));
    }

    private static void addRuns(Walked walked, List<BoardFigure> figures) {
        for (int i = 0; i < walked.steps().size(); i++)
            add(figures, walked.steps().get(i), walked.steps().get(i), walked.look(i));
        walked.wrong()
                .ifPresent(
                        answer ->
                                add(
                                        figures,
                                        answer,
                                        walked.steps().get(walked.steps().size() - 1),
                                        FigureLook.WRONG));
    }

    /**
     * @param step has the row where the run does not
     */
    private static void add(
            List<BoardFigure> figures, JsonNode run, JsonNode step, FigureLook look) {
        int y = run.path(ROW).asInt(step.path(ROW).intValue());
        int from = run.path(FROM).intValue();
        int to = Math.min(run.path(TO).intValue(), from + MOST);
        for (int x = from; x < to; x++) figures.add(new BoardCell(x, y, look));
    }
}
