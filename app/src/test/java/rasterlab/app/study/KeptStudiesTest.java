package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.study.chart.ConditionsWords;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyConditions;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.measuring.Machine;

class KeptStudiesTest {
    private static final LineTopic LINE = new LineTopic();

    @TempDir Path folder;

    private static Measurement measured(String method, double error, String detail) {
        return new Measurement(
                method,
                LINE.workloads().get(0).name(),
                16,
                Cost.of(List.of(3.0, 1.0, 2.0), Map.of("items", 16L, "inputs", 2L)),
                new Deviation(error, 1, 2, 16, "(1, 2)"),
                Verdict.Kind.WRONG,
                detail,
                List.of(0.25, error));
    }

    private static Study study(Measurement... measurements) {
        var how =
                new StudyConditions(
                        StudySettings.quick(),
                        Instant.parse("2026-11-28T02:30:00Z"),
                        new Machine("Linux 6", "Z80", 1, 65_536, "17.0.1"),
                        1.2,
                        3.5,
                        Map.of(LINE.workloads().get(0).name(), List.of(1.0, 1.1)),
                        true);
        return new Study("line", "pixel", "pixels", List.of(measurements), Optional.of(how));
    }

    @Test
    @DisplayName("a number, a round or the circumstances are lost on the way to the disk and back")
    void keptResultIsTheSame() {
        var kept = new KeptStudies(folder.resolve("studies"));
        assertEquals(Optional.empty(), kept.read(LINE));
        Study study =
                study(
                        measured("dda", 0.5, "a \"detail\""),
                        measured("naive", Double.POSITIVE_INFINITY, ""),
                        new Measurement(
                                "naive-textbook",
                                LINE.workloads().get(0).name(),
                                16,
                                Cost.NONE,
                                Deviation.NONE,
                                Verdict.Kind.ENDLESS,
                                "no end"));
        kept.keep(study);
        assertEquals(Optional.of(study), kept.read(LINE));
    }

    @Test
    @DisplayName("a method that is no more, or another's program, comes back")
    void whatIsNoMethodAnyLongerIsLeftOut() {
        var kept = new KeptStudies(folder);
        Measurement dda = measured("dda", 0.5, "");
        kept.keep(study(measured("gone", 1, ""), dda, measured(OwnMethods.NAME, 1, "")));
        assertEquals(List.of(dda), kept.read(LINE).orElseThrow().measurements());
        kept.keep(study(measured("gone", 1, "")));
        assertEquals(Optional.empty(), kept.read(LINE));
    }

    @Test
    @DisplayName("a broken file is taken for no file, or stops the window")
    void brokenFileIsToldWithItsName() throws Exception {
        var kept = new KeptStudies(folder);
        Path file = folder.resolve("line.json");
        for (String broken : List.of("{", "{}", "[1]", "{\"topic\": \"curve\"}", "")) {
            Files.writeString(file, broken);
            Complaint told = assertThrows(Complaint.class, () -> kept.read(LINE), broken);
            assertTrue(told.getMessage().startsWith(file + ": cannot be read: "), broken);
        }
    }

    @Test
    void dateMachineAndItsLoadAreSaid() {
        String english = new ConditionsWords(Language.ENGLISH).measuredOn(study()).orElseThrow();
        assertTrue(english.startsWith("Measured on "), english);
        assertTrue(
                english.endsWith("; Z80, 1 core; load of the machine 1.2 before, 3.5 after."),
                english);
        String russian = new ConditionsWords(Language.RUSSIAN).measuredOn(study()).orElseThrow();
        assertTrue(russian.startsWith("Измерено "), russian);
        assertTrue(
                russian.endsWith("; Z80, ядер: 1; загрузка машины до измерения 1,2, после 3,5."),
                russian);
    }
}
