package rasterlab.app.visibility;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.regex.Pattern;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.ChartSize;
import rasterlab.app.language.Language;
import rasterlab.engine.visibility.hidden.Growth;
import rasterlab.engine.visibility.hidden.Growth.Axis;

class GrowthChartTest {
    private static final int[] SIZES = {16, 64, 256, 1024};

    /** All methods' work grows by powers of their own. */
    private final GrowthChart chart =
            new GrowthChart(
                    Growth.methodNames().stream()
                            .flatMap(
                                    method ->
                                            Stream.of(Axis.values())
                                                    .map(axis -> growth(method, axis)))
                            .toList());

    private static Growth growth(String method, Axis axis) {
        double power = 1 + Growth.methodNames().indexOf(method) / 14.0;
        LongStream work = Arrays.stream(SIZES).mapToLong(n -> (long) (100 * Math.pow(n, power)));
        return new Growth(method, axis, SIZES, work.toArray());
    }

    @Test
    void typeGrowsWithTheWindowsWhereThereIsRoom() {
        assertEquals(new ChartSize(1200, 800, 1.5), GrowthChart.filling(1800, 1200, 1.5));
        assertEquals(new ChartSize(900, 1000, 1.5), GrowthChart.filling(1350, 1500, 2));
    }

    @ParameterizedTest(
            name = "words of the table lie over each other where there is least room: {0}")
    @EnumSource(Language.class)
    void everyWordIsWholeWhereThereIsLeastRoom(Language language) {
        ChartSize least = GrowthChart.filling(78, 58, 1);
        BufferedImage image = chart.image(language, ChartLook.PAPER, least);
        int left = least.width() / 2;
        int top = (least.height() + GrowthChart.TITLE) / 2;
        BufferedImage table =
                image.getSubimage(left, top, image.getWidth() - left, image.getHeight() - top);
        List<int[]> rows = runs(table.getHeight(), 1, y -> inked(table, 0, y, table.getWidth(), 1));
        int methods = chart.methods().size();
        assertTrue(rows.size() > methods, rows.size() + " rows of words");
        int[] head = rows.get(rows.size() - 1 - methods);
        List<int[]> columns =
                runs(table.getWidth(), 8, x -> inked(table, x, head[0], 1, head[1] - head[0] + 1));
        assertEquals(Axis.values().length, columns.size(), "heads of columns");
        assertTrue(columns.get(2)[1] < table.getWidth() - 2, "the last head is cut");
        assertTrue(rows.get(rows.size() - 1)[1] < table.getHeight() - 2, "the last row is cut");
    }

    @Test
    void eachLineHasItsNameAtItsEnd() {
        String svg = new String(chart.svg(Language.RUSSIAN, ChartLook.PAPER), UTF_8);
        for (String method : chart.methods()) {
            long written = Pattern.compile(">" + method + "<").matcher(svg).results().count();
            assertEquals(Axis.values().length + 1, written, method + " in each plot and the table");
        }
    }

    /** First and last of what follows each other with less than {@code gap} empty between. */
    private static List<int[]> runs(int size, int gap, IntPredicate inked) {
        var runs = new ArrayList<int[]>();
        for (int i = 0; i < size; i++) {
            if (!inked.test(i)) continue;
            if (!runs.isEmpty() && i - runs.get(runs.size() - 1)[1] <= gap)
                runs.get(runs.size() - 1)[1] = i;
            else runs.add(new int[] {i, i});
        }
        return runs;
    }

    private static boolean inked(BufferedImage image, int x, int y, int width, int height) {
        for (int i = x; i < x + width; i++)
            for (int j = y; j < y + height; j++) if (image.getRGB(i, j) != -1) return true;
        return false;
    }
}
