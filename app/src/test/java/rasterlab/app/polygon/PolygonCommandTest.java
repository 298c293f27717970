package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.cli.Lab;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.app.polygon.outcome.CutAnswer;
import rasterlab.app.polygon.outcome.InsideAnswer;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.PolygonResults;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.contract.FillRule;

/** The copied command computes what the lab shows. */
@Timeout(300)
class PolygonCommandTest {
    private final PolygonTopics topics = new PolygonTopics();

    /** The output of the command. */
    private static JsonNode answer(PolygonScene scene) throws IOException {
        String command = PolygonCommand.of(scene).orElseThrow();
        String json = command.substring(command.indexOf('\'') + 1, command.lastIndexOf('\''));
        String[] words = command.substring(command.indexOf("./lab") + 6).split(" ");
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int exit =
                Lab.run(
                        words,
                        new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)),
                        new PrintStream(out),
                        new PrintStream(err));
        assertEquals(0, exit, err.toString(StandardCharsets.UTF_8));
        return new ObjectMapper().readTree(out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void judgesTheSamePointsByTheSameMethod() throws IOException {
        PolygonScene scene = PolygonScene.first(PolygonMode.TRIANGLE).withMethod("sign-double");
        scene = scene.with(topics.showing(scene, "boundary-other-way-round"));
        var shown = (InsideAnswer) PolygonResults.of(topics, scene).outcome().answer();
        var said = new ArrayList<Boolean>();
        answer(scene).path("inside").forEach(each -> said.add(each.asBoolean()));
        assertEquals(shown.inside(), said);
        assertTrue(said.contains(false), "the method is wrong here");
    }

    @Test
    void cutsTheSameTriangles() throws IOException {
        PolygonScene scene = PolygonScene.first(PolygonMode.TRIANGULATION);
        var shown = (CutAnswer) PolygonResults.of(topics, scene).outcome().answer();
        JsonNode triangles = answer(scene).path("triangles");
        assertEquals(shown.steps(), triangles.size());
        for (int i = 0; i < triangles.size(); i++)
            assertEquals(shown.cuts().get(i).b(), triangles.path(i).path(1).asInt());
    }

    @Test
    void fillsByTheSameRule() throws IOException {
        PolygonScene scene = PolygonScene.first(PolygonMode.FILL);
        scene = scene.with(((FillFigure) scene.figure()).withRule(FillRule.NON_ZERO));
        var shown = (PixelAnswer) PolygonResults.of(topics, scene).outcome().answer();
        assertEquals(shown.writes(), answer(scene).path("pixels").size());
    }

    @Test
    void fillsFromTheSameSeedWithTheSameNeighbours() throws IOException {
        PolygonScene scene = PolygonScene.first(PolygonMode.SEED).withMethod("stack");
        scene = scene.with(((SeedFigure) scene.figure()).withConnectivity(8));
        var shown = (PixelAnswer) PolygonResults.of(topics, scene).outcome().answer();
        long filled = 0;
        for (JsonNode row : answer(scene).path("picture"))
            filled += row.asText().chars().filter(c -> c == SeedFigure.NEW).count();
        assertEquals(shown.writes(), filled);
    }

    @Test
    void cornerThatIsNowhereHasNoCommand() {
        PolygonScene scene = PolygonScene.first(PolygonMode.FILL);
        scene = scene.with(topics.showing(scene, "no-number"));
        assertEquals(Optional.empty(), PolygonCommand.of(scene));
    }
}
