package rasterlab.engine.visibility.painter;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class CutLineTest {
    private static final int WIDTH = 9;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("lines")
    void eachPixelIsOnOneSide(double base, double perColumn, double perRow, String nearSide) {
        String[] rows = nearSide.split(" ");
        for (int row = 0; row < rows.length; row++) {
            assertEquals(rows[row], drawn(base, perColumn, perRow, true, row), "near, row " + row);
            String other = rows[row].replace('#', '?').replace('.', '#').replace('?', '.');
            assertEquals(other, drawn(base, perColumn, perRow, false, row), "far, row " + row);
        }
    }

    private static String drawn(
            double base, double perColumn, double perRow, boolean near, int row) {
        var line = new CutLine(base, perColumn, perRow, near);
        var pixels = new StringBuilder(".".repeat(WIDTH));
        int from = line.from(row, 0, WIDTH);
        for (int x = from; x < line.to(row, 0, WIDTH); x++) pixels.setCharAt(x, '#');
        return pixels.toString();
    }

    static Stream<Arguments> lines() {
        return Stream.of(
                argumentSet("pixel on a rising line is lost", -4, 1, 0, "....#####"),
                argumentSet("pixel on a falling line is lost", 4, -1, 0, "#####...."),
                argumentSet("between pixels is rounded", -4.5, 1, 0, ".....####"),
                argumentSet("row is ignored", -4, 1, 2, "....##### ..####### #########"),
                argumentSet("level line has two sides", -1, 0, 1, "......... ######### #########"),
                argumentSet("line far away turns round", 1, -1e-300, 0, "#########"));
    }
}
