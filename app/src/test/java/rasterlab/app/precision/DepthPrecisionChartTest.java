package rasterlab.app.precision;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.engine.visibility.depth.DepthPrecision;

class DepthPrecisionChartTest {
    @ParameterizedTest(name = "{0}")
    @EnumSource
    @DisplayName("a name is missing, stands in the plot, or over another one")
    void eachLineHasItsNameAtItsEnd(Language language) {
        String svg = new String(DepthPrecisionChart.svg(language, ChartLook.PAPER), UTF_8);
        String formats = String.join("|", DepthPrecision.FORMATS);
        List<MatchResult> names =
                Pattern.compile(
                                "<text[^>]*? x=\"([\\d.]+)\"[^>]*? y=\"([\\d.]+)\"[^>]*>("
                                        + formats
                                        + ")<")
                        .matcher(svg)
                        .results()
                        .toList();
        assertEquals(DepthPrecision.FORMATS.size(), names.size());
        for (int i = 0; i < names.size(); i++) {
            assertTrue(Double.parseDouble(names.get(i).group(1)) > 0.85 * ChartLook.WIDTH);
            if (i == 0) continue;
            double down = y(names.get(i)) - y(names.get(i - 1));
            assertTrue(down >= 12, names.get(i).group(3) + " is " + down + " below the one above");
        }
    }

    private static double y(MatchResult name) {
        return Double.parseDouble(name.group(2));
    }
}
