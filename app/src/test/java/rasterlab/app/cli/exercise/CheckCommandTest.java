package rasterlab.app.cli.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.cli.Ran;
import rasterlab.app.tour.Tour;

@Tag("slow")
class CheckCommandTest {
    @TempDir Path folder;

    @Test
    void rightSolutionIsOk() throws Exception {
        Ran ran = check("right");
        assertTrue(ran.out().contains("Verdict: right"), ran.out());
        assertFalse(Files.exists(folder.resolve("pictures")), "nothing to draw");
        ran.assertDone();
    }

    @Test
    void wrongSolutionIsDrawn() throws Exception {
        Ran ran = check("wrong", "--lang", "ru");
        assertTrue(ran.out().contains("Вердикт: неверно"), ran.out());
        assertTrue(ran.out().contains("\n  #.."), ran.out());
        assertTrue(ran.out().contains("нет пикселя ("), ran.out());
        assertFalse(ran.out().contains("missing"), ran.out());
        assertTrue(ran.out().contains("крутой отрезок без разрывов, steep-line-leaves"), ran.out());
        assertTrue(ran.err().contains("выполнен тест: крутой отрезок без разрывов"), ran.err());
        Path picture = folder.resolve("pictures/steep-line-leaves-gaps-difference.png");
        assertTrue(Files.exists(picture), ran.out());
        String scene = folder.resolve("pictures/steep-line-leaves-gaps.scene.json").toString();
        Ran right = Ran.lab("run", "--scene", scene);
        right.assertDone();
        assertTrue(right.out().startsWith("{\"pixels\":[["), right.out());
        assertEquals(1, ran.exitCode());
    }

    /** Each case is wrong at first with x and y exchanged, and most are right in the end. */
    @Test
    void progressTellsNoVerdictThatTheReportTakesBack() throws Exception {
        Path file = folder.resolve("MyLine.java");
        try (InputStream in = Tour.class.getResourceAsStream("solution-right.java.txt")) {
            String right = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            String plotted = "out.plot(x, y)";
            assertTrue(right.contains(plotted), right);
            Files.writeString(file, right.replace(plotted, "out.plot(y, x)"));
        }
        String pictures = folder.resolve("pictures").toString();
        Ran ran = Ran.lab("check", "line-bresenham", file.toString(), "--out", pictures);
        assertTrue(ran.out().contains("the first pixel is drawn"), ran.out());
        List<String> progress = ran.err().lines().skip(1).toList();
        assertTrue(progress.contains("tried: the first pixel is drawn"), ran.err());
        for (String line : progress) assertFalse(line.matches(".*: (right|wrong)"), line);
        assertEquals(1, ran.exitCode());
    }

    /** There is no server here, and what it would promise to exams is nobody's question. */
    @Test
    void theFirstLineIsShortAndSpeaksOfNoServer() throws Exception {
        for (String language : List.of("en", "ru")) {
            String first =
                    check("right", "--lang", language).err().lines().findFirst().orElseThrow();
            assertTrue(first.length() < 120, first);
            assertFalse(first.matches(".*(server|root|exam|сервер|экзамен).*"), first);
        }
    }

    @Test
    void printedLinesDoNotPassForThoseOfTheReport() throws Exception {
        Path file = folder.resolve("MyLine.java");
        Files.writeString(
                file,
                """
                public class MyLine implements rasterlab.contract.LineRasterizer {
                    public void draw(int a, int b, int c, int d, rasterlab.contract.Pixels out) {
                        System.out.println("\\33[2Jx\\nVerdict: right");
                        throw new IllegalStateException("\\33[2J\\u202E");
                    }
                }
                """);
        Ran ran = Ran.lab("check", "line-bresenham", file.toString());
        assertFalse(ran.out().contains("\nVerdict: right"), ran.out());
        assertFalse(ran.out().matches("(?s).*[\\x1B\\x{202E}].*"), ran.out());
    }

    @Test
    void diagnosticsNameFileAndLine() throws Exception {
        Path file = folder.resolve("MyLine.java");
        Files.writeString(file, "public class MyLine {\n    int x = ;\n}\n");
        Ran ran = Ran.lab("check", "line-bresenham", file.toString());
        assertTrue(ran.out().contains("\nMyLine.java:2:13: "), ran.out());
        assertEquals(1, ran.exitCode());
    }

    @Test
    void picturesThatCannotBeWrittenAreRefusedBeforeACaseRuns() throws Exception {
        Path file = Files.writeString(folder.resolve("pictures"), "mine");
        for (String solution : List.of("right", "wrong"))
            check(solution)
                    .assertComplains(2, "./lab check: " + file + ": is a file, a folder is wanted");
        assertEquals("mine", Files.readString(file));
    }

    private Ran check(String solution, String... options) throws Exception {
        Path file = folder.resolve("MyLine.java");
        try (InputStream in =
                Tour.class.getResourceAsStream("solution-" + solution + ".java.txt")) {
            Files.write(file, in.readAllBytes());
        }
        String pictures = folder.resolve("pictures").toString();
        String[] all = new String[5 + options.length];
        System.arraycopy(
                new String[] {"check", "line-bresenham", file.toString(), "--out", pictures},
                0,
                all,
                0,
                5);
        System.arraycopy(options, 0, all, 5, options.length);
        return Ran.lab(all);
    }

    @Test
    void badFilesAreNamed() throws Exception {
        complains(folder, "is a folder, not a source");
        complains(folder.resolve("no.java"), "no such file to read");
        Path file = folder.resolve("a.java");
        Files.write(file, new byte[0]);
        complains(file, "is empty");
        Files.write(file, new byte[10_000_000]);
        complains(file, "has 10000000 bytes, a source has at most 262144");
        Files.write(file, new byte[] {(byte) 0xC3, 0x28});
        complains(file, "is not UTF-8 text");
    }

    private static void complains(Path file, String message) {
        Ran.lab("check", "line-bresenham", file.toString())
                .assertComplains(2, "./lab check: " + file + ": " + message);
    }

    @Test
    void unknownExerciseListsTheKnownOnes() {
        Ran ran = Ran.lab("check", "line-wu", "a.java");
        assertTrue(ran.err().contains("no exercise 'line-wu'; there are "), ran.err());
        assertEquals(2, ran.exitCode());
    }
}
