package rasterlab.exercises.line;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Method;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.marking.CaseTrial;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;

/**
 * Holds the verdicts on lines to those that were published: points, sentences in both languages,
 * explanations and pictures for programs with one mistake, for all methods of the topic and for the
 * mutants of the cases.
 *
 * <p>Where a verdict is meant to change, {@code -Drasterlab.golden=write} writes the file anew; the
 * change of each line is then reviewed as any other.
 */
@Tag("slow")
class LineVerdictsTest {
    private static final Exercise EXERCISE = Catalogue.builtIn().named("line-bresenham");
    private static final Path FILE =
            Path.of("src", "test", "resources", "rasterlab", "exercises", "line", "verdicts.txt");
    private static final long SEED = 1;
    private static final String MUTANT = "mutant ";

    @Test
    void everyProgramIsJudgedAsPublished() throws IOException {
        List<String> verdicts = new ArrayList<>();
        for (Map.Entry<String, LineRasterizer> one : programs().entrySet())
            add(one.getKey(), one.getValue(), verdicts);
        if ("write".equals(System.getProperty("rasterlab.golden"))) {
            Files.createDirectories(FILE.getParent());
            Files.write(FILE, verdicts);
        }
        List<String> golden = Files.readAllLines(FILE);
        for (int i = 0; i < Math.min(golden.size(), verdicts.size()); i++)
            assertEquals(golden.get(i), verdicts.get(i), FILE + ", line " + (i + 1));
        assertEquals(golden.size(), verdicts.size(), FILE + ": number of lines");
    }

    private static Map<String, LineRasterizer> programs() {
        Map<String, LineRasterizer> programs = new LinkedHashMap<>();
        for (OneMistake one : OneMistake.ALL) programs.put(one.name(), one.method());
        for (Method<LineRasterizer> one : new LineTopic().methods())
            programs.put("method " + one.name(), one.implementation());
        LineMutants.all()
                .forEach(one -> programs.put(MUTANT + one.get()[0], (LineRasterizer) one.get()[1]));
        return programs;
    }

    private static void add(String name, LineRasterizer method, List<String> lines) {
        MarkedMethod marked = MarkedMethod.of(EXERCISE, method, CaseSelection.all(SEED));
        lines.add(
                "%s: %d points, speed %s, charged %s | %s | %s"
                        .formatted(
                                name,
                                marked.points(),
                                TimedHere.isPaid(EXERCISE, marked.marking(), method),
                                marked.marking().charged().stream().sorted().toList(),
                                marked.marking().shared().in("en"),
                                marked.marking().shared().in("ru")));
        lines.add("  fails " + marked.failed());
        // pictures of wrong lines take a while, and those of the mutants show nothing new
        if (name.startsWith(MUTANT)) return;
        CRC32 hidden = new CRC32();
        for (CaseReport report : marked.marking().reports()) {
            String line = line(report, tried(marked, report.name()));
            if (report.visibility() == Disclosure.OPEN) lines.add(line);
            else hidden.update(line.getBytes(StandardCharsets.UTF_8));
        }
        lines.add("  the rest: " + Long.toHexString(hidden.getValue()));
    }

    private static CaseTrial tried(MarkedMethod marked, String name) {
        return marked.marking().cases().stream()
                .filter(one -> one.one().name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static String line(CaseReport report, CaseTrial tried) {
        return "  %s: %s %d of %d | %s | %s | %s | %s | scene %s"
                .formatted(
                        report.name(),
                        report.verdict(),
                        report.points(),
                        report.of(),
                        report.message("en"),
                        report.message("ru"),
                        tried.calls().stream().map(one -> explanations(one.finding())).toList(),
                        report.pictures().stream().map(LineVerdictsTest::picture).toList(),
                        sum(report.scene().getBytes(StandardCharsets.UTF_8)));
    }

    private static List<List<String>> explanations(Finding finding) {
        return finding.explanations().stream().map(Cause::codes).toList();
    }

    /** The part, and checksums of text and pixels. */
    private static String picture(CasePicture picture) {
        try {
            var image = ImageIO.read(new ByteArrayInputStream(picture.png()));
            int[] pixels =
                    image.getRGB(
                            0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
            CRC32 sum = new CRC32();
            for (int pixel : pixels)
                for (int shift = 0; shift < Integer.SIZE; shift += Byte.SIZE)
                    sum.update(pixel >> shift);
            return "%s %s %x"
                    .formatted(
                            picture.kind(),
                            sum(picture.text().in("en").getBytes(StandardCharsets.UTF_8)),
                            sum.getValue());
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    private static String sum(byte[] bytes) {
        CRC32 sum = new CRC32();
        sum.update(bytes);
        return Long.toHexString(sum.getValue());
    }
}
