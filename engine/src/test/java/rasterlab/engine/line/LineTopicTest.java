package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Workload;

class LineTopicTest {
    private static final LineTopic TOPIC = new LineTopic();

    @Test
    void everyWorkloadHasItsLengthInAllOctants() {
        for (Workload<Segment> workload : TOPIC.workloads()) {
            var octants = new HashSet<Integer>();
            for (Segment s : workload.inputs()) {
                assertEquals(workload.size(), s.steps() + 1, s.toString());
                int dx = s.x1() - s.x0();
                int dy = s.y1() - s.y0();
                int steep = Math.abs(dy) > Math.abs(dx) ? 1 : 0;
                octants.add(steep + (dx < 0 ? 2 : 0) + (dy < 0 ? 4 : 0));
            }
            assertEquals(8, octants.size(), workload.name());
        }
    }

    @Test
    void workloadsAreTheSameEachTime() {
        assertEquals(TOPIC.workloads(), TOPIC.workloads());
    }

    @Test
    void spendingCountsThePixelsDrawn() {
        LineRasterizer method = TOPIC.method("bresenham").implementation();
        assertEquals(12, TOPIC.spend(method, new Segment(0, 0, 11, 4)));
    }

    @Test
    void spendingStopsAnEndlessMethod() {
        LineRasterizer method = TOPIC.method("naive-textbook").implementation();
        var endless = new Segment(Integer.MAX_VALUE - 7, 5, Integer.MAX_VALUE, 8);
        assertThrows(LimitReached.class, () -> TOPIC.spend(method, endless));
    }

    @Test
    void exactLineIsCutAtTheLimit() {
        assertEquals(7, TOPIC.exact(new Segment(0, 0, 1 << 30, 3), 7).size());
    }

    @Test
    void unknownMethodNamesTheKnownOnes() {
        var refusal = assertThrows(IllegalArgumentException.class, () -> TOPIC.method("guess"));
        assertTrue(refusal.getMessage().contains("bresenham"), refusal.getMessage());
    }
}
