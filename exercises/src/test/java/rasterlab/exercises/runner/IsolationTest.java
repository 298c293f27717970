package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.exercises.runner.Isolation.ProcessLimit;

/** What is promised to exams is what the machine holds. */
class IsolationTest {
    @ParameterizedTest(name = "an exam is graded where the limit on processes is {0}")
    @EnumSource(ProcessLimit.class)
    void examsNeedALimitOnProcesses(ProcessLimit limit) {
        Isolation isolation = Isolation.bubblewrap("bubblewrap 0.8.0", limit);
        assertEquals(limit == ProcessLimit.HOLDS, isolation.exam());
        assertEquals(!isolation.exam(), isolation.describe().contains("not for exams: "));
    }

    @Test
    @DisplayName("what the box lacks is kept quiet")
    void whatIsMissingIsSaid() {
        Isolation isolation = Isolation.bubblewrap("bubblewrap 0.8.0", ProcessLimit.HOLDS);
        assertTrue(isolation.describe().contains("without a system call filter"));
        assertTrue(isolation.describe("ru").contains("нет фильтра системных вызовов"));
    }
}
