package rasterlab.app.cli.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.cli.study.CurveSegments.SegmentRow;

class CurveSegmentsTest {
    private static final double QUARTER = 0.25;

    private final List<SegmentRow> rows = new CurveSegments().rows();

    private SegmentRow row(String method) {
        return rows.stream()
                .filter(one -> one.flatness() == QUARTER && one.method().equals(method))
                .findFirst()
                .orElseThrow();
    }

    @Test
    @DisplayName("the planner takes one method, however often a curve is drawn")
    void plannerPicksByTheNumberOfTimes() {
        var picked = new ArrayList<String>();
        for (int i = 0; i < CurveSegments.TIMES.size(); i++)
            for (String method : List.of("uniform", "adaptive", "fewest"))
                if (row(method).chosen().get(i)) picked.add(method);
        assertEquals(List.of("uniform", "adaptive", "fewest", "fewest"), picked);
    }

    @Test
    @DisplayName("what holds the tolerance by a little less than it stands first, or has a price")
    void fewestIsTheLeastThatIsEnough() {
        SegmentRow fewest = row("fewest");
        for (SegmentRow other : rows)
            if (other.flatness() == QUARTER && other.error() <= 1)
                assertTrue(other.segments() >= fewest.segments(), other.method());
        assertTrue(row("curvature-unchecked").error() > 1, "beyond its tolerance");
        assertEquals(List.of(), row("curvature-unchecked").nanos());
        assertTrue(fewest.error() <= 1 && row("adaptive").error() <= 1);
    }

    @Test
    void fileHasTheTimesForWhichAMethodIsPlanned() {
        String csv = new CurveSegments().csv();
        assertTrue(csv.startsWith("flatness_px,method,segments_per_curve,"), csv);
        assertTrue(
                csv.lines()
                        .anyMatch(
                                line ->
                                        line.startsWith("0.25,fewest,")
                                                && line.endsWith(",100 1000")),
                csv);
    }
}
