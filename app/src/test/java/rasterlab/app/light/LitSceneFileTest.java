package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.cli.Lab;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.transform.SphericalView;

@Timeout(300)
class LitSceneFileTest {
    private static final int WIDTH = 120;
    private static final int HEIGHT = 90;

    @TempDir Path folder;

    @ParameterizedTest(name = "the file or the command draws another picture: {0}")
    @EnumSource(LightHazard.class)
    void commandDrawsThePictureOfTheLab(LightHazard hazard) throws IOException {
        LightChoice choice = hazard.shown();
        var file = LitSceneFile.write(choice, folder.resolve("lit one.scene.json"));
        String[] lines = file.commands(choice, WIDTH, HEIGHT).split("\n");
        assertEquals(LightFrame.SHADINGS.size(), lines.length);
        for (int i = 0; i < lines.length; i++)
            assertDrawn(choice, LightFrame.SHADINGS.get(i), lines[i]);
    }

    @Test
    @DisplayName("the command forgets which terms are seen")
    void commandShowsTheTermsOfTheLab() throws IOException {
        LightChoice choice = LightChoice.first().withTerms(Set.of(LightTerm.SPECULAR));
        var file = LitSceneFile.write(choice, folder.resolve("lit one.scene.json"));
        String command = file.commands(choice, WIDTH, HEIGHT).split("\n")[2];
        assertTrue(command.contains("--terms specular"), command);
        assertDrawn(choice, ShadingMethod.PHONG, command);
    }

    @ParameterizedTest(name = "the command lights sides as the scene has them, not as shown: {0}")
    @ValueSource(booleans = {true, false})
    void commandLightsTheSidesOfTheLab(boolean twoSided) throws IOException {
        LightChoice choice =
                LightChoice.first()
                        .with(new LitBody("vase", 12, LitBody.OWN))
                        .with(new SphericalView(0.5, 0.5, 600))
                        .withTwoSides(twoSided);
        Path path = folder.resolve("lit one.scene.json");
        LitSceneFile.write(choice.withTwoSides(!twoSided), path);
        String command = new LitSceneFile(path, choice).commands(choice, WIDTH, HEIGHT);
        assertDrawn(choice, ShadingMethod.PHONG, command.split("\n")[2]);
    }

    @Test
    @DisplayName("a file is taken for a scene that was changed since, or not for one turned round")
    void fileHoldsTheSceneItWasMadeOf() {
        LightChoice choice = LightChoice.first();
        var file = new LitSceneFile(folder.resolve("any.scene.json"), choice);
        assertTrue(file.holds(choice.withArrows(!choice.arrows())));
        assertFalse(file.holds(choice.withAmbient(0.9)));
        assertFalse(file.holds(choice.withLamp(choice.lamp().moved(1, 2, 3))));
    }

    @Test
    @DisplayName("a file in no folder is said to be written")
    void refusesAFileThatCannotBeWritten() {
        Path file = folder.resolve("gone").resolve("lit.scene.json");
        assertThrows(Complaint.class, () -> LitSceneFile.write(LightChoice.first(), file));
    }

    private void assertDrawn(LightChoice choice, ShadingMethod shading, String command)
            throws IOException {
        Path out = folder.resolve("out.png");
        String[] words =
                command.substring("./lab ".length())
                        .replaceAll("'[^']*'", "FILE")
                        .replaceAll("--out .*", "--out OUT")
                        .split(" ");
        for (int i = 0; i < words.length; i++) {
            if (words[i].equals("FILE")) words[i] = folder.resolve("lit one.scene.json").toString();
            if (words[i].equals("OUT")) words[i] = out.toString();
        }
        var err = new ByteArrayOutputStream();
        int exit =
                Lab.run(
                        words,
                        new ByteArrayInputStream(new byte[0]),
                        new PrintStream(new ByteArrayOutputStream()),
                        new PrintStream(err));
        assertEquals(0, exit, command + "\n" + err.toString(StandardCharsets.UTF_8));
        var drawn = ImageIO.read(out.toFile());
        var shown = new Raster(WIDTH, HEIGHT);
        try (var renderer = new Renderer()) {
            renderer.render(
                    LitScene.request(choice, choice.body().scene(), shading, WIDTH, HEIGHT),
                    shown,
                    () -> false);
        }
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assertEquals(
                        shown.argb(x, y) | 0xFF000000,
                        drawn.getRGB(x, y),
                        "pixel " + x + ", " + y + " by " + shading);
    }
}
