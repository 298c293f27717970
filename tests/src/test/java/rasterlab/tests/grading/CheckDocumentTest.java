package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.process.JavaCommand;

/** {@code ./lab check --json} beside what the server answers to the same source. */
@Tag("slow")
class CheckDocumentTest {
    private static final String EXERCISE = "line-bresenham";

    @TempDir private Path folder;

    @Test
    void aWrongSolutionIsToldAsByTheServer() throws Exception {
        var checked = checked(Solutions.source(Solutions.WRONG));
        var answered = answered(Solutions.source(Solutions.WRONG));
        for (var field : List.of("exercise", "revision", "verdict", "diagnostics", "isolation"))
            assertEquals(answered.get(field), checked.get(field), field);
        assertEquals(
                names(answered.get("points")), names(checked.get("points")), "fields of points");
        var cases = cases(checked);
        assertTrue(cases.size() > 10, cases.keySet().toString());
        assertEquals(cases(answered), cases);
        assertPictures(checked);
    }

    @Test
    void aSourceThatDoesNotCompileIsToldAsByTheServer() throws Exception {
        var source = Solutions.source(Solutions.RIGHT).replace("int y = y0;", "int y = y0");
        var checked = checked(source);
        var answered = answered(source);
        assertEquals("compile_error", checked.get("verdict").asText());
        assertFalse(checked.get("diagnostics").isEmpty(), "nothing is told");
        assertEquals(answered.get("diagnostics"), checked.get("diagnostics"));
    }

    private JsonNode answered(String source) throws Exception {
        try (var server = ServerProcess.start(folder.resolve("course"))) {
            var student = GraderClient.of(server.address(), server.token()).joinNewCourse();
            return student.result(student.submit(EXERCISE, source));
        }
    }

    private JsonNode checked(String source) throws Exception {
        var file = Files.writeString(folder.resolve("Line.java"), source);
        var out = folder.resolve("pictures").toString();
        var arguments = List.of("check", EXERCISE, file.toString(), "--json", "--out", out);
        var run =
                ChildProcess.run(
                        folder,
                        Map.of(),
                        Duration.ofMinutes(5),
                        JavaCommand.of(ChildProcess.SHORT_LIVED, "rasterlab.app.Main", arguments));
        assertEquals(1, run.exit(), run.err());
        return new ObjectMapper().readTree(run.out());
    }

    /**
     * The open ones by name, without the places of their pictures and without the measured speed.
     */
    private static Map<String, JsonNode> cases(JsonNode document) {
        var open = new LinkedHashMap<String, JsonNode>();
        for (var each : document.get("cases")) {
            if (!each.get("visibility").asText().equals("open")) continue;
            if (each.get("name").asText().equals("speed")) continue;
            var copy = (ObjectNode) each.deepCopy();
            for (var picture : copy.get("pictures")) ((ObjectNode) picture).put("url", "");
            open.put(each.get("name").asText(), copy);
        }
        return open;
    }

    private static TreeSet<String> names(JsonNode object) {
        var names = new TreeSet<String>();
        object.fieldNames().forEachRemaining(names::add);
        return names;
    }

    private static void assertPictures(JsonNode document) {
        int pictures = 0;
        for (var each : document.get("cases"))
            for (var picture : each.get("pictures")) {
                var place = Path.of(URI.create(picture.get("url").asText()));
                assertTrue(Files.isRegularFile(place), place.toString());
                pictures++;
            }
        assertTrue(pictures > 0, "no picture");
    }
}
