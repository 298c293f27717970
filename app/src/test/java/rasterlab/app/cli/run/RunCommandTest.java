package rasterlab.app.cli.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.app.cli.Ran;

class RunCommandTest {
    private static final String SEGMENT = "{\"from\":[0,0],\"to\":[5,2]}";

    @Test
    void printsPixelsInDrawingOrder() {
        Ran ran = Ran.labReading(SEGMENT, "run", "line", "bresenham");
        assertEquals("{\"pixels\":[[0,0],[1,0],[2,1],[3,1],[4,2],[5,2]]}\n", ran.out());
        ran.assertDone();
    }

    @Test
    void stepsAreThePixelsWithTheirDecisions() throws Exception {
        Ran ran = Ran.labReading(SEGMENT, "run", "line", "bresenham", "--steps");
        JsonNode answer = new ObjectMapper().readTree(ran.out());
        assertEquals(answer.path("pixels").size(), answer.path("steps").size());
        for (int i = 0; i < answer.path("steps").size(); i++) {
            JsonNode step = answer.path("steps").get(i);
            assertEquals(answer.path("pixels").get(i).get(0), step.path("x"), "step " + i);
            assertEquals(answer.path("pixels").get(i).get(1), step.path("y"), "step " + i);
            assertTrue(step.path("decision").isNumber(), "step " + i);
        }
        assertTrue(answer.path("decision").asText().startsWith("d = "), ran.out());
    }

    @Test
    void windowKeepsTheUnclippedSegmentsPixels() throws Exception {
        long seed = 20260101;
        var random = new Random(seed);
        for (int round = 0; round < 50; round++) {
            int[] c = random.ints(4, -20, 20).toArray();
            String ends = "{\"from\":[%d,%d],\"to\":[%d,%d]".formatted(c[0], c[1], c[2], c[3]);
            List<JsonNode> inWindow = new ArrayList<>();
            for (JsonNode pixel : pixels(ends + "}"))
                if (Math.abs(pixel.get(0).asInt()) <= 7 && Math.abs(pixel.get(1).asInt()) <= 4)
                    inWindow.add(pixel);
            List<JsonNode> windowed = new ArrayList<>();
            pixels(ends + ",\"window\":[-7,-4,7,4]}").forEach(windowed::add);
            assertEquals(inWindow, windowed, "seed " + seed + ", " + ends);
        }
    }

    private static JsonNode pixels(String json) throws Exception {
        Ran ran = Ran.labReading(json, "run", "line", "bresenham");
        return new ObjectMapper().readTree(ran.out()).path("pixels");
    }

    @Test
    void eachLineIsAnsweredInOrder() {
        String in = SEGMENT + "\n\nrubbish\r\n{\"from\":[3,3],\"to\":[3,3]}";
        Ran ran = Ran.labReading(in, "run", "line", "bresenham", "--lines");
        List<String> answers = ran.out().lines().toList();
        assertEquals(4, answers.size(), ran.out());
        assertTrue(answers.get(0).startsWith("{\"pixels\":[[0,0],[1,0]"), answers.get(0));
        assertTrue(answers.get(1).startsWith("{\"error\":\"the line is empty"), answers.get(1));
        assertTrue(answers.get(2).startsWith("{\"error\":\"line 1, column "), answers.get(2));
        assertEquals("{\"pixels\":[[3,3]]}", answers.get(3));
        ran.assertDone();
    }

    @Test
    void thousandsOfLinesKeepTheirOrder() {
        var in = new StringBuilder();
        for (int i = 0; i < 3000; i++)
            in.append("{\"from\":[%d,0],\"to\":[%d,0]}\n".formatted(i, i));
        List<String> answers =
                Ran.labReading(in.toString(), "run", "line", "dda", "--lines")
                        .out()
                        .lines()
                        .toList();
        assertEquals(3000, answers.size());
        for (int i = 0; i < 3000; i++) assertEquals("{\"pixels\":[[" + i + ",0]]}", answers.get(i));
    }

    @Test
    void tenMegabytesInOneLineAreRead() {
        String in = "{\"from\":[0,0],\"to\":" + " ".repeat(10_000_000) + "[0,0]}\n" + SEGMENT;
        Ran ran = Ran.labReading(in, "run", "line", "bresenham", "--lines");
        assertEquals("{\"pixels\":[[0,0]]}", ran.out().lines().findFirst().orElseThrow());
        assertEquals(2, ran.out().lines().count());
    }

    @Test
    void tenMegabytesOfRubbishAreOneLineOfError() {
        Ran ran = Ran.labReading("x".repeat(10_000_000), "run", "line", "bresenham");
        assertEquals(1, ran.err().lines().count());
        assertTrue(ran.err().length() < 600, "message has " + ran.err().length() + " characters");
        assertEquals(2, ran.exitCode());
    }

    @Test
    void refusalHasTheMethodsMessage() {
        Ran ran = Ran.labReading("{\"from\":[0,0],\"to\":[20000000,1]}", "run", "line", "dda");
        assertTrue(ran.err().startsWith("./lab run: dda refuses: "), ran.err());
        assertEquals("", ran.out());
        assertEquals(3, ran.exitCode());
    }

    @Test
    void endlessMethodIsGivenUp() {
        Ran ran =
                Ran.labReading(
                        "{\"from\":[2147483645,0],\"to\":[2147483647,0]}",
                        "run",
                        "line",
                        "bresenham-textbook");
        ran.assertComplains(
                4,
                "./lab run: bresenham-textbook does not end:"
                        + " it sent more than 1006 pixels, more than twice what the segment has");
    }

    @Test
    void tooLongAnswerNamesTheLimit() {
        Ran.labReading("{\"from\":[0,0],\"to\":[10000000,0]}", "run", "line", "bresenham")
                .assertComplains(
                        4,
                        "./lab run: the answer has more than 10000000 pixels, the most that one"
                                + " answer may have; give a smaller \"window\"");
    }

    @Test
    void unknownNamesListTheKnownOnes() {
        Ran unknown = Ran.lab("run", "spiral", "midpoint");
        assertTrue(unknown.err().contains("no topic 'spiral'; there are line,"), unknown.err());
        assertEquals(2, unknown.exitCode());
        Ran ran = Ran.lab("run", "line", "bresenhem");
        assertTrue(
                ran.err().contains("no line method 'bresenhem'; there are naive-textbook, "),
                ran.err());
        assertEquals(2, ran.exitCode());
    }
}
