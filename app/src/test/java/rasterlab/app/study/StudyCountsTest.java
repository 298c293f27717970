package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;

class StudyCountsTest {
    private static final Study VIEW =
            new Study(
                    "view",
                    "point",
                    "of the largest coordinate",
                    List.of(
                            counted("one-matrix", Map.of("multiplications", 12L, "additions", 8L)),
                            counted("by-axes", Map.of("multiplications", 5L)),
                            new Measurement(
                                    "refuses",
                                    "w",
                                    4,
                                    Cost.NONE,
                                    Deviation.NONE,
                                    Verdict.Kind.REFUSED,
                                    "")));

    private static Measurement counted(String method, Map<String, Long> operations) {
        var counts = new HashMap<>(operations);
        counts.put("items", 4L);
        counts.put("inputs", 2L);
        return new Measurement(
                method, "w", 4, new Cost(1, 1, 1, counts), Deviation.NONE, Verdict.Kind.EXACT, "");
    }

    @Test
    void countsArePerItemAndBlankWhereThereAreNone() {
        StudyCounts counts = StudyCounts.of(VIEW);
        assertEquals(List.of("additions", "multiplications"), counts.names());
        assertEquals(
                List.of(List.of("2", "3"), List.of("", "1.25"), List.of("", "")),
                VIEW.measurements().stream().map(counts::cells).toList());
    }

    @Test
    void csvHasOneMoreColumnForEachCountBehindTheOthers() {
        List<String> lines = StudyCsv.of(VIEW).lines().toList();
        assertEquals(
                "topic,method,workload,size,median_ns,low_ns,high_ns,worst_error,error_unit,"
                        + "missing,extra,of,verdict,detail,additions_per_item,"
                        + "multiplications_per_item,interval_low_ns,interval_high_ns,rounds",
                lines.get(0));
        assertEquals(List.of("2,3", ",1.25", ","), lines.stream().skip(1).map(this::end).toList());
    }

    @Test
    void aMethodThatWasRefusedHasNoTimeAndNoErrorInTheCsv() {
        String refused = StudyCsv.of(VIEW).lines().toList().get(3);
        assertTrue(refused.contains(",,,,,of the largest coordinate"), refused);
    }

    private String end(String line) {
        String[] cells = line.split(",", -1);
        return cells[cells.length - 5] + "," + cells[cells.length - 4];
    }
}
