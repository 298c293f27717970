package rasterlab.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Verdict;

/**
 * The verdicts of one topic's hazards as they were published, with counts and words.
 *
 * <p>Where a verdict is meant to change, {@code -Drasterlab.golden=write} writes the file anew; the
 * change of each line is then reviewed as any other.
 *
 * @param topic name of the topic
 */
record GoldenVerdicts(String topic) {
    private static final Path FOLDER =
            Path.of("src", "test", "resources", "rasterlab", "engine", "golden");

    /** Passes if every cell is as published. */
    void assertHold(List<VerdictCell> cells) throws IOException {
        Path file = FOLDER.resolve(topic + ".txt");
        List<String> found = cells.stream().map(GoldenVerdicts::line).toList();
        if ("write".equals(System.getProperty("rasterlab.golden"))) Files.write(file, found);
        List<String> golden = Files.readAllLines(file);
        for (int i = 0; i < Math.min(golden.size(), found.size()); i++)
            assertEquals(golden.get(i), found.get(i), file + ", line " + (i + 1));
        assertEquals(golden.size(), found.size(), file + ": number of lines");
    }

    private static String line(VerdictCell cell) {
        Verdict verdict = cell.verdict();
        Deviation deviation = verdict.deviation();
        return String.format(
                Locale.ROOT,
                "%s | %s | %s %.3e -%d +%d of %d | %s",
                cell.hazard(),
                cell.method(),
                verdict.kind().code(),
                deviation.worst(),
                deviation.missing(),
                deviation.extra(),
                deviation.of(),
                words(verdict));
    }

    /** The detail without its numbers and without the place in the code, which may move. */
    private static String words(Verdict verdict) {
        String detail = verdict.detail();
        if (verdict.kind() == Verdict.Kind.CRASHED) detail = detail.replaceFirst(" at .*", "");
        return detail.replaceAll("-?\\d+(?:\\.\\d+)?(?:[eE]-?\\d+)?", "#");
    }
}
