package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.shell.settings.LabTheme;

class PlaneRulersTest {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    @BeforeEach
    void atUsualSize() {
        LabTheme.LIGHT.install();
    }

    @ParameterizedTest(name = "rows are numbered otherwise than columns: {0}")
    @CsvSource({
        "65000, −60000, y\\x",
        "6500, −6000, y\\x",
        "100000, −8, ·10⁴",
        "650000, −6, ·10⁵",
        "6.5e200, −6, ·10²⁰⁰",
        "6.5e-9, −6, ·10⁻⁹"
    })
    void rowsAreNumberedAsColumnsAre(double most, String number, String corner) {
        String svg = margins(most, PlaneAxes.GEOMETRY);
        assertEquals(2, count(number, svg), svg);
        assertEquals(1, count(corner, svg), svg);
        assertTrue(!svg.contains("…"), "a number is cut");
    }

    @Test
    void equalScalesHaveEqualSteps() {
        for (double most = 100; most < 1000; most *= 1.1) {
            String svg = margins(most, PlaneAxes.GEOMETRY);
            for (int tick = -100; tick > -most; tick -= 10) {
                String number = ">" + String.valueOf(tick).replace('-', '−') + "</text";
                assertTrue(count(number, svg) != 1, number + " on one axis only: " + svg);
            }
        }
    }

    private static int count(String number, String svg) {
        return svg.split(
                                number.startsWith(">")
                                        ? number
                                        : ">" + Pattern.quote(number) + "</text",
                                -1)
                        .length
                - 1;
    }

    private static String margins(double most, PlaneAxes axes) {
        var map =
                PlaneMap.fitting(
                        new Rectangle2D.Double(-most, -most, most, most),
                        new Rectangle(44, 22, 400, 400),
                        axes);
        return SvgPicture.of(
                        444,
                        422,
                        g ->
                                new PlaneRulers(
                                                map,
                                                new Dimension(444, 422),
                                                StageColors.LIGHT,
                                                FONT,
                                                Locale.ENGLISH,
                                                0)
                                        .paintMargins(g))
                .document();
    }
}
