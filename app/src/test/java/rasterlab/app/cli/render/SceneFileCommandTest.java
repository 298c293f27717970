package rasterlab.app.cli.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.cli.Ran;
import rasterlab.app.model.SceneText;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.exercises.scene.SceneSource;
import rasterlab.exercises.scene.SceneView;
import rasterlab.exercises.scene.Settings;

@Tag("slow")
class SceneFileCommandTest {
    private static final String VIEW =
            """
            {"version": 1, "scene": "cube", "camera": {"theta": 1, "phi": 1, "rho": 300},
             "projection": "cabinet",
             "look": {"visibility": "painter", "shading": "gouraud", "texture": "none"}}
            """;
    private static final String CASE =
            """
            {"version": 1, "topic": "line", "method": "dda", "input": {"from": [0, 0], "to": [5, 2]}}
            """;

    @TempDir Path folder;

    @Test
    void rendersAsTheFileSays() throws Exception {
        JsonNode said = rendered();
        assertEquals("cube", said.path("scene").asText());
        assertEquals("cabinet", said.path("projection").asText());
        assertEquals("painter", said.path("visibility").asText());
        assertEquals("gouraud", said.path("shading").asText());
        assertEquals("none", said.path("texture").asText());
        assertEquals(300, said.path("camera").path("rho").asDouble());
        String named = folder.resolve("named.png").toString();
        Ran.lab(
                        "render",
                        "cube",
                        "--camera",
                        "1,1,300",
                        "--projection",
                        "cabinet",
                        "--visibility",
                        "painter",
                        "--shading",
                        "gouraud",
                        "--texture",
                        "none",
                        "--size",
                        "80x60",
                        "--out",
                        named)
                .assertDone();
        assertArrayEquals(
                Files.readAllBytes(folder.resolve("named.png")),
                Files.readAllBytes(folder.resolve("out.png")));
    }

    @Test
    void commandLineCountsBeforeTheFile() throws Exception {
        JsonNode said =
                rendered(
                        "--projection",
                        "front",
                        "--visibility",
                        "zfloat",
                        "--shading",
                        "flat",
                        "--texture",
                        "auto",
                        "--camera",
                        "0,1,200");
        assertEquals("front", said.path("projection").asText());
        assertEquals("zfloat", said.path("visibility").asText());
        assertEquals("flat", said.path("shading").asText());
        assertNotEquals("asked for", said.path("textureBecause").asText());
        assertEquals(200, said.path("camera").path("rho").asDouble());
    }

    @ParameterizedTest(
            name = "{1} in a file is not {2} on the command line, or not overruled by {3}")
    @CsvSource(
            delimiter = '|',
            value = {
                "torus | 'zoom': 1.5 | --zoom 1.5 | --zoom 0.7",
                "torus | 'near': 480 | --near 480 | --near 450",
                "torus | 'far': 470 | --far 470 | --far 500",
                "torus | 'clipPlanes': [[1,0,0,0],[0,1,1,9]] | --clip-plane 1,0,0,0 --clip-plane"
                        + " 0,1,1,9 | --clip-plane 0,0,1,0",
                "torus | 'look': {'terms': ['ambient','specular']} | --terms ambient,specular |"
                        + " --terms diffuse",
                "vase | 'camera': {'theta': 0.5, 'phi': 0.4, 'rho': 500}, 'look': {'twoSided': false,"
                        + " 'shading': 'flat'} | --camera 0.5,0.4,500 --shading flat --no-two-sided |"
                        + " --two-sided",
                "vase | 'camera': {'theta': 0.5, 'phi': 0.4, 'rho': 500}, 'look': {'cull': 'back'} |"
                        + " --camera 0.5,0.4,500 --cull back | --cull none",
                "cube | 'look': {'shading': 'wire', 'hiddenLines': 'dashed'} | --shading wire"
                        + " --hidden-lines dashed | --hidden-lines shown",
                "sphere | 'look': {'shading': 'wire', 'crease': 25} | --shading wire --crease 25 |"
                        + " --crease 0",
                "cube | 'look': {'visibility': 'painter', 'shading': 'tone', 'outline': true} |"
                        + " --visibility painter --shading tone --outline | --visibility zfloat",
                "torus | 'look': {'depthCue': 0.9} | --depth-cue 0.9 | --depth-cue 0.2",
                "torus | 'look': {'stereo': 'anaglyph'} | --stereo anaglyph | --stereo side-by-side",
                "torus | 'look': {'stereo': 'anaglyph', 'eyes': 40} | --stereo anaglyph --eyes 40 |"
                        + " --eyes 9",
                "textured-quad | 'look': {'wrap': 'clamp'} | --wrap clamp | --wrap mirrored",
                "textured-quad | 'look': {'environment': 'replace'} | --environment replace |"
                        + " --environment modulate",
            })
    void everySettingIsDrawn(String scene, String said, String options, String other)
            throws Exception {
        String file =
                written(
                        "{'version': 1, 'scene': '%s', %s}"
                                .formatted(scene, said)
                                .replace('\'', '"'));
        byte[] asFile = drawn(file, "");
        assertArrayEquals(drawn(scene, options), asFile, "the file is drawn otherwise");
        assertFalse(Arrays.equals(drawn(scene, ""), asFile), "the file says nothing to see");
        assertFalse(Arrays.equals(drawn(file, other), asFile), "the command line is overruled");
        assertArrayEquals(drawn(scene, ""), drawn(file, "--scene-only"), "more than the scene");
    }

    private byte[] drawn(String scene, String options) throws Exception {
        Path out = folder.resolve("drawn.png");
        String words = "render " + scene + " --size 120x90 " + options + " --out " + out;
        Ran.lab(words.strip().split(" +")).assertDone();
        return Files.readAllBytes(out);
    }

    @Test
    void passesOverWhatOnlyAnotherShadingOrProjectionUses() throws Exception {
        String file =
                written(
                        """
                        {"version": 1, "scene": "torus", "look": {"shading": "wire", "crease": 30,
                         "hiddenLines": "dashed", "stereo": "anaglyph", "terms": ["diffuse"]}}
                        """);
        String said = "--terms diffuse --stereo anaglyph --shading ";
        assertArrayEquals(drawn("torus", said + "phong"), drawn(file, "--shading phong"));
        assertArrayEquals(
                drawn(
                        "torus",
                        "--projection front --shading wire --crease 30 --hidden-lines dashed"),
                drawn(file, "--projection front"));
        assertArrayEquals(
                drawn("torus", "--stereo anaglyph --shading tone"), drawn(file, "--shading tone"));
    }

    @Test
    void laysThePictureBesideTheFile() throws Exception {
        Path picture = folder.resolve("red.png");
        var image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 16; i++) image.setRGB(i % 4, i / 4, i * 0x0F0301);
        ImageIO.write(image, "png", picture.toFile());
        String file =
                written(
                        "{\"version\": 1, \"scene\": \"sphere\", \"look\": {\"textureImage\":"
                                + " \"red.png\"}}");
        assertArrayEquals(drawn("sphere", "--texture-image " + picture), drawn(file, ""));
        String none = written(Files.readString(Path.of(file)).replace("red", "blue"));
        Ran.lab("render", none, "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: "
                                + none
                                + ": $.look.textureImage: there is no texture 'blue.png' in its"
                                + " folder");
    }

    @ParameterizedTest(name = "{0} is refused without its place {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "'near': 0 | $.near: near must be above 0 in perspective",
                "'near': -5 | $.near: near must be above 0 in perspective",
                "'near': 0, 'far': 9 | $.near: near must be above 0 in perspective",
                "'far': 1e-9 | $.far: near must be below far",
                "'camera': {'theta': NaN, 'phi': 1, 'rho': 9} | $.camera.theta: must be a number from"
                        + " -1000000 to 1000000, got NaN",
                "'detail': 0 | $.detail: must be a whole number from 3 to 1024, got 0",
                "'look': {'textureImage': '../x.png'} | $.look.textureImage: '../x.png' leads out",
                "'look': {'textureImage': '.'} | $.look.textureImage: FOLDER: is a folder, not a picture",
                "'look': {'textureImage': 'one.scene.json'} | $.look.textureImage: FOLDER/one.scene"
                        + ".json: is not a picture",
            })
    void namesThePlace(String said, String complaint) throws Exception {
        String file =
                written("{\"version\": 1, \"scene\": \"torus\", " + said.replace('\'', '"') + "}");
        String real = folder.toRealPath().toString();
        assertComplaint(file + ": " + complaint.replace("FOLDER", real), "render", file);
    }

    @Test
    void namesThePlaceOfAPictureThatCannotBeLaid() throws Exception {
        ImageIO.write(
                new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB),
                "png",
                folder.resolve("red.png").toFile());
        String file =
                written(
                        "{\"version\": 1, \"scene\": \"house\", \"look\": {\"textureImage\":"
                                + " \"red.png\"}}");
        assertComplaint(
                file + ": $.look.textureImage: scene 'house' has no texture", "render", file);
    }

    private static void assertComplaint(String start, String... command) {
        Ran ran =
                Ran.lab(
                        Stream.concat(Arrays.stream(command), Stream.of("--out", "x.png"))
                                .toArray(String[]::new));
        assertTrue(ran.err().startsWith("./lab render: " + start), ran.err());
    }

    @ParameterizedTest(name = "{0} of a file is not turned off by {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "'depthCue': 0.9 | --depth-cue 0",
                "'stereo': 'anaglyph' | --stereo none",
                "'visibility': 'painter', 'outline': true | --no-outline --visibility painter",
                "'textureImage': 'gone.png' | --texture none",
            })
    void commandLineTurnsOff(String look, String off) throws Exception {
        String file =
                written(
                        "{\"version\": 1, \"scene\": \"torus\", \"look\": {"
                                + look.replace('\'', '"')
                                + "}}");
        assertArrayEquals(drawn("torus", off), drawn(file, off));
    }

    @ParameterizedTest(name = "{0} of a file is not taken back by {1}")
    @CsvSource(
            delimiter = '|',
            value = {
                "'near': 480 | --near none",
                "'far': 470 | --far none",
                "'near': 470, 'far': 480 | --far none --near none",
                "'clipPlanes': [[1,0,0,0],[0,1,1,9]] | --clip-plane none",
            })
    void commandLineTakesBack(String said, String back) throws Exception {
        String file =
                written("{\"version\": 1, \"scene\": \"torus\", " + said.replace('\'', '"') + "}");
        assertFalse(Arrays.equals(drawn("torus", ""), drawn(file, "")), "nothing is cut off");
        assertArrayEquals(drawn("torus", ""), drawn(file, back));
        assertArrayEquals(drawn("torus", ""), drawn("torus", back));
    }

    @Test
    void nothingAndPlanesCannotBeCutOffTogether() {
        Ran.lab("render torus --clip-plane none --clip-plane 1,0,0,0 --out x.png".split(" "))
                .assertComplains(2, "./lab render: --clip-plane none must stand alone");
    }

    @Test
    @DisplayName("--detail is refused for a scene by name in a file, or does not count before it")
    void detailCountsBeforeTheFile() throws Exception {
        String fine = written("{\"version\": 1, \"scene\": \"torus\", \"detail\": 24}");
        assertArrayEquals(drawn("torus", "--detail 24"), drawn(fine, ""));
        assertArrayEquals(drawn("torus", "--detail 9"), drawn(fine, "--detail 9"));
        assertArrayEquals(drawn("torus", "--detail 9"), drawn(fine, "--detail 9 --scene-only"));
        String plain = written("{\"version\": 1, \"scene\": \"torus\"}");
        assertArrayEquals(drawn("torus", "--detail 9"), drawn(plain, "--detail 9"));
        SceneText.write(
                Path.of(plain),
                new SceneView(new SceneSource.Inline(Scenes.named("house")), Settings.NONE));
        Ran.lab("render", plain, "--detail", "9", "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: --detail is for scenes by name; "
                                + plain
                                + " holds the scene itself");
        Ran.lab("render", "x.obj", "--detail", "9", "--out", "x.png")
                .assertComplains(
                        2, "./lab render: --detail is for scenes by name, not for a model");
    }

    @Test
    void noTermAtAllCanBeAskedForInBothPlaces() throws Exception {
        String file = written("{\"version\": 1, \"scene\": \"torus\", \"look\": {\"terms\": []}}");
        assertArrayEquals(drawn("torus", "--terms none"), drawn(file, ""));
    }

    @Test
    void refusesPlanesThatCannotCut() {
        Ran.lab("render", "cube", "--clip-plane", "1,0,0", "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: invalid value for option '--clip-plane' (A,B,C,D): '1,0,0' is not a"
                                + " plane; expected four numbers A,B,C,D such as 1,0,0,-20, or none (see `./lab render --help`)");
        Ran.lab("render", "cube", "--clip-plane", "0,0,0,1", "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: invalid value for option '--clip-plane' (A,B,C,D): '0,0,0,1': a clip"
                                + " plane needs a direction: a, b or c other than 0 (see `./lab render --help`)");
        Ran.lab("render", "cube", "--scene-only", "--out", "x.png")
                .assertComplains(
                        2, "./lab render: --scene-only is for a scene file, FILE.scene.json");
    }

    private JsonNode rendered(String... options) throws Exception {
        String[] all = new String[6 + options.length];
        String file = written(VIEW);
        String[] fixed = {
            "render", file, "--size", "80x60", "--out", "" + folder.resolve("out.png")
        };
        System.arraycopy(fixed, 0, all, 0, 6);
        System.arraycopy(options, 0, all, 6, options.length);
        Ran ran = Ran.lab(all);
        ran.assertDone();
        return new ObjectMapper().readTree(ran.out());
    }

    @Test
    void runsTheCaseOfAFile() throws Exception {
        String input = "{\"from\":[0,0],\"to\":[5,2]}";
        String file = written(CASE);
        assertEquals(
                Ran.labReading(input, "run", "line", "dda", "--steps").out(),
                Ran.lab("run", "--scene", file, "--steps").out());
        assertEquals(
                Ran.labReading(input, "run", "line", "wu").out(),
                Ran.lab("run", "wu", "--scene", file).out());
    }

    @Test
    void complainsWithThePath() throws Exception {
        String file = written(VIEW.replace("\"rho\": 300", "\"rho\": -3"));
        Ran.lab("render", file, "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: "
                                + file
                                + ": $.camera.rho: must be a number from 0.001 to 1000000, got"
                                + " -3");
        Ran.lab("run", "--scene", written(VIEW))
                .assertComplains(
                        2,
                        "./lab run: %s: holds a view of a scene; `./lab render %s` takes it"
                                .formatted(file, file));
        Ran.lab("render", written(CASE), "--out", "x.png")
                .assertComplains(
                        2,
                        "./lab render: %s: holds an input of a topic; `./lab run --scene %s` takes it"
                                .formatted(file, file));
        Ran.lab("run", "--scene", written(CASE.replace("\"method\": \"dda\", ", "")))
                .assertComplains(2, "./lab run: " + file + ": names no method; give one: METHOD");
    }

    @Test
    void needsATopicOrAFile() {
        Ran.lab("run", "line")
                .assertComplains(
                        2,
                        "./lab run: needs TOPIC and METHOD, or --scene FILE; see `./lab methods`");
    }

    private String written(String text) throws Exception {
        Path file = folder.resolve("one.scene.json");
        Files.writeString(file, text);
        return file.toString();
    }
}
