package rasterlab.exercises.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.exercises.scene.MethodCase.DrawnPixels;
import rasterlab.exercises.scene.MethodCase.PlottedPixel;

class SceneFileTest {
    private static final long SEED = 20260311;
    private static final String TRIANGLE =
            """
            {
              "version": 1,
              "scene": {
                "name": "one",
                "vertices": [[0, 0, 0], [100, 0, 0], [0, 100, 0]],
                "faces": [{"corners": [0, 1, 2], "finish": 0}],
                "finishes": [{"diffuse": [0.5, 0.25, 1]}],
                "light": {"ambient": [0.2, 0.2, 0.2], "localViewer": true, "twoSided": true,
                  "reflection": "blinn-phong",
                  "lights": [{"at": [0, 0, 300],
                    "source": {"ambient": [0, 0, 0], "diffuse": [1, 1, 1], "specular": [1, 1, 1]}}]},
                "background": 255,
                "pictureScale": 2
              },
              "camera": {"theta": 0.5, "phi": 1, "rho": 400},
              "projection": "isometric",
              "look": {"visibility": "zfloat", "shading": "phong", "texture": "nearest"}
            }
            """;

    @Test
    @DisplayName("a case loses its method or its input")
    void caseRoundTrip() {
        var one = new MethodCase("line", Optional.of("dda"), "{\"from\":[0,0],\"to\":[5,2]}");
        assertEquals(one, SceneFile.read(one.write()));
        var own = new MethodCase("line", Optional.empty(), "{\"from\":[0,0],\"to\":[5,2]}");
        assertEquals(own, SceneFile.read(own.write()));
        var drawn =
                new MethodCase(
                        "line",
                        Optional.empty(),
                        "{\"from\":[0,0],\"to\":[5,2]}",
                        Optional.of(
                                new DrawnPixels(
                                        List.of(
                                                new PlottedPixel(-1, Integer.MAX_VALUE),
                                                new PlottedPixel(-1, 7)),
                                        true)));
        assertEquals(drawn, SceneFile.read(drawn.write()));
    }

    @Test
    @DisplayName("pixels beyond the limit are left out without a word")
    void pixelsThatAreNotKeptAreACut() {
        var plotted = new PixelRecording(MethodCase.MOST_DRAWN + 1);
        for (int x = 0; x < MethodCase.MOST_DRAWN; x++) plotted.plot(x, 0);
        assertFalse(DrawnPixels.of(new Plotted(plotted, false)).cut());
        plotted.plot(0, 1);
        DrawnPixels kept = DrawnPixels.of(new Plotted(plotted, false));
        assertTrue(kept.cut());
        assertEquals(MethodCase.MOST_DRAWN, kept.pixels().size());
    }

    @Test
    @DisplayName("a cut is told of nothing")
    void aCutNeedsPixels() {
        String file = "{\"version\":1,\"topic\":\"line\",\"input\":{},\"drawnCut\":true}";
        var refusal = assertThrows(IllegalArgumentException.class, () -> SceneFile.read(file));
        assertTrue(refusal.getMessage().startsWith("$.drawnCut: must"), refusal.getMessage());
    }

    @ParameterizedTest(name = "{1} is taken for pixels")
    @CsvSource(
            delimiter = ';',
            value = {
                "$.drawn: must be an array; 7",
                "$.drawn[1]: must be a pixel [x, y], got 3 members; [[0,0],[1,2,3]]",
                "$.drawn[0][1]: must be a whole number from -2147483648; [[0,2147483648]]"
            })
    void brokenPixelsAreNamed(String said, String drawn) {
        String file = "{\"version\":1,\"topic\":\"line\",\"input\":{},\"drawn\":" + drawn + "}";
        var refusal = assertThrows(IllegalArgumentException.class, () -> SceneFile.read(file));
        assertTrue(refusal.getMessage().startsWith(said), refusal.getMessage());
    }

    @Test
    @DisplayName("a view by name loses its detail, camera or look")
    void namedRoundTrip() {
        var view =
                new SceneView(
                        new SceneSource.ByName("sphere", OptionalInt.of(20)),
                        Settings.NONE
                                .with(SceneSetting.CAMERA, new SphericalView(0.1, 1 / 3.0, 450))
                                .with(SceneSetting.PROJECTION, Projection.CABINET)
                                .with(SceneSetting.VISIBILITY, "painter")
                                .with(SceneSetting.SHADING, ShadingMethod.GOURAUD)
                                .with(SceneSetting.TEXTURE, TextureMode.NONE));
        assertEquals(view, SceneFile.read(view.write()));
        var bare =
                new SceneView(new SceneSource.ByName("vase", OptionalInt.empty()), Settings.NONE);
        assertEquals(bare, SceneFile.read(bare.write()));
    }

    /** The pictures are compared, as they see every number. */
    @ParameterizedTest(name = "{0} looks different when it is read back")
    @MethodSource("rasterlab.engine.scene.catalogue.Scenes#names")
    void inlineRoundTrip(String name) {
        Scene scene = Scenes.named(name).with(SceneFileTest::withoutTexture);
        var view =
                new SceneView(
                        new SceneSource.Inline(scene),
                        Settings.NONE.with(SceneSetting.CAMERA, scene.defaultCamera()));
        var read = (SceneView) SceneFile.read(view.write());
        assertEquals(view.write(), read.write());
        assertTrue(
                Arrays.equals(
                        picture(scene, scene.defaultCamera()),
                        picture(
                                read.source().scene(),
                                read.settings().get(SceneSetting.CAMERA).orElseThrow())));
    }

    private static Appearance withoutTexture(Appearance finish) {
        return new Appearance(finish.front(), finish.back(), Optional.empty());
    }

    private static int[] picture(Scene scene, SphericalView camera) {
        var request = new RenderRequest(scene, "zfloat", "phong", "perspective", camera, 160, 120);
        return new Renderer().render(request, () -> false).argb();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesWithThePath(String right, String wrong, String message) {
        SceneFile.read(TRIANGLE);
        assertTrue(TRIANGLE.contains(right), right);
        String json = TRIANGLE.replace(right, wrong);
        var refusal = assertThrows(IllegalArgumentException.class, () -> SceneFile.read(json));
        assertEquals(message, refusal.getMessage());
    }

    @ParameterizedTest(name = "an empty file is told in the words for a wrong field: \"{0}\"")
    @ValueSource(strings = {"", " \n", SceneFile.BYTE_ORDER_MARK})
    void saysThatTheFileIsEmpty(String json) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> SceneFile.read(json));
        assertEquals("the file is empty; a scene file is an object {…}", refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a later version is read as this one",
                        "\"version\": 1",
                        "\"version\": 2",
                        "$.version: must be 1, got 2"),
                argumentSet(
                        "a misspelt field is passed over",
                        "\"theta\"",
                        "\"teta\"",
                        "$.camera.teta: is not known here; known are theta, phi, rho"),
                argumentSet(
                        "a missing field is 0",
                        ", \"rho\": 400",
                        "",
                        "$.camera.rho: must be a number from 0.001 to 1000000.0, got nothing"),
                argumentSet(
                        "a number out of range is taken",
                        "\"rho\": 400",
                        "\"rho\": 0",
                        "$.camera.rho: must be a number from 0.001 to 1000000.0, got 0"),
                argumentSet(
                        "a text counts as a number",
                        "[100, 0, 0]",
                        "[\"100\", 0, 0]",
                        "$.scene.vertices[1][0]: must be a number from -1.0E30 to 1.0E30, got"
                                + " \"100\""),
                argumentSet(
                        "a vertex has two coordinates",
                        "[100, 0, 0]",
                        "[100, 0]",
                        "$.scene.vertices[1]: must have 3 numbers, got 2"),
                argumentSet(
                        "a corner is no vertex",
                        "[0, 1, 2]",
                        "[0, 1, 3]",
                        "$.scene.faces[0].corners[2]: must be a whole number from 0 to 2, got 3"),
                argumentSet(
                        "a face without an area is taken",
                        "[0, 100, 0]",
                        "[50, 0, 0]",
                        "$.scene.faces: face 0: corners [0, 1, 2] span no area"),
                argumentSet(
                        "an infinite number is taken, or told otherwise than it stands there",
                        "[100, 0, 0]",
                        "[1e999, 0, 0]",
                        "$.scene.vertices[1][0]: must be a number from -1.0E30 to 1.0E30, got"
                                + " 1e999"),
                argumentSet(
                        "the parser's words are said of NaN",
                        "[100, 0, 0]",
                        "[NaN, 0, 0]",
                        "$.scene.vertices[1][0]: must be a number from -1.0E30 to 1.0E30, got NaN"),
                argumentSet(
                        "a negative infinity has no path",
                        "\"background\": 255",
                        "\"background\": -Infinity",
                        "$.scene.background: must be a whole number from 0 to 16777215, got"
                                + " -Infinity"),
                argumentSet(
                        "an angle without a direction is taken",
                        "\"theta\": 0.5",
                        "\"theta\": 1e308",
                        "$.camera.theta: must be a number from -1000000.0 to 1000000.0, got"
                                + " 1.0E308"),
                argumentSet(
                        "a huge height is taken",
                        "\"phi\": 1",
                        "\"phi\": -1000001",
                        "$.camera.phi: must be a number from -1000000.0 to 1000000.0, got"
                                + " -1000001"),
                argumentSet(
                        "the parser's words are said of a missing comma",
                        "\"version\": 1,",
                        "\"version\": 1",
                        "not JSON: line 3, column 3: expected a comma or }, got '\"'"),
                argumentSet(
                        "an unknown method is kept",
                        "\"zfloat\"",
                        "\"z\"",
                        "$.look.visibility: no visibility 'z'; there are "
                                + String.join(", ", Renderer.visibilities())
                                + ", raycast-surface"),
                argumentSet(
                        "a light stands nowhere",
                        "\"at\": [0, 0, 300],",
                        "",
                        "$.scene.light.lights[0]: must have either 'at' or 'from', the direction"
                                + " to a far light"),
                argumentSet(
                        "a colour is above 1",
                        "[0.5, 0.25, 1]",
                        "[0.5, 0.25, 2]",
                        "$.scene.finishes[0].diffuse[2]: must be a number from 0.0 to 1.0, got 2"),
                argumentSet(
                        "a field is there twice",
                        "\"projection\"",
                        "\"version\": 1, \"projection\"",
                        "not JSON: line 16, column 12: Duplicate field 'version'"),
                argumentSet(
                        "half of the corners have normals",
                        "[{\"corners\": [0, 1, 2], \"finish\": 0}]",
                        "[{\"corners\": [0, 1, 2], \"finish\": 0, \"normals\": [[0, 0, 1]]}]",
                        "$.scene.faces[0].normals: must have one for each of 3 corners, got 1"));
    }

    @ParameterizedTest(name = "{0} is read")
    @ValueSource(
            strings = {
                "",
                "[]",
                "{}",
                "{\"version\":1}",
                "{\"version\":1,\"scene\":\"vas\"}",
                "{\"version\":1,\"scene\":\"house\",\"detail\":5}",
                "{\"version\":1,\"topic\":\"line\",\"input\":[]}",
                "{\"version\":1,\"topic\":\"line\",\"input\":{}} x",
            })
    void refuses(String json) {
        assertThrows(IllegalArgumentException.class, () -> SceneFile.read(json));
    }

    @Test
    @DisplayName("a byte-order mark is refused, or one in the midst of the text is not")
    void passesOverAByteOrderMark() {
        String marked = ((SceneView) SceneFile.read("\uFEFF" + TRIANGLE)).write();
        assertEquals(((SceneView) SceneFile.read(TRIANGLE)).write(), marked);
        assertThrows(
                IllegalArgumentException.class, () -> SceneFile.read("\uFEFF\uFEFF" + TRIANGLE));
    }

    @Test
    @DisplayName("NaN in a method's input becomes a text")
    void refusesNotANumberInAnInput() {
        String json = "{\"version\":1,\"topic\":\"line\",\"input\":{\"from\":[0,{\"x\":NaN}]}}";
        var refusal = assertThrows(IllegalArgumentException.class, () -> SceneFile.read(json));
        assertEquals("$.input.from[1].x: must be a finite number, got NaN", refusal.getMessage());
    }

    /** Damage of one sign each time: read, or refused in words, and nothing else. */
    @Test
    @DisplayName("a damaged file crashes the reader")
    void damageIsRefusedInWords() {
        var random = new Random(SEED);
        String signs = "0123456789-+.eE{}[]\",: \\ntrufalsé\u0000";
        List<String> files =
                List.of(
                        TRIANGLE,
                        "{\"version\":1,\"scene\":\"sphere\",\"detail\":9}",
                        "{\"version\":1,\"topic\":\"line\",\"input\":{\"from\":[0,0]}}");
        for (int round = 0; round < 20_000; round++) {
            var damaged = new StringBuilder(files.get(round % files.size()));
            for (int times = random.nextInt(3); times >= 0; times--) {
                int at = random.nextInt(damaged.length());
                switch (random.nextInt(3)) {
                    case 0 -> damaged.deleteCharAt(at);
                    case 1 -> damaged.insert(at, signs.charAt(random.nextInt(signs.length())));
                    default -> damaged.setCharAt(at, signs.charAt(random.nextInt(signs.length())));
                }
            }
            try {
                SceneFile.read(damaged.toString());
            } catch (IllegalArgumentException refusal) {
                assertTrue(refusal.getMessage().length() > 5, "seed " + SEED + ": " + damaged);
            }
        }
    }
}
