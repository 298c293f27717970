package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.tests.bench.grader.FairOrder.TimedResult;

class FairOrderTest {
    /** Letters are students in the order in which their results came. */
    @ParameterizedTest(name = "{0}: a lead of {1} is counted otherwise")
    @CsvSource({"abab, 1", "abba, 1", "aabb, 2", "aaab, 3", "baaa, 1", "abaaa, 1", "aaa, 0"})
    void countsHowFarSomebodyIsAheadOfWhoWaits(String order, int lead) {
        List<TimedResult> results = new ArrayList<>();
        for (int k = order.length() - 1; k >= 0; k--)
            results.add(new TimedResult(order.substring(k, k + 1), Instant.EPOCH.plusSeconds(k)));
        assertEquals(lead, FairOrder.lead(results));
    }
}
