package rasterlab.exercises.drawing;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import rasterlab.exercises.drawing.TableComparison.CellState;
import rasterlab.exercises.drawing.TableComparison.TableCell;
import rasterlab.exercises.drawing.ThreePictures.DrawnPicture;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.PictureBytes;

/** Draws the answer of a case whose output is a table of numbers. */
public final class TablePictures {
    /** Rows of a picture; around the first wrong one where there are more. */
    static final int MOST_ROWS = 16;

    private static final int MOST_COLUMNS = 12;

    /** The largest width in pixels; fewer columns are shown where they would be wider. */
    private static final int WIDEST = 900;

    private static final String ENGLISH = "en";
    private static final String COMMA = "ru";

    private final TableComparison table;
    private final TableLabels labels;
    private final ShownRange rows;
    private final ShownRange columns;
    private final TableSheet sheet;

    private TablePictures(TableComparison table, TableLabels labels) {
        this.table = table;
        this.labels = labels;
        TableCell center = table.firstWrong().orElse(new TableCell(0, 0));
        rows = ShownRange.around(center.row(), MOST_ROWS, table.rows());
        ShownRange fitting = null;
        TableSheet drawn = null;
        for (int most = MOST_COLUMNS; drawn == null || drawn.width() > WIDEST && most > 0; most--) {
            fitting = ShownRange.around(center.column(), most, table.columns());
            drawn = new TableSheet(table, labels, rows.lines(), fitting.lines(), ENGLISH);
        }
        columns = fitting;
        sheet = drawn;
    }

    /**
     * Draws the expected numbers, the actual ones, and the differences actual − expected, in which
     * wrong, missing and extra cells stand in a frame with a sign. The pictures show at most 16
     * rows, around the first wrong one. A wrong number has as many digits as tell it from the right
     * one, any other up to 6.
     *
     * @param labels names of the rows and columns
     * @param expected the right numbers, row by row; NaN and infinities too
     * @param actual the numbers to look at; rows may be more, fewer, longer or shorter
     * @param agreement decides which cells are right
     * @return three pictures of one size: expected, actual, difference
     */
    public static List<CasePicture> of(
            TableLabels labels, double[][] expected, double[][] actual, Agreement agreement) {
        return new TablePictures(new TableComparison(expected, actual, agreement), labels).drawn();
    }

    private List<CasePicture> drawn() {
        return ThreePictures.of(
                new DrawnPicture(
                        png(one -> one.numbers(table::expected, Ink.EXPECTED)),
                        numbersSaid(table::expected)),
                new DrawnPicture(
                        png(one -> one.numbers(table::actual, Ink.ACTUAL)),
                        numbersSaid(table::actual)),
                new DrawnPicture(png(TableSheet::difference), differenceSaid()));
    }

    private PictureBytes png(Function<TableSheet, BufferedImage> drawing) {
        byte[] usual = PngBytes.small(drawing.apply(sheet));
        if (!sheet.hasFractions()) return PictureBytes.alike(usual);
        return PictureBytes.of(
                usual, Map.of(COMMA, () -> PngBytes.small(drawing.apply(sheet.in(COMMA)))));
    }

    /** The size, and the numbers that the picture shows, row by row. */
    private Message numbersSaid(TableSheet.Cells cells) {
        Message said = Message.of("drawing.table.size", table.rows(), table.columns());
        if (!rows.isWhole())
            said =
                    said.and(
                            Message.of(
                                    "drawing.table.rows",
                                    labels.row(rows.first()),
                                    labels.row(rows.last())));
        if (!columns.isWhole())
            said =
                    said.and(
                            Message.of(
                                    "drawing.table.columns",
                                    labels.column(columns.first()),
                                    labels.column(columns.last())));
        for (int row = rows.first(); row <= rows.last(); row++) {
            List<String> numbers = inRow(row, cells);
            if (!numbers.isEmpty())
                said =
                        said.and(
                                Message.of(
                                        "drawing.table.row",
                                        labels.row(row),
                                        "(" + String.join(", ", numbers) + ")"));
        }
        return said;
    }

    private List<String> inRow(int row, TableSheet.Cells cells) {
        var numbers = new ArrayList<String>();
        for (int column = columns.first(); column <= columns.last(); column++) {
            String text = cells.text(row, column);
            if (!text.isEmpty()) numbers.add(text);
        }
        return numbers;
    }

    private Message differenceSaid() {
        if (table.firstWrong().isEmpty()) return Message.of("drawing.same");
        int right = table.count(CellState.RIGHT);
        int wrong = table.count(CellState.WRONG);
        int missing = table.count(CellState.MISSING);
        int extra = table.count(CellState.EXTRA);
        Message said = Message.of("drawing.table.wrong", wrong, right + wrong + missing);
        if (missing > 0) said = said.and(Message.of("drawing.table.missing", missing));
        if (extra > 0) said = said.and(Message.of("drawing.table.extra", extra));
        return said.and(firstSaid(table.firstWrong().orElseThrow()));
    }

    private Message firstSaid(TableCell cell) {
        String row = labels.row(cell.row());
        String column = labels.column(cell.column());
        String expected = table.expected(cell.row(), cell.column());
        String actual = table.actual(cell.row(), cell.column());
        return switch (table.state(cell.row(), cell.column())) {
            case MISSING -> Message.of("drawing.table.first-missing", row, column, expected);
            case EXTRA -> Message.of("drawing.table.first-extra", row, column, actual);
            default ->
                    Message.of(
                            "drawing.table.first",
                            row,
                            column,
                            expected,
                            actual,
                            table.difference(cell.row(), cell.column()));
        };
    }
}
