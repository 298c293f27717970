package rasterlab.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.course.Standing.Earned;
import rasterlab.exercises.score.ScorePoints;

class LocalTriesTest {
    @TempDir Path folder;

    @Test
    void worseTryLeavesTheBestAsItWas() throws IOException {
        note("circle", 40, 100);
        note("circle", 30, 100);
        assertEquals(Map.of("circle", Standing.graded(new Earned(40, 100))), found());
    }

    @Test
    void bestOfAllWindowsIsTold() throws IOException {
        note("circle", 40, 100);
        note("circle.2", 70, 100);
        note("ellipse", 70, 100);
        note("ellipse.2", 40, 100);
        note("line-bresenham", 1, 10);
        assertEquals(
                Map.of(
                        "circle", Standing.graded(new Earned(70, 100)),
                        "ellipse", Standing.graded(new Earned(70, 100)),
                        "line-bresenham", Standing.graded(new Earned(1, 10))),
                found());
    }

    @Test
    void lastResultServesWhereNoBestWasKeptAndNeverInsteadOfOne() throws IOException {
        String told =
                "{\"revision\":\"r\",\"outcome\":{\"points\":"
                        + "{\"accuracy\":5,\"stability\":2,\"speed\":1,\"of\":100}}}";
        Files.writeString(folder.resolve("circle.result.json"), told);
        assertEquals(Map.of("circle", Standing.graded(new Earned(8, 100))), found());
        note("circle", 7, 100);
        assertEquals(Map.of("circle", Standing.graded(new Earned(7, 100))), found());
    }

    @Test
    void halfAFileOrNoFolderIsNoTry() throws IOException {
        Files.writeString(folder.resolve("circle.best.json"), "{\"points\": 5");
        Files.writeString(folder.resolve("ellipse.best.json"), "{}");
        assertEquals(Map.of(), found());
        assertEquals(Map.of(), LocalTries.in(folder.resolve("none")));
    }

    private Map<String, Standing> found() throws IOException {
        return LocalTries.in(folder);
    }

    private void note(String stem, int points, int of) {
        LocalTries.note(folder.resolve(stem + ".result.json"), new ScorePoints(points, 0, 0, of));
    }
}
