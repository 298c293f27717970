package rasterlab.app.line.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYSeries;
import rasterlab.app.language.Language;

class BrightnessChartTest {
    @Test
    @DisplayName("seven of eight methods hide behind one curve")
    void legendNamesWhatCoincides() {
        assertEquals(
                Set.of(
                        "naive-textbook",
                        "naive = dda-float = dda = bresenham = midpoint = wu\n= clip-first-textbook"),
                series(
                        List.of(
                                "naive",
                                "naive-textbook",
                                "dda-float",
                                "dda",
                                "bresenham",
                                "midpoint",
                                "wu",
                                "clip-first-textbook")));
    }

    @Test
    @DisplayName("curves that differ share a line of the legend")
    void curvesOfTheirOwnAreNamedAlone() {
        assertEquals(
                Set.of("bresenham", "naive-textbook"),
                series(List.of("bresenham", "naive-textbook")));
        assertEquals(Set.of("wu"), series(List.of("wu", "wu")));
    }

    private static Set<String> series(List<String> methods) {
        return new BrightnessChart(methods)
                .chart(Language.ENGLISH).getSeriesCollection().stream()
                        .map(XYSeries::getName)
                        .collect(Collectors.toSet());
    }
}
