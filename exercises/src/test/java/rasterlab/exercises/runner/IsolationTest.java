package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.exercises.runner.Isolation.ProcessLimit;
import rasterlab.exercises.score.Message;

/** Exams are promised only what the machine holds. */
class IsolationTest {
    @ParameterizedTest(name = "an exam is graded where the limit on processes is {0}")
    @EnumSource(ProcessLimit.class)
    void examsNeedALimitOnProcesses(ProcessLimit limit) {
        Isolation isolation = Isolation.bubblewrap("bubblewrap 0.8.0", limit, true, List.of());
        assertEquals(limit == ProcessLimit.HOLDS, isolation.exam());
        assertEquals(!isolation.exam(), isolation.describe("en").contains("not for exams: "));
        assertEquals(isolation.exam(), isolation.missingForExams().isEmpty());
        for (Message one : isolation.missing())
            assertFalse(one.toString().matches("(without|not for|no) .*"), one::toString);
    }

    @Test
    @DisplayName("an exam is graded where a limit was set but does not hold")
    void examsNeedWhatIsPromisedToHold() {
        var fault = Message.of("isolation.limit-fails", "Max file size unlimited");
        Isolation isolation =
                Isolation.bubblewrap("0.8.0", ProcessLimit.HOLDS, true, List.of(fault));
        assertFalse(isolation.exam());
        Message missing = Message.of("missing.limit-fails", "Max file size unlimited");
        assertTrue(isolation.missing().contains(missing));
        assertEquals(missing, isolation.missingForExams());
        assertTrue(
                isolation.describe("en").contains("Max file size unlimited"),
                () -> isolation.describe("en"));
    }

    @Test
    @DisplayName("an exam is graded where no filter of system calls holds")
    void examsNeedTheFilter() {
        var fault = Message.of("isolation.no-filter");
        Isolation isolation =
                Isolation.bubblewrap("0.8.0", ProcessLimit.HOLDS, true, List.of(fault));
        assertFalse(isolation.exam());
        assertEquals(Message.of("missing.no-filter"), isolation.missingForExams());
    }

    @Test
    @DisplayName("an exam is graded on the whole JDK")
    void examsNeedAnImage() {
        var lacking = Message.of("isolation.no-jlink");
        Isolation isolation =
                Isolation.bubblewrap("0.8.0", ProcessLimit.HOLDS, false, List.of(lacking));
        assertFalse(isolation.exam());
        assertEquals(Message.of("missing.no-jlink"), isolation.missingForExams());
        assertTrue(isolation.describe("en").contains("root with the JDK"), isolation::toString);
    }

    @Test
    @DisplayName("what the box lacks is kept quiet")
    void whatIsMissingIsSaid() {
        var lacking = Message.of("isolation.groups-kinds", "memory, pids");
        Isolation isolation =
                Isolation.bubblewrap(
                        "bubblewrap 0.8.0", ProcessLimit.HOLDS, true, List.of(lacking));
        assertFalse(isolation.exam());
        assertTrue(isolation.describe("en").contains("the control groups here lack memory, pids"));
        assertTrue(isolation.describe("ru").contains("в контрольных группах здесь нет memory"));
        assertEquals("missing.groups-kinds", isolation.missing().get(0).sentences().get(0).key());
    }
}
