package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class RegimeTest {
    private final List<Measurement> measured = new ArrayList<>();

    private void add(int size, String method, double nanos, double error) {
        var rounds = new ArrayList<Double>();
        for (int i = 0; i < 12; i++) rounds.add(nanos * (1 + 0.01 * i));
        measured.add(
                new Measurement(
                        method,
                        "length-" + size,
                        size,
                        nanos > 0 ? Cost.of(rounds, Map.of()) : Cost.NONE,
                        new Deviation(error, 0, 0, 9, ""),
                        error == 0 ? Verdict.Kind.EXACT : Verdict.Kind.WRONG,
                        ""));
    }

    private List<Regime> regimes() {
        var study = new Study("line", "pixel", "pixels", measured);
        List<String> workloads = measured.stream().map(Measurement::workload).distinct().toList();
        return Regime.along(study, workloads);
    }

    @Test
    @DisplayName("the regimes do not say where the best method changes")
    void theAccurateOneTakesOverWhereTheQuickOneFails() {
        for (int size : new int[] {16, 64}) {
            add(size, "dda", 10, 0);
            add(size, "bresenham", 20, 0);
        }
        for (int size : new int[] {256, 1024}) {
            add(size, "dda", 10, 1);
            add(size, "bresenham", 20, 0);
        }
        assertEquals(List.of(regime(16, 64, "dda"), regime(256, 1024, "bresenham")), regimes());
    }

    private static Regime regime(int from, int to, String... methods) {
        return new Regime(List.of(methods), from, to);
    }

    @Test
    @DisplayName("a method is called best whose time is not told apart from another's")
    void whatIsNotToldApartIsOpen() {
        add(16, "dda", 10, 0);
        add(16, "bresenham", 10.1, 0);
        add(16, "naive", 20, 0);
        add(64, "dda", 10.1, 0);
        add(64, "bresenham", 10, 0);
        add(64, "naive", 20, 0);
        assertEquals(List.of(regime(16, 64, "dda", "bresenham")), regimes());
        assertTrue(regimes().get(0).isOpen());
        add(256, "dda", 20, 0);
        add(256, "bresenham", 10, 0);
        add(256, "naive", 20, 0);
        assertEquals(
                List.of(regime(16, 64, "dda", "bresenham"), regime(256, 256, "bresenham")),
                regimes());
    }

    @Test
    @DisplayName("noise makes a regime")
    void whatIsNotToldApartEndsNoRegime() {
        add(16, "dda", 10, 0);
        add(16, "bresenham", 20, 0);
        add(64, "dda", 10.1, 0);
        add(64, "bresenham", 10, 0);
        assertEquals(List.of(regime(16, 64, "dda")), regimes());
    }

    @Test
    @DisplayName("open methods go on where one of the accurate ones loses its accuracy")
    void openRegimeEndsWhereAccuracyChanges() {
        for (int size : new int[] {16, 64})
            for (String method : List.of("dda", "bresenham", "midpoint"))
                add(size, method, 10, size == 64 && method.equals("dda") ? 1 : 0);
        assertEquals(
                List.of(
                        regime(16, 16, "dda", "bresenham", "midpoint"),
                        regime(64, 64, "bresenham", "midpoint")),
                regimes());
    }

    @Test
    void workloadWithoutATimeHasNoBest() {
        add(16, "dda", 0, 0);
        assertEquals(List.of(), regimes());
    }
}
