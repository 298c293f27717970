package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.Cell;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

class LineHazardTest {
    private static final LineTopic TOPIC = new LineTopic();
    private static final List<Cell> TABLE = HazardTrial.table(TOPIC, Duration.ofSeconds(20));

    @ParameterizedTest
    @MethodSource("table")
    void everyVerdictIsTheRecordedOne(Cell cell) {
        assertEquals(cell.recorded(), cell.verdict().kind(), cell.verdict().detail());
    }

    @Test
    void everyTextbookMethodFailsSomewhereAndNoOtherOneDoes() {
        Set<String> failing =
                TABLE.stream()
                        .filter(cell -> cell.verdict().kind() != Verdict.Kind.EXACT)
                        .filter(cell -> cell.verdict().kind() != Verdict.Kind.REFUSED)
                        .map(Cell::method)
                        .collect(Collectors.toSet());
        Set<String> faulty =
                TOPIC.methods().stream()
                        .filter(Method::faulty)
                        .map(Method::name)
                        .collect(Collectors.toSet());
        assertEquals(faulty, failing);
    }

    @Test
    void everyMethodHasARecordedVerdictOnEveryHazard() {
        Set<String> names = TOPIC.methods().stream().map(Method::name).collect(Collectors.toSet());
        for (var hazard : TOPIC.hazards())
            assertEquals(names, hazard.recorded().keySet(), hazard.name());
    }

    @Test
    void bresenhamIsExactOnEveryHazard() {
        for (Cell cell : TABLE)
            if (cell.method().equals("bresenham"))
                assertEquals(Verdict.Kind.EXACT, cell.verdict().kind(), cell.hazard());
    }

    @Test
    void everyFailureSaysWhatHappenedInOneLine() {
        for (Cell cell : TABLE) {
            String detail = cell.verdict().detail();
            boolean exact = cell.verdict().kind() == Verdict.Kind.EXACT;
            assertEquals(exact, detail.isEmpty(), cell.toString());
            assertTrue(detail.lines().count() <= 1, detail);
        }
    }

    static Stream<Cell> table() {
        return TABLE.stream();
    }
}
