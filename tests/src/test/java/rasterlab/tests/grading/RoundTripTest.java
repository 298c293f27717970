package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.tests.grading.Solutions.source;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.exercises.catalogue.Catalogue;

@Tag("slow")
class RoundTripTest {
    private static final String EXERCISE = "line-bresenham";

    @TempDir private static Path folder;
    private static ServerProcess server;
    private static GraderClient instructor;
    private static GraderClient student;

    @BeforeAll
    static void startServer() throws Exception {
        server = ServerProcess.start(folder.resolve("course"));
        instructor = GraderClient.of(server.address(), server.token());
        student = instructor.joinNewCourse();
    }

    @AfterAll
    static void stopServer() throws IOException {
        server.close();
    }

    @Test
    void aRightSolutionIsOk() throws Exception {
        var result = graded(Solutions.RIGHT);
        assertEquals("ok", result.path("verdict").asText(), result.toString());
        var plan = Catalogue.builtIn().named(EXERCISE).points();
        var points = result.path("points");
        assertEquals(plan.accuracy(), points.path("accuracy").asInt(), points.toString());
        assertEquals(plan.stability(), points.path("stability").asInt(), points.toString());
        assertEquals(plan.total(), points.path("of").asInt(), points.toString());
        // The measured speed differs from run to run.
        assertEquals(
                plan.accuracy() + plan.stability() + points.path("speed").asInt(),
                points.path("total").asInt(),
                points.toString());
    }

    @Test
    void aWrongSolutionIsShownItsPictures() throws Exception {
        var result = graded(Solutions.WRONG);
        assertEquals("wrong", result.path("verdict").asText(), result.toString());
        var wrong =
                StreamSupport.stream(result.path("cases").spliterator(), false)
                        .filter(each -> each.path("visibility").asText().equals("open"))
                        .filter(each -> each.path("verdict").asText().equals("wrong"))
                        .findFirst()
                        .orElseThrow();
        assertFalse(wrong.path("message").asText().isEmpty());
        assertTrue(wrong.path("points").asInt() < wrong.path("of").asInt(), wrong.toString());
        var kinds = new ArrayList<String>();
        for (var picture : wrong.path("pictures")) {
            kinds.add(picture.path("kind").asText());
            assertIsPng(picture.path("url").asText());
        }
        assertEquals(List.of("expected", "actual", "difference"), kinds);
    }

    @Test
    void aForbiddenCallIsRefusedWithItsLine() throws Exception {
        var result = graded(Solutions.FORBIDDEN);
        assertEquals("refused", result.path("verdict").asText(), result.toString());
        var diagnostic = result.path("diagnostics").path(0);
        assertEquals(7, diagnostic.path("line").asInt(), diagnostic.toString());
        assertTrue(
                diagnostic.path("message").asText().contains("System.exit"), diagnostic.toString());
        assertEquals(0, result.at("/points/total").asInt());
    }

    @Test
    void anEndlessLoopMeetsItsTimeLimit() throws Exception {
        var result = graded(Solutions.ENDLESS);
        assertEquals("time_limit", result.path("verdict").asText(), result.toString());
    }

    @Test
    void aSourceThatDoesNotCompileIsShownTheLine() throws Exception {
        var id =
                student.submit(
                        EXERCISE, source(Solutions.RIGHT).replace("int y = y0;", "int y = y0"));
        var result = student.result(id);
        assertEquals("compile_error", result.path("verdict").asText(), result.toString());
        assertEquals(
                17, result.path("diagnostics").path(0).path("line").asInt(), result.toString());
    }

    @Test
    void hiddenCasesShowAStudentOnlyTheirVerdict() throws Exception {
        var id = student.submit(EXERCISE, source(Solutions.WRONG));
        var hidden =
                StreamSupport.stream(student.result(id).path("cases").spliterator(), false)
                        .filter(each -> !each.path("visibility").asText().equals("open"))
                        .toList();
        assertFalse(hidden.isEmpty(), "the exercise has no hidden case");
        for (var each : hidden) {
            assertTrue(each.path("scene").asText("").isEmpty(), each.toString());
            assertEquals(0, each.path("pictures").size(), each.toString());
            // Coordinates, sizes and counts are told in digits only.
            assertFalse(each.path("message").asText().matches("(?s).*\\d.*"), each.toString());
        }
    }

    @Test
    void theDocumentedCurlCallIsAccepted() throws Exception {
        var response =
                student.send(
                        student.request("/exercises/" + EXERCISE + "/submissions")
                                .header("Content-Type", "text/x-java-source")
                                .POST(BodyPublishers.ofString(source(Solutions.RIGHT))));
        assertEquals(202, response.statusCode(), response.body());
        var location = response.headers().firstValue("Location").orElseThrow();
        var id = GraderClient.expect(202, response).path("id").asText();
        assertTrue(location.endsWith("/api/v1/submissions/" + id), location);
    }

    private static JsonNode graded(String solution) throws Exception {
        return student.result(student.submit(EXERCISE, source(solution)));
    }

    private static void assertIsPng(String path) throws Exception {
        var request = student.request("").uri(server.address().resolve(path)).build();
        var response = student.http().send(request, BodyHandlers.ofByteArray());
        assertEquals(200, response.statusCode(), path);
        assertEquals(
                "PNG",
                new String(response.body(), 1, 3, java.nio.charset.StandardCharsets.US_ASCII),
                path);
    }
}
