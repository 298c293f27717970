package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Rectangle;
import java.util.Locale;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.shell.LabTheme;

class PlaneRulersTest {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    @BeforeEach
    void atUsualSize() {
        LabTheme.LIGHT.install();
    }

    @ParameterizedTest(name = "the start of a row''s number is cut off: {0}")
    @CsvSource({"65000, −60000, −60000", "6500, −6000, −6000", "650000, −600000, −6·10⁵"})
    void rowsAreNumberedInFull(int most, String column, String row) {
        var map =
                PlaneMap.fitting(
                        new Rectangle(-most, -most, most, most),
                        new Rectangle(44, 22, 400, 400),
                        PlaneAxes.GEOMETRY);
        String svg =
                SvgPicture.of(
                        444,
                        422,
                        g ->
                                new PlaneRulers(
                                                map,
                                                new Dimension(444, 422),
                                                StageColours.LIGHT,
                                                FONT,
                                                Locale.ENGLISH)
                                        .paintMargins(g));
        int places = (column.equals(row) ? 2 : 1) + 1;
        assertTrue(svg.split(">" + column + "</text", -1).length >= places, svg);
        assertTrue(svg.split(">" + row + "</text", -1).length >= places, svg);
        assertTrue(!svg.contains("…"), "a number is cut");
    }
}
